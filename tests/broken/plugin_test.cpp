/// Plugin libraries that must fail: in the probe, in the registry, in the validator; each with its reason, none with a crash.
#include <fstream>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "installation.h"
#include "modules/registry.h"
#include "modules/validator.h"
#include "process/helper.h"

namespace {

using lumenshop::CheckResult;
using lumenshop::Helper;
using lumenshop::Installation;
using lumenshop::Registry;
namespace fs = std::filesystem;

class BrokenPlugin : public testing::Test {
 protected:
  BrokenPlugin() : folder(fs::path(testing::TempDir()) / ("broken-" + std::to_string(::getpid()))) {
    fs::remove_all(folder);
    fs::create_directories(folder / "second");
    fs::create_directories(folder / "first");
  }
  ~BrokenPlugin() override { fs::remove_all(folder); }

  fs::path library(const std::string& name) const { return installation.root / "tests/broken/plugins" / (name + ".so"); }
  fs::path put(const std::string& name, const std::string& subfolder = "first") const {
    const fs::path file = folder / subfolder / (name + ".so");
    fs::copy_file(library(name), file, fs::copy_options::overwrite_existing);
    return file;
  }

  std::string refusal(const std::string& name) {
    Registry registry({folder / "first"}, &helper);
    try {
      registry.load_candidate(put(name));
    } catch (const lumen::Error& error) {
      return error.what();
    }
    return "accepted";
  }

  /// "3 create and destroy: why" of the first failed check, else empty.
  std::string first_failure(const std::string& name, int level = 3) {
    for (const CheckResult& result : lumenshop::validate(library(name), level, helper))
      if (!result.passed) return std::to_string(result.level) + " " + result.name + ": " + result.message;
    return {};
  }

  const Installation installation = Installation::find();
  Helper helper{installation.helper(), installation.workers()};
  fs::path folder;
};

TEST_F(BrokenPlugin, IsRefusedWithItsReason) {
  EXPECT_EQ(refusal("sound"), "accepted");
  EXPECT_EQ(refusal("throws"), "ambient.throws: its constructor threw: it does not want to");
  EXPECT_EQ(refusal("crashes"), "crashes.so: crashed (signal 11, SIGSEGV) while creating ambient.crashes");
  EXPECT_EQ(refusal("crashes_at_load"), "crashes_at_load.so: crashed (signal 11, SIGSEGV) while loading");
  EXPECT_EQ(refusal("other_abi"), "other_abi.so: built for another SDK; rebuild it");
  EXPECT_EQ(refusal("no_table"), "no_table.so: it exports no lumen_plugins; declare its types with LUMEN_PLUGIN");
  EXPECT_EQ(refusal("bad_id"), "bad_id.so: 'shading.bad_id' is no type id; it must be <kind>.<name> with a known kind");
  EXPECT_EQ(refusal("wrong_kind"), "diffuse.wrong_kind: its class is of the kind ambient");
  EXPECT_EQ(refusal("prints_and_aborts"),
            "prints_and_aborts.so: crashed (signal 6, SIGABRT) while creating ambient.prints_and_aborts: the vessel has no wall");
  EXPECT_NE(refusal("undefined_symbol").find("undefined_symbol.so: undefined symbol: function_that_nobody_has"), std::string::npos) << refusal("undefined_symbol");
}

TEST_F(BrokenPlugin, ThatNeverEndsIsEnded) { EXPECT_EQ(refusal("loops"), "loops.so: took longer than 2 s while creating ambient.loops"); }

TEST_F(BrokenPlugin, CutOffAnywhereIsNeverLoaded) {
  std::ifstream whole(library("sound"), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(whole)), {});
  ASSERT_GT(bytes.size(), 4096u);
  const fs::path file = folder / "first/cut.so";
  Registry registry({folder / "first"}, nullptr);
  for (std::size_t part = 0; part < 200; ++part) {
    const std::size_t size = part < 100 ? bytes.size() * part / 100 : bytes.size() - 1 - (part - 100) * 7;
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(size));
    EXPECT_THROW(registry.load_candidate(file), lumen::Error) << size << " of " << bytes.size() << " bytes";
  }
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_NE(registry.load_candidate(file), nullptr);
}

TEST_F(BrokenPlugin, WithZerosInsteadOfItsEndDoesNotCrashTheProgram) {
  std::ifstream whole(library("sound"), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(whole)), {});
  const fs::path file = folder / "first/zeros.so";
  Registry registry({folder / "first"}, &helper);
  for (int part = 1; part < 10; ++part) {
    std::string half = bytes;
    std::fill(half.begin() + static_cast<std::ptrdiff_t>(bytes.size() * static_cast<std::size_t>(part) / 10), half.end(), '\0');
    std::ofstream(file, std::ios::binary | std::ios::trunc) << half;
    EXPECT_THROW(registry.load_candidate(file), lumen::Error) << part;
  }
}

TEST_F(BrokenPlugin, ThatIsNoRegularFileIsRefused) {
  Registry registry({folder / "first"}, nullptr);
  EXPECT_THROW(registry.load_candidate("/dev/zero"), lumen::Error);
  EXPECT_THROW(registry.load_candidate(folder), lumen::Error);
  EXPECT_THROW(registry.load_candidate(folder / "absent.so"), lumen::Error);
}

TEST_F(BrokenPlugin, InAFolderLeavesTheOthersLoaded) {
  put("sound");
  put("other_abi");
  put("bad_id");
  Registry registry({folder / "first"}, &helper);
  registry.load_all();
  ASSERT_EQ(registry.types().size(), 1u);
  EXPECT_EQ(registry.types()[0].id, "ambient.sound");
  EXPECT_EQ(registry.types()[0].kind, lumen::Kind::ambient);
  EXPECT_EQ(registry.types()[0].doc, "Nothing is wrong with it.");
  EXPECT_EQ(registry.problems().size(), 2u);
}

TEST_F(BrokenPlugin, InAUsersFolderIsProbedAtTheStart) {
  put("sound");
  put("crashes_at_load", "second");
  put("throws", "second");
  Registry registry({folder / "first", folder / "second"}, &helper);
  registry.load_all();
  EXPECT_EQ(registry.types().size(), 1u);
  ASSERT_EQ(registry.problems().size(), 2u);
  EXPECT_EQ(registry.problems()[0].file, (folder / "second/crashes_at_load.so").string());
}

TEST_F(BrokenPlugin, WithAnIdThatIsTakenIsNamedWithTheOther) {
  put("duplicate");
  put("sound");
  Registry registry({folder / "first"}, nullptr);
  registry.load_all();
  ASSERT_EQ(registry.problems().size(), 1u);
  EXPECT_EQ(registry.problems()[0].message, "sound.so: the type ambient.sound is in duplicate.so, too; that one is used");
  EXPECT_EQ(registry.types().at(0).library.filename(), "duplicate.so");
}

TEST_F(BrokenPlugin, InALaterFolderOverridesWithANote) {
  put("sound");
  put("duplicate", "second");
  Registry registry({folder / "first", folder / "second"}, nullptr);
  registry.load_all();
  ASSERT_EQ(registry.problems().size(), 1u);
  EXPECT_EQ(registry.problems()[0].severity, lumen::Severity::note);
  EXPECT_EQ(registry.types().at(0).library.filename(), "duplicate.so");
  EXPECT_TRUE(registry.types_of(*registry.load_candidate(folder / "first/sound.so")).empty()) << "a reload must not take it back";
}

TEST_F(BrokenPlugin, FailsTheLevelThatItBreaks) {
  EXPECT_EQ(first_failure("sound"), "");
  EXPECT_EQ(first_failure("exports_more").substr(0, 9), "1 exports");
  EXPECT_NE(first_failure("exports_more").find("surplus"), std::string::npos);
  EXPECT_EQ(first_failure("undefined_symbol").substr(0, 7), "1 loads");
  EXPECT_EQ(first_failure("crashes_at_load").substr(0, 7), "1 loads");
  EXPECT_EQ(first_failure("no_table").substr(0, 9), "1 exports");
  EXPECT_EQ(first_failure("other_abi").substr(0, 19), "2 handshake and ids");
  EXPECT_EQ(first_failure("bad_id").substr(0, 19), "2 handshake and ids");
  EXPECT_EQ(first_failure("no_doc"), "2 docs: ambient.no_doc: it has no doc");
  EXPECT_EQ(first_failure("throws").substr(0, 20), "3 create and destroy");
  EXPECT_EQ(first_failure("crashes").substr(0, 20), "3 create and destroy");
  EXPECT_EQ(first_failure("crashes", 2), "") << "level 2 creates nothing";
  EXPECT_EQ(first_failure("wrong_kind").substr(0, 20), "3 create and destroy");
}

TEST_F(BrokenPlugin, HasAllItsPropertiesNamed) {
  const std::string failure = first_failure("bad_properties");
  EXPECT_EQ(failure.substr(0, 12), "3 properties");
  for (const char* const property : {"outside: its default 3.0", "choice: its default 'third'", "silent: it has no doc", "scale: it is logarithmic", "waits: its condition names 'nobody'"})
    EXPECT_NE(failure.find(std::string("ambient.bad_properties.") + property), std::string::npos) << property;
}

TEST_F(BrokenPlugin, ProbeDescribesWhatASoundOneDeclares) {
  const nlohmann::json description = nlohmann::json::parse(helper.probe(library("sound"), 3));
  const nlohmann::json& type = description.at("types").at(0);
  EXPECT_EQ(type.at("id"), "ambient.sound");
  ASSERT_EQ(type.at("properties").size(), 3u);
  EXPECT_EQ(type.at("properties")[0].at("id"), "enabled");
  EXPECT_EQ(type.at("properties")[1].at("max"), 1);
  EXPECT_EQ(type.at("properties")[2].at("choices"), (std::vector<std::string>{"soft", "hard"}));
}

}  // namespace
