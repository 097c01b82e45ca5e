// Runs an example of port/display/examples against a model of its display.
//
// The functions of the example's your_board.h are the test's. They call
// stop() when they have seen enough, which ends the example. On a board the
// example's stack is printed.
#pragma once

#include "check.hpp"
#include "inkcell/geometry.hpp"

#if INKCELL_BOARD_FIRMWARE
#  include "stack.hpp"
#else
#  include <stdio.h>
#  include <stdlib.h>
#endif

/// The example's main().
#if EXAMPLE_IS_C
extern "C"
#endif
    int
    example_main();

namespace example {

using inkcell::Rect;

inline void* place[5];

[[noreturn, gnu::noinline]] inline void stop() {
  __builtin_longjmp(place, 1);
}

[[gnu::noinline]] inline void run_to_stop() {
  if (__builtin_setjmp(place) == 0) {
    const int status = example_main();
    CHECK_EQ(status, -1 && "examples do not end");
  }
}

inline void run() {
#if INKCELL_BOARD_FIRMWARE
  const size_t stack = inkcell::board::count_stack(run_to_stop);
  check::write("stack ");
  check::write_number(static_cast<int64_t>(stack));
  check::write("\n");
#else
  run_to_stop();
#endif
}

/// A screen as the user sees it: 24-bit colours.
template <int32_t kWidth, int32_t kHeight>
struct Screen {
  uint32_t pixels[static_cast<size_t>(kHeight)][static_cast<size_t>(kWidth)];

  /// Pixels of another colour than `paper` in a rectangle.
  int32_t ink(const Rect& rect, uint32_t paper) const {
    int32_t count = 0;
    for (int32_t y = rect.y0; y < rect.y1; ++y) {
      for (int32_t x = rect.x0; x < rect.x1; ++x) {
        count += pixels[y][x] != paper ? 1 : 0;
      }
    }
    return count;
  }
  int32_t ink(uint32_t paper) const {
    return ink({0, 0, kWidth, kHeight}, paper);
  }

  /// The smallest rectangle with all pixels that differ from another screen.
  Rect changes(const Screen& other) const {
    Rect rect = {kWidth, kHeight, 0, 0};
    for (int32_t y = 0; y < kHeight; ++y) {
      for (int32_t x = 0; x < kWidth; ++x) {
        if (pixels[y][x] != other.pixels[y][x]) {
          rect.x0 = x < rect.x0 ? x : rect.x0;
          rect.x1 = x >= rect.x1 ? x + 1 : rect.x1;
          rect.y0 = y < rect.y0 ? y : rect.y0;
          rect.y1 = y + 1;
        }
      }
    }
    return rect;
  }

  /// Prints a hash, which is the same on all machines. On the host it writes
  /// <folder>/<name>_<frame>.ppm, too, if INKCELL_PICTURES names a folder.
  void show(const char* name, int32_t frame) const {
    uint32_t hash = 2166136261;
    for (const auto& row : pixels) {
      for (const uint32_t pixel : row) {
        hash = (hash ^ pixel) * 16777619;
      }
    }
    check::write(name);
    check::write(" ");
    check::write_number(frame);
    check::write(": ");
    check::write_number(hash);
    check::write("\n");
#if !INKCELL_BOARD_FIRMWARE
    if (const char* const folder = getenv("INKCELL_PICTURES")) {
      char path[256];
      snprintf(path, sizeof path, "%s/%s_%03d.ppm", folder, name, frame);
      FILE* const file = fopen(path, "wb");
      CHECK(file != nullptr);
      if (file != nullptr) {
        fprintf(file, "P6\n%d %d\n255\n", kWidth, kHeight);
        for (const auto& row : pixels) {
          for (const uint32_t pixel : row) {
            for (int shift = 16; shift >= 0; shift -= 8) {
              fputc(static_cast<int>(pixel >> shift & 255), file);
            }
          }
        }
        fclose(file);
      }
    }
#endif
  }
};

/// Whether `inner` is not empty and lies in `outer`.
constexpr bool lies_in(const Rect& inner, const Rect& outer) {
  return !is_empty(inner) && inner.x0 >= outer.x0 && inner.y0 >= outer.y0 &&
         inner.x1 <= outer.x1 && inner.y1 <= outer.y1;
}

}  // namespace example
