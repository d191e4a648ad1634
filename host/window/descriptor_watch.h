/// Wakes the window when a file descriptor becomes readable: a thread that sleeps in poll().
#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace lumenshop {

class DescriptorWatch {
 public:
  /// `wake` is called from the thread, once per rearm(). A negative descriptor is never ready.
  DescriptorWatch(int descriptor, std::function<void()> wake);
  ~DescriptorWatch();
  DescriptorWatch(const DescriptorWatch&) = delete;
  DescriptorWatch& operator=(const DescriptorWatch&) = delete;

  /// Whether it became readable since the last rearm(). Thread: any.
  bool ready() const { return ready_; }
  /// The descriptor was emptied: watch it again.
  void rearm();

 private:
  void run(int descriptor, const std::function<void()>& wake);
  std::atomic<bool> ready_{false}, stop_{false};
  int nudge_ = -1;  ///< an eventfd that ends the thread's sleep
  std::thread thread_;
};

}  // namespace lumenshop
