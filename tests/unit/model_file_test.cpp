// Session files: bad ones, saving atomically, versions, sessions for data files alone.
#include <csignal>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "model_fakes.h"
#include "model/json_text.h"
#include "model/regular_file.h"

namespace lumenshop {
namespace {

namespace fs = std::filesystem;
using fakes::Bench;
using fakes::error_of;

/// A folder of the test's own.
class SessionFile : public testing::Test {
 protected:
  SessionFile() {
    std::string name = (fs::temp_directory_path() / "lumenshop-model-XXXXXX").string();
    folder = ::mkdtemp(name.data());
  }
  ~SessionFile() override {
    fs::permissions(folder, fs::perms::owner_all);
    fs::remove_all(folder);
  }
  fs::path write(const std::string& name, const std::string& text) {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string load_error(const fs::path& file) {
    const std::string before = bench.session.to_json().dump();
    const std::string error = error_of([&] { bench.session.load(file); });
    EXPECT_EQ(bench.session.to_json().dump(), before) << "the old contents stay";
    EXPECT_NE(error, "") << file;
    EXPECT_NE(error.find(file.filename().string()), std::string::npos) << error;
    return error;
  }
  fs::path folder;
  Bench bench;
};

TEST_F(SessionFile, SavesInAFormThatDiffsWellAndLoadsAgain) {
  bench.session.load(write("s.json", R"({"lumenshop": 1, "title": "Wall", "plugins": {"a": {"type": "diffuse.box", "offset": [0.1, 2, 3], "width": {"link": "b.width"}},
    "b": {"type": "diffuse.box"}}, "views": {"main": {"camera": "orbit"}}, "layout": [["main"]]})"));
  EXPECT_FALSE(bench.session.modified());
  EXPECT_EQ(bench.session.title(), "Wall");
  bench.session.set("b.height", 0.3f);
  EXPECT_TRUE(bench.session.modified());
  bench.session.save(folder / "t.json");
  EXPECT_FALSE(bench.session.modified());
  EXPECT_EQ(bench.session.file(), folder / "t.json");
  const std::string expected =
      "{\n  \"lumenshop\": 1,\n  \"title\": \"Wall\",\n  \"plugins\": {\n    \"a\": {\n      \"type\": \"diffuse.box\",\n"
      "      \"width\": {\"link\": \"b.width\"},\n      \"offset\": [0.1, 2, 3]\n    },\n    \"b\": {\n      \"type\": \"diffuse.box\",\n"
      "      \"height\": 0.3\n    }\n  },\n  \"views\": {\n    \"main\": {\"camera\": \"orbit\"}\n  },\n  \"layout\": [\n    [\"main\"]\n  ]\n}\n";
  EXPECT_EQ(text_of(folder / "t.json"), expected);
  bench.session.load(folder / "t.json");
  bench.session.save(folder / "u.json");
  EXPECT_EQ(text_of(folder / "u.json"), expected) << "saving again changes nothing";
}

TEST_F(SessionFile, KeepsRelativePathsRightWhenItMoves) {
  bench.session.load(write("one/s.json", R"({"lumenshop": 1, "plugins": {"a": {"type": "diffuse.box", "file": "x.vtp"}}})"));
  EXPECT_EQ(bench.box("a").file->file, (folder / "one/x.vtp").string());
  bench.session.set("a.file", lumen::Path{"y.vtp"});
  fs::create_directory(folder / "two");
  bench.session.save(folder / "two/s.json");
  EXPECT_EQ(bench.saved("a")["file"], "../one/y.vtp");
  bench.session.history().undo();
  EXPECT_EQ(bench.box("a").file->file, (folder / "one/x.vtp").string()) << "undo remembers where its paths started";
}

TEST_F(SessionFile, RefusesWhatIsNoRegularFileWithoutWaiting) {
  ASSERT_EQ(::mkfifo((folder / "pipe.json").c_str(), 0600), 0);
  EXPECT_NE(load_error(folder / "pipe.json").find("a pipe"), std::string::npos);
  EXPECT_NE(load_error("/dev/zero").find("a device"), std::string::npos);
  EXPECT_NE(load_error(folder).find("a folder"), std::string::npos);
  EXPECT_NE(load_error(folder / "absent.json").find("No such file"), std::string::npos);
  fs::create_symlink("/dev/zero", folder / "zero.json");
  EXPECT_NE(load_error(folder / "zero.json").find("a device"), std::string::npos);
}

TEST_F(SessionFile, RefusesWhatIsNoSessionWithThePlace) {
  EXPECT_NE(load_error(write("syntax.json", "{\n  \"lumenshop\": 1,\n  \"plugins\": {]\n}")).find("syntax.json:3:"), std::string::npos);
  EXPECT_NE(load_error(write("deep.json", std::string(100000, '['))).find("nested deeper"), std::string::npos);
  EXPECT_NE(load_error(write("empty.json", "")).find("empty"), std::string::npos);
  std::string garbage(10'000'000, '\0');
  std::uint32_t state = 1;
  for (char& c : garbage) c = static_cast<char>((state = state * 1664525 + 1013904223) >> 24);
  load_error(write("garbage.json", garbage));
  load_error(write("quotes.json", std::string(10'000'000, '"')));
  for (const char* text : {"[]", "5", "null", "{}", "{\"a\": 1}", "{\"lumenshop\": \"one\"}", "{\"lumenshop\": -1}", "{\"lumenshop\": 1, \"plugins\": []}",
                           "{\"lumenshop\": 1, \"views\": 3}", "{\"lumenshop\": 1.5}"})
    EXPECT_NE(load_error(write("no.json", text)).find("no session"), std::string::npos) << text;
  EXPECT_NE(load_error(write("newer.json", "{\"lumenshop\": 7}")).find("session version 7, this one reads up to 1"), std::string::npos);
}

TEST_F(SessionFile, RefusesFilesBeyondTheLimit) {
  const fs::path file = write("large.json", "{");
  fs::resize_file(file, (64u << 20) + 1);
  EXPECT_NE(load_error(file).find("larger than 64 MiB"), std::string::npos);
  EXPECT_EQ(error_of([] { read_regular_file("/proc/self/status", 1 << 20); }), "");
  EXPECT_NE(error_of([] { read_regular_file("/proc/self/status", 10); }), "") << "the limit counts where the size says 0";
}

TEST_F(SessionFile, MigratesSessionsWithoutAVersion) {
  bench.session.load(write("old.json", R"({"plugins": {"a": {"type": "diffuse.box", "width": 8}}})"));
  EXPECT_EQ(bench.number("a.width"), 8);
  EXPECT_EQ(bench.session.to_json()["lumenshop"], 1);
}

TEST_F(SessionFile, NamesKeysThatAppearTwice) {
  bench.session.load(write("twice.json", R"({"lumenshop": 1, "plugins": {"a": {"type": "diffuse.box", "width": 1, "width": 2}}})"));
  EXPECT_EQ(bench.number("a.width"), 2);
  EXPECT_TRUE(bench.has_problem("\"width\" appears twice"));
}

TEST_F(SessionFile, SurvivesAnyDamageAndSavesStably) {
  const std::string sound = R"({"lumenshop": 1, "title": "T", "plugins": {"a": {"type": "diffuse.box", "width": {"link": "b.height", "expression": "2*x"},
    "offset": [1, 2, 3], "mode": "sorted", "turn": [0, 0, 1, 0], "words": ["x"], "map": {"range": [0, 1], "points": [[0, 0, 0, 0, 0], [1, 1, 1, 1, 1]]}},
    "b": {"type": "diffuse.box", "height": 4, "file": "x.vtp", "terms": ["a"]}}, "views": {"main": {"camera": "a", "time": {"link": "a.width"}}}})";
  const std::string letters = "{}[]\",:.-0159eE ab\\\n\xff";
  std::uint32_t state = 7;
  const auto random = [&](std::size_t below) { return ((state = state * 1664525 + 1013904223) >> 8) % below; };
  int loaded = 0;
  for (int round = 0; round < 1000; ++round) {
    std::string text = sound;
    for (std::size_t hits = 1 + random(3); hits > 0; --hits) {
      const std::size_t at = random(text.size());
      if (random(3) == 0) text.erase(at, 1 + random(6));
      else text[at] = letters[random(letters.size())];
    }
    Json json;
    try {
      json = parse_json(text, "damaged");
      bench.session.load(json, folder);
    } catch (const lumen::Error&) {
      continue;
    }
    ++loaded;
    bench.session.update();
    bench.session.problems();
    const Json once = bench.session.to_json();
    bench.session.load(once, folder);
    EXPECT_EQ(bench.session.to_json(), once) << text;
  }
  EXPECT_GT(loaded, 100) << "else it tests nothing";
}

TEST_F(SessionFile, BoundsTheNumberOfInstances) {
  std::string text = R"({"lumenshop": 1, "plugins": {)";
  for (int i = 0; i < 4100; ++i) text += (i ? ",\"i" : "\"i") + std::to_string(i) + R"(": {"type": "opacity.fade"})";
  bench.session.load(write("many.json", text + "}}"));
  EXPECT_EQ(bench.session.plugins().size(), 4096u);
  EXPECT_TRUE(bench.has_problem("at most 4096"));
  EXPECT_EQ(bench.session.to_json()["plugins"].size(), 4100u) << "the others are kept";
}

TEST_F(SessionFile, AFailingSaveLeavesTheOldFileAndNoTrace) {
  const fs::path file = write("deep/s.json", "old");
  EXPECT_NE(error_of([&] { bench.session.save(folder / "absent/s.json"); }).find("cannot be written"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.session.save(folder / "deep"); }).find("a folder"), std::string::npos);
  EXPECT_NE(error_of([&] { bench.session.save("/dev/full"); }).find("a device"), std::string::npos);
  EXPECT_TRUE(bench.session.file().empty()) << "it is where it was";
  if (::geteuid() != 0) {  // root may write anywhere
    fs::permissions(folder / "deep", fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(error_of([&] { bench.session.save(file); }), "");
    fs::permissions(folder / "deep", fs::perms::owner_all);
  }
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "deep"), {}), 1);
}

TEST_F(SessionFile, AFullDiskLeavesTheOldFile) {
  // Every write beyond the limit fails, as on a full disk.
  const fs::path file = write("s.json", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    struct rlimit limit {4096, 4096};
    ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const bool refused = !error_of([&] { write_file_atomically(file, std::string(100'000, 'x')); }).empty();
    ::_exit(refused ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST_F(SessionFile, SavingKeepsRightsAndSymbolicLinks) {
  const fs::path file = write("real.json", "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.json", folder / "name.json");
  bench.session.save(folder / "name.json");
  EXPECT_TRUE(fs::is_symlink(folder / "name.json"));
  EXPECT_EQ(text_of(file).substr(0, 1), "{");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(SessionFile, MakesASessionForDataFilesAlone) {
  for (const char* type : {"renderer.surface", "diffuse.lambert", "ambient.constant", "compositor.background", "occlusion.ssao"})
    bench.factory.script(type, [](fakes::Scripted& self) { self.add<float>("intensity", 1.0f); });
  bench.session.load_data({folder / "one.vtp", folder / "two.vtp"}, [](const fs::path&) { return "importer.vtk"; });
  const Json saved = bench.session.to_json();
  EXPECT_EQ(saved["plugins"]["data"]["path"], (folder / "one.vtp").string());
  EXPECT_EQ(saved["plugins"]["surface2"]["mesh"]["link"], "data2.mesh");
  EXPECT_EQ(saved["plugins"]["surface"]["diffuse"], "lambert");
  EXPECT_FALSE(saved["plugins"].contains("blinn")) << "the program lacks it";
  EXPECT_FALSE(saved["plugins"]["surface"].contains("specular"));
  EXPECT_EQ(saved["plugins"]["back"]["intensity"], 0.35);
  const auto direction = saved["plugins"]["front"]["direction"].get<std::vector<double>>();
  EXPECT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1, 1e-5);
  EXPECT_EQ(saved["views"]["main"]["renderers"], Json::parse(R"(["surface", "surface2"])"));
  EXPECT_EQ(saved["views"]["main"]["lights"], Json::parse(R"(["front", "back"])"));
  EXPECT_EQ(saved["views"]["main"]["occlusion"], "ssao");
  EXPECT_EQ(saved["views"]["main"]["camera"], "camera");
  EXPECT_FALSE(bench.session.modified());
  const std::string error = error_of([&] { bench.session.load_data({"x.pdf"}, [](const fs::path&) { return ""; }); });
  EXPECT_EQ(error, "x.pdf: no importer reads this kind of file");
  EXPECT_NE(bench.session.find("data2"), nullptr) << "the old contents stay";
}

TEST_F(SessionFile, SaysThatDataWithoutASurfaceHasNoViewOfItsOwn) {
  bench.factory.script("renderer.surface", [](fakes::Scripted&) {});
  bench.factory.script("importer.picture", [](fakes::Scripted& self) { self.add<float>("gamma", 1.0f); });
  const std::string error = error_of([&] { bench.session.load_data({"a.png"}, [](const fs::path&) { return "importer.picture"; }); });
  EXPECT_NE(error.find("a.png: holds no surface"), std::string::npos) << error;
  bench.session.load_data({"one.vtp", "a.png"}, [](const fs::path& file) { return file == "a.png" ? "importer.picture" : "importer.vtk"; });
  EXPECT_NE(bench.session.find("data2"), nullptr);
  EXPECT_EQ(bench.session.to_json()["views"]["main"]["renderers"], Json::parse(R"(["surface"])"));
}

}  // namespace
}  // namespace lumenshop
