// What the engines of Inkcell share.
#include "inkcell_strips.hpp"
#include "inkcell/field/draw.hpp"
#if INKCELL_BENCH_TRUETYPE
#  include "inkcell/truetype/truetype_font.hpp"
#endif

using namespace inkcell;

namespace {

// Pixels of a box of ink, rounded outwards.
uint32_t box_pixels(const GlyphMetrics& metrics) {
  const int32_t units = bench::font.units_per_em();
  const int32_t size = bench::style.size().raw;
  const auto to_px_down = [units, size](int32_t value) {
    const int64_t product = int64_t{value} * size;
    const int64_t whole = int64_t{units} * 64;
    return static_cast<int32_t>((product - (product < 0 ? whole - 1 : 0)) /
                                whole);
  };
  const int32_t width = -to_px_down(-metrics.x_max) - to_px_down(metrics.x_min);
  const int32_t rows = -to_px_down(-metrics.y_max) - to_px_down(metrics.y_min);
  return static_cast<uint32_t>(width * rows);
}

// Bytes of all strips that the glyph takes, in the widest format.
int32_t drawn_bytes() {
  const int32_t strips = (bench::height + bench::kRows - 1) / bench::kRows;
  return strips * bench::kRows * kEngineSide * bench::kMaxPixelBytes;
}

}  // namespace

engine_answer bench::place(uint16_t glyph, const Rect& rect) {
  GlyphMetrics metrics;
  if (font.glyph_metrics(glyph, metrics) != Status::ok) {
    return engine_lacks;
  }
  if (rect.x1 - rect.x0 > kEngineSide || rect.y1 - rect.y0 > kEngineSide) {
    return engine_too_large;
  }
  origin = {Q26_6::from_int(-rect.x0), Q26_6::from_int(-rect.y0)};
  height = rect.y1 - rect.y0;
  box = box_pixels(metrics);
  for (int32_t i = 0; i < drawn_bytes(); ++i) {
    pixels[i] = 0;
  }
  return engine_ready;
}

engine_answer bench::place_glyph(uint32_t code_point) {
  uint16_t glyph = 0;
  GlyphField field;
  if (font.glyph_of(code_point, glyph) != Status::ok ||
      read_field(font, glyph, field) != Status::ok) {
    return engine_lacks;
  }
  return place(glyph, field_box(field, style, {}));
}

bool bench::equal(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

bool engine_open(const uint8_t* bytes, size_t size) {
#if INKCELL_BENCH_TRUETYPE
  static TrueTypeFont opened;
  const bool is_open = opened.open({bytes, size}) == Status::ok;
  bench::font = opened.font();
  return is_open;
#else
  return open_any_font({bytes, size}, bench::font) == Status::ok;
#endif
}

uint32_t engine_ink() {
  uint32_t sum = 0;
  for (int32_t i = 0; i < drawn_bytes(); ++i) {
    sum += bench::pixels[i];
  }
  return sum;
}

uint32_t engine_box() {
  return bench::box;
}

size_t engine_heap() {
  return 0;
}
