// OpenVDB files that the program itself never writes.
#pragma once
#include <filesystem>
#include <glm/vec3.hpp>

namespace cloudscape::vdb {

namespace fs = std::filesystem;

void write_level_set(const fs::path& file);
void write_vectors(const fs::path& file);                  // grid "velocity"
void write_two_grids(const fs::path& file);                // "heat" of 2 and "density" of 1, a voxel each; doubles
void write_nothing(const fs::path& file);                  // "density" without an active voxel
void write_value(const fs::path& file, float value);       // one voxel
void write_far_apart(const fs::path& file, int distance);  // two voxels
void write_rotated(const fs::path& file);
void write_tile(const fs::path& file, float value);  // 64 x 8 x 8 voxels, none of them in a leaf
// 4 x 2 x 1 voxels of 1 + i + 10 j, in voxels of `scale`, index (0, 0, 0) at `origin`.
void write_scaled(const fs::path& file, const glm::dvec3& scale, const glm::dvec3& origin);

}  // namespace cloudscape::vdb
