#include "window/restore.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <ctime>
#include <fstream>

#include <unistd.h>

namespace lumenshop {
namespace {

constexpr double pause = 5;                       // seconds between two copies
constexpr std::uintmax_t longest_file = 64 << 20;
constexpr const char* prefix = "window-";

bool alive(pid_t process) { return kill(process, 0) == 0 || errno == EPERM; }

/// The process that a copy is of; 0 if it is none.
pid_t process_of(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(prefix) || file.extension() != ".json") return 0;
  pid_t process = 0;
  std::from_chars(name.data() + std::string_view(prefix).size(), name.data() + name.size(), process);
  return process;
}

std::string clock() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[8];
  std::strftime(text, sizeof text, "%H:%M", &local);
  return text;
}

}  // namespace

Restore::Restore(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (!folder_.empty()) own_ = folder_ / (prefix + std::to_string(getpid()) + ".json");
}

Restore::~Restore() {
  std::error_code error;
  if (!own_.empty()) std::filesystem::remove(own_, error);
}

std::optional<Restore::Leftover> Restore::find() const {
  std::error_code error;
  std::optional<Leftover> newest;
  std::filesystem::file_time_type newest_time{};
  if (folder_.empty()) return newest;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const pid_t process = process_of(entry.path());
    if (process <= 0 || alive(process) || !entry.is_regular_file(error) || entry.file_size(error) > longest_file) continue;
    const auto time = entry.last_write_time(error);
    if (newest && time < newest_time) continue;
    std::ifstream stream(entry.path());
    Json json = Json::parse(stream, nullptr, false);
    if (!json.is_object() || !json.contains("contents")) continue;
    newest = Leftover{entry.path(), json.value("session", ""), json.value("folder", ""), json.value("time", ""), std::move(json["contents"])};
    newest_time = time;
  }
  return newest;
}

void Restore::discard(const Leftover& leftover) {
  std::error_code error;
  std::filesystem::remove(leftover.file, error);
}

bool Restore::due(const Session& session) const { return !own_.empty() && session.modified() && session.revision() != kept_revision_; }

double Restore::next(const Session& session) const { return due(session) ? kept_at_ + pause : 0; }

void Restore::keep(const Session& session, double now) {
  std::error_code error;
  if (!own_.empty() && !session.modified() && kept_revision_ != 0) {
    std::filesystem::remove(own_, error);
    kept_revision_ = 0;
  }
  if (!due(session) || now < kept_at_ + pause) return;
  kept_at_ = now;
  kept_revision_ = session.revision();
  std::filesystem::create_directories(folder_, error);
  const Json json = {{"time", clock()}, {"session", session.file().string()}, {"folder", session.folder().string()}, {"contents", session.to_json()}};
  const std::filesystem::path aside = own_.string() + ".new";
  std::ofstream stream(aside);
  stream << json.dump(-1, ' ', false, Json::error_handler_t::replace);
  stream.close();
  if (stream) std::filesystem::rename(aside, own_, error);
}

}  // namespace lumenshop
