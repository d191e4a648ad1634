/// The queue between the main thread and the workers.
#include "jobs/worker_pool.h"

#include <utility>

namespace lumenshop {

WorkerPool::WorkerPool(int threads, std::function<void()> finished) : finished_callback_(std::move(finished)) {
  for (int index = 0; index < threads; ++index) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  queued_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerPool::start(std::shared_ptr<Run> run) {
  {
    std::lock_guard lock(mutex_);
    queue_.push_back(std::move(run));
  }
  queued_.notify_one();
}

std::vector<std::shared_ptr<Run>> WorkerPool::take_finished() {
  std::lock_guard lock(mutex_);
  return std::exchange(finished_, {});
}

void WorkerPool::wait_for_finished() {
  std::unique_lock lock(mutex_);
  finished_changed_.wait(lock, [this] { return !finished_.empty(); });
}

void WorkerPool::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    queued_.wait(lock, [this] { return stopping_ || !queue_.empty(); });
    if (stopping_) return;
    std::shared_ptr<Run> run = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    run->compute();
    lock.lock();
    // Moved, not copied: the last reference to a plugin object must not go on this thread.
    finished_.push_back(std::move(run));
    finished_changed_.notify_all();
    lock.unlock();
    if (finished_callback_) finished_callback_();
    lock.lock();
  }
}

}  // namespace lumenshop
