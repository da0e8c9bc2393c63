// The pictures of the comparison, as PNG.
#pragma once
#include <filesystem>
#include <string>

#include "bench/picture.h"

namespace cloudscape::bench {

// Beside report.json and index.html. `column`: "reference" or a model.
std::string picture_file(const std::string& view, const std::string& column);   // "noon-single.png"
std::string flip_map_file(const std::string& view, const std::string& column);  // "noon-single-flip.png"
void write_picture(const std::filesystem::path& file, const Picture& display);  // throws Error

// Errors of 0..1 as colours from black through red and yellow to white, which is reached at 0.5: more is rare.
Picture flip_map(const std::vector<double>& errors, const ImageSize& size_px);

}  // namespace cloudscape::bench
