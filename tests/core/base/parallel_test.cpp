#include "steradian/core/base/parallel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace steradian {
namespace {

template <class Work>
void inArenaOf(int threads, const Work& work) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 4);  // also on smaller machines
  tbb::task_arena arena(threads);
  arena.execute(work);
}

TEST(Parallel, EachIndexOnce) {
  for (const int threads : {1, 4}) {
    for (const std::size_t count : {0u, 1u, 3u, 1000u}) {
      std::vector<std::atomic<int>> calls(count);
      inArenaOf(threads, [&] { parallelForEach(count, [&](std::size_t i) { ++calls[i]; }); });
      for (const auto& c : calls) EXPECT_EQ(c, 1);
    }
  }
}

TEST(Parallel, RangesMakeUpTheWhole) {
  for (const std::size_t count : {0u, 1u, 64u, 1000u}) {
    std::vector<std::atomic<int>> calls(count);
    inArenaOf(4, [&] {
      parallelForRanges(count, 64, [&](std::size_t begin, std::size_t end) {
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i != end; ++i) ++calls[i];
      });
    });
    for (const auto& c : calls) EXPECT_EQ(c, 1);
  }
}

/// 2^depth leaves, of which half are called by each side.
void split(int depth, std::atomic<int>& leaves) {
  if (depth == 0) {
    ++leaves;
    return;
  }
  parallelInvoke([&] { split(depth - 1, leaves); }, [&] { split(depth - 1, leaves); });
}

TEST(Parallel, InvokesMayNest) {
  for (const int threads : {1, 4}) {
    std::atomic<int> leaves{0};
    inArenaOf(threads, [&] { split(6, leaves); });
    EXPECT_EQ(leaves, 64);
  }
}

TEST(Parallel, LoopsMayNest) {
  std::atomic<int> calls{0};
  inArenaOf(4, [&] {
    parallelForEach(8, [&](std::size_t) { isolated([&] { parallelForEach(8, [&](std::size_t) { ++calls; }); }); });
  });
  EXPECT_EQ(calls, 64);
}

TEST(Parallel, ExceptionsReachTheCaller) {
  for (const int threads : {1, 4}) {
    const auto fail = [](std::size_t i) {
      if (i == 5) throw std::runtime_error("five");
    };
    EXPECT_THROW(inArenaOf(threads, [&] { parallelForEach(100, fail); }), std::runtime_error);
    EXPECT_THROW(inArenaOf(threads, [&] { parallelInvoke([&] { fail(5); }, [] {}); }), std::runtime_error);
    EXPECT_THROW(inArenaOf(threads, [&] { parallelInvoke([] {}, [&] { fail(5); }); }), std::runtime_error);
  }
}

TEST(Parallel, OneThreadIsTheCallers) {
  const auto threadsOf = [](const auto& run) {
    std::set<std::thread::id> ids;  // without a lock: there is one thread
    run([&] { parallelForEach(100, [&](std::size_t) { ids.insert(std::this_thread::get_id()); }); });
    return ids;
  };
  const std::set<std::thread::id> own{std::this_thread::get_id()};
  EXPECT_EQ(threadsOf([](const auto& work) { inArenaOf(1, work); }), own);
  EXPECT_EQ(threadsOf([](const auto& work) { onOneThread(work); }), own);
}

}  // namespace
}  // namespace steradian
