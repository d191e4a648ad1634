#include "modules/reloader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <optional>
#include <set>

#include <sys/epoll.h>

#include <lumen/error.h>

#include "modules/builder.h"
#include "modules/compiler_messages.h"
#include "modules/reload_clock.h"
#include "modules/watcher.h"

namespace lumenshop {

namespace {

using Paths = std::vector<std::filesystem::path>;

void append(Paths& files, const std::filesystem::path& file) {
  if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

bool is_inside(const std::filesystem::path& file, const std::filesystem::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

bool is_source(const std::filesystem::path& file) {
  const std::filesystem::path extension = file.extension();
  return extension == ".cpp" || extension == ".h" || file.filename() == "CMakeLists.txt";
}

/// The library that a source <kind>/<name>/... below `folder` goes into; empty if it lies elsewhere.
std::string library_of(const std::filesystem::path& source, const std::filesystem::path& folder) {
  const std::filesystem::path inside = source.lexically_relative(folder);
  auto part = inside.begin();
  if (std::distance(part, inside.end()) < 3) return {};
  const std::string kind = part->string();
  return kind + "." + std::next(part)->string();
}

lumen::Problem problem_at(const std::filesystem::path& file, std::string message) {
  lumen::Problem problem;
  problem.file = file.string();
  problem.message = std::move(message);
  return problem;
}

}  // namespace

struct Reloader::State {
  State(Registry& registry, Session& session, FrameCheck& frame, Options options);

  void collect();                                              ///< what the watcher saw
  void start_build(std::vector<ReloadEvent>& events);
  void end_build(const Builder::Outcome& outcome, std::vector<ReloadEvent>& events);
  void apply_changes(std::vector<ReloadEvent>& events);
  std::string swap_in(const std::filesystem::path& file);
  ReloadEvent load(const std::filesystem::path& file);
  int generation_of(const std::string& library) const;
  ReloadEvent enter(const std::string& library, BuildState state, std::string message = {});

  Registry& registry;
  Session& session;
  FrameCheck& frame;
  const Options options;
  Watcher watcher;
  ReloadClock clock;
  std::optional<Builder> builder;
  std::filesystem::path sources;                               ///< folder of the plugins' sources; empty without a builder
  lumen::Descriptor events;
  Paths shader_folders;

  Paths changed_shaders, changed_libraries, changed_sources;   ///< since they were last applied
  std::map<std::string, BuildState> states;                    ///< by library
  std::map<std::string, lumen::Problem> kept;                  ///< by library: why its last build is not in use
  std::vector<lumen::Problem> build_problems;
};

Reloader::State::State(Registry& registry_, Session& session_, FrameCheck& frame_, Options options_)
    : registry(registry_), session(session_), frame(frame_), options(std::move(options_)), events(::epoll_create1(EPOLL_CLOEXEC)) {
  if (!events) throw lumen::Error("watching files", std::string("no descriptor: ") + std::strerror(errno));
  if (!options.shader_folder.empty()) shader_folders.push_back(options.shader_folder);
  for (const std::filesystem::path& folder : registry.folders()) {
    watcher.watch(folder, false);
    shader_folders.push_back(folder / "shaders");
  }
  for (const std::filesystem::path& folder : shader_folders) watcher.watch(folder, true);
  if (options.build && !options.build_description.empty() && std::filesystem::exists(options.build_description)) {
    builder.emplace(BuildDescription::load(options.build_description));
    sources = builder->description().sources / "plugins";
    watcher.watch(sources, true);
  }
  const auto join = [&](int descriptor) {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.fd = descriptor;
    if (::epoll_ctl(events.get(), EPOLL_CTL_ADD, descriptor, &event) != 0) throw lumen::Error("watching files", std::strerror(errno));
  };
  join(watcher.descriptor());
  join(clock.descriptor());
  if (builder) join(builder->descriptor());
}

void Reloader::State::collect() {
  bool any = false;
  for (const std::filesystem::path& file : watcher.take()) {
    const std::string name = file.filename().string();
    if (name.starts_with('.')) continue;
    Paths* list = nullptr;
    if (file.extension() == ".so" && std::find(registry.folders().begin(), registry.folders().end(), file.parent_path()) != registry.folders().end())
      list = &changed_libraries;
    else if (file.extension() == ".glsl" && std::any_of(shader_folders.begin(), shader_folders.end(), [&](const auto& folder) { return is_inside(file, folder); }))
      list = &changed_shaders;
    else if (builder && is_source(file) && is_inside(file, sources))
      list = &changed_sources;
    if (!list) continue;
    append(*list, file);
    any = true;
  }
  if (any) clock.changed();
}

int Reloader::State::generation_of(const std::string& library) const {
  int generation = 0;
  for (const TypeInfo& type : registry.types())
    if (type.library.stem() == library) generation = std::max(generation, type.generation);
  return generation;
}

ReloadEvent Reloader::State::enter(const std::string& library, BuildState state, std::string message) {
  states[library] = state;
  return {library, state, generation_of(library), std::move(message)};
}

void Reloader::State::start_build(std::vector<ReloadEvent>& out) {
  std::set<std::string> libraries;
  for (const std::filesystem::path& source : changed_sources)
    if (std::string library = library_of(source, sources); !library.empty()) libraries.insert(std::move(library));
  changed_sources.clear();
  try {
    builder->start();
  } catch (const std::exception& error) {
    build_problems = {problem_at({}, error.what())};
    return;
  }
  for (const std::string& library : libraries) out.push_back(enter(library, BuildState::building));
}

void Reloader::State::end_build(const Builder::Outcome& outcome, std::vector<ReloadEvent>& out) {
  build_problems = parse_compiler_messages(outcome.output, builder->description().build);
  const auto error = std::find_if(build_problems.begin(), build_problems.end(), [](const lumen::Problem& problem) { return problem.severity == lumen::Severity::error; });
  if (!outcome.success && error == build_problems.end()) {
    const std::string_view text = std::string_view(outcome.output).substr(0, outcome.output.find_last_not_of(" \r\n") + 1);
    build_problems.push_back(problem_at({}, "the build failed: " + std::string(text.substr(text.find_last_of('\n') + 1).substr(0, 500))));
  }
  for (auto& [library, state] : states) {
    if (state != BuildState::building) continue;
    // What was built and changed has been loaded before this; the rest is as it was.
    if (outcome.success) out.push_back(enter(library, kept.contains(library) ? BuildState::kept : BuildState::idle));
    else out.push_back(enter(library, BuildState::kept, "it does not compile"));
  }
}

std::string Reloader::State::swap_in(const std::filesystem::path& file) {
  try {
    std::unique_ptr<Module> candidate = registry.load_candidate(file);
    const std::unique_ptr<PluginFactory> factory = registry.with(*candidate);
    const std::vector<std::string> types = registry.types_of(*candidate);
    std::string unclean;
    {
      Rebuild rebuild(session, *factory, types);
      rebuild.swap();
      unclean = frame.try_frame();
      if (unclean.empty()) {
        rebuild.keep();
        registry.adopt(std::move(candidate));
        return {};
      }
    }
    // The old objects are back. A frame that was no better with them says nothing against the new ones.
    if (frame.try_frame() != unclean) return unclean;
    Rebuild rebuild(session, *factory, types);
    rebuild.swap();
    rebuild.keep();
    registry.adopt(std::move(candidate));
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

ReloadEvent Reloader::State::load(const std::filesystem::path& file) {
  const std::string library = file.stem().string();
  std::string reason = swap_in(file);
  if (reason.empty()) {
    kept.erase(library);
    return enter(library, BuildState::loaded);
  }
  const int generation = generation_of(library);
  kept[library] = problem_at(file, generation > 0 ? "generation " + std::to_string(generation) + " kept: " + reason : "not loaded: " + reason);
  return enter(library, BuildState::kept, std::move(reason));
}

void Reloader::State::apply_changes(std::vector<ReloadEvent>& out) {
  clock.stop();
  if (!changed_shaders.empty()) frame.shaders_changed(std::exchange(changed_shaders, {}));
  for (const std::filesystem::path& file : std::exchange(changed_libraries, {})) out.push_back(load(file));
  if (!changed_sources.empty()) start_build(out);
}

Reloader::Reloader(Registry& registry, Session& session, FrameCheck& frame, Options options)
    : state_(std::make_unique<State>(registry, session, frame, std::move(options))) {}

Reloader::~Reloader() = default;

int Reloader::descriptor() const { return state_->events.get(); }

std::vector<ReloadEvent> Reloader::poll() {
  std::vector<ReloadEvent> events;
  std::optional<Builder::Outcome> outcome;
  try {
    if (state_->builder) outcome = state_->builder->poll();
  } catch (const std::exception& error) {
    outcome = Builder::Outcome{false, error.what()};
  }
  // After the builder: all that an ended build wrote is among this.
  state_->collect();
  if (outcome || state_->clock.settled()) state_->apply_changes(events);
  // Sources that changed at the last moment are being built already: their messages are still to come.
  if (outcome && !building()) state_->end_build(*outcome, events);
  return events;
}

void Reloader::build_now() {
  std::vector<ReloadEvent> events;
  if (state_->builder) state_->start_build(events);
}

bool Reloader::building() const { return state_->builder && state_->builder->running(); }

BuildState Reloader::state(const std::string& library) const {
  const auto found = state_->states.find(library);
  return found == state_->states.end() ? BuildState::idle : found->second;
}

std::vector<lumen::Problem> Reloader::problems() const {
  std::vector<lumen::Problem> problems = state_->build_problems;
  for (const auto& [library, problem] : state_->kept) problems.push_back(problem);
  return problems;
}

std::string Reloader::reload(const std::filesystem::path& library) { return state_->load(library).message; }

}  // namespace lumenshop
