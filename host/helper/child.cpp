#include "helper/child.h"

#include <chrono>
#include <new>
#include <optional>

#include <lumen/transfer.h>

#include "helper/limits.h"
#include "helper/plugin_probe.h"
#include "helper/worker_library.h"
#include "process/wire.h"
#include "process/work_message.h"

namespace lumenshop {

namespace {

/// The new-handler and a worker's progress function are plain functions: what they speak through can only be here.
const Channel* current_channel = nullptr;

void tell_out_of_memory() {
  current_channel->send_if_possible(MessageType::out_of_memory, {});
  throw std::bad_alloc();
}

void tell_progress(float fraction) {
  static std::chrono::steady_clock::time_point last{};
  const auto now = std::chrono::steady_clock::now();
  if (now - last < std::chrono::milliseconds(10)) return;
  last = now;
  WireWriter writer;
  writer.real(fraction);
  current_channel->send_if_possible(MessageType::progress, writer.take());
}

/// What is handed over counts, too: as long as both exist, it is held twice.
void check_limit(const lumen::WorkerReply& reply, std::uint64_t memory_before, std::uint64_t limit) {
  std::uint64_t held = data_memory() - std::min(data_memory(), memory_before);
  for (const lumen::DataPointer& data : reply.data)
    if (data) held += lumen::packed_size(*data);
  if (held > limit) tell_out_of_memory();
}

class Server {
 public:
  Server(const Channel& channel, const std::filesystem::path& workers_folder) : channel_(channel), workers_folder_(workers_folder) {}

  void take(const Message& message) {
    switch (message.type) {
      case MessageType::load: load(WireReader(message.payload).text()); break;
      case MessageType::run: finish([&] { return run(to_work_order(message)); }); break;
      case MessageType::probe: finish([&] { return probe(message); }); break;
      default: break;
    }
  }

  bool finished() const { return finished_; }

 private:
  void load(const std::string& module) {
    try {
      library_.emplace(workers_folder_, module);
    } catch (const std::exception&) {
      // run() tries again, and then somebody hears of it.
    }
  }

  Message run(const WorkOrder& order) {
    if (!library_ || library_->module() != order.request.module) library_.emplace(workers_folder_, order.request.module);
    const std::uint64_t memory_before = data_memory();
    limit_memory(order.memory_limit);
    std::set_new_handler(tell_out_of_memory);
    lumen::WorkerReply reply;
    library_->run(order.request, reply, tell_progress);
    check_limit(reply, memory_before, order.memory_limit);
    return to_message(reply);
  }

  Message probe(const Message& message) {
    WireReader reader(message.payload);
    const std::filesystem::path library = reader.text();
    const int level = static_cast<int>(reader.number());
    limit_probe();
    WireWriter writer;
    writer.text(probe_library(library, level, [&](const std::string& stage) {
      channel_.send({MessageType::stage, stage});
    }));
    return {MessageType::reply, writer.take()};
  }

  template <class Work> void finish(const Work& work) {
    finished_ = true;
    try {
      channel_.send(work());
    } catch (const std::bad_alloc&) {
      channel_.send_if_possible(MessageType::out_of_memory, {});
      channel_.send_if_possible(MessageType::failure, "ran out of memory");
    } catch (const std::exception& error) {
      channel_.send_if_possible(MessageType::failure, std::string_view(error.what()).substr(0, 4096));
    } catch (...) {
      channel_.send_if_possible(MessageType::failure, "threw something that is no std::exception");
    }
  }

  const Channel& channel_;
  const std::filesystem::path& workers_folder_;
  std::optional<WorkerLibrary> library_;
  bool finished_ = false;
};

}  // namespace

void serve(Channel channel, const std::filesystem::path& workers_folder) {
  current_channel = &channel;
  limit_process();
  Server server(channel, workers_folder);
  try {
    while (!server.finished()) {
      const std::optional<Message> message = channel.receive();
      if (!message) ::_exit(0);
      server.take(*message);
    }
  } catch (const std::exception& error) {
    channel.send_if_possible(MessageType::failure, error.what());
  }
  ::_exit(0);
}

}  // namespace lumenshop
