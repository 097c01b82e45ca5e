// The loop over threads: every round once, the first failure, progress.
#include <gtest/gtest.h>

#include "parallel.hpp"

#include <chrono>
#include <stdexcept>
#include <thread>

namespace inkcell::gen::test {
namespace {

TEST(Parallel, RunsEveryRoundOnce) {
  for (const int jobs : {1, 2, 4, 64}) {
    for (const size_t count : {0u, 1u, 3u, 1000u}) {
      std::vector<std::atomic<int>> runs(count);
      parallel_for(count, jobs, [&](size_t i) { ++runs[i]; });
      for (const std::atomic<int>& run : runs) {
        EXPECT_EQ(run, 1);
      }
    }
  }
}

TEST(Parallel, ThrowsTheFirstFailure) {
  for (const int jobs : {1, 2, 4}) {
    for (int i = 0; i < 50; ++i) {
      try {
        parallel_for(100, jobs, [](size_t round) {
          if (round >= 20) {
            throw std::runtime_error(std::to_string(round));
          }
        });
        ADD_FAILURE();
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "20");
      }
    }
  }
}

TEST(Parallel, EndsWhenProgressThrows) {
  for (const int jobs : {1, 3}) {
    std::atomic<int> rounds{0};
    EXPECT_THROW(
        parallel_for(
            1000000, jobs,
            [&](size_t) {
              ++rounds;
              std::this_thread::sleep_for(std::chrono::milliseconds(4));
            },
            [](size_t) { throw std::runtime_error("enough"); }),
        std::runtime_error);
    EXPECT_GT(rounds, 0);
    EXPECT_LT(rounds, 1000000);
  }
}

TEST(Parallel, ReportsTheEnd) {
  for (const int jobs : {1, 3}) {
    size_t last = 0;
    parallel_for(
        10, jobs, [](size_t) {},
        [&](size_t done) {
          EXPECT_GE(done, last);
          last = done;
        });
    EXPECT_EQ(last, 10u);
  }
}

}  // namespace
}  // namespace inkcell::gen::test
