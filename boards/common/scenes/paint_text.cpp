#include "paint_text.hpp"

namespace inkcell::scenes {
namespace {

int32_t px_q6(const Font& font, Q26_6 size, int32_t units) noexcept {
  return static_cast<int32_t>(int64_t{units} * size.raw / font.units_per_em());
}

}  // namespace

motion::DistanceGrid take_grid(Span<int8_t>& left,
                               int32_t width,
                               int32_t height,
                               int32_t scale) noexcept {
  using motion::DistanceGrid;
  const size_t size = samples_for(width, height, scale);
  if (size > left.size) {
    left.size = 0;
    return {};
  }
  const DistanceGrid grid(left, DistanceGrid::samples_of(width, scale),
                          DistanceGrid::samples_of(height, scale), scale);
  left = {left.data + size, left.size - size};
  return grid;
}

Text word_of(Text text, size_t index) noexcept {
  size_t end = 0;
  while (end < text.size && text.data[end] != ' ') {
    ++end;
  }
  const size_t after = end < text.size ? end + 1 : end;
  return index == 0 ? Text(text.data, end)
                    : Text(text.data + after, text.size - after);
}

bool find_place(const Font& font,
                Text text,
                int32_t width,
                int32_t height,
                int32_t width_part_q8,
                int32_t height_part_q8,
                TextPlace& out) noexcept {
  const TextMeasure ink = measure(font, text);
  const int32_t ink_width = ink.x_max - ink.x_min;
  const int32_t ink_height = ink.y_max - ink.y_min;
  if (ink_width <= 0 || ink_height <= 0) {
    return false;
  }
  const int64_t em_q6 = int64_t{font.units_per_em()} * 64;
  const int64_t by_height = em_q6 * height * height_part_q8 / 256 / ink_height;
  const int64_t by_width = em_q6 * width * width_part_q8 / 256 / ink_width;
  const int64_t size_q6 = by_height < by_width ? by_height : by_width;
  out.size = Q26_6::from_raw(
      static_cast<int32_t>(size_q6 > kMaxSize.raw ? kMaxSize.raw : size_q6));
  out.origin = {
      Q26_6::from_raw(width * 32 -
                      px_q6(font, out.size, ink.x_min + ink.x_max) / 2),
      Q26_6::from_raw(height * 32 +
                      px_q6(font, out.size, ink.y_min + ink.y_max) / 2)};
  return true;
}

bool paint_text(const Font& font,
                Text text,
                const TextPlace& place,
                Workspace workspace,
                motion::DistanceGrid& grid) noexcept {
  grid.clear();
  TextCursor cursor(font, text);
  PositionedGlyph glyph;
  while (cursor.next(glyph)) {
    const Point at = {
        Q26_6::from_raw(place.origin.x.raw + px_q6(font, place.size, glyph.x)),
        place.origin.y};
    if (grid.paint(font, glyph.glyph, place.size, at, workspace) !=
        Status::ok) {
      return false;
    }
  }
  return true;
}

void tell_grid(const motion::DistanceGrid& grid,
               const StateSink& sink) noexcept {
  for (int32_t y = 0; y < grid.height(); ++y) {
    const int8_t* row = grid.row(y);
    for (int32_t x = 0; x < grid.width(); ++x) {
      sink.tell(row[x]);
    }
  }
}

Rect known_pixels(const motion::DistanceGrid& grid) noexcept {
  const Rect box = grid.known_box();
  const int32_t side = 1 << grid.scale_log2();
  return {(box.x0 - 1) * side, (box.y0 - 1) * side, (box.x1 + 1) * side,
          (box.y1 + 1) * side};
}

}  // namespace inkcell::scenes
