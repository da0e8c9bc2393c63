// Bakes on disk: what was kept comes back, what is damaged does not, and too much is thrown away.
#include "bake/cache.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "core/content_hash.h"
#include "fixture.h"

namespace cloudscape::bake {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre, testing::IsEmpty;

constexpr std::uint64_t plenty = 1ULL << 30;

// The right sizes, and bytes that differ from place to place.
BakedTexels made_up(std::uint32_t seed) {
  BakedTexels texels{tiny_recipe(seed), std::vector<std::uint8_t>(4), std::vector<std::uint8_t>(4),
                     std::vector<std::uint8_t>(8 * variation_resolution * variation_resolution)};
  std::uint8_t value = static_cast<std::uint8_t>(seed);
  for (auto* part : {&texels.shape, &texels.detail, &texels.variation})
    for (std::uint8_t& byte : *part) byte = value = static_cast<std::uint8_t>(value * 5 + 3);
  return texels;
}

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

class Cache : public testing::Test {
 protected:
  CacheFolder folder_;
  BakeCache cache_{folder_.path() / "deep" / "inside", plenty};
  BakedTexels texels_ = made_up(1);
  fs::path path_ = cache_.path_of(texels_.recipe);

  void expect_refused(const std::string& file) {
    write(path_, file);
    EXPECT_FALSE(cache_.load(texels_.recipe));
    EXPECT_FALSE(fs::exists(path_));
  }
};

TEST_F(Cache, GivesBackWhatWasStored) {
  EXPECT_FALSE(cache_.load(texels_.recipe));
  cache_.store(texels_);
  EXPECT_EQ(cache_.load(texels_.recipe), texels_);
  EXPECT_EQ(BakeCache(folder_.path() / "deep" / "inside", plenty).load(texels_.recipe), texels_);
  EXPECT_FALSE(cache_.load(tiny_recipe(2)));
}

TEST_F(Cache, LeavesOneFileNamedByTheKey) {
  cache_.store(texels_);
  cache_.store(texels_);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_.parent_path())) names.push_back(entry.path().filename());
  EXPECT_THAT(names, ElementsAre(bake_key(texels_.recipe) + ".bake"));
}

TEST_F(Cache, NoticesADamagedByteAnywhere) {
  cache_.store(texels_);
  const std::string good = read(path_);
  for (const std::size_t at : {std::size_t{0}, std::size_t{20}, std::size_t{82}, good.size() / 2, good.size() - 1}) {
    std::string damaged = good;
    damaged[at] ^= 1;
    if (at == 82) continue;  // the newline between digest and texels says nothing
    SCOPED_TRACE(at);
    expect_refused(damaged);
  }
}

TEST_F(Cache, NoticesATruncatedFile) {
  cache_.store(texels_);
  const std::string good = read(path_);
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, std::size_t{60}, std::size_t{83}, good.size() - 1})
    expect_refused(good.substr(0, size));
  expect_refused(good + "x");
}

// Such a file is whole, but not what the recipe asks for.
TEST_F(Cache, NoticesAWrongSize) {
  cache_.store(texels_);
  const std::string payload(1000, 'x');
  expect_refused(read(path_).substr(0, 18) + sha256_hex(payload) + "\n" + payload);
}

TEST_F(Cache, KeepsNothingWithoutAFolder) {
  const BakeCache none("", plenty);
  none.store(texels_);
  EXPECT_FALSE(none.load(texels_.recipe));
}

TEST_F(Cache, DoesWithoutAFolderThatCannotBeMade) {
  write(folder_.path() / "file", "in the way");
  const BakeCache blocked(folder_.path() / "file" / "cache", plenty);
  blocked.store(texels_);
  EXPECT_FALSE(blocked.load(texels_.recipe));
}

TEST_F(Cache, LeavesNoUnfinishedFileWhenTheDiskIsFull) {
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit little{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  cache_.store(texels_);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(fs::is_empty(path_.parent_path()));
  EXPECT_FALSE(cache_.load(texels_.recipe));
}

TEST_F(Cache, RemovesWhatAKilledProcessLeftAnHourAgo) {
  const fs::path old_file = folder_.path() / "a.bake.tmp123", new_file = folder_.path() / "b.bake.tmp124";
  write(old_file, "half a bake");
  write(new_file, "half a bake");
  fs::last_write_time(old_file, fs::file_time_type::clock::now() - std::chrono::hours(2));
  const BakeCache cache(folder_.path(), plenty);
  EXPECT_FALSE(fs::exists(old_file));
  EXPECT_TRUE(fs::exists(new_file)) << "another process may be writing it";
}

TEST_F(Cache, ThrowsAwayTheLeastRecentlyUsed) {
  const BakeCache small(folder_.path() / "small", 300000);  // two files of 131 kB
  const auto hours_ago = [](int hours) { return fs::file_time_type::clock::now() - std::chrono::hours(hours); };
  small.store(made_up(1));
  small.store(made_up(2));
  fs::last_write_time(small.path_of(tiny_recipe(1)), hours_ago(2));
  fs::last_write_time(small.path_of(tiny_recipe(2)), hours_ago(1));
  EXPECT_TRUE(small.load(tiny_recipe(1)));  // now the second is the one longest unused
  small.store(made_up(3));
  EXPECT_TRUE(small.load(tiny_recipe(1)));
  EXPECT_FALSE(small.load(tiny_recipe(2)));
  EXPECT_TRUE(small.load(tiny_recipe(3)));
}

TEST_F(Cache, ThrowsAwayOnlyBakes) {
  const BakeCache small(folder_.path() / "small", 1);
  write(folder_.path() / "small" / "notes.txt", std::string(1000, 'x'));
  small.store(texels_);
  EXPECT_FALSE(small.load(texels_.recipe));
  EXPECT_TRUE(fs::exists(folder_.path() / "small" / "notes.txt"));
}

}  // namespace
}  // namespace cloudscape::bake
