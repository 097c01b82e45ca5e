#include "exercise.hpp"

#include <stdio.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "inkcell/field/draw.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"

namespace hostile {
namespace {

using namespace inkcell;

constexpr int32_t kWidth = 37;  // more than kMaxSpan
constexpr int32_t kHeight = 18;
constexpr size_t kGuard = 64;
constexpr uint8_t kGuardByte = 0xa5;

bool bytes_change = false;

// A strip between guards. Checks each call, and blends like a grey display.
class Canvas {
 public:
  explicit Canvas(const Rect& window)
      : window_(window),
        width_(window.x1 - window.x0),
        bytes_(
            2 * kGuard + static_cast<size_t>(width_ * (window.y1 - window.y0)),
            kGuardByte),
        drawn_(bytes_.size()) {
    std::fill(bytes_.begin() + kGuard, bytes_.end() - kGuard, uint8_t{0});
  }

  Sink sink() { return {window_, this, coverage, solid}; }
  // Glyphs of a run may overlap; within a glyph, each pixel comes once.
  void next_glyph() { std::fill(drawn_.begin(), drawn_.end(), uint8_t{0}); }
  void check_guards() const {
    for (size_t i = 0; i < kGuard; ++i) {
      require(bytes_[i] == kGuardByte, "guard before the strip");
      require(bytes_[bytes_.size() - 1 - i] == kGuardByte,
              "guard after the strip");
    }
  }
  bool row_equals(int32_t y, const Canvas& other) const {
    return std::memcmp(row(y), other.row(y), static_cast<size_t>(width_)) == 0;
  }

 private:
  const uint8_t* row(int32_t y) const {
    return bytes_.data() + kGuard + (y - window_.y0) * width_;
  }
  uint8_t* begin(int32_t x, int32_t y, int32_t count) {
    require(y >= window_.y0 && y < window_.y1, "row in the window");
    require(x >= window_.x0 && x < window_.x1, "pixel in the window");
    require(count >= 1 && count <= window_.x1 - x, "run in the window");
    const auto at = static_cast<ptrdiff_t>(kGuard) + (y - window_.y0) * width_ +
                    x - window_.x0;
    for (ptrdiff_t i = at; i < at + count; ++i) {
      require(drawn_[static_cast<size_t>(i)]++ == 0 || bytes_change,
              "no pixel twice");
    }
    return bytes_.data() + at;
  }
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    require(count <= kMaxSpan, "length of the span");
    uint8_t* at = static_cast<Canvas*>(context)->begin(x, y, count);
    for (int32_t i = 0; i < count; ++i) {
      at[i] = static_cast<uint8_t>(at[i] + (255 - at[i]) * coverage[i] / 255);
    }
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    uint8_t* at = static_cast<Canvas*>(context)->begin(x, y, count);
    std::fill(at, at + count, uint8_t{255});
  }

  Rect window_;
  int32_t width_;
  std::vector<uint8_t> bytes_;
  std::vector<uint8_t> drawn_;
};

struct Look {
  int32_t size_q6;
  int32_t cosine_q30;
  int32_t sine_q30;
};

constexpr int32_t kOne = 1 << 30;
constexpr Look kLooks[] = {
    {4 * 64, kOne, 0},    {13 * 64 + 21, kOne, 0},
    {1024 * 64, kOne, 0}, {4 * 64, 759250125, 759250125},
    {20 * 64, 0, -kOne},  {700 * 64, -858993459, 644245094}};

Style style_of(const Look& look) {
  Direction direction;
  direction.cosine.raw = look.cosine_q30;
  direction.sine.raw = look.sine_q30;
  return Style(Q26_6::from_raw(look.size_q6), kFilterText, direction);
}

void use_glyph(const Font& font, uint16_t glyph) {
  GlyphMetrics metrics;
  const bool known = font.glyph_metrics(glyph, metrics) == Status::ok;
  require(known == (glyph < font.glyph_count()), "glyphs up to the count");
  require(metrics.advance >= 0 && metrics.advance <= 65535, "advance");
  const Span<const uint8_t> record = font.record(glyph);
  const Span<const uint8_t> rom = font.rom();
  require(record.size <= rom.size &&
              (record.size == 0 ||
               (record.data >= rom.data &&
                record.data + record.size <= rom.data + rom.size)),
          "record in the font");
  for (const Look& look : kLooks) {
    // A place in the upper part of a glyph of any size.
    const Point origin = {Q26_6::from_raw(-look.size_q6 / 8 + 1000),
                          Q26_6::from_raw(look.size_q6 / 2 + 300)};
    Style style = style_of(look);
    draw_checked(font, glyph, style, origin);
    Fit fit;
    FitOptions options;
    options.across = glyph % 2 == 0;
    options.levels = static_cast<uint8_t>(glyph % 3 * 2);
    options.strength_q8 = static_cast<uint16_t>(256 - glyph % 100);
    if (style.is_upright() &&
        Fit::make(font, style, options, fit) == Status::ok) {
      style.set_fit(fit);
      draw_checked(font, glyph, style, origin);
    }
  }
}

void use_tables(const Font& font) {
  const FontMetrics metrics = font.metrics();
  require(metrics.units_per_em >= 1, "units per em");
  volatile uint32_t sum = font.range().band_u;
  for (const char c : font.name()) {
    sum = sum + static_cast<uint8_t>(c);
  }
  const uint32_t code_points[] = {0,      ' ',     'A',      'B',       'C',
                                  0x7fff, 0x1f600, 0x10ffff, 0xffffffff};
  for (const uint32_t code_point : code_points) {
    uint16_t glyph = 1;
    const Status status = font.glyph_of(code_point, glyph);
    require(status == Status::ok ? glyph < font.glyph_count() : glyph == 0,
            "glyph of a code point");
  }
  const uint16_t ids[] = {0, 1, 2, 3, 4, 5, 0x7fff, 0xffff};
  for (const uint16_t left : ids) {
    for (const uint16_t right : ids) {
      const int32_t kerning = font.kerning(left, right);
      require(kerning >= INT16_MIN && kerning <= INT16_MAX, "kerning");
    }
  }
}

bool is_of_outlines(const Font& font) {
  return font.rom().data[format::header::kCoding] ==
         static_cast<uint8_t>(format::Coding::outline);
}

// Whether hostile numbers give the same picture in every window. For larger
// upright text in object order, fields must be within the format's limits;
// outlines must be in their boxes.
bool is_exact(const Font& font, const Style& style) {
  return !bytes_change && !is_of_outlines(font) &&
         (style.size().raw < 40 * 64 || !style.is_upright());
}

}  // namespace

void require(bool condition, const char* what) {
  if (!condition) {
    fprintf(stderr, "hostile font: broken promise: %s\n", what);
    abort();
  }
}

void expect_changing_bytes() {
  bytes_change = true;
}

bool bytes_may_change() {
  return bytes_change;
}

// Draws one picture, then the same in two strips, then row by row by distances.
void draw_checked(const Font& font,
                  uint16_t glyph,
                  const Style& style,
                  Point origin) {
  Canvas whole({0, 0, kWidth, kHeight});
  Painter(whole.sink()).glyph(font, style, origin, glyph);
  whole.check_guards();
  Canvas upper({0, 0, kWidth, 7});
  Painter(upper.sink()).glyph(font, style, origin, glyph);
  upper.check_guards();
  Canvas lower({0, 7, kWidth, kHeight});
  Painter(lower.sink()).glyph(font, style, origin, glyph);
  lower.check_guards();
  for (int32_t y = 0; y < kHeight; ++y) {
    require(
        !is_exact(font, style) || whole.row_equals(y, y < 7 ? upper : lower),
        "the same picture in strips");
  }
  GlyphField field;
  if (read_field(font, glyph, field) == Status::ok) {
    std::array<Q6_10, kWidth> distances;
    distance_row(field, style, origin, -3, 5,
                 {distances.data(), distances.size()});
    const auto x = static_cast<int32_t>(glyph * 97 % 2000 * 65536);
    distance_at(field, Q16_16::from_raw(x), Q16_16::from_raw(x / 3));
    gradient_at(field, Q16_16::from_raw(x), Q16_16::from_raw(x / 3));
  }
}

void use_text(const Font& font, Text text, const Style& style, Point origin) {
  const TextMeasure line = measure(font, text);
  require(line.advance >= -(1 << 24) && line.advance <= 1 << 24, "advance");
  std::array<PositionedGlyph, 64> buffer;
  Span<const PositionedGlyph> run;
  require(
      text.size <= buffer.size() &&
          Painter().lay_out(font, Style(), text, {buffer.data(), buffer.size()},
                            run) == Status::ok &&
          run.size <= text.size,
      "layout");
  Canvas whole({0, 0, kWidth, kHeight});
  Canvas parts({0, 0, kWidth, kHeight});
  for (const PositionedGlyph& glyph : run) {
    whole.next_glyph();
    Painter(whole.sink()).glyphs(font, style, origin, {&glyph, 1});
  }
  whole.check_guards();
  // As a line of text, calls restart with each glyph: one window a row.
  for (int32_t y = 0; y < kHeight; ++y) {
    for (const PositionedGlyph& glyph : run) {
      parts.next_glyph();
      Sink sink = parts.sink();
      sink.window.y0 = y;
      sink.window.y1 = y + 1;
      Painter(sink).glyphs(font, style, origin, {&glyph, 1});
    }
    require(!is_exact(font, style) || parts.row_equals(y, whole),
            "the same line row by row");
  }
}

void use(const Font& font) {
  use_tables(font);
  use_text(font,
           "AB\xf0\x9f\x98\x80 C\xff"
           "BA",
           style_of(kLooks[1]), {Q26_6::from_int(2), Q26_6::from_int(14)});
  const uint16_t count = font.glyph_count();
  for (uint16_t glyph = 0; glyph < count && glyph < 5; ++glyph) {
    use_glyph(font, glyph);
  }
  use_glyph(font, static_cast<uint16_t>(count - 1));
  use_glyph(font, count);
}

// A verified font has every glyph.
void use_verified(const Font& font) {
  for (uint16_t glyph = 0; glyph < font.glyph_count(); ++glyph) {
    GlyphField field;
    const Status status = read_field(font, glyph, field);
    require(status == Status::ok ||
                (status == Status::unsupported && is_of_outlines(font)),
            "verified glyphs open");
  }
}

Outcome exercise(Span<const uint8_t> rom) {
  Outcome outcome;
  Font font;
  outcome.opened = open_any_font(rom, font) == Status::ok;
  if (outcome.opened) {
    outcome.verified = verify_fields(font) == Status::ok;
    if (outcome.verified) {
      use_verified(font);
    }
    use(font);
  } else {
    require(font.glyph_count() == 0, "a refused font stays closed");
  }
  return outcome;
}

}  // namespace hostile
