/// `lumenshop bench`: what a frame costs, as a whole and pass by pass.
#include <chrono>
#include <cstdio>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lumen/error.h>

#include "command/commands.h"
#include "command/host_cpu.h"
#include "command/offscreen.h"
#include "command/samples.h"

namespace lumenshop {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }

/// What makes each frame differ from the one before.
class FrameChange {
 public:
  virtual ~FrameChange() = default;
  virtual void apply(int frame) = 0;
};

/// The view's camera turns about the vertical axis, to and fro, by half a degree a frame.
class Turn : public FrameChange {
 public:
  Turn(Session& session, const std::string& view) {
    const auto [instance, slot] = session.resolve(view + ".camera");
    const std::string camera = std::get<lumen::Reference>(instance->read(slot)).id;
    if (camera.empty()) throw lumen::Error(view + ".camera", "the view has no camera to turn", "give it one, or measure with --still");
    std::tie(camera_, slot_) = session.resolve(camera + ".rotation");
    rotation_ = std::get<glm::quat>(camera_->read(slot_));
  }
  void apply(int frame) override {
    const int phase = frame % 40;
    const float angle = glm::radians(0.5f * float(phase < 20 ? phase : 40 - phase) + 0.25f);
    camera_->write(slot_, rotation_ * glm::angleAxis(angle, glm::vec3(0, 1, 0)));
  }

 private:
  Instance* camera_;
  int slot_;
  glm::quat rotation_;
};

/// One property takes the given values in turn.
class Alternate : public FrameChange {
 public:
  Alternate(Session& session, const Override& values) : session_(session), path_(values.path) {
    const Json list = Json::parse("[" + values.value + "]", nullptr, false);
    if (list.is_array())
      for (const Json& value : list) values_.push_back(value.dump());
    else  // words: a,b
      for (std::size_t begin = 0; begin <= values.value.size();) {
        const std::size_t end = std::min(values.value.find(',', begin), values.value.size());
        values_.push_back(values.value.substr(begin, end - begin));
        begin = end + 1;
      }
    if (values_.size() < 2) throw UsageError("--set-each " + path_ + ": expected two or more values, separated by commas");
    session_.resolve(path_);
  }
  void apply(int frame) override { session_.override_value(path_, values_[std::size_t(frame) % values_.size()]); }

 private:
  Session& session_;
  std::string path_;
  std::vector<std::string> values_;
};

class Nothing : public FrameChange {
 public:
  void apply(int) override {}
};

std::unique_ptr<FrameChange> change_of(const BenchOptions& options, Session& session) {
  if (options.alternate) return std::make_unique<Alternate>(session, *options.alternate);
  if (options.still) return std::make_unique<Nothing>();
  return std::make_unique<Turn>(session, options.view.empty() ? session.views().front()->id() : options.view);
}

/// Frames of one open session, drawn one after the other.
class Frames {
 public:
  explicit Frames(const BenchOptions& options, const std::vector<std::filesystem::path>& plugin_folders)
      : options_(options),
        offscreen_({.files = options.files, .plugin_folders = plugin_folders, .overrides = options.overrides, .view = options.view, .size = options.size}),
        change_(change_of(options, offscreen_.workshop().session())) {
    offscreen_.finish();
    for (int frame = 0; frame < 4; ++frame) draw(frame);  // programs compiled, memory touched
    glFinish();
  }
  Offscreen& offscreen() { return offscreen_; }

  void draw(int frame) {
    change_->apply(frame);
    Workshop& workshop = offscreen_.workshop();
    workshop.session().update();
    if (workshop.scheduler().update()) workshop.session().update();
    if (options_.final) offscreen_.view().finish();
    else offscreen_.view().draw();
  }

  Quartiles whole() {
    std::vector<double> samples;
    for (int frame = 0; frame < options_.frames; ++frame) {
      const auto begin = Clock::now();
      draw(frame);
      glFinish();
      samples.push_back(milliseconds_since(begin));
    }
    return quartiles_of(std::move(samples));
  }

  /// Apart from whole(), since timing waits for each pass.
  std::vector<PassStatistics> passes() {
    ViewRenderer& view = offscreen_.view();
    view.set_timing(true);
    view.reset_statistics();
    for (int frame = 0; frame < options_.frames; ++frame) draw(frame);
    view.set_timing(false);
    return view.statistics();
  }

  /// Milliseconds of this thread's CPU.
  Quartiles cpu() {
    std::vector<double> samples;
    for (int frame = 0; frame < options_.frames; ++frame) {
      const double begin = thread_cpu_seconds();
      draw(frame);
      glFinish();
      samples.push_back(1e3 * (thread_cpu_seconds() - begin));
    }
    return quartiles_of(std::move(samples));
  }

 private:
  const BenchOptions& options_;
  Offscreen offscreen_;
  std::unique_ptr<FrameChange> change_;
};

Json to_json(const Quartiles& quartiles) {
  return {{"median_ms", quartiles.median}, {"first_quartile_ms", quartiles.first}, {"third_quartile_ms", quartiles.third}};
}

void print_json(const BenchOptions& options, const Quartiles& frame, const std::optional<Quartiles>& host, const std::vector<PassStatistics>& passes) {
  Json json{{"file", options.files.front().string()}, {"size", {options.size.x, options.size.y}}, {"frames", options.frames}, {"frame", to_json(frame)}};
  if (host) json["host_cpu"] = to_json(*host);
  json["passes"] = Json::array();
  for (const PassStatistics& pass : passes) {
    Json entry{{"name", pass.name}, {"runs", pass.runs}};
    entry.update(to_json(quartiles_of(pass.samples)));
    json["passes"].push_back(std::move(entry));
  }
  json["peak_memory_bytes"] = peak_memory();
  fmt::print("{}\n", json.dump(2));
}

void print_table(const BenchOptions& options, const Quartiles& frame, const std::optional<Quartiles>& host, const std::vector<PassStatistics>& passes) {
  fmt::print("{} at {}x{}, {} frames: milliseconds, median (spread between quartiles)\n", options.files.front().string(), options.size.x,
             options.size.y, options.frames);
  const auto row = [](const std::string& name, const Quartiles& time, const std::string& runs) {
    fmt::print("  {:<28} {:>9.3f} ({:.3f}) {}\n", name, time.median, time.spread(), runs);
  };
  row("whole frame", frame, "");
  if (host) row("host CPU, GL work aside", *host, "");
  for (const PassStatistics& pass : passes) row(pass.name, quartiles_of(pass.samples), fmt::format("  {} runs", pass.runs));
  fmt::print("  peak memory {:.1f} MB\n", double(peak_memory()) / 1e6);
}

}  // namespace

int run_bench(const BenchOptions& options, const std::vector<std::filesystem::path>& plugin_folders) {
  if (options.host_cpu) {
    Frames frames(options, plugin_folders);
    const Quartiles cpu = frames.cpu();
    fmt::print("{} {} {}\n", cpu.first, cpu.median, cpu.third);
    return exit_well;
  }
  const std::optional<Quartiles> host = host_cpu_of_child();
  Frames frames(options, plugin_folders);
  const Quartiles whole = frames.whole();
  (options.json ? print_json : print_table)(options, whole, host, frames.passes());
  const Findings findings = frames.offscreen().all_findings();
  std::fputs(findings.text().c_str(), stderr);
  return findings.empty() ? exit_well : exit_failed;
}

}  // namespace lumenshop
