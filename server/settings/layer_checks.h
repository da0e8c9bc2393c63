// Rules between the fields of a noise volume's layers and its own.
#pragma once
#include <string>

#include "core/cloudscape.h"

namespace cloudscape::settings {

// Lattice cells narrower than a texel hold no shape, only aliasing. `rule` tells how the cells of the last octave
// follow from what stands at the pointer. Throws InvalidInput.
void check_octaves(const std::string& pointer, double finest_cells, const char* rule, int resolution,
                   const char* resolution_key);

// Where each layer lies, the document's own too, and how fine its noise is. Throws InvalidInput.
void check_layers(const Cloudscape& cloudscape, const std::string& pointer);

}  // namespace cloudscape::settings
