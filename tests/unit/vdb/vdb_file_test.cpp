// OpenVDB files: what was written comes back, coarser ones keep their mass, and one sentence for each that is no
// volume.
#include "vdb/vdb_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <random>

#include "core/error.h"
#include "strange_files.h"
#include "tests/height_maps.h"

namespace cloudscape::vdb {
namespace {

using testing::HasSubstr;

class VdbFiles : public testing::Test {
 protected:
  fs::path path(const std::string& name = "a.vdb") const { return folder_.path() / name; }
  std::string refusal(const Wanted& wanted = {}) const {
    try {
      read(path(), wanted);
      return "";
    } catch (const UnusableFile& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
  }
  HeightMapFolder folder_;
};

double sum_of(const Voxels& voxels) { return std::accumulate(voxels.densities.begin(), voxels.densities.end(), 0.0); }

// Three slabs of 20 x 12 voxels; halves hold these values exactly.
std::vector<float> some_densities() {
  std::vector<float> densities;
  for (int i = 0; i < 20 * 12 * 24; ++i) densities.push_back(static_cast<float>((i * 37) % 64) / 64);
  return densities;
}

void write_some(const fs::path& file, UpAxis up = UpAxis::z) {
  Writer writer(25, {1000, -500, 800}, up);
  const std::vector<float> densities = some_densities();
  for (int z = 0; z < 24; z += 8) writer.add(z, 20, 12, std::span(densities).subspan(std::size_t(z) * 240, 8 * 240));
  writer.write(file, {{"creator", "a test"}}, {{"extinction_per_m", 0.06}});
}

TEST_F(VdbFiles, ComeBackAsTheyWereWritten) {
  for (const UpAxis up : {UpAxis::z, UpAxis::y}) {
    write_some(path(), up);
    const Voxels voxels = read(path(), {.up = up});
    EXPECT_EQ(voxels.size, glm::ivec3(20, 12, 24));
    EXPECT_EQ(voxels.densities, some_densities());
    EXPECT_LT(glm::distance(voxels.low, glm::dvec3(987.5, -512.5, 787.5)), 1e-9);
    EXPECT_LT(glm::distance(voxels.high, glm::dvec3(987.5 + 500, -512.5 + 300, 787.5 + 600)), 1e-9);
  }
}

TEST_F(VdbFiles, AreCutToTheirActiveVoxels) {
  Writer writer(1, {0, 0, 0}, UpAxis::z);
  std::vector<float> densities(10 * 10 * 2, 0.0F);
  densities[100 + 3 * 10 + 4] = 0.5F, densities[100 + 3 * 10 + 6] = 0.25F;
  writer.add(0, 10, 10, densities);
  writer.write(path(), {}, {});
  const Voxels voxels = read(path(), {});
  EXPECT_EQ(voxels.size, glm::ivec3(3, 1, 1));
  EXPECT_EQ(voxels.densities, (std::vector<float>{0.5F, 0, 0.25F}));
  EXPECT_EQ(voxels.low, glm::dvec3(3.5, 2.5, 0.5));
}

TEST_F(VdbFiles, MadeCoarserKeepTheirMass) {
  write_some(path());
  const double mass = sum_of(read(path(), {}));
  for (const int resolution : {24, 12, 10, 7, 1}) {
    const Voxels voxels = read(path(), {.resolution = resolution});
    EXPECT_EQ(std::max({voxels.size.x, voxels.size.y, voxels.size.z}), resolution);
    EXPECT_NEAR(sum_of(voxels) * (20.0 * 12 * 24) / static_cast<double>(count_of(voxels.size)) / mass, 1, 1e-4)
        << resolution;
    EXPECT_LT(glm::distance(voxels.low, glm::dvec3(987.5, -512.5, 787.5)), 1e-9);
  }
}

TEST_F(VdbFiles, MadeHalfAsFineAreMeansOfEight) {
  write_some(path());
  const Voxels fine = read(path(), {}), coarse = read(path(), {.resolution = 12});
  ASSERT_EQ(coarse.size, glm::ivec3(10, 6, 12));
  for (int z = 0; z < 12; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 10; ++x) {
        double mean = 0;
        for (int i = 0; i < 8; ++i)
          mean += fine.densities[static_cast<std::size_t>(((2 * z + (i >> 2)) * 12 + 2 * y + (i >> 1 & 1)) * 20 +
                                                          2 * x + (i & 1))] /
                  8;
        ASSERT_NEAR(coarse.densities[static_cast<std::size_t>((z * 6 + y) * 10 + x)], mean, 1e-6);
      }
}

TEST_F(VdbFiles, OfUnevenAndMirroredVoxelsLieWhereTheyAre) {
  write_scaled(path(), {-2, 3, 0.5}, {100, 200, 300});
  const Voxels voxels = read(path(), {});
  EXPECT_EQ(voxels.size, glm::ivec3(4, 2, 1));
  EXPECT_EQ(voxels.densities, (std::vector<float>{4, 3, 2, 1, 14, 13, 12, 11})) << "index 0 is the easternmost";
  EXPECT_LT(glm::distance(voxels.low, glm::dvec3(100 - 7, 200 - 1.5, 300 - 0.25)), 1e-9);
  EXPECT_LT(glm::distance(voxels.high, glm::dvec3(100 + 1, 200 + 4.5, 300 + 0.25)), 1e-9);
}

TEST_F(VdbFiles, MayHoldTilesDoublesAndOtherGrids) {
  write_tile(path(), 0.5F);
  const Voxels tile = read(path(), {.resolution = 16});
  EXPECT_EQ(tile.size, glm::ivec3(16, 2, 2));
  for (const float density : tile.densities) EXPECT_FLOAT_EQ(density, 0.5F);
  write_two_grids(path());
  EXPECT_EQ(read(path(), {}).densities, std::vector<float>{1});
  EXPECT_EQ(read(path(), {.grid = "heat"}).densities, std::vector<float>{2});
}

TEST_F(VdbFiles, WithoutAVolumeAreRefused) {
  write_two_grids(path());
  EXPECT_EQ(refusal({.grid = "smoke"}), "has no grid 'smoke': it has 'heat', 'density'");
  write_level_set(path());
  EXPECT_THAT(refusal(), HasSubstr("a level set"));
  write_vectors(path());
  EXPECT_THAT(refusal({.grid = "velocity"}), HasSubstr("no numbers but 'Tree_vec3s_5_4_3'"));
  write_nothing(path());
  EXPECT_THAT(refusal(), HasSubstr("no active voxel"));
  write_rotated(path());
  EXPECT_THAT(refusal(), HasSubstr("rotated"));
  folder_.write("a.vdb", "");
  EXPECT_THAT(refusal(), HasSubstr("no OpenVDB file"));
  folder_.write("a.vdb", "this is text, and longer than the magic number");
  EXPECT_THAT(refusal(), HasSubstr("no OpenVDB file"));
}

TEST_F(VdbFiles, OfImpossibleDensitiesAreRefused) {
  write_value(path(), -0.5F);
  EXPECT_THAT(refusal(), HasSubstr("negative"));
  for (const float value : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    write_value(path(), value);
    EXPECT_THAT(refusal(), HasSubstr("not finite"));
  }
}

TEST_F(VdbFiles, ThatSpanTooMuchAreRefusedBeforeTheyTakeMemory) {
  write_far_apart(path(), 60000);
  EXPECT_EQ(read(path(), {}).size, glm::ivec3(256, 1, 1)) << "much air is no matter";
  write_far_apart(path(), 2000000000);
  EXPECT_THAT(refusal(), HasSubstr("spans 2000000001 voxels"));
}

// Each length of the file, and then garbage: never more than a sentence.
TEST_F(VdbFiles, ThatAreCutOffAreRefused) {
  write_some(path());
  const std::string whole = folder_.read("a.vdb");
  for (std::size_t length = 0; length < whole.size(); length += 1 + length / 16) {
    folder_.write("a.vdb", whole.substr(0, length));
    EXPECT_THAT(refusal(), HasSubstr("write it anew")) << length;
  }
}

TEST_F(VdbFiles, ThatAreDamagedDoNoHarm) {
  write_some(path());
  const std::string whole = folder_.read("a.vdb");
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string damaged = whole;
    for (int j = 0; j < 3; ++j)
      damaged[random() % std::min<std::size_t>(damaged.size(), i % 2 ? 2500 : damaged.size())] =
          static_cast<char>(random() % 4 ? random() : 0xff);
    folder_.write("a.vdb", damaged);
    refused += !refusal().empty();
  }
  EXPECT_GT(refused, 200) << "most damage can be seen";
}

TEST_F(VdbFiles, ThatClaimMuchAreRefused) {
  write_some(path());
  const std::string whole = folder_.read("a.vdb");
  for (const char* claim : {"class", "density", "ScaleMap", "ScaleTranslateMap"}) {
    const std::size_t at = whole.find(claim);
    if (at == std::string::npos) continue;
    std::string lying = whole;
    lying[at - 1] = static_cast<char>(0xff);  // the highest byte of the length in front: 4 GiB
    folder_.write("a.vdb", lying);
    EXPECT_THAT(refusal(), HasSubstr("write it anew")) << claim;
  }
}

TEST_F(VdbFiles, ThatCannotBeWrittenAreTold) {
  Writer writer(1, {0, 0, 0}, UpAxis::z);
  EXPECT_THROW(writer.write(path("nowhere/a.vdb"), {}, {}), Error);
  EXPECT_FALSE(fs::exists(path("nowhere")));
}

}  // namespace
}  // namespace cloudscape::vdb
