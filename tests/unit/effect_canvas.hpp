// What tests of effects draw on, and what they all must keep.
#pragma once

#include "check.hpp"
#include "inkcell/field/draw.hpp"

namespace effect {

using namespace inkcell;

inline constexpr int32_t kSide = 40;
inline uint8_t picture[kSide * kSide];
inline uint8_t whole[kSide * kSide];

// Keeps what is drawn; fails if pixels leave the window or come twice.
struct Canvas {
  Rect window;
  Rect shown;                        // the part that may be drawn to
  uint8_t drawn[kSide * kSide / 8];  // a bit a pixel

  explicit Canvas(const Rect& all) : window(all), shown(all) {
    for (uint8_t& pixel : picture) {
      pixel = 0;
    }
    show(all);
  }
  void show(const Rect& part) {
    shown = part;
    for (uint8_t& eight : drawn) {
      eight = 0;
    }
  }
  Sink sink() { return {shown, this, coverage, solid}; }

  void put(int32_t x, int32_t y, const uint8_t* values, int32_t count) {
    const bool fits = count >= 1 && y >= shown.y0 && y < shown.y1 &&
                      x >= shown.x0 && count <= shown.x1 - x;
    CHECK(fits && "pixels inside the window");
    for (int32_t i = 0; fits && i < count; ++i) {
      const int32_t at = (y - window.y0) * kSide + x - window.x0 + i;
      const int32_t bit = 1 << at % 8;
      CHECK((drawn[at / 8] & bit) == 0 && "no pixel twice");
      drawn[at / 8] = static_cast<uint8_t>(drawn[at / 8] | bit);
      picture[at] = values != nullptr ? values[i] : 255;
    }
  }
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    CHECK(count <= kMaxSpan);
    static_cast<Canvas*>(context)->put(x, y, coverage, count);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    static_cast<Canvas*>(context)->put(x, y, nullptr, count);
  }
};

inline constexpr Rect kAll = {-3, -2, -3 + kSide, -2 + kSide};

inline void draw(const GlyphField& field,
                 const Style& style,
                 FinePoint origin) {
  Canvas canvas(kAll);
  draw_field(field, style, origin, canvas.sink());
}

inline int32_t ink() {
  int32_t sum = 0;
  for (const uint8_t pixel : picture) {
    sum += pixel;
  }
  return sum;
}

inline void keep() {
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    whole[i] = picture[i];
  }
}

inline void check_windows(const GlyphField& field,
                          const Style& style,
                          FinePoint origin) {
  draw(field, style, origin);
  keep();
  for (int32_t cut = 1; cut < kSide; cut += 5) {
    Canvas parts(kAll);
    const int32_t x = kAll.x0 + cut;
    for (int32_t y = kAll.y0; y < kAll.y1; y += cut) {
      parts.show(intersect(kAll, {kAll.x0, y, x, y + cut}));
      draw_field(field, style, origin, parts.sink());
      parts.show(intersect(kAll, {x, y, kAll.x1, y + cut}));
      draw_field(field, style, origin, parts.sink());
    }
    for (int32_t i = 0; i < kSide * kSide; ++i) {
      CHECK_EQ(picture[i], whole[i]);
    }
  }
}

inline int32_t magnitude(int32_t value) {
  return value < 0 ? -value : value;
}

}  // namespace effect
