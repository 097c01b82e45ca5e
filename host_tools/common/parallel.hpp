// A loop whose rounds run on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace inkcell::tools {

/// The number of threads that was asked for; 0: all cores.
inline unsigned thread_count(unsigned wanted) {
  const unsigned cores = std::thread::hardware_concurrency();
  return wanted != 0 ? wanted : (cores != 0 ? cores : 1);
}

/// Calls work(i) once for every i below `count`, in any order, on at most that
/// many threads. The first exception ends the loop and is rethrown.
template <typename Work>
void parallel_for(size_t count, unsigned threads, const Work& work) {
  std::atomic<size_t> next{0};
  std::exception_ptr error;
  std::mutex guard;
  const auto rounds = [&] {
    try {
      for (size_t i = next++; i < count; i = next++) {
        work(i);
      }
    } catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(guard);
      error = error ? error : std::current_exception();
    }
  };
  std::vector<std::thread> others;
  for (size_t i = 1; i < std::min<size_t>(count, thread_count(threads)); ++i) {
    others.emplace_back(rounds);
  }
  rounds();
  for (std::thread& thread : others) {
    thread.join();
  }
  if (error) {
    std::rethrow_exception(error);
  }
}

}  // namespace inkcell::tools
