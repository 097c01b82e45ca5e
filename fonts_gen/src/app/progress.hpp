// Progress of work that takes longer than two seconds, on standard error.
#pragma once

#include <chrono>
#include <cstddef>

namespace inkcell::gen {

/// Draws a bar on a terminal; elsewhere prints a line for each tenth.
class Progress {
 public:
  explicit Progress(bool quiet);

  /// `done` of `count` glyphs are finished.
  void update(size_t done, size_t count);
  /// Takes the bar away. No more updates follow.
  void finish();

 private:
  void draw_bar(size_t done, size_t count);
  void print_tenth(size_t done, size_t count);

  bool quiet_;
  bool terminal_;
  bool bar_shown_ = false;
  size_t tenth_ = 0;  // last one printed
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace inkcell::gen
