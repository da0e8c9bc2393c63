// Field descriptions, embedded files, errors and the log: what everything else stands on.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/cloudscape.h"
#include "core/embedded.h"
#include "core/error.h"
#include "core/frame.h"
#include "core/log.h"

namespace cloudscape {
namespace {

static_assert(Described<Cloudscape> && Described<Tower> && Described<View>);
static_assert(!Described<std::string> && !Described<glm::dvec3> && !Described<double>);

// Calls visit(value, limits) for every number of a described value.
template <class T>
void each_number(const T& value, const Limits& limits, auto&& visit) {
  if constexpr (Described<T>)
    T::fields(value, [&](std::string_view, const auto& member, const Limits& inner, auto&&) {
      each_number(member, inner, visit);
    });
  else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)
    visit(static_cast<double>(value), limits);
  else if constexpr (std::is_same_v<T, glm::dvec3> || std::is_same_v<T, glm::dvec2>)
    for (int i = 0; i < value.length(); ++i) visit(value[i], limits);
  else if constexpr (std::is_same_v<T, std::array<NoiseChannel, 4>>)
    for (const auto& channel : value) each_number(channel, {}, visit);
}

TEST(Fields, DefaultsLieWithinTheirLimits) {
  int numbers = 0;
  const auto check = [&](double value, const Limits& limits) {
    EXPECT_GE(value, limits.min);
    EXPECT_LE(value, limits.max);
    EXPECT_LT(limits.min, limits.max);
    EXPECT_TRUE(!limits.power_of_two || std::exp2(std::round(std::log2(value))) == value) << value;
    ++numbers;
  };
  each_number(Cloudscape{}, {}, check);
  each_number(Tower{}, {}, check);
  EXPECT_GT(numbers, 80);
}

template <class T>
void check_descriptions(const T& value) {
  std::set<std::string_view> names;
  T::fields(value, [&](std::string_view name, const auto& member, auto&&, std::string_view meaning) {
    EXPECT_TRUE(names.insert(name).second) << name << " stands twice";
    EXPECT_EQ(meaning.back(), '.') << name;
    if constexpr (Described<std::remove_cvref_t<decltype(member)>>) check_descriptions(member);
  });
}

TEST(Fields, HaveNamesOfTheirOwnAndSentences) {
  check_descriptions(Cloudscape{});
  check_descriptions(Tower{});
  check_descriptions(NoiseChannel{});
}

TEST(Fields, EnumeratorsHaveTheirNames) {
  EXPECT_EQ(name_of(PhaseKind::two_lobe), "two-lobe");
  EXPECT_EQ(name_of(Quality::reference), "reference");
  EXPECT_EQ(name_of(ExrType::float32), "float");
}

TEST(Embedded, FindsFilesByPath) {
  const EmbeddedFile table[]{{"a/b.txt", "text"}, {"empty", ""}};
  EXPECT_EQ(find(table, "a/b.txt")->bytes, "text");
  EXPECT_EQ(find(table, "empty")->bytes, "");
  EXPECT_EQ(find(table, "b.txt"), nullptr);
  EXPECT_EQ(find({}, "a/b.txt"), nullptr);
}

TEST(Errors, InvalidInputOpensWithItsPointer) {
  const InvalidInput with("/a/b", "is 1: must be 2"), without("", "the whole is wrong");
  EXPECT_STREQ(with.what(), "/a/b is 1: must be 2");
  EXPECT_EQ(with.pointer, "/a/b");
  EXPECT_STREQ(without.what(), "the whole is wrong");
}

TEST(Log, RefusesUnknownLevels) {
  EXPECT_THROW(log::start("loud"), InvalidInput);
  EXPECT_THROW(log::start(""), InvalidInput);
}

}  // namespace
}  // namespace cloudscape
