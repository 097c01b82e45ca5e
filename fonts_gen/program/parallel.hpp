// A loop whose rounds run on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace inkcell {

/// Calls work(i) once for every i below `count`, on up to `jobs` threads (0:
/// all cores), in any order. If calls throw, no new ones start, and the
/// exception of the smallest i that threw is thrown on. `done`, if set, is
/// called on the calling thread only, now and then, with the number of finished
/// rounds. If it throws, no new rounds start, and its exception is thrown on.
///
/// With one thread the rounds run on the calling thread.
inline void parallel_for(size_t count,
                         int jobs,
                         const std::function<void(size_t)>& work,
                         const std::function<void(size_t)>& done = {}) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kReportEvery{50};
  std::atomic<size_t> next{0};
  std::atomic<size_t> finished{0};
  std::atomic<bool> is_stopped{false};
  std::mutex mutex;  // guards what follows
  size_t failed_round = 0;
  std::exception_ptr failure;
  const auto stop = [&](size_t round) {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!failure || round < failed_round) {
      failure = std::current_exception();
      failed_round = round;
    }
    is_stopped = true;
  };
  // Rounds are handed out in ascending order, so that everything below a failed
  // round has been started: the first failure does not depend on luck.
  const auto run_round = [&] {
    const size_t round = is_stopped ? count : next++;
    if (round >= count) {
      return false;
    }
    try {
      work(round);
    } catch (...) {
      stop(round);
    }
    ++finished;
    return true;
  };
  const auto tell = [&] {
    try {
      if (done && !is_stopped) {
        done(finished);
      }
    } catch (...) {
      stop(0);
    }
  };
  const size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const size_t threads =
      std::min(jobs > 0 ? static_cast<size_t>(jobs) : cores, count);
  if (threads <= 1) {
    for (auto last = Clock::now(); run_round();) {
      if (Clock::now() - last >= kReportEvery) {
        tell();
        last = Clock::now();
      }
    }
  } else {
    std::vector<std::future<void>> pool;
    for (size_t i = 0; i < threads; ++i) {
      pool.push_back(std::async(std::launch::async, [&] {
        while (run_round()) {
        }
      }));
    }
    for (const std::future<void>& thread : pool) {
      while (thread.wait_for(kReportEvery) == std::future_status::timeout) {
        tell();
      }
    }
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  if (done) {
    done(count);
  }
}

}  // namespace inkcell
