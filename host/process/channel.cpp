#include "process/channel.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <lumen/error.h>

namespace lumenshop {

namespace {

constexpr std::size_t largest_inline = 64 << 10;   // beyond that the payload goes by shared memory
constexpr std::size_t largest_payload = 64 << 20;
constexpr std::size_t most_descriptors = 128;

struct Header {
  MessageType type;
  std::uint32_t in_memory;   // 1: the payload is in the last descriptor
  std::uint64_t size;        // of the payload
};

[[noreturn]] void fail(const std::string& what) { throw lumen::Error("helper process", what + ": " + std::strerror(errno)); }

lumen::Descriptor to_memory(std::string_view payload) {
  lumen::Descriptor memory(::memfd_create("lumen-message", MFD_CLOEXEC));
  if (!memory) fail("no shared memory");
  for (std::size_t done = 0; done < payload.size();) {
    const ssize_t written = ::write(memory.get(), payload.data() + done, payload.size() - done);
    if (written < 0 && errno != EINTR) fail("no shared memory");
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  return memory;
}

std::string from_memory(int memory, std::size_t size) {
  struct stat status {};
  if (::fstat(memory, &status) != 0 || static_cast<std::size_t>(status.st_size) < size) throw lumen::Error("helper process", "a message is too short");
  std::string payload(size, '\0');
  for (std::size_t done = 0; done < size;) {
    const ssize_t got = ::pread(memory, payload.data() + done, size - done, static_cast<off_t>(done));
    if (got == 0) throw lumen::Error("helper process", "a message is too short");
    if (got < 0 && errno != EINTR) fail("a message cannot be read");
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  return payload;
}

}  // namespace

std::pair<Channel, Channel> Channel::connected() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) fail("no socket");
  return {Channel(lumen::Descriptor(ends[0])), Channel(lumen::Descriptor(ends[1]))};
}

bool Channel::send(const Message& message) const {
  if (message.payload.size() > largest_payload || message.descriptors.size() > most_descriptors)
    throw lumen::Error("helper process", "a message of " + std::to_string(message.payload.size()) + " bytes and " + std::to_string(message.descriptors.size()) + " arrays is too large");
  std::vector<int> descriptors;
  for (const lumen::Descriptor& descriptor : message.descriptors) descriptors.push_back(descriptor.get());
  Header header{message.type, 0, message.payload.size()};
  lumen::Descriptor memory;
  if (message.payload.size() > largest_inline) {
    memory = to_memory(message.payload);
    descriptors.push_back(memory.get());
    header.in_memory = 1;
  }

  std::array<iovec, 2> parts{iovec{&header, sizeof header}, iovec{const_cast<char*>(message.payload.data()), header.in_memory ? 0 : message.payload.size()}};
  msghdr packet{};
  packet.msg_iov = parts.data();
  packet.msg_iovlen = parts.size();
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * (most_descriptors + 1))> control{};
  if (!descriptors.empty()) {
    packet.msg_control = control.data();
    packet.msg_controllen = CMSG_SPACE(sizeof(int) * descriptors.size());
    cmsghdr* const rights = CMSG_FIRSTHDR(&packet);
    rights->cmsg_level = SOL_SOCKET;
    rights->cmsg_type = SCM_RIGHTS;
    rights->cmsg_len = CMSG_LEN(sizeof(int) * descriptors.size());
    std::memcpy(CMSG_DATA(rights), descriptors.data(), sizeof(int) * descriptors.size());
  }
  while (::sendmsg(socket_.get(), &packet, MSG_NOSIGNAL) < 0) {
    if (errno == EPIPE || errno == ECONNRESET) return false;
    if (errno != EINTR) fail("a message cannot be sent");
  }
  return true;
}

void Channel::send_if_possible(MessageType type, std::string_view payload) const noexcept {
  Header header{type, 0, payload.size()};
  std::array<iovec, 2> parts{iovec{&header, sizeof header}, iovec{const_cast<char*>(payload.data()), payload.size()}};
  msghdr packet{};
  packet.msg_iov = parts.data();
  packet.msg_iovlen = parts.size();
  while (::sendmsg(socket_.get(), &packet, MSG_NOSIGNAL | MSG_DONTWAIT) < 0 && errno == EINTR) {
  }
}

std::optional<Message> Channel::receive() const {
  Header header{};
  std::string payload(largest_inline, '\0');
  std::array<iovec, 2> parts{iovec{&header, sizeof header}, iovec{payload.data(), payload.size()}};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int) * (most_descriptors + 1))> control{};
  msghdr packet{};
  packet.msg_iov = parts.data();
  packet.msg_iovlen = parts.size();
  packet.msg_control = control.data();
  packet.msg_controllen = control.size();
  ssize_t size;
  while ((size = ::recvmsg(socket_.get(), &packet, MSG_CMSG_CLOEXEC)) < 0) {
    if (errno == ECONNRESET) return std::nullopt;
    if (errno != EINTR) fail("a message cannot be received");
  }
  if (size == 0) return std::nullopt;

  Message message{header.type};
  for (cmsghdr* rights = CMSG_FIRSTHDR(&packet); rights; rights = CMSG_NXTHDR(&packet, rights)) {
    if (rights->cmsg_level != SOL_SOCKET || rights->cmsg_type != SCM_RIGHTS) continue;
    const std::size_t count = (rights->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t index = 0; index < count; ++index) {
      int number;
      std::memcpy(&number, CMSG_DATA(rights) + index * sizeof(int), sizeof number);
      message.descriptors.emplace_back(number);
    }
  }
  const auto malformed = [] { throw lumen::Error("helper process", "a malformed message"); };
  if (static_cast<std::size_t>(size) < sizeof header || (packet.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0) malformed();
  if (header.in_memory != 0) {
    if (message.descriptors.empty() || header.size > largest_payload) malformed();
    message.payload = from_memory(message.descriptors.back().get(), header.size);
    message.descriptors.pop_back();
  } else {
    payload.resize(static_cast<std::size_t>(size) - sizeof header);
    message.payload = std::move(payload);
  }
  return message;
}

}  // namespace lumenshop
