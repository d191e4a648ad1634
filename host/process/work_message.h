/// Requests and replies of worker modules as messages: texts in the payload, data in sealed memory.
#pragma once

#include <lumen/worker.h>

#include "process/channel.h"

namespace lumenshop {

struct WorkOrder {
  lumen::WorkerRequest request;
  std::uint64_t memory_limit = 0;  ///< bytes beyond what the loaded libraries hold
};

Message to_message(const WorkOrder& order);
/// Throws lumen::Error if it is malformed.
WorkOrder to_work_order(const Message& message);

Message to_message(const lumen::WorkerReply& reply);
/// Throws lumen::Error if it is malformed, or if the data is.
lumen::WorkerReply to_worker_reply(const Message& message);

}  // namespace lumenshop
