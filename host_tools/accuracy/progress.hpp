// A progress bar on the terminal.
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace inkcell::tools {

/// Draws on standard error if that is a terminal, after the first second, and
/// erases itself at the end.
class ProgressBar {
 public:
  ProgressBar() : begin_(std::chrono::steady_clock::now()) {}
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar() {
    if (shown_) {
      std::fputs("\r\033[K", stderr);
    }
  }

  /// `done` of `count` glyphs are finished. One thread at a time.
  void update(size_t done, size_t count) {
    const std::chrono::duration<double> spent =
        std::chrono::steady_clock::now() - begin_;
    if (isatty(STDERR_FILENO) == 0 || spent.count() < 1 || done == 0) {
      return;
    }
    constexpr size_t kWidth = 40;  // [columns]
    const size_t filled = kWidth * done / count;
    const std::string bar =
        std::string(filled, '#') + std::string(kWidth - filled, '.');
    const double left = spent.count() * static_cast<double>(count - done) /
                        static_cast<double>(done);
    std::fprintf(stderr, "\r[%s] %zu/%zu glyphs, %.0f s left \033[K",
                 bar.c_str(), done, count, left);
    shown_ = true;
  }

 private:
  std::chrono::steady_clock::time_point begin_;
  bool shown_ = false;
};

}  // namespace inkcell::tools
