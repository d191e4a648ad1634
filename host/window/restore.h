/// A copy of unsaved work, for the next start after a crash: in $XDG_STATE_HOME/lumenshop, one file per running program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "model/session.h"

namespace lumenshop {

class Restore {
 public:
  struct Leftover {
    std::filesystem::path file;    ///< of the copy
    std::filesystem::path session; ///< what it was a copy of, or empty
    std::filesystem::path folder;  ///< where its relative paths start
    std::string time;              ///< "14:02"
    Json contents;
  };

  /// Empty folder: keeps nothing.
  explicit Restore(std::filesystem::path folder);
  ~Restore();                                      ///< left in good order: the copy goes
  Restore(const Restore&) = delete;
  Restore& operator=(const Restore&) = delete;

  /// What a program that is no longer there has left, the newest; unreadable ones are passed over.
  std::optional<Leftover> find() const;
  static void discard(const Leftover& leftover);

  /// Writes the copy if the session is modified and has not been copied as it is; at most every five seconds.
  void keep(const Session& session, double now);
  double next(const Session& session) const;       ///< when keep() has something to do; 0 = never

 private:
  bool due(const Session& session) const;
  std::filesystem::path folder_, own_;
  std::uint64_t kept_revision_ = 0;
  double kept_at_ = 0;
};

}  // namespace lumenshop
