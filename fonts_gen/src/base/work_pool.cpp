#include "base/work_pool.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>

namespace inkcell::gen {
namespace {

// How often `done` hears of progress.
constexpr std::chrono::milliseconds kReportEvery{50};

// State shared by the threads of one loop.
struct Loop {
  Loop(size_t rounds, const std::function<void(size_t)>& to_do)
      : count(rounds), work(to_do) {}

  size_t count;
  const std::function<void(size_t)>& work;
  std::atomic<size_t> next{0};
  std::atomic<size_t> finished{0};
  std::atomic<bool> stopped{false};
  std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  int running = 0;
  size_t failed_round = 0;
  std::exception_ptr failure;

  void run_round(size_t round) {
    try {
      work(round);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure || round < failed_round) {
        failure = std::current_exception();
        failed_round = round;
      }
      stopped = true;
    }
    ++finished;
  }

  // Tells of the rounds that are finished. An exception ends the loop.
  void tell(const std::function<void(size_t)>& done) {
    if (!done || stopped) {
      return;
    }
    try {
      done(finished);
    } catch (...) {
      failure = std::current_exception();
      failed_round = 0;
      stopped = true;
    }
  }

  // Rounds are handed out in ascending order, so that everything below a
  // failed round has been started: the first failure does not depend on luck.
  void run_rounds() {
    while (!stopped) {
      const size_t round = next++;
      if (round >= count) {
        break;
      }
      run_round(round);
    }
    const std::lock_guard<std::mutex> lock(mutex);
    --running;
    changed.notify_all();
  }
};

void run_here(Loop& loop, const std::function<void(size_t)>& done) {
  auto last = std::chrono::steady_clock::now();
  for (size_t i = 0; i < loop.count && !loop.stopped; ++i) {
    loop.run_round(i);
    const auto now = std::chrono::steady_clock::now();
    if (now - last >= kReportEvery) {
      loop.tell(done);
      last = now;
    }
  }
}

void run_threads(Loop& loop,
                 int threads,
                 const std::function<void(size_t)>& done) {
  loop.running = threads;
  std::vector<std::thread> pool;
  for (int i = 0; i < threads; ++i) {
    pool.emplace_back([&loop] { loop.run_rounds(); });
  }
  {
    std::unique_lock<std::mutex> lock(loop.mutex);
    while (!loop.changed.wait_for(lock, kReportEvery,
                                  [&loop] { return loop.running == 0; })) {
      loop.tell(done);
    }
  }
  for (std::thread& thread : pool) {
    thread.join();
  }
}

}  // namespace

void parallel_for(size_t count,
                  int jobs,
                  const std::function<void(size_t)>& work,
                  const std::function<void(size_t)>& done) {
  Loop loop(count, work);
  const int threads = static_cast<int>(
      std::min<size_t>(static_cast<size_t>(thread_count(jobs)), count));
  if (threads <= 1) {
    run_here(loop, done);
  } else {
    run_threads(loop, threads, done);
  }
  if (loop.failure) {
    std::rethrow_exception(loop.failure);
  }
  if (done) {
    done(count);
  }
}

}  // namespace inkcell::gen
