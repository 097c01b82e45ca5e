// A loop whose rounds run on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace inkcell::gen {

/// Threads for `jobs` as the command line gives it: 0 means all cores.
inline int thread_count(int jobs) {
  if (jobs > 0) {
    return jobs;
  }
  const unsigned cores = std::thread::hardware_concurrency();
  return cores == 0 ? 1 : static_cast<int>(cores);
}

/// Calls work(i) once for every i below `count`, on up to `jobs` threads, in
/// any order. If calls throw, no new ones start, and the exception of the
/// smallest i that threw is thrown on. `done`, if set, is called on the calling
/// thread only, now and then, with the number of finished rounds. If it throws,
/// no new rounds start, and its exception is thrown on.
///
/// With one thread the rounds run on the calling thread.
void parallel_for(size_t count,
                  int jobs,
                  const std::function<void(size_t)>& work,
                  const std::function<void(size_t)>& done = {});

}  // namespace inkcell::gen
