// Hashes name values by what they say.
#include "core/content_hash.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "core/cloudscape.h"

namespace cloudscape {
namespace {

// FIPS 180-2, appendix B.1.
TEST(ContentHash, IsSha256) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(ContentHash, EqualValuesHaveEqualHashes) {
  Cloudscape a, b;
  EXPECT_EQ(content_hash(a), content_hash(b));
  a.wind.speed_m_per_s = 0.0;
  b.wind.speed_m_per_s = -0.0;
  EXPECT_EQ(content_hash(a), content_hash(b));
}

// Changes every number, name, flag and list of a described value, one at a time.
template <class T>
void change_each(T& value, const std::function<void()>& changed) {
  const T before = value;
  const auto now = [&](T other) { value = other, changed(), value = before; };
  if constexpr (Described<T>)
    T::fields(value, [&](std::string_view, auto& member, auto&&...) { change_each(member, changed); });
  else if constexpr (std::is_same_v<T, bool>)
    now(!value);
  else if constexpr (std::is_arithmetic_v<T>)
    now(value + 1);
  else if constexpr (std::is_enum_v<T>)
    now(static_cast<T>(static_cast<int>(value) + 1));
  else if constexpr (std::is_same_v<T, std::string>)
    now(value + "x");
  else if constexpr (std::is_same_v<T, std::optional<double>>)
    now(0.5);
  else if constexpr (std::is_same_v<T, std::optional<int>>)
    now(7);
  else if constexpr (std::is_same_v<T, std::vector<Tower>>)
    now({Tower{}}), now({Tower{}, Tower{}});
  else
    for (int i = 0; i < static_cast<int>(sizeof(T) / sizeof(value[0])); ++i) change_each(value[i], changed);
}

TEST(ContentHash, EveryFieldMatters) {
  Cloudscape sky;
  std::set<std::string> hashes{content_hash(sky)};
  std::size_t changes = 0;
  change_each(sky, [&] { hashes.insert(content_hash(sky)), ++changes; });
  EXPECT_GT(changes, 90u);
  EXPECT_EQ(hashes.size(), changes + 1);
  EXPECT_EQ(sky, Cloudscape{});
}

TEST(ContentHash, NeighbouringFieldsDoNotRunTogether) {
  Cloudscape a, b;
  a.title = "ab", a.description = "c";
  b.title = "a", b.description = "bc";
  EXPECT_NE(content_hash(a), content_hash(b));
  a = b = Cloudscape{};
  a.title = "1:x;description=0:";
  b.title = "1:x", b.description = "0:";
  EXPECT_NE(content_hash(a), content_hash(b));
}

TEST(ContentHash, TellsNeighbouringDoublesApart) {
  Cloudscape a, b;
  b.sky.haze = std::nextafter(a.sky.haze, 2.0);
  EXPECT_NE(content_hash(a), content_hash(b));
}

// The same on every machine and in every run: it is the key of caches on disk.
TEST(ContentHash, IsStable) {
  EXPECT_EQ(content_hash(Wind{8.0, 60.0, 0.0, 0.5}),
            sha256_hex("{speed_m_per_s=0x1p+3;towards_azimuth_deg=0x1.ep+5;shear_per_s=0x0p+0;"
                       "evolution_m_per_s=0x1p-1;}"));
  EXPECT_EQ(content_hash(Display{0.0, ToneCurve::agx, true, 0.0, 8.0, 0.5}),
            sha256_hex("{exposure_ev=0x0p+0;tone_curve=0;dither=1;bloom_strength=0x0p+0;bloom_threshold=0x1p+3;"
                       "bloom_radius=0x1p-1;}"));
}

}  // namespace
}  // namespace cloudscape
