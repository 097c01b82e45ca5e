// A glyph of a TrueType file with its components, as they lie on the screen.
#pragma once

#include <stdint.h>

#include "inkcell/style.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "outlines/outline_glyph.hpp"
#include "simple_reader.hpp"
#include "tables.hpp"

namespace inkcell::detail {

// How far heights go to the grid of pixels: all the way to 24 px, and not at
// all from 40 px on, as those of Fit, or where the style is not fitted.
int32_t fit_strength_q8(const Style& style) noexcept;

// A glyph, with its components, placed and read for one style. Views the face,
// which must outlive it.
class TrueTypeGlyph : private OutlinePlace {
 public:
  // As those of OutlineGlyph.
  bool find(const Font& font,
            uint16_t glyph,
            const Style& style,
            InkEnds (&ink)[2],
            bool& is_mirrored) noexcept;
  using OutlinePlace::find_box;
  void rewind() noexcept;
  // `room`: SimpleReader::kLeastRoom at least.
  ScreenPoint* read(ScreenPoint* out, int32_t room) noexcept;
  bool is_done() const noexcept { return is_done_; }
  // Once more, if others were found since: their records may lie there.
  void find_again() noexcept;

 private:
  // The last component takes the place of its composite, so that four are
  // nested at least.
  static constexpr int32_t kDepth = 3;
  static constexpr int16_t kMostPoints = 8192;
  static constexpr int32_t kMostParts = 64;

  struct Frame {
    Table rest;  // components that come yet
    OutlineMap map;
    int32_t origin_q18[2];
  };

  bool begin_record(const Table& record,
                    const OutlineMap& map,
                    const int32_t (&origin_q18)[2]) noexcept;
  bool next_part() noexcept;

  const TrueTypeFace* face_;
  Table record_;
  int32_t shift_;  // what the file's box is moved by [font units]
  OutlineMap part_map_;
  uint16_t glyph_;
  int16_t budget_;  // points that may come
  uint8_t parts_;
  uint8_t depth_;
  bool is_done_;

  // What find() does not set.
  struct Work {
    SimpleReader reader;
    Frame frames[kDepth];
  };
  Work work_;

 public:
  static constexpr int32_t kWorkBytes = sizeof(Work);
};

}  // namespace inkcell::detail
