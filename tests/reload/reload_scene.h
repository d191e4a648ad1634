/// A folder with the library under test, a session that uses it, and a frame that can be told to fail.
#pragma once

#include <chrono>
#include <functional>

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include "installation.h"
#include "modules/reloader.h"
#include "process/helper.h"

namespace lumenshop::tests {

namespace fs = std::filesystem;

struct FakeFrame final : FrameCheck {
  explicit FakeFrame(Session& session_) : session(session_) {}
  std::string try_frame() override {
    ++frames;
    session.update();
    for (const auto& instance : session.plugins())
      if (const int slot = instance->slot_of("unclean"); slot >= 0 && std::get<bool>(instance->read(slot))) return "a picture with NaN";
    return always;
  }
  void shaders_changed(const std::vector<fs::path>& files) override { shaders.insert(shaders.end(), files.begin(), files.end()); }

  Session& session;
  std::vector<fs::path> shaders;
  std::string always;   ///< what every frame fails with; empty = clean
  int frames = 0;
};

class ReloadScene : public testing::Test {
 protected:
  ReloadScene() {
    put("first");
    registry.load_all();
    session.load(Json::parse(R"({"lumenshop": 1,
      "plugins": {
        "changed": {"type": "ambient.subject", "strength": 0.25, "steps": 5},
        "untouched": {"type": "ambient.subject"},
        "linked": {"type": "ambient.subject", "strength": {"link": "changed.strength"}}},
      "views": {"main": {}}})"), folder);
    session.update();
  }
  ~ReloadScene() override { fs::remove_all(folder); }

  static fs::path make_folder() {
    const fs::path folder = fs::path(testing::TempDir()) / ("reload-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder / "plugins");
    fs::create_directories(folder / "shaders/ambient");
    return folder;
  }

  /// As a linker does it: complete under another name, then renamed.
  void put(const std::string& variant) const {
    fs::copy_file(installation.root / "tests/reload" / (variant + ".so"), folder / "plugins/.new", fs::copy_options::overwrite_existing);
    fs::rename(folder / "plugins/.new", library);
  }

  float strength(const char* instance) const { return std::get<float>(value(instance, "strength")); }
  const lumen::Value& value(const char* instance, const char* property) const {
    const auto [found, slot] = session.resolve(std::string(instance) + "." + property);
    return found->read(slot);
  }

  /// Lets the reloader work, whenever its descriptor announces something, until `done`; false after the patience.
  template <class Condition> static bool poll_until(Reloader& reloader, const Condition& done, const std::function<void(ReloadEvent)>& take = [](ReloadEvent) {}) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(patience);
    while (!done() && std::chrono::steady_clock::now() < end) {
      pollfd waited{reloader.descriptor(), POLLIN, 0};
      ::poll(&waited, 1, 50);
      for (ReloadEvent& event : reloader.poll()) take(std::move(event));
    }
    return done();
  }

  /// Waits for what the descriptor announces, until `count` events came; only a failure waits for the whole patience.
  std::vector<ReloadEvent> events(Reloader& reloader, std::size_t count = 1) {
    std::vector<ReloadEvent> all;
    poll_until(reloader, [&] { return all.size() >= count; }, [&](ReloadEvent event) { all.push_back(std::move(event)); });
    return all;
  }

  static constexpr int patience = 120;   ///< seconds
  const Installation installation = Installation::find();
  const fs::path folder = make_folder();
  const fs::path library = folder / "plugins/ambient.subject.so";
  Helper helper{installation.helper(), installation.workers()};
  Registry registry{{folder / "plugins"}, &helper};
  Session session{registry};
  FakeFrame frame{session};
};

}  // namespace lumenshop::tests
