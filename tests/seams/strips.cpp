// Whether pictures of a whole font of outlines depend on strips.
//
//   strips <font.bin> [strikes | only-strikes]
//
// Draws every glyph by distance, by area and with a wide filter, upright and
// turned, at sizes from 8 to 200 px: whole with a large workspace, then in
// strips of several heights and in two columns with small ones and with none.
// Of a font with strikes, 12 px and twice that: fitted, and as designed, with
// the levels of each canvas.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "inkcell/font.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "rom_file.hpp"

namespace {

using namespace inkcell;

// What PreparedGlyph::make takes where pointers have 64 bits.
constexpr uint32_t kLeastBytes = 928;

constexpr Filter kWide =
    make_filter({Q6_10::from_raw(-3500), Q6_10::from_raw(2500)});

struct Picture {
  int32_t width;
  int32_t height;
  std::vector<uint8_t> pixels;

  Picture(int32_t columns, int32_t rows)
      : width(columns),
        height(rows),
        pixels(static_cast<size_t>(columns * rows)) {}

  decltype(Sink::levels) levels = nullptr;

  Sink sink(const Rect& window) {
    Sink sink = {window, this, coverage, solid};
    sink.levels = levels;
    return sink;
  }

  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    auto& picture = *static_cast<Picture*>(context);
    std::copy(coverage, coverage + count,
              picture.pixels.begin() + y * picture.width + x);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    auto& picture = *static_cast<Picture*>(context);
    std::fill_n(picture.pixels.begin() + y * picture.width + x, count,
                uint8_t{255});
  }
};

Style make_style(int look, int32_t px) {
  const Q26_6 size = Q26_6::from_int(px);
  Direction turned;
  turned.cosine.raw = 858993459;
  turned.sine.raw = -644245094;
  const Filter* const filters[] = {&kFilterText, &kFilterArea, &kWide};
  const Filter& filter = *filters[look % 3];
  return look < 3 ? Style(size, filter) : Style(size, filter, turned);
}

constexpr int kLooks = 6;

// Those that strikes serve, and what lies between: on canvases of many levels,
// of 1 and of 2 bits.
Style make_strike_style(int look, int32_t px) {
  const Q26_6 size = Q26_6::from_int(px);
  return look % 3 == 0   ? strike_style(size)
         : look % 3 == 1 ? strike_height_style(size)
                         : Style(size).clear_fit();
}
decltype(Sink::levels) levels_of(int look) {
  return look == 3   ? port::MonoRowsCanvas().levels
         : look == 4 ? port::Grey2Canvas().levels
                     : nullptr;
}

// How many pixels differ.
int64_t compare(const Font& font,
                uint16_t glyph,
                const Style& style,
                int32_t px,
                decltype(Sink::levels) levels) {
  const int32_t width = 2 * px + 12;
  const int32_t height = 2 * px + 12;
  const Point origin = {Q26_6::from_raw(px * 32 + glyph * 11 % 64),
                        Q26_6::from_raw(px * 90 + glyph * 7 % 64)};
  Picture whole(width, height);
  whole.levels = levels;
  std::vector<uint32_t> ram(1 << 14);
  const Workspace large(reinterpret_cast<uint8_t*>(ram.data()), 1 << 16);
  Painter(whole.sink({0, 0, width, height}), large)
      .glyph(font, style, origin, glyph);
  int64_t differences = 0;
  for (const int32_t rows : {1, 5, 16, height}) {
    Picture parts(width, height);
    parts.levels = levels;
    const int32_t cut = rows * 7 % width;
    for (int32_t y = 0; y < height; y += rows) {
      const int32_t end = std::min(y + rows, height);
      const Workspace small = {large.data, rows % 2 == 0 ? 2560u : kLeastBytes};
      Painter(parts.sink({0, y, cut, end}), small)
          .glyph(font, style, origin, glyph);
      Painter(parts.sink({cut, y, width, end}))
          .glyph(font, style, origin, glyph);
    }
    for (size_t i = 0; i < whole.pixels.size(); ++i) {
      differences += whole.pixels[i] != parts.pixels[i] ? 1 : 0;
    }
  }
  return differences;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string strikes = argc == 3 ? argv[2] : "";
  const bool is_alone = strikes == "only-strikes";
  if (argc < 2 || argc > 3 ||
      (argc == 3 && !is_alone && strikes != "strikes")) {
    std::fprintf(stderr, "strips <font.bin> [strikes | only-strikes]\n");
    return 2;
  }
  const bool has_strikes = argc == 3;
  const RomFile file(argv[1], is_alone      ? &kStrikeCoding
                              : has_strikes ? &kOutlineStrikeCoding
                                            : nullptr);
  const Font& font = file.font();
  const std::vector<int32_t> sizes = has_strikes
                                         ? std::vector<int32_t>{12, 24}
                                         : std::vector<int32_t>{8, 13, 31, 200};
  int64_t pictures = 0;
  int64_t failures = 0;
  for (uint16_t glyph = 1; glyph < font.glyph_count(); ++glyph) {
    for (int look = 0; look < kLooks; ++look) {
      for (const int32_t px : sizes) {
        if (px == 200 && glyph % 8 != look) {
          continue;
        }
        const Style style =
            has_strikes ? make_strike_style(look, px) : make_style(look, px);
        const int64_t different = compare(
            font, glyph, style, px, has_strikes ? levels_of(look) : nullptr);
        ++pictures;
        if (different != 0) {
          ++failures;
          std::printf("glyph %d, look %d, %d px: %lld pixels differ\n", glyph,
                      look, px, static_cast<long long>(different));
        }
      }
    }
  }
  std::printf("%lld pictures, %lld depend on strips\n",
              static_cast<long long>(pictures),
              static_cast<long long>(failures));
  return pictures >= 94 * kLooks * (has_strikes ? 2 : 3) && failures == 0 ? 0
                                                                          : 1;
}
