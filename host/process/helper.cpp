#include "process/helper.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <system_error>

#include "process/helper_process.h"
#include "process/wire.h"
#include "process/work_message.h"

namespace lumenshop {

namespace {

constexpr std::uint64_t mebibyte = 1 << 20;

std::uint64_t memory_limit_of(const lumen::WorkerRequest& request) {
  if (request.untrusted_file.empty()) return 4096 * mebibyte;
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(request.untrusted_file, error);
  constexpr std::uint64_t smallest = 256 * mebibyte, largest = 1024 * 1024 * mebibyte;
  return error || size > largest / 200 ? smallest : std::max(smallest, 200 * size);
}

}  // namespace

struct Helper::State {
  State(const std::filesystem::path& executable, const std::filesystem::path& workers_folder) : process(executable, workers_folder) {}

  HelperChild child_for(const std::string& module) {
    {
      const std::lock_guard lock(mutex);
      if (const auto found = warm.find(module); found != warm.end()) {
        HelperChild child = std::move(found->second);
        warm.erase(found);
        if (child.alive()) return child;
      }
    }
    return process.fork_child();
  }

  HelperProcess process;
  std::mutex mutex;
  std::map<std::string, HelperChild> warm;   ///< by module, at most one each
};

Helper::Helper(const std::filesystem::path& executable, const std::filesystem::path& workers_folder)
    : state_(std::make_unique<State>(executable, workers_folder)) {}

Helper::~Helper() = default;

lumen::WorkerReply Helper::run(const lumen::WorkerRequest& request, const std::function<bool(float)>& progress) {
  const WorkOrder order{request, memory_limit_of(request)};
  const Message message = to_message(order);
  HelperChild child = state_->child_for(request.module);
  child.send(message);   // if it is dead, wait() says how it died
  const bool reads = !request.untrusted_file.empty();
  const HelperChild::Watch watch{reads ? std::filesystem::path(request.untrusted_file).filename().string() : request.module, reads ? "its reader " : "",
                                 std::chrono::seconds(600), "600 s", order.memory_limit, progress};
  return to_worker_reply(child.wait(watch));
}

void Helper::warm_up(const std::string& module) {
  {
    const std::lock_guard lock(state_->mutex);
    if (const auto found = state_->warm.find(module); found != state_->warm.end() && found->second.alive()) return;
  }
  HelperChild child = state_->process.fork_child();
  WireWriter writer;
  writer.text(module);
  child.send({MessageType::load, writer.take()});
  const std::lock_guard lock(state_->mutex);
  state_->warm.insert_or_assign(module, std::move(child));
}

std::string Helper::probe(const std::filesystem::path& library, int level) {
  HelperChild child = state_->process.fork_child();
  WireWriter writer;
  writer.text(std::filesystem::absolute(library).string());
  writer.number(static_cast<std::uint64_t>(level));
  child.send({MessageType::probe, writer.take()});
  // The child's own limit of 2 s counts processor time, so that a busy machine fails nobody; this one is for those who sleep.
  const Message reply = child.wait({library.filename().string(), "", std::chrono::seconds(10), "2 s", std::uint64_t{1} << 30});
  return WireReader(reply.payload).text();
}

}  // namespace lumenshop
