/// Pictures for panels that are in no session: thumbnails of files and of generated materials.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include <lumen/image.h>

#include "jobs/scheduler.h"
#include "model/session.h"

namespace lumenshop {

class Helper;
class PluginFactory;

/// Thread: main.
class PictureShelf {
 public:
  /// `wake` is called from worker threads when update() has something to do.
  PictureShelf(PluginFactory& types, Helper* helper, std::function<void()> wake);

  /// What an importer of the type makes of the values, a JSON object: null while it is being made, handed over once. Throws
  /// lumen::Error: why there is none; the next call tries again.
  std::shared_ptr<const lumen::Image> take(const std::string& type, const std::string& properties);
  /// Adopts what was made. True if something was.
  bool update();

 private:
  void forget(const std::string& key);

  Session session_;
  Scheduler scheduler_;
  std::map<std::string, std::string> makers_;  ///< what was asked for -> the instance that makes it
};

}  // namespace lumenshop
