#include "app/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace inkcell::gen {
namespace {

constexpr std::chrono::seconds kSilence{2};
constexpr size_t kBarWidth = 40;  // [columns]

}  // namespace

Progress::Progress(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      begin_(std::chrono::steady_clock::now()) {}

void Progress::update(size_t done, size_t count) {
  if (quiet_ || count == 0 ||
      std::chrono::steady_clock::now() - begin_ < kSilence) {
    return;
  }
  if (terminal_) {
    draw_bar(done, count);
  } else {
    print_tenth(done, count);
  }
}

void Progress::draw_bar(size_t done, size_t count) {
  const std::chrono::duration<double> spent =
      std::chrono::steady_clock::now() - begin_;
  const size_t filled = kBarWidth * done / count;
  const std::string bar =
      std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  const double left = done == 0
                          ? 0
                          : spent.count() * static_cast<double>(count - done) /
                                static_cast<double>(done);
  std::fprintf(stderr, "\r[%s] %zu/%zu glyphs, %.0f s left \033[K", bar.c_str(),
               done, count, left);
  std::fflush(stderr);
  bar_shown_ = true;
}

void Progress::print_tenth(size_t done, size_t count) {
  const size_t tenth = 10 * done / count;
  if (tenth > tenth_) {
    tenth_ = tenth;
    std::fprintf(stderr, "%3zu %%: %zu of %zu glyphs\n", 10 * tenth, done,
                 count);
  }
}

void Progress::finish() {
  if (bar_shown_) {
    std::fputs("\r\033[K", stderr);
  }
}

}  // namespace inkcell::gen
