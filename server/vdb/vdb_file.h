// OpenVDB files, read as files of strangers, and written.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "core/cloudscape_grid.h"
#include "core/voxels.h"

namespace cloudscape::vdb {

bool is_built_in();  // false: the program was built without OpenVDB, and reading and writing throw Error

// tuned: more than clouds take that people share; what OpenVDB makes of a file in memory is some ten times its size.
constexpr std::uint64_t max_file_bytes = std::uint64_t{1} << 30;
constexpr int max_extent = 1 << 16;  // voxels a side of the active voxels' box

struct Wanted {
  std::string grid = "density";
  int resolution = 256;  // most voxels along the longest side
  UpAxis up = UpAxis::z;
};

// The box of the grid's active voxels; inactive ones are empty. A grid that is finer than `resolution` is averaged over
// the voxels that each of the result covers, so that optical depths stay; another is copied. Throws UnusableFile, one
// sentence without the file's name: damaged, cut off, empty, too large, no such grid, no numbers, a level set, a
// transform that is more than scale and translation, densities that are negative or not finite. Thread-safe.
Voxels read(const std::filesystem::path& file, const Wanted& wanted);

// Writes a fog volume in uniform voxels, slice by slice.
class Writer {
 public:
  // `first_m`: the middle of voxel (0, 0, 0). `up`: the file's upward axis, as core's UpAxis.
  Writer(double voxel_m, const glm::dvec3& first_m, UpAxis up);
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  // Voxels x < width, y < height of the slices from z on, x fastest. Those of density 0 take no room.
  void add(int z, int width, int height, std::span<const float> densities);
  // Grid `density`, 16 bit floats, compressed by zlib. `texts` become the file's metadata, `numbers` the grid's. Throws
  // Error if the file cannot be written; it is whole or not there.
  void write(const std::filesystem::path& file, const std::map<std::string, std::string>& texts,
             const std::map<std::string, double>& numbers);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cloudscape::vdb
