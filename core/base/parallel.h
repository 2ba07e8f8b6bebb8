#pragma once
/// Work shared by the threads of the caller's tbb::task_arena. The library uses oneTBB through this header alone.
///
/// ThreadSanitizer cannot see how oneTBB, which is built without it, hands work from one thread to another, and reports
/// races there. Builds with ThreadSanitizer use std::threads instead, as many as the arena has slots.
#include <tbb/task_arena.h>

#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#define STERADIAN_STD_THREADS 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define STERADIAN_STD_THREADS 1
#endif
#endif

#if defined(STERADIAN_STD_THREADS)
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

#if defined(STERADIAN_STD_THREADS)

namespace detail {

/// While it lives, this thread counts as a worker: parallel calls that it makes run on it alone.
class OneOfSeveral {
 public:
  OneOfSeveral() : before_(isHere) { isHere = true; }
  ~OneOfSeveral() { isHere = before_; }
  OneOfSeveral(const OneOfSeveral&) = delete;
  OneOfSeveral& operator=(const OneOfSeveral&) = delete;

  static std::size_t threadsToUse() {
    if (isHere) return 1;
    return std::min(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
                    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  }

 private:
  static inline thread_local bool isHere = false;
  bool before_;
};

/// Calls work() on `count` threads, the caller's included, and rethrows the first exception.
template <class Work>
void onThreads(std::size_t count, const Work& work) {
  std::mutex mutex;
  std::exception_ptr first;
  const auto guarded = [&] {
    const OneOfSeveral mark;
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!first) first = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < count; ++i) others.emplace_back(guarded);
    guarded();
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace detail

#endif

/// Calls body(i) for each i below `count`, each a task of its own: for few and long ones.
template <class Body>
void parallelForEach(std::size_t count, const Body& body) {
#if defined(STERADIAN_STD_THREADS)
  std::atomic<std::size_t> next{0};
  detail::onThreads(std::min(count, detail::OneOfSeveral::threadsToUse()), [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    } catch (...) {
      next = count;
      throw;
    }
  });
#else
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(
      Range(0, count, 1),
      [&](const Range& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
      },
      tbb::simple_partitioner());
#endif
}

/// Calls body(begin, end) for ranges that make up [0, count), each about `grain` long or longer.
template <class Body>
void parallelForRanges(std::size_t count, std::size_t grain, const Body& body) {
#if defined(STERADIAN_STD_THREADS)
  parallelForEach((count + grain - 1) / grain,
                  [&](std::size_t i) { body(i * grain, std::min(count, (i + 1) * grain)); });
#else
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, count, grain), [&](const Range& range) { body(range.begin(), range.end()); });
#endif
}

/// Calls both, in parallel where threads are free.
template <class First, class Second>
void parallelInvoke(const First& first, const Second& second) {
#if defined(STERADIAN_STD_THREADS)
  if (detail::OneOfSeveral::threadsToUse() == 1) {
    first();
    second();
    return;
  }
  std::exception_ptr error;
  {
    const std::jthread other([&] {
      const detail::OneOfSeveral mark;
      try {
        first();
      } catch (...) {
        error = std::current_exception();
      }
    });
    second();
  }
  if (error) std::rethrow_exception(error);
#else
  tbb::parallel_invoke(first, second);
#endif
}

/// Calls `work`; while it waits for tasks, this thread runs only tasks that `work` has spawned (task isolation).
template <class Work>
void isolated(const Work& work) {
  tbb::this_task_arena::isolate(work);
}

/// Calls `work` in an arena of this thread alone.
template <class Work>
void onOneThread(const Work& work) {
  tbb::task_arena alone(1);
  alone.execute(work);
}

}  // namespace steradian
