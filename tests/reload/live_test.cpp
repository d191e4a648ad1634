/// Reloads under a running picture: real plugins, real frames, a scene of 100 thousand triangles. How long each step took
/// is printed, not asserted.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include "frame/headless.h"
#include "frame/shader_library.h"
#include "installation.h"
#include "model/json_value.h"
#include "modules/reloader.h"
#include "window/live_frame_check.h"
#include "workshop.h"

namespace lumenshop::tests {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* scene = R"({"lumenshop": 1,
  "plugins": {
    "phantom": {"type": "importer.phantom", "triangles": 100000},
    "lambert": {"type": "diffuse.lambert"}, "blinn": {"type": "specular.blinn"}, "ssao": {"type": "occlusion.ssao", "radius": 0.07},
    "bias": {"type": "occlusion.ssao", "radius": {"link": "ssao.radius"}},
    "wall": {"type": "renderer.surface", "mesh": {"link": "phantom.wall"}, "diffuse": "lambert", "specular": "blinn"},
    "orbit": {"type": "interactor.orbit"}, "front": {"type": "interactor.light", "direction": [0.3, -1, 0.5]}},
  "views": {"main": {"camera": "orbit", "lights": ["front"], "renderers": ["wall"], "occlusion": "ssao", "interactors": ["orbit"], "antialiasing": 1}}})";

double milliseconds_since(Clock::time_point begin) { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }

/// The names that a GL object kind has alive, up to a bound that the tests stay below.
int alive(GLboolean (*is)(GLuint)) {
  int count = 0;
  for (GLuint name = 1; name < 20000; ++name) count += is(name) == GL_TRUE;
  return count;
}

struct Objects {
  int textures, buffers, framebuffers, arrays;
  bool operator==(const Objects&) const = default;
};
Objects objects() {
  return {alive([](GLuint n) { return glIsTexture(n); }), alive([](GLuint n) { return glIsBuffer(n); }),
          alive([](GLuint n) { return glIsFramebuffer(n); }), alive([](GLuint n) { return glIsVertexArray(n); })};
}

double resident_megabytes() {
  std::ifstream status("/proc/self/statm");
  long total = 0, resident = 0;
  status >> total >> resident;
  return double(resident) * double(::sysconf(_SC_PAGESIZE)) / 1e6;
}

class LiveScene : public testing::Test {
 protected:
  LiveScene(const Json& session, const fs::path& session_folder, glm::ivec2 size) {
    fs::remove_all(folder);
    fs::create_directories(folder / "shaders/diffuse");
    workshop = std::make_unique<Workshop>(Workshop::Options{.plugin_folders = {folder}});
    context = std::make_unique<HeadlessContext>();
    workshop->session().load(session, session_folder);
    workshop->scheduler().wait();
    view().resize(size);
    view().finish();
    frame = std::make_unique<LiveFrameCheck>(*workshop);
    reloader = std::make_unique<Reloader>(workshop->registry(), workshop->session(), *frame, Reloader::Options{.shader_folder = {}, .build_description = {}, .build = false});
  }
  ~LiveScene() override {
    reloader.reset();
    workshop->close_views();
    workshop.reset();
    context.reset();
    fs::remove_all(folder);
  }

  ViewRenderer& view() { return workshop->view(); }

  /// Waits as the window does, for the reloader's descriptor, until a library or a shader has changed; then draws a frame.
  std::vector<ReloadEvent> next_frame(int timeout = patience) {
    const std::uint64_t shaders = workshop->shaders().revision();
    const auto begin = Clock::now();
    std::vector<ReloadEvent> events;
    while (events.empty() && workshop->shaders().revision() == shaders && milliseconds_since(begin) < timeout) {
      pollfd ready{reloader->descriptor(), POLLIN, 0};
      ::poll(&ready, 1, timeout);
      events = reloader->poll();
    }
    view().draw();
    return events;
  }
  /// As a linker does it: complete under another name, then renamed.
  void put(const std::string& library) const {
    fs::copy_file(Installation::find().plugins() / library, folder / ".new", fs::copy_options::overwrite_existing);
    fs::rename(folder / ".new", folder / library);
  }
  float center() {
    const auto image = view().layer("diffuse");
    float sum = 0;
    for (const float value : image->pixels) sum += value;
    return sum;
  }
  Instance& instance(const std::string& id) { return *workshop->session().find(id); }

  static constexpr int patience = 120'000;   ///< milliseconds for what must come; only a failure waits for them all
  const fs::path folder = fs::path(testing::TempDir()) / ("live-reload-" + std::to_string(::getpid()));
  std::unique_ptr<HeadlessContext> context;
  std::unique_ptr<Workshop> workshop;
  std::unique_ptr<LiveFrameCheck> frame;
  std::unique_ptr<Reloader> reloader;
};

class LiveReload : public LiveScene {
 protected:
  LiveReload() : LiveScene(Json::parse(scene), testing::TempDir(), {640, 512}) {}
};

/// The term's shader with another factor, written in place as editors do.
void write_lambert(const fs::path& file, const std::string& body) {
  std::ofstream(file) << "#include \"lib/surface.glsl\"\nvec3 diffuse(Properties p, Surface s, Light l) { " << body << " }\n";
}

TEST_F(LiveReload, AnEditedShaderIsSeenInTheNextFrameAndABrokenOneKeepsThePicture) {
  view().request({"diffuse"});
  const fs::path file = folder / "shaders/diffuse/lambert.glsl";
  write_lambert(file, "return s.diffuse_color * l.radiance * max(dot(s.normal, l.direction), 0.0);");
  next_frame();
  view().finish();
  const float full = center();
  ASSERT_GT(full, 0);

  const auto saved = Clock::now();
  write_lambert(file, "return 0.5 * s.diffuse_color * l.radiance * max(dot(s.normal, l.direction), 0.0);");
  next_frame();
  glFinish();
  std::printf("shader saved to new picture: %.1f ms\n", milliseconds_since(saved));
  view().finish();
  EXPECT_NEAR(center(), full / 2, full * 1e-4);

  write_lambert(file, "return s.diffuse_colour;");
  next_frame();
  view().finish();
  EXPECT_NEAR(center(), full / 2, full * 1e-4);
  const auto problems = view().problems();
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(fs::path(problems[0].file).filename(), "lambert.glsl") << problems[0].message;
  EXPECT_EQ(problems[0].line, 2);

  write_lambert(file, "return s.diffuse_color * l.radiance * max(dot(s.normal, l.direction), 0.0);");
  next_frame();
  view().finish();
  EXPECT_NEAR(center(), full, full * 1e-4);
  EXPECT_TRUE(view().problems().empty());
}

TEST_F(LiveReload, AHundredReloadsLeaveThePictureAndTheCountOfObjects) {
  put("occlusion.ssao.so");
  next_frame();
  view().finish();
  const auto before = view().picture().download();
  const Objects objects_before = objects();
  const int geometry_runs = [&] {
    for (const PassStatistics& pass : view().statistics())
      if (pass.name == "geometry") return pass.runs;
    return 0;
  }();
  const double memory_before = resident_megabytes();
  double slowest = 0, sum = 0;
  for (int i = 0; i < 100; ++i) {
    const auto begin = Clock::now();
    put("occlusion.ssao.so");
    const auto events = next_frame();
    glFinish();
    const double took = milliseconds_since(begin);
    slowest = std::max(slowest, took);
    sum += took;
    ASSERT_FALSE(events.empty());
    ASSERT_EQ(events.back().state, BuildState::loaded) << events.back().message;
  }
  view().finish();
  std::printf("library replaced to new picture: mean %.1f ms, slowest %.1f ms; memory grew by %.1f MB in 100 reloads\n", sum / 100, slowest,
              resident_megabytes() - memory_before);
  EXPECT_EQ(view().picture().download(), before);
  EXPECT_EQ(objects(), objects_before);
  for (const PassStatistics& pass : view().statistics()) {
    if (pass.name == "geometry") { EXPECT_EQ(pass.runs, geometry_runs) << "the mesh and its layers belong to another plugin"; }
  }
  Instance& ssao = instance("ssao");
  EXPECT_EQ(std::get<float>(ssao.read(ssao.slot_of("radius"))), 0.07f);
  Instance& linked = instance("bias");
  EXPECT_EQ(std::get<float>(linked.read(linked.slot_of("radius"))), 0.07f);
}

/// The session with a plugin of every kind.
class EveryKind : public LiveScene {
 protected:
  EveryKind() : LiveScene(parsed(), Installation::find().sessions(), {160, 128}) {}
  static Json parsed() {
    std::ifstream stream(Installation::find().sessions() / "every_kind.json");
    return Json::parse(stream);
  }

  /// The session as it would be saved; objects compare in any order.
  nlohmann::json saved() const { return nlohmann::json::parse(workshop->session().to_json().dump()); }
  static nlohmann::json written() { return nlohmann::json::parse(parsed().dump()); }

  /// All that an instance's properties read; data by what it holds, since a new object makes it anew.
  static std::map<std::string, std::string> values_of(const Instance& instance) {
    std::map<std::string, std::string> values;
    for (const auto& slot : instance.slots()) {
      if (slot->retracted) continue;
      const lumen::Value& value = instance.read(instance.slot_of(slot->spec.id));
      const auto* data = std::get_if<lumen::DataPointer>(&value);
      values[slot->spec.id] = data == nullptr ? to_json(value).dump() : *data ? (*data)->summary() : "none";
    }
    return values;
  }
  std::map<std::string, std::map<std::string, std::string>> values() const {
    std::map<std::string, std::map<std::string, std::string>> all;
    for (const auto& instance : workshop->session().plugins()) all[instance->id()] = values_of(*instance);
    return all;
  }
  std::string library_of(const std::string& type) const {
    for (const TypeInfo& info : workshop->registry().types())
      if (info.id == type) return info.library.filename();
    return {};
  }
};

TEST_F(EveryKind, IsInTheSession) {
  std::set<lumen::Kind> missing;
  for (int kind = 0; kind <= static_cast<int>(lumen::Kind::editor); ++kind) missing.insert(static_cast<lumen::Kind>(kind));
  for (const auto& instance : workshop->session().plugins()) missing.erase(instance->kind());
  EXPECT_TRUE(missing.empty()) << lumen::name_of(*missing.begin());
}

TEST_F(EveryKind, ReloadsWithTheSamePictureAndValuesAndTheSessionComesBackAsItWasWritten) {
  const auto picture = view().picture().download();
  const auto before = values();
  ASSERT_EQ(saved(), written());
  std::set<std::string> reloaded;
  for (const auto& [id, properties] : before) {
    const std::string library = library_of(instance(id).type());
    ASSERT_FALSE(library.empty()) << id;
    if (!reloaded.insert(library).second) continue;
    const lumen::Plugin* old = instance(id).plugin();
    put(library);
    const auto events = next_frame();
    ASSERT_FALSE(events.empty()) << library;
    ASSERT_EQ(events.back().state, BuildState::loaded) << library << ": " << events.back().message;
    EXPECT_NE(instance(id).plugin(), old) << id;
    workshop->scheduler().wait();
    view().finish();
    EXPECT_EQ(view().picture().download(), picture) << library;
    EXPECT_EQ(values(), before) << library;
  }
  EXPECT_EQ(saved(), written());
  for (const lumen::Problem& problem : workshop->problems()) EXPECT_EQ(problem.severity, lumen::Severity::note) << problem.message;
}

TEST_F(LiveReload, ATruncatedLibraryKeepsThePicture) {
  put("occlusion.ssao.so");
  next_frame();
  view().finish();
  const auto before = view().picture().download();
  const auto size = fs::file_size(folder / "occlusion.ssao.so");
  for (const double part : {0.0, 0.3, 0.7, 0.97}) {
    fs::copy_file(folder / "occlusion.ssao.so", folder / ".whole", fs::copy_options::overwrite_existing);
    fs::copy_file(folder / ".whole", folder / ".part", fs::copy_options::overwrite_existing);
    fs::resize_file(folder / ".part", std::uintmax_t(double(size) * part));
    fs::rename(folder / ".part", folder / "occlusion.ssao.so");
    next_frame(200);
    view().finish();
    EXPECT_EQ(view().picture().download(), before) << part;
    fs::rename(folder / ".whole", folder / "occlusion.ssao.so");
    next_frame();
    view().finish();
    EXPECT_EQ(view().picture().download(), before) << part;
  }
}

}  // namespace
}  // namespace lumenshop::tests
