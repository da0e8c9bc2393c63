// Threads that turn frames into bytes. Pure work: what to do with the bytes is the caller's.
#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cloudscape::app {

class EncodePool {
 public:
  explicit EncodePool(unsigned threads, const char* name = "encode");  // of the threads, for tools that list them
  ~EncodePool();                                                       // finishes what was given
  void run(std::function<void()> task);

 private:
  void work(const char* name);
  std::mutex mutex_;
  std::condition_variable news_;
  std::deque<std::function<void()>> tasks_;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace cloudscape::app
