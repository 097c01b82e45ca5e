// The demo's scene: a clock with large digits, body text, and a line that moves
// by 1/8 px from frame to frame. The same code runs on boards and on the host.
//
// The build makes its font (demo.cmake) and sets the sizes:
// INKCELL_DEMO_CLOCK_PX and INKCELL_DEMO_TEXT_PX [px/em].
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "canvas.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell::demo {
inline namespace INKCELL_DEMO_NAME {

/// Laid out once a frame, drawn strip by strip.
class Scene {
 public:
  Scene() noexcept = default;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Opens the font and lays out the still text.
  Status open() noexcept;

  /// Frame 0 is at 10:42; a minute has 480 frames.
  void set_frame(uint32_t frame) noexcept;

  /// Not for two tasks at once: they would share the scratch RAM.
  void draw(const Strip& strip) noexcept;

  /// How many characters of the scene the font lacks.
  int32_t missing_characters() const noexcept;

 private:
  // On a display of a few rows the clock and the moving line are side by side.
  static constexpr bool kOneLine = kHeight < 32;
  static constexpr int32_t kBodyLines = kOneLine ? 0 : kHeight < 100 ? 2 : 4;
  static constexpr int32_t kMaxCharacters = 48;  // of a line
  // Speeds up large digits; small displays have little RAM.
  static constexpr size_t kLentBytes = kHeight < 100 ? 0 : 2560;
  static constexpr bool kIsMono = kFormat == port::PixelFormat::mono_pages;

  struct Line {
    PositionedGlyph glyphs[kMaxCharacters];
    Span<const PositionedGlyph> used;
    Point origin;
    int32_t width_q6 = 0;  // [px]
  };

  // The style of one size. It refers to the other members.
  struct Look {
    Style style{kMinSize, kFilterText};
    Fit fit;
    Bilevel bilevel;
  };

  static const char* body_text(int32_t line) noexcept;
  Status make_look(int32_t size_q6, bool is_still, Look& look) noexcept;
  static Status lay_out(const Font& font,
                        const Style& style,
                        Text text,
                        Line& line) noexcept;
  Status lay_out_body() noexcept;

  Font font_;
  Look clock_look_;
  Look text_look_;
  Look moving_look_;
  Line clock_;
  Line moving_;
  Line body_[kBodyLines == 0 ? 1 : kBodyLines];
  alignas(4) uint8_t ram_[kLentBytes == 0 ? 4 : kLentBytes];
};

}  // namespace INKCELL_DEMO_NAME
}  // namespace inkcell::demo
