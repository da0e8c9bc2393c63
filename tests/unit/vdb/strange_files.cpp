#include "strange_files.h"

#include <openvdb/openvdb.h>

#include <limits>

namespace cloudscape::vdb {
namespace {

using openvdb::Coord;

template <class Grid = openvdb::FloatGrid>
typename Grid::Ptr grid_of(const char* name = "density") {
  openvdb::initialize();
  auto grid = Grid::create();
  grid->setName(name);
  return grid;
}

void write(const fs::path& path, const openvdb::GridPtrVec& grids) {
  openvdb::io::File file(path.string());
  file.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
  file.write(grids);
}

}  // namespace

void write_level_set(const fs::path& file) {
  const auto grid = grid_of();
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->tree().setValueOn(Coord(0, 0, 0), -1.0F);
  write(file, {grid});
}

void write_vectors(const fs::path& file) {
  const auto grid = grid_of<openvdb::Vec3SGrid>("velocity");
  grid->tree().setValueOn(Coord(0, 0, 0), openvdb::Vec3s(1, 2, 3));
  write(file, {grid});
}

void write_two_grids(const fs::path& file) {
  const auto heat = grid_of<openvdb::DoubleGrid>("heat"), density = grid_of<openvdb::DoubleGrid>();
  heat->tree().setValueOn(Coord(0, 0, 0), 2);
  density->tree().setValueOn(Coord(0, 0, 0), 1);
  write(file, {heat, density});
}

void write_nothing(const fs::path& file) { write(file, {grid_of()}); }

void write_value(const fs::path& file, float value) {
  const auto grid = grid_of();
  grid->tree().setValueOn(Coord(0, 0, 0), value);
  write(file, {grid});
}

void write_far_apart(const fs::path& file, int distance) {
  const auto grid = grid_of();
  grid->tree().setValueOn(Coord(0, 0, 0), 1);
  grid->tree().setValueOn(Coord(distance, 0, 0), 1);
  write(file, {grid});
}

void write_rotated(const fs::path& file) {
  const auto grid = grid_of();
  grid->tree().setValueOn(Coord(0, 0, 0), 1);
  auto transform = openvdb::math::Transform::createLinearTransform(1);
  transform->postRotate(0.3, openvdb::math::X_AXIS);
  grid->setTransform(transform);
  write(file, {grid});
}

void write_tile(const fs::path& file, float value) {
  const auto grid = grid_of();
  for (int i = 0; i < 8; ++i) grid->tree().addTile(1, Coord(8 * i, 0, 0), value, true);
  write(file, {grid});
}

void write_scaled(const fs::path& file, const glm::dvec3& scale, const glm::dvec3& origin) {
  const auto grid = grid_of();
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 4; ++i) grid->tree().setValueOn(Coord(i, j, 0), static_cast<float>(1 + i + 10 * j));
  auto transform = openvdb::math::Transform::createLinearTransform();
  transform->preScale(openvdb::Vec3d(scale.x, scale.y, scale.z));
  transform->postTranslate(openvdb::Vec3d(origin.x, origin.y, origin.z));
  grid->setTransform(transform);
  write(file, {grid});
}

}  // namespace cloudscape::vdb
