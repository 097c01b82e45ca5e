// One glyph of outlines where it stands on the screen: its box and its points.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/glyph_warp.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "outlines/component.hpp"
#include "outlines/outline_reader.hpp"
#include "place/position.hpp"

namespace inkcell {
namespace detail {

// Where painters have pixels, and how far they show around the ink.
struct OutlineSampling {
  // What lies at whole numbers, from a pixel's upper left corner. [px]
  int32_t origin_q8;
  int32_t reach_q8;  // of a pixel's centre [px]
  // Samples a pixel, to the right and down.
  int32_t columns = 1;
  int32_t rows = 1;
  // How much farther they show to the sides, and up and down. [px]
  int32_t moved_x_q8 = 0;
  int32_t moved_y_q8 = 0;
  // Moves both ends of an upright glyph as grid fitting moves its points;
  // `sign` is -1 where places count down. Fitted styles link it. [px, Q18]
  void (*warp_range)(const AxisMap& map,
                     int32_t sign,
                     int32_t& low,
                     int32_t& high) noexcept = nullptr;
};

// Whether a record, which may be empty, is one of outlines.
inline bool is_outline(Span<const uint8_t> record) noexcept {
  return record.size != 0 &&
         ((record.data[0] & format::outline::kRecordBit) != 0 ||
          record.data[0] == format::composite::kType);
}

// Placed and read for one style. Views the font, which must outlive it. Lies in
// RAM that is lent as bytes.
class __attribute__((may_alias)) OutlineGlyph {
 public:
  // `record` is the glyph's; is_outline(record). `slanted` is null for
  // upright glyphs; `warp` moves points, and may be null. `box`: the pixels
  // that may show something. False: the font is not one of outlines.
  bool open(const Font& font,
            const GlyphMetrics& metrics,
            Span<const uint8_t> record,
            Q26_6 size,
            const Style* slanted,
            const Placed& placed,
            const OutlineSampling& sampling,
            const GlyphWarp* warp,
            Rect& box) noexcept;

  bool open(const Font& font,
            const GlyphMetrics& metrics,
            Span<const uint8_t> record,
            const Style& style,
            const Placed& placed,
            const OutlineSampling& sampling,
            const GlyphWarp* warp,
            Rect& box) noexcept {
    return open(font, metrics, record, style.size(),
                style.is_upright() ? nullptr : &style, placed, sampling, warp,
                box);
  }

  // Where the glyph's origin is, as points have it. [samples, Q8]
  int32_t origin_x_q8() const noexcept { return x_q18_ >> 10; }
  int32_t origin_y_q8() const noexcept { return y_q18_ >> 10; }

  bool is_mirrored() const noexcept { return is_mirrored_; }

  // Goes back to the first point.
  void rewind() noexcept;
  // Writes the next points, at most `room`; returns their end. With is_done()
  // there are no more.
  ScreenPoint* read(ScreenPoint* out, int32_t room) noexcept;
  bool is_done() const noexcept { return points_left_ == 0; }

 private:
  struct Axis {
    int32_t low_px;
    int32_t high_px;
  };
  Axis axis_of(const GlyphMetrics& metrics,
               int32_t per_x,
               int32_t per_y,
               int32_t at_q10,
               const OutlineSampling& sampling,
               int32_t moved_q8,
               const AxisMap* map) const noexcept;
  // Its map is in place.
  void begin_part(int32_t x_min,
                  int32_t y_min,
                  Span<const uint8_t> record,
                  int32_t x_q18,
                  int32_t y_q18) noexcept;
  bool next_component() noexcept;
  int32_t scaled(int32_t units, int32_t per_unit) const noexcept;

  const Font* font_;
  Span<const uint8_t> record_;
  OutlineMap map_;       // of the glyph
  OutlineMap part_map_;  // of the component at hand
  int32_t x_q18_;        // the glyph's origin as points have it [samples]
  int32_t y_q18_;
  OutlineReader reader_;
  ComponentReader components_;  // of a composite that come yet
  uint16_t points_left_;        // that may come
  int16_t x_min_;               // of the glyph's box [font units]
  int16_t y_min_;
  bool is_composite_;
  bool is_mirrored_;
};

}  // namespace detail
}  // namespace inkcell
