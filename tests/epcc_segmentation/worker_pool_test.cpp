// SPDX-License-Identifier: BSD-3-Clause
// Workers that are kept: every part is done once, exceptions arrive, users do not wait for each other, forks work.
#include "worker_pool.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "parallel_for.h"

namespace {

/// Calls work() on two threads, when both have begun.
void onTwoAtOnce(const std::function<void()>& work) {
  std::atomic<int> begun{0};
  epcc::onWorkers(2, [&] {
    ++begun;
    while (begun < 2) std::this_thread::yield();
    work();
  });
}

TEST(WorkerPool, EveryPartIsDoneOnceTimeAfterTime) {
  for (int round = 0; round < 2000; ++round) {
    std::vector<int> done(37, 0);
    epcc::parallelFor(37, 1 + round % 5, [&](int /*part*/, int begin, int end) {
      for (int i = begin; i < end; ++i) ++done[static_cast<std::size_t>(i)];
    });
    ASSERT_EQ(done, std::vector<int>(37, 1)) << round;
  }
}

TEST(WorkerPool, TheThreadsAreKept) {
  std::mutex mutex;
  std::set<long> ids;
  for (int round = 0; round < 100; ++round)
    onTwoAtOnce([&] {
      const std::lock_guard<std::mutex> lock(mutex);
      ids.insert(syscall(SYS_gettid));
    });
  EXPECT_LT(ids.size(), 50u) << "workers as many as the largest task of this process needed, not one a task";
}

TEST(WorkerPool, TheFirstExceptionArrivesAndTheNextTaskRuns) {
  EXPECT_THROW(epcc::onWorkers(3, [] { throw std::runtime_error("one"); }), std::runtime_error);
  std::atomic<int> calls{0};
  epcc::onWorkers(3, [&] { ++calls; });
  EXPECT_GE(calls, 1);
}

TEST(WorkerPool, TasksWithinTasksAndOfManyUsersEnd) {
  std::atomic<int> inner{0};
  epcc::parallelFor(4, 4, [&](int, int, int) { epcc::parallelFor(8, 4, [&](int, int b, int e) { inner += e - b; }); });
  EXPECT_EQ(inner, 32);
  std::vector<std::thread> users;
  std::atomic<int> sum{0};
  for (int user = 0; user < 4; ++user)
    users.emplace_back([&] {
      for (int round = 0; round < 200; ++round)
        epcc::parallelFor(10, 3, [&](int, int begin, int end) { sum += end - begin; });
    });
  for (std::thread& user : users) user.join();
  EXPECT_EQ(sum, 4 * 200 * 10);
}

TEST(WorkerPool, AForkedProcessHasThreadsToo) {
  onTwoAtOnce([] {});  // the parent's worker runs; none is still starting when the process forks
  const pid_t child = fork();
  if (child == 0) {
    std::atomic<int> calls{0};
    epcc::onWorkers(2, [&] { ++calls; });
    _exit(calls >= 1 ? 0 : 1);
  }
  ASSERT_GT(child, 0);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
