// SPDX-License-Identifier: BSD-3-Clause
// Work on several threads: its exceptions, and threads that the system refuses.
#include "epcc_segmentation/on_threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "parallel_for.h"
#include "tests/support/refused_threads.h"

namespace {

using epcc::onThreads;
using epcc::parallelFor;

/// Calls of work() while all wait for each other: that many threads.
int threadsAtOnce(int threads) {
  std::atomic<int> calls{0};
  onThreads(threads, [&] {
    ++calls;
    while (calls < threads) std::this_thread::yield();
  });
  return calls;
}

TEST(OnThreads, EveryThreadMakesACall) {
  for (const int threads : {1, 2, 5}) EXPECT_EQ(threadsAtOnce(threads), threads);
  EXPECT_EQ(threadsAtOnce(0), 1);
}

TEST(OnThreads, AnExceptionReachesTheCallerAfterAllHaveEnded) {
  std::atomic<int> started{0}, ended{0};
  const auto work = [&] {
    if (started++ == 0) throw std::runtime_error("first call");
    while (started < 4) std::this_thread::yield();
    ++ended;
  };
  try {
    onThreads(4, work);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "first call");
  }
  EXPECT_EQ(ended, 3);
}

TEST(OnThreads, OfManyExceptionsOneReachesTheCaller) {
  EXPECT_THROW(onThreads(4, [] { throw std::runtime_error("every call"); }), std::runtime_error);
}

TEST(OnThreads, WithoutThreadsTheCallerWorksAlone) {
  EXPECT_TRUE(epcc::test::holdsWithoutThreads([] {
    int calls = 0;
    onThreads(8, [&] { ++calls; });
    return calls == 1;
  }));
}

TEST(OnThreads, WithoutThreadsExceptionsReachTheCallerToo) {
  EXPECT_TRUE(epcc::test::holdsWithoutThreads([] {
    try {
      onThreads(8, [] { throw std::runtime_error("alone"); });
    } catch (const std::runtime_error&) {
      return true;
    }
    return false;
  }));
}

/// Which part did each number of the range.
std::vector<int> partOfEach(int count, int threads) {
  std::vector<int> parts(static_cast<std::size_t>(count), -1);
  parallelFor(count, threads, [&](int part, int begin, int end) {
    for (int i = begin; i < end; ++i) parts[static_cast<std::size_t>(i)] = part;
  });
  return parts;
}

TEST(ParallelFor, PartsAreConsecutiveAndCoverTheRange) {
  EXPECT_EQ(partOfEach(5, 2), (std::vector<int>{0, 0, 1, 1, 1}));
  EXPECT_EQ(partOfEach(2, 7), (std::vector<int>{0, 1}));
  EXPECT_EQ(partOfEach(3, 1), (std::vector<int>{0, 0, 0}));
  EXPECT_TRUE(partOfEach(0, 4).empty());
}

TEST(ParallelFor, WithoutThreadsTheCallerDoesEveryPart) {
  EXPECT_TRUE(epcc::test::holdsWithoutThreads([] { return partOfEach(5, 2) == std::vector<int>{0, 0, 1, 1, 1}; }));
}

TEST(ParallelFor, AnExceptionOfAnyPartReachesTheCaller) {
  for (int bad = 0; bad < 3; ++bad) {
    std::atomic<int> done{0};
    const auto work = [&](int part, int, int) {
      if (part == bad) throw std::runtime_error("bad part");
      ++done;
    };
    EXPECT_THROW(parallelFor(30, 3, work), std::runtime_error) << bad;
    EXPECT_LE(done, 2) << bad;
  }
}

}  // namespace
