// SPDX-License-Identifier: BSD-3-Clause
// Workers look for a new task for a moment, then sleep until they are woken.
#include "worker_pool.h"

#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "epcc_segmentation/on_threads.h"

namespace epcc {

namespace {

/// Looks before sleep, with the processor offered to others after each: up to a millisecond, longer than the serial
/// steps of a frame last.
constexpr int kLooks = 2000;

class WorkerPool {
 public:
  /// False if the workers are not to be had; then nothing was called.
  bool run(int threads, const std::function<void()>& work) {
    const std::unique_lock<std::mutex> use(in_use_, std::try_to_lock);
    if (!use.owns_lock() || process_ != getpid()) return false;
    grow(threads - 1);
    offer(threads - 1, work);
    call(work);
    withdraw();
    if (!failure_) return true;
    std::exception_ptr failure;
    std::swap(failure, failure_);
    std::rethrow_exception(failure);
  }

 private:
  void grow(int workers) {
    try {
      for (; workers_ < workers; ++workers_) std::thread([this] { serve(); }).detach();
    } catch (const std::exception&) {
      // No more threads or no memory for them: those that run do the work.
    }
  }

  void offer(int calls, const std::function<void()>& work) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      work_ = &work;
      open_calls_ = calls;
      ++task_;
    }
    new_task_.notify_all();
  }

  /// Takes back the calls that nobody has begun and waits for the others.
  void withdraw() {
    for (int look = 0; look < kLooks && running_ > 0; ++look) std::this_thread::yield();
    std::unique_lock<std::mutex> lock(mutex_);
    open_calls_ = 0;
    idle_.wait(lock, [this] { return running_ == 0; });
    work_ = nullptr;
  }

  void serve() {
    for (unsigned seen = 0;;) {
      for (int look = 0; look < kLooks && task_ == seen; ++look) std::this_thread::yield();
      std::unique_lock<std::mutex> lock(mutex_);
      new_task_.wait(lock, [&] { return task_ != seen; });
      seen = task_;
      if (open_calls_ == 0) continue;
      --open_calls_;
      ++running_;
      const std::function<void()>* work = work_;
      lock.unlock();
      call(*work);
      lock.lock();
      if (--running_ == 0) idle_.notify_one();
    }
  }

  void call(const std::function<void()>& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  const pid_t process_ = getpid();
  std::mutex in_use_;
  int workers_ = 0;
  std::mutex mutex_;
  std::condition_variable new_task_, idle_;
  std::atomic<unsigned> task_{0};
  std::atomic<int> running_{0};
  int open_calls_ = 0;
  const std::function<void()>* work_ = nullptr;
  std::exception_ptr failure_;
};

/// Never destroyed: its workers may outlive the statics of the process.
WorkerPool& workerPool() {
  static auto* pool = new WorkerPool;
  return *pool;
}

}  // namespace

void onWorkers(int threads, const std::function<void()>& work) {
  if (threads <= 1)
    work();
  else if (!workerPool().run(threads, work))
    onThreads(threads, work);
}

}  // namespace epcc
