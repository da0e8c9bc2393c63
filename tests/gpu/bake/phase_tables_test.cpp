// Phase tables at hand: computed beside the frames, kept on disk and in memory.
#include "bake/phase_tables.h"

#include <numbers>
#include <thread>

#include "bake/mie_phase.h"
#include "fixture.h"

namespace cloudscape::bake {
namespace {

constexpr std::uint64_t plenty = 1ULL << 30;
constexpr double sun_deg = 0.268;
constexpr PhaseRecipe haze{.effective_radius_um = 1.25};  // quick to compute
constexpr PhaseRecipe drizzle{.effective_radius_um = 50, .effective_variance = 0.5};

class Phases : public gpu::GpuTest {
 protected:
  std::shared_ptr<const PhaseTexture> wait_for(PhaseTables& tables, const PhaseRecipe& recipe) {
    for (;;)
      if (auto texture = tables.find(recipe, sun_deg)) return texture;
  }
  PhaseCache cache() const { return PhaseCache(KeptFiles(folder_.path(), plenty)); }
  CacheFolder folder_;
};

TEST_F(Phases, AreComputedBesideTheCaller) {
  PhaseTables tables{PhaseCache(KeptFiles({}, 0))};
  EXPECT_FALSE(tables.find(drizzle, sun_deg)) << "it takes seconds, and nobody waited";
  EXPECT_EQ(tables.jobs(), 1U);
  EXPECT_FALSE(tables.find(drizzle, sun_deg));
  EXPECT_EQ(tables.jobs(), 1U) << "asking again starts nothing";
  EXPECT_TRUE(wait_for(tables, haze)) << "another sky need not wait for it";
}

TEST_F(Phases, TheTextureIsTheTableAsTheSunShowsIt) {
  PhaseTables tables{PhaseCache(KeptFiles({}, 0))};
  const auto phase = wait_for(tables, haze);
  const PhaseTable table = seen_by_disc(*mie_phase_table(haze), sun_deg * std::numbers::pi / 180);
  EXPECT_EQ(phase->mean_asymmetry_g, table.mean_asymmetry_g());
  const std::vector<std::uint8_t> bytes = phase->texture.download();
  const auto* texels = reinterpret_cast<const float*>(bytes.data());
  ASSERT_EQ(bytes.size(), 4 * sizeof(float) * phase_table_texels);
  for (std::size_t i = 0; i < phase_table_texels; i += 64)
    for (std::size_t colour = 0; colour < 3; ++colour)
      EXPECT_EQ(texels[4 * i + colour], static_cast<float>(table.phase_per_sr[colour][i]));
}

TEST_F(Phases, AreRemembered) {
  PhaseTables tables{PhaseCache(KeptFiles({}, 0))};
  const auto first = wait_for(tables, haze);
  EXPECT_EQ(tables.find(haze, sun_deg), first);
  const auto wide = tables.find(haze, 2);
  EXPECT_TRUE(wide) << "another sun needs no other table";
  EXPECT_NE(wide, first);
}

TEST_F(Phases, ComeBackFromTheDisk) {
  {
    PhaseTables tables{cache()};
    wait_for(tables, haze);
  }
  PhaseTables tables{cache()};
  EXPECT_TRUE(tables.find(haze, sun_deg));
  EXPECT_EQ(tables.jobs(), 0U);
  EXPECT_EQ(cache().load(haze), mie_phase_table(haze));
  EXPECT_FALSE(cache().load(drizzle));
}

TEST_F(Phases, AreComputedAnewWhereTheFileIsDamaged) {
  const PhaseTable table = *mie_phase_table(haze, {.radii = 50});
  cache().store(table);
  const auto path = cache().path_of(haze);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_FALSE(cache().load(haze));
  EXPECT_FALSE(std::filesystem::exists(path));
  cache().store(table);
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(2000).put('x').put('y');
  EXPECT_FALSE(cache().load(haze));
  PhaseTables tables{cache()};
  EXPECT_TRUE(wait_for(tables, haze));
  EXPECT_EQ(cache().load(haze), mie_phase_table(haze));
}

TEST_F(Phases, NoMoreThanTwoAreComputedAtATime) {
  PhaseTables tables{PhaseCache(KeptFiles({}, 0))};
  for (const double variance : {0.4, 0.41, 0.42, 0.43})
    EXPECT_FALSE(tables.find({.effective_radius_um = 50, .effective_variance = variance}, sun_deg));
  EXPECT_EQ(tables.jobs(), 2U);
}  // and what is unfinished is given up here, not waited for

TEST_F(Phases, WhatNobodyAsksForAnyMoreMakesRoom) {
  PhaseTables tables{PhaseCache(KeptFiles({}, 0))};
  for (const double variance : {0.4, 0.41})
    tables.find({.effective_radius_um = 50, .effective_variance = variance}, sun_deg);
  std::this_thread::sleep_for(std::chrono::milliseconds(2100));
  EXPECT_TRUE(wait_for(tables, haze));
}

}  // namespace
}  // namespace cloudscape::bake
