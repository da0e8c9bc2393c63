#include "app/encode_pool.h"

#include <pthread.h>

namespace cloudscape::app {

EncodePool::EncodePool(unsigned threads, const char* name) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this, name] { work(name); });
}

EncodePool::~EncodePool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  news_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void EncodePool::run(std::function<void()> task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  news_.notify_one();
}

void EncodePool::work(const char* name) {
  pthread_setname_np(pthread_self(), name);
  for (;;) {
    std::unique_lock lock(mutex_);
    news_.wait(lock, [this] { return stopping_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    const std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    task();
  }
}

}  // namespace cloudscape::app
