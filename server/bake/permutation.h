// The permutation of 0..255 behind the Perlin noise.
#pragma once
#include <array>
#include <cstdint>

namespace cloudscape::bake {

// Seed 0: the table of the reference implementation (Perlin 2002). Else a shuffle of 0..255 that depends on the seed
// alone.
std::array<std::uint8_t, 256> permutation_table(std::uint32_t seed);

}  // namespace cloudscape::bake
