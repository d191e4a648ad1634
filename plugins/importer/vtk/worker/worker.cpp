/// The worker module `vtk`: verbs read (argument path) and write (see writing.h).
#include <algorithm>

#include <lumen/worker.h>

#include "file_kind.h"
#include "reading.h"
#include "surface.h"
#include "writing.h"

namespace {

void read(const std::string& path, lumen::WorkerReply& reply, lumen::WorkerProgress progress) {
  const FileKind kind = kind_of(path);
  const std::string file = short_name(path);
  if (!extension_fits(path, kind)) reply.notes.push_back({lumen::Severity::note, file + " holds " + name_of(kind) + ", whatever its name says"});
  const vtkSmartPointer<vtkPolyData> surface = read_file(path, kind, reply, progress);
  progress(0.8f);
  if (auto mesh = mesh_of(surface, file, reply)) reply.data.push_back(std::move(mesh));
  progress(0.95f);
  if (auto lines = lines_of(surface, file, reply)) reply.data.push_back(std::move(lines));
  // What mesh and lines share is noted by both.
  for (auto note = reply.notes.begin(); note != reply.notes.end();)
    note = std::any_of(reply.notes.begin(), note, [&](const auto& earlier) { return earlier.text == note->text; }) ? reply.notes.erase(note) : note + 1;
  if (reply.data.empty()) {
    std::string why = "holds no triangles and no lines";
    for (const auto& note : reply.notes)
      if (note.severity == lumen::Severity::warning) why += "; " + note.text;
    throw lumen::Error(file, why);
  }
}

void run(const lumen::WorkerRequest& request, lumen::WorkerReply& reply, lumen::WorkerProgress progress) {
  if (request.verb == "read") read(request.arguments.at("path"), reply, progress);
  else if (request.verb == "write") write_file(request, progress);
  else throw lumen::Error("vtk", "no verb '" + request.verb + "'");
}

}  // namespace

LUMEN_WORKER(run)
