/// Work away from the main thread, on a frozen copy of an instance's properties and inputs.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <lumen/error.h>
#include <lumen/property.h>
#include <lumen/worker.h>

namespace lumen {

/// Thrown by Job::progress when a newer request or a person has cancelled the work. Let it pass.
struct Cancelled {};

/// One run of compute() or write(). Thread: the worker that runs it.
class Job {
 public:
  virtual ~Job() = default;

  /// The frozen value.
  template <class T> const T& operator[](const Property<T>& property) const { return std::get<T>(read(property.slot())); }
  /// The frozen data; null if the link has none.
  template <class T> std::shared_ptr<const T> operator[](const Input<T>& input) const {
    return std::dynamic_pointer_cast<const T>(std::get<DataPointer>(read(input.slot())));
  }
  /// Hands over the result; the host checks it and adopts it between two frames.
  template <class T> void set(const Output<T>& output, std::shared_ptr<const T> data) { write(output.slot(), std::move(data)); }
  template <class T> void set(const Output<T>& output, std::shared_ptr<T> data) { write(output.slot(), std::move(data)); }

  /// Says how far it is (0..1) and leaves by Cancelled if it is no longer wanted. Call it every few milliseconds.
  virtual void progress(float fraction) = 0;
  /// Shows a line in Problems, until the next job of this instance.
  virtual void report(Severity severity, const std::string& message) = 0;
  /// Runs a worker module in a process of its own, with bounded memory and time. Throws Error if it fails or dies.
  virtual WorkerReply run(const WorkerRequest& request) = 0;

  virtual void write(int slot, DataPointer data) = 0;

 protected:
  virtual const Value& read(int slot) const = 0;
};

}  // namespace lumen
