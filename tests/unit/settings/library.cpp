// The named documents: presets, a folder's files, and what was put there.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "settings/cloudscape_json.h"
#include "settings/text_file.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Library : public testing::Test {
 protected:
  Library() : folder(fs::temp_directory_path() / ("cloudscape-library-" + std::to_string(::getpid()))) {
    fs::remove_all(folder);
  }
  ~Library() override { fs::remove_all(folder); }
  void write_file(const std::string& name, const std::string& text) const {
    fs::create_directories(folder);
    std::ofstream(folder / name) << text;
  }
  static bool has(const CloudscapeLibrary& library, const std::string& name) {
    for (const auto& entry : library.list())
      if (entry.name == name) return true;
    return false;
  }
  fs::path folder;
};

TEST_F(Library, HoldsPresetsThatIntroduceThemselves) {
  const CloudscapeLibrary library{{}};
  for (const char* name :
       {"alpine-morning", "fair-weather-cumulus", "towering-congestus", "stratocumulus-deck", "sunset-broken",
        "morning-puffs", "overcast", "ocean-evening", "mountain-lakes", "mackerel-sky"}) {
    EXPECT_TRUE(has(library, name)) << name;
    EXPECT_EQ(library.text(name).substr(0, 3), "// ") << name << " opens with a sentence about its sky";
  }
  for (const auto& entry : library.list()) {
    EXPECT_TRUE(entry.preset);
    EXPECT_NE(entry.title, "") << entry.name;
    EXPECT_NE(entry.description, "") << entry.name;
    EXPECT_NE(library.get(entry.name)->view, View{}) << entry.name << " has a view of its own";
  }
}

TEST_F(Library, ReadsTheFilesOfItsFolderAndLeavesOutBrokenOnes) {
  write_file("mine.json", R"(// my sky
{"title": "Mine"})");
  write_file("broken.json", R"({"seed": -1})");
  write_file("Bad Name.json", "{}");
  write_file("notes.txt", "{}");
  write_file("overcast.json", R"({"title": "Not the preset"})");
  write_file("long.json", std::string(300 * 1024, ' ') + "{}");
  fs::create_directories(folder / "a-folder.json");
  const CloudscapeLibrary library{folder};
  EXPECT_EQ(library.get("mine")->title, "Mine");
  EXPECT_THAT(library.text("mine"), HasSubstr("// my sky"));
  EXPECT_EQ(library.get("overcast")->title, "Overcast");
  EXPECT_EQ(library.list().size(), 1 + CloudscapeLibrary({}).list().size());
}

TEST_F(Library, PutsLiveOnInTheFolder) {
  const std::string text = "// kept\n{\"title\": \"First\"}";
  {
    CloudscapeLibrary library{folder};
    EXPECT_TRUE(library.put("new-sky", text));
    EXPECT_FALSE(library.put("new-sky", "{\"title\": \"Second\"}"));
    EXPECT_FALSE(library.put("new-sky", text));
  }
  CloudscapeLibrary again{folder};
  EXPECT_EQ(again.text("new-sky"), text);
  EXPECT_EQ(again.get("new-sky")->title, "First");
  EXPECT_TRUE(again.remove("new-sky"));
  EXPECT_FALSE(fs::exists(folder / "new-sky.json"));
  EXPECT_TRUE(fs::is_empty(folder)) << "no partial files stay";
  EXPECT_FALSE(has(CloudscapeLibrary{folder}, "new-sky"));
}

TEST_F(Library, KeepsTheOldDocumentWhereTheNewOneIsRefused) {
  CloudscapeLibrary library{folder};
  library.put("sky", R"({"title": "Old"})");
  EXPECT_EQ(refusal([&] { library.put("sky", R"({"sky": {"haze": -1}})"); }).pointer, "/sky/haze");
  EXPECT_EQ(library.get("sky")->title, "Old");
  EXPECT_EQ(CloudscapeLibrary{folder}.get("sky")->title, "Old");
}

TEST_F(Library, NamesCannotLeaveTheFolder) {
  CloudscapeLibrary library{folder};
  for (const std::string& name :
       {std::string("../x"), std::string("a/b"), std::string(""), std::string("."), std::string("A"), std::string("1a"),
        std::string("a.b"), std::string("a_b"), std::string("a\0b", 3), std::string(65, 'a'), std::string("ü")}) {
    EXPECT_EQ(refusal([&] { library.put(name, "{}"); }).pointer, "/name") << name;
    EXPECT_THROW(library.remove(name), NotFound) << name;
  }
  EXPECT_TRUE(library.put(std::string(64, 'a'), "{}"));
  EXPECT_TRUE(library.put("a-1", "{}"));
}

TEST_F(Library, PresetsStayAsTheyAre) {
  CloudscapeLibrary library{folder};
  EXPECT_EQ(refusal([&] { library.put("overcast", "{}"); }).sentence,
            R"(/name is "overcast": a preset, which cannot be changed; choose another name)");
  EXPECT_THROW(library.remove("overcast"), InvalidInput);
  EXPECT_TRUE(has(library, "overcast"));
}

TEST_F(Library, UnknownNamesGetTheNearestKnown) {
  CloudscapeLibrary library{{}};
  EXPECT_EQ(refusal<NotFound>([&] { library.get("sunset"); }).sentence,
            R"(there is no cloudscape "sunset": did you mean sunset-broken?)");
  EXPECT_THAT(refusal<NotFound>([&] { library.text("zzz"); }).sentence, HasSubstr("known are alpine-morning"));
  EXPECT_THROW(library.remove("zzz"), NotFound);
}

TEST_F(Library, IsBounded) {
  CloudscapeLibrary library{{}};
  for (int i = 0; i < 256; ++i) library.put("sky-" + std::to_string(i), "{}");
  EXPECT_THROW(library.put("one-more", "{}"), OverLimit);
  EXPECT_FALSE(library.put("sky-7", R"({"seed": 2})")) << "replacing needs no room";
  library.remove("sky-3");
  EXPECT_TRUE(library.put("one-more", "{}"));
  EXPECT_THROW(library.put("sky-7", std::string(256 * 1024, ' ') + "{}"), OverLimit);
}

TEST_F(Library, AFolderThatCannotBeWrittenIsOneSentence) {
  write_file("in-the-way", "");
  CloudscapeLibrary library{folder / "in-the-way"};
  EXPECT_THAT(refusal<Error>([&] { library.put("sky", "{}"); }).sentence, HasSubstr("in-the-way"));
  EXPECT_FALSE(has(library, "sky")) << "what is not stored is not there";
}

TEST_F(Library, ServesManyThreads) {
  CloudscapeLibrary library{{}};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&library, name = "sky-" + std::to_string(i)] {
      for (int round = 0; round < 50; ++round) {
        library.put(name, R"({"seed": )" + std::to_string(round) + "}");
        EXPECT_EQ(library.get(name)->seed, static_cast<unsigned>(round));
        library.list();
      }
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(library.list().size(), 4 + CloudscapeLibrary({}).list().size());
}

TEST_F(Library, TheCommandLineNamesPresetsOrFiles) {
  const CloudscapeLibrary library{{}};
  EXPECT_EQ(find_cloudscape(library, "overcast"), library.get("overcast"));
  write_file("mine.json", R"({"title": "Mine"})");
  write_file("bad.json", R"({"seed": -1})");
  EXPECT_EQ(find_cloudscape(library, (folder / "mine.json").string())->title, "Mine");
  EXPECT_EQ(refusal([&] { find_cloudscape(library, (folder / "bad.json").string()); }).sentence,
            (folder / "bad.json").string() + "#/seed is -1: must be within [0, 4294967295]");
  EXPECT_THAT(refusal<Error>([&] { find_cloudscape(library, "./nowhere.json"); }).sentence,
              HasSubstr("./nowhere.json: No such file"));
  EXPECT_THAT(refusal<Error>([&] { find_cloudscape(library, folder.string()); }).sentence, HasSubstr("folder"));
}

}  // namespace
}  // namespace cloudscape::settings
