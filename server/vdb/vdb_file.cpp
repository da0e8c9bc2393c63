#include "vdb/vdb_file.h"

#ifdef CLOUDSCAPE_VDB
#include <openvdb/io/File.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include <array>
#include <cmath>
#include <mutex>
#include <new>
#include <sstream>
#include <system_error>

#include "core/error.h"
#include "vdb/one_grid.h"

namespace cloudscape::vdb {
namespace {

namespace fs = std::filesystem;

void initialize() {
  static std::once_flag once;
  std::call_once(once, [] { openvdb::initialize(); });
}

// Of one of our axes: how the voxels of the file lie along it, and what part of each goes into which voxel of the
// result.
struct Axis {
  int file_axis = 0;
  bool reversed = false;
  std::int64_t first = 0;  // lowest index in the file
  int voxels = 0, result = 0;
  double low = 0, high = 0;  // in the file's units

  double ratio() const { return static_cast<double>(voxels) / result; }
  // Voxels from `begin` to `end` (indices of the file, both included) in voxels of the result, [x, y).
  std::pair<double, double> span(std::int64_t begin, std::int64_t end) const {
    const auto from_low = static_cast<double>(reversed ? voxels - 1 - (end - first) : begin - first);
    return {from_low / ratio(), (from_low + static_cast<double>(end - begin + 1)) / ratio()};
  }
};

using Axes = std::array<Axis, 3>;

// Adds a value to all voxels of the result that a box of the file's voxels covers, each by the share that it covers.
void add(Voxels& voxels, const Axes& axes, const openvdb::CoordBBox& box, float value) {
  std::array<std::pair<double, double>, 3> spans;
  std::array<int, 3> first{}, last{};
  for (std::size_t i = 0; i < 3; ++i) {
    spans[i] = axes[i].span(box.min()[axes[i].file_axis], box.max()[axes[i].file_axis]);
    first[i] = static_cast<int>(spans[i].first + 1e-9);
    last[i] = std::min(static_cast<int>(std::ceil(spans[i].second - 1e-9)), axes[i].result) - 1;
  }
  const auto share = [&](std::size_t axis, int cell) {
    return std::min(spans[axis].second, cell + 1.0) - std::max<double>(spans[axis].first, cell);
  };
  for (int z = first[2]; z <= last[2]; ++z)
    for (int y = first[1]; y <= last[1]; ++y) {
      const auto row =
          (static_cast<std::size_t>(z) * static_cast<std::size_t>(axes[1].result) + static_cast<std::size_t>(y)) *
          static_cast<std::size_t>(axes[0].result);
      const double of_row = value * share(2, z) * share(1, y);
      for (int x = first[0]; x <= last[0]; ++x)
        voxels.densities[row + static_cast<std::size_t>(x)] += static_cast<float>(of_row * share(0, x));
    }
}

float checked(double value) {
  if (!std::isfinite(value) || value > std::numeric_limits<float>::max())
    throw UnusableFile("holds densities that are not finite: repair it in the program that made it");
  if (value < 0) throw UnusableFile("holds negative densities: clamp them in the program that made it");
  return static_cast<float>(value);
}

template <class Tree>
void add_all(Voxels& voxels, const Axes& axes, const Tree& tree) {
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (auto value = leaf->cbeginValueOn(); value; ++value)
      add(voxels, axes, openvdb::CoordBBox(value.getCoord(), value.getCoord()), checked(static_cast<double>(*value)));
  auto tile = tree.cbeginValueOn();
  tile.setMaxDepth(Tree::ValueOnCIter::LEAF_DEPTH - 1);
  for (; tile; ++tile) {
    openvdb::CoordBBox box;
    tile.getBoundingBox(box);
    add(voxels, axes, box, checked(static_cast<double>(*tile)));
  }
}

// Scale and translation of each of the file's axes.
struct Placement {
  openvdb::Vec3d scale, translation;
};

Placement placement_of(const openvdb::math::Transform& transform) {
  const auto map = transform.isLinear() ? transform.baseMap()->getAffineMap() : nullptr;
  if (!map) throw UnusableFile("lies in a frustum: resample its grid into cubic voxels");
  const openvdb::Mat4d matrix = map->getMat4();
  Placement placement{{matrix[0][0], matrix[1][1], matrix[2][2]}, matrix.getTranslation()};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i != j && !(std::abs(matrix[i][j]) <= 1e-6 * std::abs(placement.scale[i])))
        throw UnusableFile("is rotated or sheared by its transform: resample its grid along the axes");
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(placement.scale[i]) || placement.scale[i] == 0 || !std::isfinite(placement.translation[i]))
      throw UnusableFile("has a transform that is not finite or flat: write it anew");
  return placement;
}

// Our axis i is the file's, and in the same direction or not.
constexpr std::array<std::pair<int, int>, 3> axes_of(UpAxis up) {
  if (up == UpAxis::y) return {{{0, 1}, {2, -1}, {1, 1}}};
  return {{{0, 1}, {1, 1}, {2, 1}}};
}

Axes axes_of(const openvdb::CoordBBox& box, const Placement& placement, const Wanted& wanted) {
  Axes axes;
  int longest = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [file_axis, sign] = axes_of(wanted.up)[i];
    const std::int64_t first = box.min()[file_axis], last = box.max()[file_axis];
    if (last - first >= max_extent)
      throw UnusableFile("spans " + std::to_string(last - first + 1) + " voxels: crop its grid to at most " +
                         std::to_string(max_extent) + " a side");
    const double scale = sign * placement.scale[file_axis], zero = sign * placement.translation[file_axis];
    const double a = zero + scale * (static_cast<double>(scale < 0 ? last : first) - (scale < 0 ? -0.5 : 0.5));
    Axis& axis = axes[i];
    axis = {file_axis, scale < 0, first, static_cast<int>(last - first + 1), 0, a, 0};
    axis.high = axis.low + std::abs(scale) * axis.voxels;
    longest = std::max(longest, axis.voxels);
  }
  const double ratio = std::max(1.0, static_cast<double>(longest) / wanted.resolution);
  for (Axis& axis : axes) axis.result = std::max(1, static_cast<int>(std::lround(axis.voxels / ratio)));
  return axes;
}

template <class Grid>
Voxels voxels_of(const Grid& grid, const Wanted& wanted) {
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  if (grid.empty() || box.empty()) throw UnusableFile("is empty: its grid '" + wanted.grid + "' has no active voxel");
  const Axes axes = axes_of(box, placement_of(grid.transform()), wanted);
  Voxels voxels;
  for (int i = 0; i < 3; ++i) {
    const Axis& axis = axes[static_cast<std::size_t>(i)];
    voxels.size[i] = axis.result, voxels.low[i] = axis.low, voxels.high[i] = axis.high;
  }
  voxels.densities.assign(count_of(voxels.size), 0.0F);
  add_all(voxels, axes, grid.tree());
  return voxels;
}

// OpenVDB does not look whether there was something to read: the stream does.
openvdb::GridBase::Ptr grid_in(OneGrid one) {
  std::istringstream in(std::move(one.bytes));
  in.exceptions(std::ios::badbit | std::ios::failbit | std::ios::eofbit);
  openvdb::io::Stream stream(in, false);
  const auto grids = stream.getGrids();
  if (!grids || grids->size() != 1) throw UnusableFile("is damaged: write it anew");
  return grids->front();
}

Voxels read_checked(const fs::path& file, const Wanted& wanted) {
  OneGrid one = one_grid(file, wanted.grid);
  if (one.grid_class == "level set")
    throw UnusableFile("holds in its grid '" + wanted.grid +
                       "' a level set, distances from a surface: convert it to a fog volume");
  const openvdb::GridBase::Ptr grid = grid_in(std::move(one));
  if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) return voxels_of(*floats, wanted);
  if (const auto doubles = openvdb::gridPtrCast<openvdb::DoubleGrid>(grid)) return voxels_of(*doubles, wanted);
  throw UnusableFile("holds no floats: write it with a grid of floats");
}

}  // namespace

bool is_built_in() { return true; }

Voxels read(const fs::path& file, const Wanted& wanted) {
  initialize();
  try {
    return read_checked(file, wanted);
  } catch (const UnusableFile&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw UnusableFile("needs more memory than there is: crop it or make it coarser");
  } catch (const std::exception&) {  // its text is for programmers
    throw UnusableFile("is damaged or cut off: write it anew");
  }
}

struct Writer::State {
  openvdb::FloatGrid::Ptr grid = openvdb::FloatGrid::create(0.0F);
  openvdb::FloatGrid::Accessor voxels = grid->getAccessor();
  UpAxis up = UpAxis::z;

  openvdb::Coord coordinate(int x, int y, int z) const {
    return up == UpAxis::y ? openvdb::Coord(x, z, -y) : openvdb::Coord(x, y, z);
  }
};

Writer::Writer(double voxel_m, const glm::dvec3& first_m, UpAxis up) {
  initialize();
  state_ = std::make_unique<State>();
  state_->up = up;
  auto transform = openvdb::math::Transform::createLinearTransform(voxel_m);
  transform->postTranslate(up == UpAxis::y ? openvdb::Vec3d(first_m.x, first_m.z, -first_m.y)
                                           : openvdb::Vec3d(first_m.x, first_m.y, first_m.z));
  state_->grid->setTransform(transform);
  state_->grid->setName("density");
  state_->grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  state_->grid->setSaveFloatAsHalf(true);
}

Writer::~Writer() = default;

void Writer::add(int z, int width, int height, std::span<const float> densities) {
  const auto plane = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < densities.size(); ++i) {
    if (densities[i] <= 0) continue;
    const auto in_plane = static_cast<int>(i % plane);
    const int slice = z + static_cast<int>(i / plane);
    state_->voxels.setValueOn(state_->coordinate(in_plane % width, in_plane / width, slice), densities[i]);
  }
}

void Writer::write(const fs::path& file, const std::map<std::string, std::string>& texts,
                   const std::map<std::string, double>& numbers) {
  for (const auto& [name, number] : numbers)
    state_->grid->insertMeta(name, openvdb::FloatMetadata(static_cast<float>(number)));
  openvdb::MetaMap metadata;
  for (const auto& [name, text] : texts) metadata.insertMeta(name, openvdb::StringMetadata(text));
  const fs::path unfinished = file.string() + ".unfinished";
  std::error_code error;
  try {
    openvdb::io::File out(unfinished.string());
    out.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);  // all readers know these
    out.write({state_->grid}, metadata);
    out.close();
    one_grid(unfinished, state_->grid->getName());  // a full disk would else go unnoticed
    fs::rename(unfinished, file, error);
    if (!error) return;
  } catch (const openvdb::Exception&) {
  } catch (const UnusableFile&) {
  }
  fs::remove(unfinished, error);
  throw Error("cannot write " + file.string() + ": is the folder there, and the disk not full?");
}

}  // namespace cloudscape::vdb
#endif
