// One glyph of outlines where it stands on the screen: its box, and from the
// bits of its record its points.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/mixer.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "outlines/record_bits.hpp"
#include "outlines/screen_point.hpp"
#include "place/position.hpp"

namespace inkcell::detail {

// Where grid units lead on the screen, to the right and down. Computed modulo
// 2^32, so that pictures do not depend on strips.
struct OutlineMap {
  struct Axis {
    int32_t per_x;  // by a unit to the right [px, Q18]
    int32_t per_y;  // by a unit up
  };
  Axis axes[2];
};

// What drawing needs of a style that is not upright. Constructors of Style name
// it, so that upright text does not link it.
struct Slant {
  // From the map of an upright style to that of this one. Returns whether it
  // mirrors.
  bool (*map)(const Style& style, OutlineMap& map) noexcept;
  // From the origin along the baseline and up across it. [px, Q10]
  FinePoint (*place)(const Style& style,
                     const FinePoint& origin,
                     int64_t along_q10,
                     int64_t across_q10) noexcept;
};

// Reads records of simple outlines. Reads any bytes: beyond the record's end
// there are zeros, and no more than the budget of points comes of it.
class OutlineReader {
 public:
  // How many points may come, of one record or of several.
  void set_budget(int32_t points) noexcept { budget_ = points; }

  // The record's first bit, which says that it is an outline, is skipped.
  // `pen`: where steps begin. [px, Q18]
  void begin(const Span<const uint8_t>& record,
             const int32_t (&pen_q18)[2]) noexcept {
    record_ = record.data;
    size_ = static_cast<uint32_t>(record.size);
    place_ = 1;
    x_q18_ = static_cast<uint32_t>(pen_q18[0]);
    y_q18_ = static_cast<uint32_t>(pen_q18[1]);
    start_ = ScreenPoint::at(0, 0, kStart);
  }

  // Writes the next points, at most `room`. Returns the end of what is written.
  ScreenPoint* read(const OutlineCoding& coding,
                    const OutlineMap& map,
                    ScreenPoint* out,
                    int32_t room) noexcept;

  // Whether the record has no more points, and whether no more may come.
  bool has_ended() const noexcept { return record_ == nullptr; }
  bool is_spent() const noexcept { return budget_ == 0; }

 private:
  // So many points as may come take fewer bits.
  static constexpr uint32_t kPlaceBits = 29;

  const uint8_t* record_;  // null: it has no more points
  uint32_t size_;          // [bytes]
  uint32_t place_;         // the next bit; above it the number of its table
  uint32_t x_q18_;         // [px, modulo 2^32]
  uint32_t y_q18_;
  ScreenPoint start_;  // of the contour; kind kStart: it comes yet
  int32_t budget_;     // points that may come
};

// The ends of a glyph's ink along an axis of the screen, from the glyph's
// origin. [px, Q18]
struct InkEnds {
  int32_t low;
  int32_t high;
};

// A row of a map times a column of a component's, which is in Q14 and 16 bits
// wide: rounded, modulo 2^32.
int32_t mixed(int32_t a, int32_t x, int32_t b, int32_t y) noexcept;

// Where an outline stands on the screen. Lies in RAM that is lent as bytes.
struct __attribute__((may_alias)) OutlinePlace {
  // The pixels that may show something of ink to the right and down; the map
  // becomes one of samples, and the origin is set. `origin_q8`: what lies at
  // whole numbers, from a sample's upper left corner. [samples]
  void find_box(const Placed& placed,
                const BandPlan& plan,
                int32_t origin_q8,
                const InkEnds (&ink)[2],
                Rect& box) noexcept;

  OutlineMap map_;         // of the glyph
  int32_t origin_q18_[2];  // the glyph's, as points have it [samples]
};

// Whether a record, which may be empty, is one of outlines.
inline bool is_outline(const Span<const uint8_t>& record) noexcept {
  return record.size != 0 &&
         ((record.data[0] & format::outline::kRecordBit) != 0 ||
          record.data[0] == format::composite::kType);
}

// A glyph in its font.
struct OutlineRecord {
  Span<const uint8_t> bytes;
  GlyphMetrics metrics;

  // False: the font has no outline for it.
  bool find(const Font& font, uint16_t glyph) noexcept;
  bool is_composite() const noexcept {
    return bytes.data[0] == format::composite::kType;
  }
};

// Placed and read for one style. Views the font, which must outlive it. Lies in
// RAM that is lent as bytes.
class __attribute__((may_alias)) OutlineGlyph : private OutlinePlace {
 public:
  // Finds the glyph and its ink, to the right and down; `slanted` is null for
  // upright glyphs. False: the font has no outline for it.
  bool find(const Font& font,
            uint16_t glyph,
            Q26_6 size,
            const Style* slanted,
            InkEnds (&ink)[2],
            bool& is_mirrored) noexcept;
  // Then the pixels that may show something.
  using OutlinePlace::find_box;

  const GlyphMetrics& metrics() const noexcept { return record_.metrics; }

  // Where the glyph's origin is, as points have it. [samples, Q8]
  int32_t origin_x_q8() const noexcept { return origin_q18_[0] >> 10; }
  int32_t origin_y_q8() const noexcept { return origin_q18_[1] >> 10; }

  // Goes back to the first point.
  void rewind() noexcept;
  // Writes the next points, at most `room`; returns their end. With is_done()
  // there are no more.
  ScreenPoint* read(ScreenPoint* out, int32_t room) noexcept;
  bool is_done() const noexcept { return reader_.is_spent(); }

 private:
  int32_t scaled(int32_t units, int32_t per_unit) const noexcept;
  int32_t moved(const OutlineMap::Axis& axis,
                int32_t x,
                int32_t y) const noexcept;
  void begin_part(const OutlineRecord& record, const Component* part) noexcept;
  bool next_component() noexcept;

  const Font* font_;
  OutlineRecord record_;
  OutlineMap part_map_;  // of the component at hand
  OutlineReader reader_;
  ComponentReader components_;  // of a composite that come yet
};

}  // namespace inkcell::detail
