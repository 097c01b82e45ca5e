// Progress and time left, on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

#ifdef _WIN32
#  include <io.h>
#else
#  include <unistd.h>
#endif

namespace inkcell::tools {

/// Draws a bar on a terminal. Elsewhere prints a line at the start and for each
/// tenth, at most one a second.
class Progress {
 public:
  /// `what` is the plural of the things made.
  explicit Progress(bool quiet, const char* what = "glyphs")
      : quiet_(quiet), what_(what) {}
  /// Removes the bar.
  ~Progress() {
    if (bar_shown_) {
      std::fputs("\r\033[K", stderr);
    }
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  static bool is_terminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(fileno(stderr)) != 0;
#endif
  }

  /// `done` of `count` glyphs are finished. One thread at a time.
  void update(size_t done, size_t count) {
    if (quiet_ || count == 0) {
      return;
    }
    if (terminal_) {
      draw_bar(done, count);
    } else {
      print_tenth(done, count);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  // ", 12 s left", once it can be estimated.
  std::string time_left(size_t done, size_t count) const {
    if (done == 0 || done == count) {
      return "";
    }
    const std::chrono::duration<double> spent = Clock::now() - begin_;
    char text[32];
    std::snprintf(text, sizeof text, ", %.0f s left",
                  spent.count() * static_cast<double>(count - done) /
                      static_cast<double>(done));
    return text;
  }

  void draw_bar(size_t done, size_t count) {
    constexpr size_t kWidth = 40;  // [columns]
    const size_t filled = kWidth * done / count;
    const std::string bar =
        std::string(filled, '#') + std::string(kWidth - filled, '.');
    std::fprintf(stderr, "\r[%s] %zu/%zu %s%s \033[K", bar.c_str(), done, count,
                 what_, time_left(done, count).c_str());
    std::fflush(stderr);
    bar_shown_ = true;
  }

  void print_tenth(size_t done, size_t count) {
    constexpr std::chrono::seconds kSilence{1};  // between two lines
    const size_t tenth = 10 * done / count;
    const Clock::time_point now = Clock::now();
    if (!tenth_ || (tenth > *tenth_ && now - printed_ >= kSilence)) {
      tenth_ = tenth;
      printed_ = now;
      std::fprintf(stderr, "%3zu %%: %zu of %zu %s%s\n", 10 * tenth, done,
                   count, what_, time_left(done, count).c_str());
    }
  }

  bool quiet_;
  const char* what_;
  bool terminal_ = is_terminal();
  bool bar_shown_ = false;
  std::optional<size_t> tenth_;  // last one printed
  Clock::time_point printed_;    // when it was
  Clock::time_point begin_ = Clock::now();
};

}  // namespace inkcell::tools
