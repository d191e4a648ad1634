/// A session with the built plugins, jobs and the helper process, but no window and no GL.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "installation.h"
#include "jobs/scheduler.h"
#include "model/session.h"
#include "modules/registry.h"
#include "process/helper.h"
#include "testing/given.h"

namespace lumenshop {

class DataSession {
 public:
  DataSession() : registry_({installation_.plugins()}, nullptr), factory_(loaded(registry_)), session(factory_), scheduler(session, &helper) {}

  Instance& add(const std::string& type, const std::string& id) { return session.add(type, id); }
  Instance& given(const std::string& id, lumen::DataPointer data) {
    Instance& instance = add(Given::type, id);
    instance.as<Given>(lumen::Kind::importer)->give(std::move(data));
    return instance;
  }
  /// Waits for all jobs.
  void run() {
    session.update();
    scheduler.wait();
  }
  template <class T> std::shared_ptr<const T> data(const std::string& path) {
    const auto [instance, slot] = session.resolve(path);
    return std::dynamic_pointer_cast<const T>(std::get<lumen::DataPointer>(instance->read(slot)));
  }
  std::string state(const std::string& path) {
    const auto [instance, slot] = session.resolve(path);
    return instance->slots()[static_cast<std::size_t>(slot)]->data_state;
  }
  /// The messages of an instance, one a line.
  std::string messages(const std::string& id) {
    std::string all;
    for (const lumen::Problem& problem : session.find(id)->problems()) all += problem.message + "\n";
    return all;
  }

 private:
  static Registry& loaded(Registry& registry) {
    registry.load_all();
    return registry;
  }
  Installation installation_ = Installation::find();

 public:
  Helper helper{installation_.helper(), installation_.workers()};

 private:
  Registry registry_;
  GivenFactory factory_;

 public:
  Session session;
  Scheduler scheduler;
};

/// A folder that goes with the test.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "lumenshop-test-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace lumenshop
