/// Jobs: when they run, in which order, what becomes of their results, and how they end early.
#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <lumen/exporter.h>
#include <lumen/filter.h>
#include <lumen/mesh.h>

#include "jobs/scheduler.h"

namespace lumenshop {
namespace {

/// What the plugins of a test share: how often they ran, and a gate that holds them.
struct Stage {
  std::atomic<int> made = 0, filtered = 0, entered = 0;
  std::atomic<bool> hold = false;
  void gate(lumen::Job& job) {
    ++entered;
    while (hold) {
      job.progress(0.5f);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
};

std::shared_ptr<lumen::Mesh> triangle(float size) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->positions = std::vector<glm::vec3>{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 1, 2}};
  return mesh;
}

/// A triangle of the given size; 13 fails, 14 throws something odd, 15 hands over bad indices.
struct Maker : lumen::Importer {
  Maker(lumen::Binding& binding, Stage& stage) : Importer(binding), stage(stage) {}
  lumen::Property<float> size{this, "size", 1.0f};
  lumen::Property<float> label{this, "label", 0.0f, {.affects = lumen::Affects::nothing}};
  lumen::Output<lumen::Mesh> mesh{this, "mesh"};
  Stage& stage;
  void compute(lumen::Job& job) const override {
    ++stage.made;
    stage.gate(job);
    const float wanted = job[size];
    if (wanted == 13) throw lumen::Error("maker: thirteen");
    if (wanted == 14) throw 14;
    auto result = triangle(wanted);
    if (wanted == 15) result->triangles = std::vector<glm::uvec3>{{0, 1, 7}};
    if (wanted == 16) job.report(lumen::Severity::note, "sixteen it is");
    job.set(mesh, result);
  }
};

/// Moves it up.
struct Lift : lumen::Filter {
  Lift(lumen::Binding& binding, Stage& stage) : Filter(binding), stage(stage) {}
  lumen::Input<lumen::Mesh> input{this, "input"};
  lumen::Property<float> height{this, "height", 1.0f};
  lumen::Output<lumen::Mesh> mesh{this, "mesh"};
  Stage& stage;
  void compute(lumen::Job& job) const override {
    ++stage.filtered;
    const auto source = job[input];
    if (!source) return;
    auto result = std::make_shared<lumen::Mesh>(*source);
    std::vector<glm::vec3> positions(source->positions.begin(), source->positions.end());
    for (glm::vec3& position : positions) position.z += job[height];
    result->positions = std::move(positions);
    job.set(mesh, result);
  }
};

struct Writer : lumen::Exporter {
  Writer(lumen::Binding& binding, std::string& written) : Exporter(binding), written(written) {}
  lumen::Input<lumen::Mesh> mesh{this, "mesh"};
  std::string& written;
  std::vector<lumen::FileFormat> formats() const override { return {{".txt", lumen::DataKind::mesh, "text"}}; }
  void write(lumen::Job& job) const override {
    const auto data = job[mesh];
    if (job[path].file == "/refused.txt") throw lumen::Error("/refused.txt", "cannot be written");
    written = job[path].file + ": " + (data ? data->summary() : "nothing");
  }
};

struct Factory : PluginFactory {
  Stage stage;
  std::string written;
  std::shared_ptr<lumen::Plugin> create(const std::string& type, lumen::Binding& binding) override {
    if (type == "importer.maker") return std::make_shared<Maker>(binding, stage);
    if (type == "filter.lift") return std::make_shared<Lift>(binding, stage);
    if (type == "exporter.writer") return std::make_shared<Writer>(binding, written);
    return nullptr;
  }
  bool has(const std::string& type) const override { return type == "importer.maker" || type == "filter.lift" || type == "exporter.writer"; }
  int generation(const std::string& type) const override { return has(type) ? 1 : 0; }
};

struct SchedulerTest : testing::Test {
  Factory factory;
  Stage& stage = factory.stage;
  Session session{factory};
  std::atomic<int> wakes = 0;
  Scheduler scheduler{session, nullptr, [this] { ++wakes; }};

  void set(const std::string& path, float value) { session.set(path, lumen::Value(value)); }
  void run() {
    session.update();
    scheduler.wait();
  }
  const Slot& slot(const std::string& path) {
    const auto [instance, index] = session.resolve(path);
    return *instance->slots()[static_cast<std::size_t>(index)];
  }
  std::shared_ptr<const lumen::Mesh> mesh(const std::string& path) {
    const auto [instance, index] = session.resolve(path);
    return std::dynamic_pointer_cast<const lumen::Mesh>(std::get<lumen::DataPointer>(instance->read(index)));
  }
  std::string message(const std::string& id) {
    const auto problems = session.find(id)->problems();
    return problems.empty() ? "" : problems.front().message;
  }
  /// Lets frames pass until `done`; only a failure waits for the whole minute or more.
  bool frames_until(const std::function<bool()>& done) {
    for (int frame = 0; frame < 60000 && !done(); ++frame) {
      session.update();
      scheduler.update();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return done();
  }
  void chain() {
    session.add("filter.lift", "lift");
    session.add("importer.maker", "maker");
    session.link("lift.input", "maker.mesh");
  }
};

TEST_F(SchedulerTest, makes_data_once_and_again_only_when_a_value_changes) {
  session.add("importer.maker", "maker");
  EXPECT_EQ(slot("maker.mesh").data_state, "pending");
  run();
  run();
  EXPECT_EQ(stage.made, 1);
  ASSERT_TRUE(mesh("maker.mesh"));
  EXPECT_EQ(slot("maker.mesh").data_state, "ready");
  set("maker.label", 3);
  run();
  EXPECT_EQ(stage.made, 1) << "a value that affects nothing";
  set("maker.size", 4);
  run();
  EXPECT_EQ(stage.made, 2);
  EXPECT_EQ(mesh("maker.mesh")->positions[1].x, 4);
  // A worker wakes the host after its result can be taken, so the second call may still be on its way.
  EXPECT_TRUE(frames_until([this] { return wakes >= 2; })) << wakes;
}

TEST_F(SchedulerTest, adopted_data_is_checked_and_has_its_bounds) {
  session.add("importer.maker", "maker");
  set("maker.size", 2);
  run();
  EXPECT_EQ(mesh("maker.mesh")->bounds().max, glm::vec3(2, 2, 0));
  set("maker.size", 15);
  run();
  EXPECT_NE(message("maker").find("names point 7"), std::string::npos) << message("maker");
  EXPECT_EQ(mesh("maker.mesh")->bounds().max, glm::vec3(2, 2, 0)) << "the last good data stays";
}

TEST_F(SchedulerTest, a_chain_runs_in_order_and_once) {
  chain();
  run();
  ASSERT_TRUE(mesh("lift.mesh"));
  EXPECT_EQ(stage.made, 1);
  EXPECT_EQ(stage.filtered, 1);
  set("maker.size", 3);
  set("lift.height", 5);
  run();
  EXPECT_EQ(stage.filtered, 2) << "it waited for its input instead of running twice";
  EXPECT_EQ(mesh("lift.mesh")->positions[1], glm::vec3(3, 0, 5));
}

TEST_F(SchedulerTest, a_failure_is_told_once_and_what_depends_on_it_says_what_it_waits_for) {
  chain();
  set("maker.size", 13);
  run();
  EXPECT_EQ(message("maker"), "maker: thirteen");
  EXPECT_EQ(session.find("maker")->problems().size(), 1u);
  EXPECT_EQ(slot("maker.mesh").data_state, "maker: thirteen");
  EXPECT_EQ(slot("lift.mesh").data_state, "waits for maker.mesh, which failed");
  EXPECT_EQ(stage.filtered, 0);
  set("maker.size", 1);
  run();
  EXPECT_EQ(message("maker"), "");
  EXPECT_EQ(slot("lift.mesh").data_state, "ready");
}

TEST_F(SchedulerTest, a_chain_that_worked_goes_back_to_its_state_when_the_fault_is_undone) {
  chain();
  run();
  set("maker.size", 13);
  run();
  EXPECT_EQ(slot("lift.mesh").data_state, "waits for maker.mesh, which failed");
  ASSERT_TRUE(mesh("lift.mesh")) << "the last good data stays";
  set("maker.size", 2);
  run();
  EXPECT_EQ(slot("lift.mesh").data_state, "ready");
  EXPECT_EQ(mesh("lift.mesh")->positions[1].x, 2);
}

TEST_F(SchedulerTest, what_is_no_exception_is_caught_too) {
  session.add("importer.maker", "maker");
  set("maker.size", 14);
  run();
  EXPECT_NE(message("maker").find("threw"), std::string::npos) << message("maker");
}

TEST_F(SchedulerTest, reports_of_a_job_stay_until_the_next) {
  session.add("importer.maker", "maker");
  set("maker.size", 16);
  run();
  EXPECT_EQ(message("maker"), "sixteen it is");
  EXPECT_EQ(slot("maker.mesh").data_state, "ready");
  set("maker.size", 1);
  run();
  EXPECT_EQ(message("maker"), "");
}

TEST_F(SchedulerTest, a_newer_request_cancels_the_older_and_alone_is_adopted) {
  session.add("importer.maker", "maker");
  stage.hold = true;
  ASSERT_TRUE(frames_until([&] { return stage.entered == 1; }));
  EXPECT_EQ(scheduler.running().size(), 1u);
  EXPECT_EQ(scheduler.running()[0].instance, "maker");
  set("maker.size", 2);
  set("maker.size", 3);
  ASSERT_TRUE(frames_until([&] { return stage.entered == 2; }));
  EXPECT_FALSE(mesh("maker.mesh"));
  stage.hold = false;
  scheduler.wait();
  EXPECT_EQ(stage.made, 2);
  EXPECT_EQ(mesh("maker.mesh")->positions[1].x, 3);
  EXPECT_TRUE(scheduler.running().empty());
}

TEST_F(SchedulerTest, cancelled_by_a_person_it_does_not_start_again_by_itself) {
  chain();
  stage.hold = true;
  ASSERT_TRUE(frames_until([&] { return stage.entered == 1; }));
  scheduler.cancel("maker");
  ASSERT_TRUE(frames_until([&] { return scheduler.running().empty(); }));
  EXPECT_EQ(slot("maker.mesh").data_state, "cancelled");
  EXPECT_EQ(slot("lift.mesh").data_state, "waits for maker.mesh, which failed");
  stage.hold = false;
  run();
  EXPECT_EQ(stage.made, 1);
  set("maker.size", 6);
  run();
  EXPECT_EQ(stage.made, 2);
  EXPECT_EQ(slot("lift.mesh").data_state, "ready");
}

TEST_F(SchedulerTest, what_is_off_does_no_work_and_runs_when_it_is_on_again) {
  chain();
  session.set("maker.enabled", lumen::Value(false));
  run();
  EXPECT_EQ(stage.made, 0);
  EXPECT_EQ(slot("lift.mesh").data_state, "waits for maker.mesh, which is off");
  session.set("maker.enabled", lumen::Value(true));
  run();
  EXPECT_EQ(stage.made, 1);
  EXPECT_EQ(slot("lift.mesh").data_state, "ready");
  session.set("maker.enabled", lumen::Value(false));
  session.set("maker.enabled", lumen::Value(true));
  run();
  EXPECT_EQ(stage.made, 1) << "nothing that it reads has changed";
}

TEST_F(SchedulerTest, an_instance_that_goes_takes_its_job_with_it) {
  session.add("importer.maker", "maker");
  stage.hold = true;
  ASSERT_TRUE(frames_until([&] { return stage.entered == 1; }));
  session.remove("maker");
  ASSERT_TRUE(frames_until([&] { return scheduler.running().empty(); }));
  EXPECT_FALSE(session.find("maker"));
}

TEST_F(SchedulerTest, filters_that_wait_for_each_other_say_so_instead_of_hanging) {
  session.add("filter.lift", "a");
  session.add("filter.lift", "b");
  session.link("a.input", "b.mesh");
  session.link("b.input", "a.mesh");
  run();
  EXPECT_EQ(stage.filtered, 0);
  EXPECT_NE(slot("a.mesh").data_state.find("waits for b.mesh"), std::string::npos) << slot("a.mesh").data_state;
}

TEST_F(SchedulerTest, an_export_waits_for_its_input_and_writes_it) {
  session.add("importer.maker", "maker");
  Instance& writer = session.add("exporter.writer", "writer");
  session.link("writer.mesh", "maker.mesh");
  session.set("writer.path", lumen::Value(lumen::Path{"/there/a.txt"}));
  scheduler.run_export(writer);
  EXPECT_EQ(factory.written, "/there/a.txt: 1 triangles, 3 points");
  set("maker.size", 13);
  EXPECT_THROW(scheduler.run_export(writer), lumen::Error);
}

TEST_F(SchedulerTest, data_of_no_session_can_be_written) {
  Instance& writer = session.add("exporter.writer", "writer");
  auto mesh = triangle(1);
  mesh->finish();
  scheduler.write_file(writer, mesh, "/there/b.txt");
  EXPECT_EQ(factory.written, "/there/b.txt: 1 triangles, 3 points");
  EXPECT_THROW(scheduler.write_file(writer, nullptr, "/there/c.txt"), lumen::Error);
}

TEST_F(SchedulerTest, a_file_is_written_while_its_session_goes_on) {
  Instance& writer = session.add("exporter.writer", "writer");
  auto mesh = triangle(1);
  mesh->finish();
  std::future<void> written = scheduler.start_writing(writer, std::move(mesh), "/there/d.txt");
  session.set("writer.path", lumen::Value(lumen::Path{"/elsewhere.txt"}));
  written.get();
  EXPECT_EQ(factory.written, "/there/d.txt: 1 triangles, 3 points");
  auto another = triangle(1);
  another->finish();
  std::future<void> refused = scheduler.start_writing(writer, std::move(another), "/refused.txt");
  EXPECT_THROW(refused.get(), lumen::Error);
}

}  // namespace
}  // namespace lumenshop
