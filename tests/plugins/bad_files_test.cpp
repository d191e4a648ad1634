/// Broken files, collected from other programs' tests: each loads or gives one message, in bounded memory.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <optional>

#include <sys/resource.h>
#include <sys/wait.h>

#include "format_catalog.h"
#include "plugins/data_session.h"

namespace lumenshop {
namespace {

namespace files = std::filesystem;

struct BadFile {
  files::path path;
  std::string importer;  ///< that claims it
};

class BadFiles : public testing::Test {
 protected:
  void SetUp() override {
    const files::path folder = files::path(LUMEN_TEST_DATA) / "bad";
    if (!files::exists(folder)) GTEST_SKIP() << "no broken files at " << folder;
    Registry registry({Installation::find().plugins()}, nullptr);
    registry.load_all();
    const FormatCatalog catalog(registry);
    for (const auto& entry : files::recursive_directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      try {
        claimed.push_back({entry.path(), catalog.importer_of(entry.path())});
      } catch (const lumen::Error&) {
        // No importer's.
      }
    }
    // The peak of all children so far is measured: it holds for each file if the bounds grow.
    std::sort(claimed.begin(), claimed.end(), [](const BadFile& a, const BadFile& b) { return files::file_size(a.path) < files::file_size(b.path); });
  }

  /// What is wrong with how the file is taken; empty = well. `failed`: it did not load.
  static std::string fault(DataSession& bench, const BadFile& file, bool& failed) {
    if (bench.session.find("scan")) bench.session.remove("scan");
    Instance& importer = bench.add(file.importer, "scan");
    bench.session.set("scan.path", lumen::Value(lumen::Path{file.path.string()}));
    bench.run();
    const auto problems = importer.problems();
    const auto errors = std::count_if(problems.begin(), problems.end(), [](const lumen::Problem& problem) { return problem.severity == lumen::Severity::error; });
    bool data = false;
    failed = true;
    for (const auto& slot : importer.slots()) {
      if (!slot->spec.output) continue;
      if (slot->data_state == "ready") failed = false;
      data |= std::get<lumen::DataPointer>(slot->effective) != nullptr;
    }
    if (failed && errors != 1) return std::to_string(errors) + " messages:\n" + bench.messages("scan");
    if (!failed && errors != 0) return "loaded, and yet: " + bench.messages("scan");
    return failed || data ? "" : "loaded, but there is no data";
  }

  static std::uint64_t peak_memory(int who) {
    rusage usage{};
    ::getrusage(who, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) << 10;
  }
  static std::uint64_t bound(const BadFile& file) { return std::max<std::uint64_t>(256 << 20, 200 * files::file_size(file.path)); }

  std::vector<BadFile> claimed;
};

TEST_F(BadFiles, LoadOrGiveOneMessage) {
  EXPECT_GT(claimed.size(), 90u);
  DataSession bench;
  for (const BadFile& file : claimed) {
    bool failed = false;
    EXPECT_EQ(fault(bench, file, failed), "") << file.path;
  }
}

TEST_F(BadFiles, TakeNoMoreMemoryThanTheirSizeAllows) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer's own memory is counted, too";
#endif
  std::optional<DataSession> bench;
  for (std::size_t index = 0; index < claimed.size(); ++index) {
    if (!bench) bench.emplace();
    bool failed = false;
    fault(*bench, claimed[index], failed);
    ASSERT_LE(peak_memory(RUSAGE_SELF), bound(claimed[index])) << claimed[index].path;
    if (index + 1 < claimed.size() && bound(claimed[index + 1]) == bound(claimed[index])) continue;
    bench.reset();  // its helper process and that one's readers have ended, and count as children
    ASSERT_LE(peak_memory(RUSAGE_CHILDREN), bound(claimed[index])) << claimed[index].path << " or a smaller one";
  }
  EXPECT_GT(peak_memory(RUSAGE_CHILDREN), std::uint64_t{1} << 20) << "nothing was measured";
}

/// What the program prints for a file, by lines, and its exit code.
struct Answer {
  int code = -1;
  std::vector<std::string> lines;
};
Answer render(const files::path& file, const ScratchFolder& folder) {
  const std::string command = "MESA_SHADER_CACHE_DIR='" + folder.path().string() + "' '" + (Installation::find().root / "bin/lumenshop").string() + "' render '" +
                              file.string() + "' -o '" + (folder / "picture.pfm").string() + "' --size 8x8 2>&1";
  Answer answer;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) return answer;
  std::array<char, 4096> line;
  while (std::fgets(line.data(), line.size(), pipe)) answer.lines.emplace_back(line.data());
  const int status = ::pclose(pipe);
  if (WIFEXITED(status)) answer.code = WEXITSTATUS(status);
  return answer;
}

TEST_F(BadFiles, EndTheProgramWithOneLineAndCodeOne) {
  // One of each collection and kind that does not load.
  std::map<std::pair<std::string, std::string>, files::path> chosen;
  DataSession bench;
  for (const BadFile& file : claimed) {
    const std::pair key(file.path.parent_path().filename().string(), file.path.extension().string());
    bool failed = false;
    if (!chosen.contains(key) && fault(bench, file, failed).empty() && failed) chosen[key] = file.path;
  }
  EXPECT_GT(chosen.size(), 3u);
  const ScratchFolder folder;
  for (const auto& [key, path] : chosen) {
    const Answer answer = render(path, folder);
    EXPECT_EQ(answer.code, 1) << path;
    ASSERT_EQ(answer.lines.size(), 1u) << path;
    EXPECT_NE(answer.lines[0].find(path.filename().string()), std::string::npos) << answer.lines[0];
  }
}

}  // namespace
}  // namespace lumenshop
