/// A worker that does what its verb says, most of it bad.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>

#include <unistd.h>

#include <lumen/mesh.h>
#include <lumen/worker.h>

namespace {

using lumen::WorkerReply;
using lumen::WorkerRequest;

void echo(const WorkerRequest& request, WorkerReply& reply) {
  reply.values = request.arguments;
  reply.data = request.inputs;
  reply.notes.push_back({lumen::Severity::warning, "two cells skipped"});
}

/// Takes memory in pieces and touches it.
void take_memory(std::size_t mebibytes) {
  std::vector<std::vector<char>> pieces;
  for (std::size_t taken = 0; taken < mebibytes; ++taken) pieces.emplace_back(1 << 20, 'x');
}

/// Data that is nearly all of the limit: not there twice.
void large_data(WorkerReply& reply, std::size_t mebibytes) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->positions = std::vector<glm::vec3>(mebibytes * (1 << 20) / sizeof(glm::vec3));
  mesh->finish();
  reply.data.push_back(mesh);
}

void bad_mesh(WorkerReply& reply) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->origin = "bad.ply";
  mesh->positions = std::vector<glm::vec3>(3);
  mesh->triangles = std::vector<glm::uvec3>{{0, 1, 3000000}};
  reply.data.push_back(mesh);
}

void run(const WorkerRequest& request, WorkerReply& reply, lumen::WorkerProgress progress) {
  const std::string& verb = request.verb;
  const auto number = [&](const char* name) { return static_cast<std::size_t>(std::atoll(request.arguments.at(name).c_str())); };
  std::puts("a worker's rubbish on the standard output");
  if (verb == "echo") echo(request, reply);
  else if (verb == "throw") throw std::runtime_error("line 3: not a mesh");
  else if (verb == "throw number") throw 3;
  else if (verb == "crash") std::raise(SIGSEGV);
  else if (verb == "abort") { std::fputs("assertion 'cells > 0' failed\n", stderr); std::abort(); }
  else if (verb == "exit") ::_exit(7);
  else if (verb == "memory") take_memory(number("MiB"));
  else if (verb == "malloc") { if (char* const memory = static_cast<char*>(std::malloc(number("MiB") << 20))) std::memset(memory, 1, 64); else throw std::runtime_error("no memory"); }
  else if (verb == "large data") large_data(reply, number("MiB"));
  else if (verb == "bad mesh") bad_mesh(reply);
  else if (verb == "process") reply.values["process"] = std::to_string(::getpid());
  else if (verb == "descriptors") {
    int open = 0;
    for (int descriptor = 0; descriptor < 1024; ++descriptor) open += ::lseek(descriptor, 0, SEEK_CUR) >= 0 || errno != EBADF;
    reply.values["open"] = std::to_string(open);
  } else if (verb == "print") {
    for (int line = 0; line < 100000; ++line) std::fprintf(stderr, "warning %d: nobody wants to know\n", line);
  } else if (verb == "work") {
    for (std::size_t step = 0; step < number("steps"); ++step) {
      progress(static_cast<float>(step) / static_cast<float>(number("steps")));
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
}

}  // namespace

LUMEN_WORKER(run)
