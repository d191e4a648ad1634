#include "process/work_message.h"

#include <lumen/transfer.h>

#include "process/wire.h"

namespace lumenshop {

namespace {

/// One descriptor per piece of data that is there; the returned number per piece says whether it is.
void append(const std::vector<lumen::DataPointer>& data, WireWriter& writer, Message& message) {
  writer.number(data.size());
  for (const lumen::DataPointer& piece : data) {
    writer.number(piece ? 1 : 0);
    if (piece) message.descriptors.push_back(lumen::pack(*piece));
  }
}

std::vector<lumen::DataPointer> read_data(WireReader& reader, const Message& message) {
  std::vector<lumen::DataPointer> data;
  std::size_t next = 0;
  for (std::uint64_t left = reader.number(); left > 0; --left) {
    if (reader.number() == 0) {
      data.push_back(nullptr);
      continue;
    }
    if (next == message.descriptors.size()) throw lumen::Error("helper process", "a message lacks its data");
    data.push_back(lumen::unpack(message.descriptors[next++].get()));
  }
  return data;
}

}  // namespace

Message to_message(const WorkOrder& order) {
  Message message{MessageType::run};
  WireWriter writer;
  writer.text(order.request.module);
  writer.text(order.request.verb);
  writer.texts(order.request.arguments);
  writer.text(order.request.untrusted_file);
  writer.number(order.memory_limit);
  append(order.request.inputs, writer, message);
  message.payload = writer.take();
  return message;
}

WorkOrder to_work_order(const Message& message) {
  WorkOrder order;
  WireReader reader(message.payload);
  order.request.module = reader.text();
  order.request.verb = reader.text();
  order.request.arguments = reader.texts();
  order.request.untrusted_file = reader.text();
  order.memory_limit = reader.number();
  order.request.inputs = read_data(reader, message);
  return order;
}

Message to_message(const lumen::WorkerReply& reply) {
  Message message{MessageType::reply};
  WireWriter writer;
  writer.texts(reply.values);
  writer.number(reply.notes.size());
  for (const lumen::WorkerReply::Note& note : reply.notes) {
    writer.number(static_cast<std::uint64_t>(note.severity));
    writer.text(note.text);
  }
  append(reply.data, writer, message);
  message.payload = writer.take();
  return message;
}

lumen::WorkerReply to_worker_reply(const Message& message) {
  lumen::WorkerReply reply;
  WireReader reader(message.payload);
  reply.values = reader.texts();
  for (std::uint64_t left = reader.number(); left > 0; --left) {
    const std::uint64_t severity = reader.number();
    if (severity > static_cast<std::uint64_t>(lumen::Severity::error)) throw lumen::Error("helper process", "a malformed message");
    reply.notes.push_back({static_cast<lumen::Severity>(severity), reader.text()});
  }
  reply.data = read_data(reader, message);
  return reply;
}

}  // namespace lumenshop
