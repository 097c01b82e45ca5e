// Scene `clock`: a minute takes a second and a half, and digits morph: by their
// outlines if the font holds the pair, else by their distances.
#pragma once

#include <stdint.h>

#include "inkcell/dirty_rects.hpp"
#include "inkcell/font.hpp"
#include "inkcell/kinetic/morph.hpp"
#include "inkcell/kinetic/outline_morph.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"
#include "paper.hpp"

namespace inkcell {
namespace scenes {

/// A frame depends only on its number.
class ClockScene {
 public:
  static constexpr const char* kText = "12:58";

  /// The changes of its digits, as inkcell-fontgen --morph takes them.
  static constexpr const char* kMorphs =
      "01 12 23 34 45 56 67 78 89 90 50 20 30";

  /// The layout of digits: their size and the box of each.
  struct Layout {
    int32_t size_px = 0;
    int32_t digit_px = 0;  // the width of a digit's box
    int32_t colon_px = 0;
    kinetic::MorphBox box;
    int32_t left = 0;
    int32_t top = 0;
  };

  static constexpr SceneNeeds needs(int32_t width, int32_t height) noexcept {
    return {kDigits * kinetic::morph_bytes(layout_of(width, height).box), 0, 0};
  }

  /// For faces with digits up to 0.7 em wide.
  static constexpr Layout layout_of(int32_t width, int32_t height) noexcept {
    Layout layout;
    // Four digits of 0.7 em, a colon of 0.34, and a margin.
    const int32_t by_width = width * 94 / 100 * 100 / (4 * 70 + 34);
    const int32_t by_height = height * 94 / 100 * 100 / 78;
    layout.size_px = by_width < by_height ? by_width : by_height;
    layout.digit_px = layout.size_px * 70 / 100;
    layout.colon_px = layout.size_px * 34 / 100;
    const int32_t margin = layout.size_px < 40 ? 1 : layout.size_px / 14;
    layout.box.scale_log2 = layout.size_px >= 80 ? 1 : 0;
    layout.box.width = layout.digit_px;
    layout.box.height = layout.size_px * 74 / 100 + 2 * margin;
    layout.box.baseline = layout.size_px * 74 / 100 + margin;
    layout.left = (width - 4 * layout.digit_px - layout.colon_px) / 2;
    layout.top = (height - layout.box.height) / 2;
    return layout;
  }

  /// The text is the start time, HH:MM.
  explicit ClockScene(const SceneSetting& setting) noexcept;
  ClockScene(const ClockScene&) = delete;
  ClockScene& operator=(const ClockScene&) = delete;

  /// bad_argument: the text is not a time, or the screen is too small. Others
  /// as GlyphMorph::set().
  Status open() noexcept;
  void set_frame(uint32_t frame) noexcept;
  void draw(const Paper& paper) noexcept;
  void add_changes(DirtyRects& dirty) const noexcept;
  uint32_t next_due() const noexcept;
  void tell_state(const StateSink& sink) const noexcept;

 private:
  static constexpr int32_t kDigits = 4;
  static constexpr uint32_t kFramesPerMinute = 45;

  Span<int8_t> part_of(Span<int8_t> grids, int32_t digit) const noexcept;
  void set_digit(int32_t digit, uint16_t from, uint16_t to) noexcept;
  Rect box_of(int32_t digit) const noexcept;
  Point origin_of(int32_t digit) const noexcept;
  void draw_digit(int32_t digit,
                  const Filter& filter,
                  const Sink& sink) const noexcept;
  uint32_t digit_of(uint32_t minute, int32_t digit) const noexcept;
  void draw_colon(const Paper& paper) const noexcept;

  const Font& font_;
  Text text_;
  int32_t width_;
  int32_t height_;
  Layout layout_;
  Workspace workspace_;
  kinetic::GlyphMorph digits_[kDigits];
  kinetic::OutlineMorph outlines_[kDigits];
  bool has_outlines_[kDigits] = {};  // the pair at hand
  uint16_t from_[kDigits] = {};
  uint16_t to_[kDigits] = {};
  Q16_16 progress_[kDigits];
  kinetic::GridHistogram scratch_;
  uint16_t digit_glyphs_[10] = {};
  uint16_t colon_ = 0;
  uint32_t first_minute_ = 0;
  uint32_t frame_ = 0;
  bool has_changed_[kDigits] = {};
};

}  // namespace scenes
}  // namespace inkcell
