// What the textures of a volume from a file depend on.
#pragma once
#include <array>
#include <filesystem>
#include <string>

#include "core/cloudscape.h"
#include "core/file_stamp.h"

namespace cloudscape::bake {

struct GridRecipe {
  std::string file;  // "": the volume is not from a file
  FileStamp stamp;   // so that a file that was changed is read again
  bool vdb = false;
  std::string name;           // of the grid in a .vdb
  std::array<int, 3> size{};  // of a .raw or .exr
  int resolution = 0;         // of a .vdb
  bool tiling = false;
  VoxelInterpolation interpolation = VoxelInterpolation::linear;
  UpAxis up = UpAxis::z;
  bool operator==(const GridRecipe&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("file", self.file, Limits{}, "");
    visit("stamp", self.stamp, Limits{}, "");
    visit("vdb", self.vdb, Limits{}, "");
    visit("name", self.name, Limits{}, "");
    visit("size", self.size, Limits{}, "");
    visit("resolution", self.resolution, Limits{}, "");
    visit("tiling", self.tiling, Limits{}, "");
    visit("interpolation", self.interpolation, Limits{}, "");
    visit("up", self.up, Limits{}, "");
  }
};

// Of a volume from a file of `folder` ("": there is none). A file that is missing is found out when it is read.
GridRecipe grid_recipe(const Volume& volume, const std::filesystem::path& folder);

}  // namespace cloudscape::bake
