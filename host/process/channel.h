/// One end of a connection between two processes: whole messages, with file descriptors.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <lumen/descriptor.h>

namespace lumenshop {

enum class MessageType : std::uint32_t {
  fork,           ///< program -> helper process: a channel's end and a pipe for the child's output
  load,           ///< program -> child: load this worker module and wait
  run,            ///< program -> child: do what the request says
  probe,          ///< program -> child: load this plugin library and check it
  progress,       ///< child -> program: how far, 0..1
  stage,          ///< child -> program: what it does now, for the message if it dies of it
  out_of_memory,  ///< child -> program: an allocation failed at the limit
  reply,          ///< child -> program: done
  failure,        ///< child -> program: the reason as text
  exited          ///< helper process -> program, in the child's place: its wait status
};

struct Message {
  MessageType type;
  std::string payload = {};                          ///< at most 64 MiB
  std::vector<lumen::Descriptor> descriptors = {};   ///< at most 128
};

/// A connected SOCK_SEQPACKET socket, close-on-exec. Thread: one at a time.
class Channel {
 public:
  Channel() = default;
  explicit Channel(lumen::Descriptor socket) : socket_(std::move(socket)) {}
  /// Two connected ends. Throws lumen::Error.
  static std::pair<Channel, Channel> connected();

  /// False if the other end is gone. Throws lumen::Error if the message cannot be sent at all.
  bool send(const Message& message) const;
  /// Gives up, silently, where send() would wait.
  void send_if_possible(MessageType type, std::string_view payload) const noexcept;
  /// Waits for a message; nothing if the other end is gone. Throws lumen::Error if what came is malformed.
  std::optional<Message> receive() const;

  int descriptor() const { return socket_.get(); }
  explicit operator bool() const { return static_cast<bool>(socket_); }
  lumen::Descriptor release() { return std::move(socket_); }

 private:
  lumen::Descriptor socket_;
};

}  // namespace lumenshop
