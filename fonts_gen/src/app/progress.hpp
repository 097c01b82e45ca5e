// Progress and time left, on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace inkcell::gen {

/// Draws a bar on a terminal. Elsewhere prints a line at the start and for each
/// tenth, at most one a second.
class Progress {
 public:
  /// `what` is the plural of the things made.
  explicit Progress(bool quiet, const char* what = "glyphs");
  /// Removes the bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `count` glyphs are finished.
  void update(size_t done, size_t count);

 private:
  void draw_bar(size_t done, size_t count);
  void print_tenth(size_t done, size_t count);
  std::string time_left(size_t done, size_t count) const;

  using Clock = std::chrono::steady_clock;

  bool quiet_;
  const char* what_;
  bool terminal_;
  bool bar_shown_ = false;
  std::optional<size_t> tenth_;  // last one printed
  Clock::time_point printed_;    // when it was
  Clock::time_point begin_;
};

}  // namespace inkcell::gen
