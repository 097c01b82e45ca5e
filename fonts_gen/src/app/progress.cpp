#include "app/progress.hpp"

#include <cstdio>
#include <string>

#ifdef _WIN32
#  include <io.h>
#else
#  include <unistd.h>
#endif

namespace inkcell::gen {
namespace {

constexpr std::chrono::seconds kSilence{1};  // between two lines
constexpr size_t kBarWidth = 40;             // [columns]

bool is_terminal(std::FILE* file) {
#ifdef _WIN32
  return _isatty(_fileno(file)) != 0;
#else
  return isatty(fileno(file)) != 0;
#endif
}

}  // namespace

Progress::Progress(bool quiet, const char* what)
    : quiet_(quiet),
      what_(what),
      terminal_(is_terminal(stderr)),
      begin_(Clock::now()) {}

Progress::~Progress() {
  if (bar_shown_) {
    std::fputs("\r\033[K", stderr);
  }
}

void Progress::update(size_t done, size_t count) {
  if (quiet_ || count == 0) {
    return;
  }
  if (terminal_) {
    draw_bar(done, count);
  } else {
    print_tenth(done, count);
  }
}

// ", 12 s left", once it can be estimated.
std::string Progress::time_left(size_t done, size_t count) const {
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

void Progress::draw_bar(size_t done, size_t count) {
  const size_t filled = kBarWidth * done / count;
  const std::string bar =
      std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  std::fprintf(stderr, "\r[%s] %zu/%zu %s%s \033[K", bar.c_str(), done, count,
               what_, time_left(done, count).c_str());
  std::fflush(stderr);
  bar_shown_ = true;
}

void Progress::print_tenth(size_t done, size_t count) {
  const size_t tenth = 10 * done / count;
  const Clock::time_point now = Clock::now();
  if (!tenth_ || (tenth > *tenth_ && now - printed_ >= kSilence)) {
    tenth_ = tenth;
    printed_ = now;
    std::fprintf(stderr, "%3zu %%: %zu of %zu %s%s\n", 10 * tenth, done, count,
                 what_, time_left(done, count).c_str());
  }
}

}  // namespace inkcell::gen
