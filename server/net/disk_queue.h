// Work on files, which the network thread must not wait for: done one after the other on another thread.
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>

namespace cloudscape::net {

using Task = std::function<void()>;

class DiskQueue {
 public:
  // `run` hands a task to a thread that does one at a time, and must outlive this.
  explicit DiskQueue(std::function<void(Task)> run) : run_(std::move(run)) {}
  ~DiskQueue() { wait(); }

  void run(Task task) {
    {
      const std::lock_guard lock(mutex_);
      ++waiting_;
    }
    run_([this, task = std::move(task)]() mutable {
      task();
      task = nullptr;  // what it holds ends here, before `wait` does
      const std::lock_guard lock(mutex_);
      --waiting_;
      done_.notify_all();
    });
  }
  void wait() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return waiting_ == 0; });
  }

 private:
  const std::function<void(Task)> run_;
  std::mutex mutex_;
  std::condition_variable done_;
  int waiting_ = 0;
};

}  // namespace cloudscape::net
