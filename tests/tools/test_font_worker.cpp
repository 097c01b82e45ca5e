// Fonts made beside the window's thread.
#include "font_worker.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace inkcell::tools {
namespace {

// A maker that goes on when it is told to.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    is_open_ = true;
    changed_.notify_all();
  }
  bool wait(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [this] { return is_open_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_open_ = false;
};

RomFile any_font() {
  return RomFile(read_file(INKCELL_GOLDEN_FONT), INKCELL_GOLDEN_FONT);
}

std::optional<RomFile> take_in_time(FontWorker& worker, const FontWish& wish) {
  for (int i = 0; i < 100000; ++i) {  // ends what hangs
    std::optional<RomFile> font = worker.take(wish);
    if (font) {
      return font;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return std::nullopt;
}

void wait_for_progress(FontWorker& worker) {
  for (int i = 0; i < 100000 && worker.work()->done == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

const FontWish kOutline = {"outline", "ab", ""};
const FontWish kField = {"field", "ab", ""};

TEST(FontWorker, MakesWhileTheCallerGoesOn) {
  Gate gate;
  FontWorker worker([&](const FontWish&, const FontWorker::Progress& tell) {
    tell(3, 97);
    EXPECT_TRUE(gate.wait(std::chrono::minutes(10)));
    return any_font();
  });
  EXPECT_FALSE(worker.work());
  EXPECT_FALSE(worker.take(kOutline));
  wait_for_progress(worker);
  EXPECT_EQ(worker.work()->coding, "outline");
  EXPECT_EQ(worker.work()->done, 3u);
  EXPECT_EQ(worker.work()->count, 97u);
  gate.open();
  EXPECT_TRUE(take_in_time(worker, kOutline));
  EXPECT_FALSE(worker.work());
}

TEST(FontWorker, DropsWhatNobodyAsksForAnyMore) {
  Gate gate;
  FontWorker worker(
      [&](const FontWish& wish, const FontWorker::Progress& tell) {
        while (wish == kOutline) {
          tell(1, 2);
          gate.wait(std::chrono::milliseconds(1));
        }
        return any_font();
      });
  EXPECT_FALSE(worker.take(kOutline));
  EXPECT_TRUE(take_in_time(worker, kField));
}

TEST(FontWorker, ThrowsWhatTheMakerThrew) {
  FontWorker worker(
      [](const FontWish&, const FontWorker::Progress&) -> RomFile {
        throw std::runtime_error("no such font");
      });
  EXPECT_THROW(take_in_time(worker, kOutline), std::runtime_error);
  EXPECT_FALSE(worker.work());
}

TEST(FontWorker, EndsWithItsOwner) {
  std::atomic<bool> was_ended{false};
  {
    FontWorker worker([&](const FontWish&, const FontWorker::Progress& tell) {
      try {
        while (true) {
          tell(1, 2);
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      } catch (const std::runtime_error&) {
        was_ended = true;
        throw;
      }
      return any_font();
    });
    EXPECT_FALSE(worker.take(kOutline));
    wait_for_progress(worker);
  }
  EXPECT_TRUE(was_ended);
}

}  // namespace
}  // namespace inkcell::tools
