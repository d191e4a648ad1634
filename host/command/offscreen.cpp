#include "command/offscreen.h"

#include <lumen/error.h>

namespace lumenshop {

Offscreen::Offscreen(const Options& options) : view_id_(options.view), size_(options.size) {
  workshop_ = std::make_unique<Workshop>(Workshop::Options{.plugin_folders = options.plugin_folders, .warm_workers = options.warm_workers});
  workshop_->open(options.files);
  Session& session = workshop_->session();
  for (const Override& override : options.overrides) {
    try {
      session.override_value(override.path, override.value);
    } catch (const lumen::Error& error) {
      findings_.add(std::string("--set ") + error.what());
    }
  }
  session.update();
  workshop_->scheduler().update();  // files are read on worker threads while the driver starts
  context_.emplace();
  reopen();
  if (!options.layers.empty()) {
    view_->request(options.layers);
    if (!workshop_->scheduler().running().empty()) view_->prepare();
  }
  workshop_->scheduler().wait();
}

void Offscreen::reopen() {
  view_ = &workshop_->view(view_id_);
  view_->resize(size_);
}

Offscreen::~Offscreen() {
  if (workshop_) workshop_->close_views();
}

void Offscreen::finish() {
  workshop_->session().update();
  workshop_->scheduler().wait();
  workshop_->session().update();
  view_->finish();
}

void Offscreen::drop_scene() {
  workshop_->close_views();
  view_ = nullptr;
  workshop_->session().load(Json{{"lumenshop", 1}, {"plugins", Json::object()}, {"views", Json::object()}}, "/");
}

void Offscreen::drop_context() { context_.reset(); }

Findings Offscreen::all_findings() const {
  Findings all = findings_;
  all.add(workshop_->problems());
  return all;
}

}  // namespace lumenshop
