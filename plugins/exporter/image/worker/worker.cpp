/// The worker module `openimageio`: verbs read and write (see pictures.h).
#include <lumen/worker.h>

#include "pictures.h"

namespace {

void run(const lumen::WorkerRequest& request, lumen::WorkerReply& reply, lumen::WorkerProgress progress) {
  if (request.verb == "read") read_picture(request, reply, progress);
  else if (request.verb == "write") write_picture(request, progress);
  else throw lumen::Error("openimageio", "no verb '" + request.verb + "'");
}

}  // namespace

LUMEN_WORKER(run)
