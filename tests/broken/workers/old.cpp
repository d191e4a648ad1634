/// A worker that was built for another SDK.
#include <lumen/abi.h>
#undef LUMEN_ABI
#define LUMEN_ABI "another"
#include <lumen/worker.h>

namespace {

void run(const lumen::WorkerRequest&, lumen::WorkerReply&, lumen::WorkerProgress) {}

}  // namespace

LUMEN_WORKER(run)
