// The RAM that a large digit takes in LVGL: of its heap, of the stack, and the
// font's own. A space instead of the digit tells what LVGL needs besides.
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <vector>

#include "check.hpp"
#include "fonts/lv_sans.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "screen.hpp"

namespace {

constexpr int32_t kSize = 512;  // [px/em]
constexpr size_t kA8 = 94320;   // 262 x 360 px
// Frames are larger with 64 bits than those of Cortex-M3, which tests/bench
// measures.
constexpr size_t kMostStack = 2048;
constexpr size_t kStack = 1 << 20;
constexpr uint8_t kPattern = 0xa5;

struct Job {
  const char* text;
  bool is_direct;
};

struct Cost {
  size_t heap;   // [bytes] at the peak
  size_t stack;  // [bytes]
};

inkcell_lv_font_t font;
Cost cost;

// Draws one screen, and notes the peak of LVGL's heap.
void* draw(void* argument) {
  const auto& job = *static_cast<const Job*>(argument);
  Screen screen(320, 480, LV_COLOR_FORMAT_RGB565, 16);
  if (job.is_direct) {
    inkcell_lv_font_set_direct(&font);
  }
  Look look;
  look.font = &font.lv;
  look.text = job.text;
  screen.add(look);
  screen.draw();
  lv_mem_monitor_t heap;
  lv_mem_monitor(&heap);
  cost.heap = heap.max_used;
  return nullptr;
}

// Each picture in a process of its own, whose heap and stack are fresh.
Cost measure(Job job) {
  int ends[2];
  CHECK_EQ(pipe(ends), 0);
  const pid_t child = fork();
  if (child == 0) {
    static_cast<void>(inkcell_lv_font_init(&font, fonts::lv_sans,
                                           sizeof fonts::lv_sans, kSize * 64));
    alignas(64) static uint8_t stack[kStack];
    memset(stack, kPattern, sizeof stack);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstack(&attributes, stack, sizeof stack);
    pthread_t thread;
    pthread_create(&thread, &attributes, draw, &job);
    pthread_join(thread, nullptr);
    size_t untouched = 0;
    while (stack[untouched] == kPattern) {
      ++untouched;
    }
    cost.stack = kStack - untouched;
    const bool is_sent = write(ends[1], &cost, sizeof cost) == sizeof cost;
    _exit(is_sent ? 0 : 1);
  }
  Cost result = {};
  CHECK_EQ(read(ends[0], &result, sizeof result), sizeof result);
  int status = 1;
  CHECK_EQ(waitpid(child, &status, 0), child);
  CHECK_EQ(status, 0);
  close(ends[0]);
  close(ends[1]);
  return result;
}

size_t more(size_t with, size_t without) {
  return with > without ? with - without : 0;
}

}  // namespace

TEST(large_digit_needs_little_ram) {
  const Cost blank = measure({" ", true});
  const Cost direct = measure({"0", true});
  const Cost bitmap = measure({"0", false});
  const size_t direct_heap = more(direct.heap, blank.heap);
  const size_t direct_stack = more(direct.stack, blank.stack);
  printf("digit of %d px/em, bytes beside what a space takes\n", kSize);
  printf("  direct: heap %zu, stack %zu, font %zu\n", direct_heap, direct_stack,
         sizeof(inkcell_lv_font_t));
  printf("  bitmap: heap %zu, stack %zu\n", more(bitmap.heap, blank.heap),
         more(bitmap.stack, blank.stack));
  CHECK_EQ(direct_heap, 0);
  CHECK(direct_stack < kMostStack);
  CHECK(more(bitmap.heap, blank.heap) > kA8);
}
