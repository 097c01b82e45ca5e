// Draws a label with LVGL, and counts.
//
//   FIRMWARE FONT TEXT Y WIDTH HEIGHT ROWS PX...
//
// FONT is a ROM font; the label's is that at PX px, or one of lv_font_conv. The
// screen has WIDTH x HEIGHT pixels of RGB565, drawn in strips of ROWS rows, and
// the label stands at row Y. Prints what the text takes more than a space:
//
//   label PX FIRST LATER STACK HEAP    instructions of the first drawing and of
//                                      a later one; bytes, the most
//   object FONT CACHE                  bytes of a font with its fitting, and of
//                                      a cache for all
//
// INKCELL_LABEL says with which font: kLabels in ../../lvgl.py.
#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "heap.h"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "stack.hpp"

LV_FONT_DECLARE(lv_14_raw)
LV_FONT_DECLARE(lv_28_raw)
LV_FONT_DECLARE(lv_14_rle)
LV_FONT_DECLARE(lv_28_rle)

namespace {

using namespace inkcell;
using bench::parse;

enum Label { kBlank, kRaw, kRle, kBitmap, kFitted, kDirect, kCached };
constexpr int kLabel = INKCELL_LABEL;

alignas(4) uint8_t rom[1 << 17];
size_t rom_bytes = 0;
alignas(8) uint8_t strip[320 * 40 * 2];

struct OwnFont {
  inkcell_lv_font_t font;
  inkcell_lv_fit_t fit;
  inkcell_lv_cache_t cache;
  alignas(8) uint8_t ram[4096];
};
OwnFont own;

constexpr size_t kFontBytes =
    kLabel < kBitmap
        ? 0
        : sizeof own.font + (kLabel == kFitted ? sizeof own.fit : 0);
constexpr size_t kCacheBytes =
    kLabel == kCached ? sizeof own.cache + sizeof own.ram : 0;

const lv_font_t* font_of(uint32_t px) {
  if constexpr (kLabel == kBlank) {
    return &bench_no_font;
  } else if constexpr (kLabel == kRaw) {
    return px == 14 ? &lv_14_raw : &lv_28_raw;
  } else if constexpr (kLabel == kRle) {
    return px == 14 ? &lv_14_rle : &lv_28_rle;
  } else {
    lv_result_t result = inkcell_lv_font_init(&own.font, rom, rom_bytes,
                                              static_cast<int32_t>(px) * 64);
    if constexpr (kLabel == kFitted) {
      if (result == LV_RESULT_OK) {
        result = inkcell_lv_font_fit_heights(&own.font, &own.fit);
      }
    }
    if constexpr (kLabel >= kDirect) {
      inkcell_lv_font_set_direct(&own.font);
    }
    if constexpr (kLabel == kCached) {
      if (result == LV_RESULT_OK) {
        result = inkcell_lv_cache_init(&own.cache, own.ram, sizeof own.ram, 1);
        inkcell_lv_font_set_cache(&own.font, &own.cache);
      }
    }
    return result == LV_RESULT_OK ? &own.font.lv : nullptr;
  }
}

lv_display_t* make_screen(int32_t width, int32_t height, int32_t rows) {
  lv_init();
  lv_display_t* display = lv_display_create(width, height);
  lv_display_set_color_format(display, LV_COLOR_FORMAT_RGB565);
  lv_display_set_buffers(display, strip, nullptr,
                         static_cast<uint32_t>(width * rows * 2),
                         LV_DISPLAY_RENDER_MODE_PARTIAL);
  lv_display_set_flush_cb(display,
                          [](lv_display_t* shown, const lv_area_t*, uint8_t*) {
                            lv_display_flush_ready(shown);
                          });
  return display;
}

lv_obj_t* make_label(const lv_font_t* font, int32_t y) {
  lv_obj_t* screen = lv_screen_active();
  lv_obj_set_style_bg_color(screen, lv_color_hex(0xf0e8d0), 0);
  lv_obj_set_style_bg_opa(screen, LV_OPA_COVER, 0);
  lv_obj_t* label = lv_label_create(screen);
  lv_obj_set_style_text_font(label, font, 0);
  lv_obj_set_style_text_color(label, lv_color_hex(0x102030), 0);
  lv_obj_set_y(label, y);
  return label;
}

// A drawing of the whole screen.
struct Cost {
  uint32_t first;
  uint32_t later;
  size_t stack;
  size_t heap;
};

Cost draw(lv_display_t* display, lv_obj_t* label, const char* text) {
  lv_label_set_text_static(label, text);
  const auto work = [display] { lv_refr_now(display); };
  const auto prepare = [] {
    lv_obj_invalidate(lv_screen_active());
    lv_obj_update_layout(lv_screen_active());
  };
  Cost cost;
  heap_forget();
  const size_t before = heap_most();
  // The first drawing may take more of the stack.
  prepare();
  cost.stack =
      board::count_stack([&] { cost.first = board::count_instructions(work); });
  prepare();
  cost.later = board::count_instructions(work);
  cost.heap = heap_most() - before;
  return cost;
}

size_t more(size_t with, size_t without) {
  return with > without ? with - without : 0;
}

bool run(uint32_t px, char** arguments) {
  lv_display_t* display =
      make_screen(static_cast<int32_t>(parse(arguments[2])),
                  static_cast<int32_t>(parse(arguments[3])),
                  static_cast<int32_t>(parse(arguments[4])));
  const bool is_up = arguments[1][0] == '-';
  const auto y = static_cast<int32_t>(parse(arguments[1] + (is_up ? 1 : 0)));
  const lv_font_t* font = font_of(px);
  if (font == nullptr) {
    return false;
  }
  lv_obj_t* label = make_label(font, is_up ? -y : y);
  draw(display, label, " ");  // what LVGL allocates once
  const Cost space = draw(display, label, " ");
  const Cost text = draw(display, label, arguments[0]);
  lv_deinit();
  bench::print_row("label", px, more(text.first, space.first),
                   more(text.later, space.later), more(text.stack, space.stack),
                   more(text.heap, space.heap));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  rom_bytes = argc < 8 ? 0 : bench::read_file(argv[1], rom, sizeof rom);
  if (rom_bytes == 0) {
    return bench::fail("usage: FONT TEXT Y WIDTH HEIGHT ROWS PX...");
  }
  for (int i = 7; i < argc; ++i) {
    if (!run(parse(argv[i]), argv + 2)) {
      return bench::fail("the font does not open");
    }
  }
  bench::print_row("object", kFontBytes, kCacheBytes);
  return 0;
}
