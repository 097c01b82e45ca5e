// Lines of text: broken, aligned, shortened, in several fonts and directions.
//
// Nothing here needs a buffer: a line is found from the one before, and its
// glyphs are found while they are drawn. text_box.hpp draws whole boxes; these
// are its parts, for layouts of your own.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/layout/bidi.hpp"
#include "inkcell/layout/line_break.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/text.hpp"
#include "inkcell/word_shaper.hpp"

namespace inkcell {

/// Where the lines of a paragraph stand.
enum class Align : uint8_t {
  start,  // left; right where the paragraph begins at the right
  left,
  centre,
  right,
  justify,  // both ends, but for the last line of a paragraph
};

/// What shows that text was left out.
enum class Ellipsis : uint8_t {
  none,
  end,
  middle,  // of text that does not wrap; at the end of other text
};

struct LayoutOptions;

namespace detail {
/// What layout calls for mixed text. Linked with LayoutOptions::set_bidi().
struct BidiOrder {
  uint8_t (*prepare)(const LayoutOptions& options,
                     const Text& text,
                     size_t begin);  // the level of the paragraph there
  uint8_t (*level)(const Bidi& bidi, size_t offset);
  BidiRun (*first_run)(const Bidi& bidi, size_t begin, size_t end);
  bool (*next_run)(const Bidi& bidi, size_t begin, size_t end, BidiRun& run);
  uint32_t (*mirrored)(uint32_t code_point);
};
extern const BidiOrder kBidiOrder;

// The same for words. Linked with LayoutOptions::set_shaper().
struct ShapedWords;
extern const ShapedWords kShapedWords;
}  // namespace detail

/// Bytes of a text, from the beginning of a character to that of another, that
/// a face of LayoutOptions::fallback sets before others: 1 is the first one.
struct FaceSpan {
  size_t begin = 0;
  size_t end = SIZE_MAX;
  uint8_t face = 0;
};

namespace detail {
class Pen;
struct LineCell;
struct FaceGlyph {
  uint16_t id = 0;
  uint8_t face = 0;
  bool is_found = false;
};
// As Pen::find(), but first in the face of the span that holds a cell.
FaceGlyph find_in_spans(const Pen& pen,
                        uint32_t code_point,
                        const LineCell& cell) noexcept;
}  // namespace detail

/// Spans of a text, for LayoutOptions: the first one that holds a character
/// counts. `all` must outlive it.
struct FaceSpans {
  explicit constexpr FaceSpans(Span<const FaceSpan> spans = {}) noexcept
      : all(spans) {}

  Span<const FaceSpan> all;
  detail::FaceGlyph (*find)(const detail::Pen& pen,
                            uint32_t code_point,
                            const detail::LineCell& cell) noexcept =
      detail::find_in_spans;
};

/// How text is set. Lengths are in px; 0 takes the default that is stated. What
/// is pointed to must outlive it.
struct LayoutOptions {
  Face face;
  /// For characters that `face` lacks, in this order; at most 255.
  Span<const Face> fallback;
  Align align = Align::start;
  Ellipsis ellipsis = Ellipsis::none;
  /// Whether lines end where there is no more room, and not only at line feeds.
  bool wraps = true;
  /// Whether all digits are as wide as the widest.
  bool tabular_digits = false;
  BaseDirection direction = BaseDirection::from_text;
  Q26_6 letter_spacing;
  /// From a baseline to the next. Default: that of the font, in whole px.
  Q26_6 line_height;
  /// Tab stops from the start of the line on, in rising order; after the last
  /// one multiples of tab_width. Default: eight spaces. Paragraphs that begin
  /// at the right have no stops: there each tab is tab_width wide.
  Span<const Q26_6> tab_stops;
  Q26_6 tab_width;
  /// Words of another size, or another font. Lines break by the advances of
  /// these faces, stay line_height apart, and have one baseline. Ellipses and
  /// hyphens are of `face`. Letters of other faces are not kerned.
  const FaceSpans* spans = nullptr;

  constexpr LayoutOptions() noexcept = default;
  /// Refers to font and style, which must outlive it.
  constexpr LayoutOptions(const Font& font, const Style& style) noexcept
      : face{&font, &style} {}
  LayoutOptions(const Font&, const Style&&) = delete;

  /// Orders mixed lines. Without it all text is read from left to right.
  void set_bidi(Bidi& bidi) noexcept {
    bidi_ = &bidi;
    order_ = &detail::kBidiOrder;
  }
  Bidi* bidi() const noexcept { return bidi_; }
  const detail::BidiOrder* order() const noexcept { return order_; }

  /// Joins letters, makes ligatures and places marks, where fonts can
  /// (inkcell/shaping/text_shaper.hpp). Without it each character is drawn by
  /// itself. Letter spacing does not part joined letters.
  void set_shaper(WordShaper& shaper) noexcept {
    shaper_ = &shaper;
    words_ = &detail::kShapedWords;
  }
  WordShaper* shaper() const noexcept { return shaper_; }
  const detail::ShapedWords* words() const noexcept { return words_; }

  /// Call it when text was changed in place. Text boxes call it themselves.
  void forget() const noexcept {
    if (bidi_ != nullptr) {
      bidi_->forget();
    }
    if (shaper_ != nullptr) {
      shaper_->forget();
    }
  }

 private:
  Bidi* bidi_ = nullptr;
  const detail::BidiOrder* order_ = nullptr;
  WordShaper* shaper_ = nullptr;
  const detail::ShapedWords* words_ = nullptr;
};

/// A line of a text. What it shows is `length` bytes from `begin` on; spaces
/// and line ends behind that show nothing.
struct TextLine {
  uint32_t begin = 0;
  uint32_t next = 0;       // where the next line begins
  uint32_t paragraph = 0;  // where its paragraph begins
  int32_t width = 0;       // [font units]
  uint16_t length = 0;
  uint16_t skip_at = 0;      // from `begin` on: an ellipsis stands there
  uint16_t skip_length = 0;  // for so many bytes
  uint16_t gaps = 0;         // where justified text is stretched
  uint8_t base_level = 0;    // odd: it begins at the right
  bool is_found = false;     // by next_line()
  bool is_last = false;      // of the text
  bool ends_paragraph = false;
  bool has_hyphen = false;  // at a soft hyphen
  bool has_ellipsis = false;

  constexpr uint32_t end() const noexcept { return begin + length; }
};

/// Finds the line that follows `line`, and the first one if that is new, in
/// `width` px. A text has a line more than line feeds. False after the last.
/// A line holds one character at least, and at most kMaxLineBytes. The painter
/// is like the one that draws: as in TextBox.
///
///   TextLine line;
///   while (next_line(options, painter, text, width, line)) { ... }
bool next_line(const LayoutOptions& options,
               const Painter& painter,
               Text text,
               Q26_6 width,
               TextLine& line) noexcept;

/// Ends a line with an ellipsis, though its text goes on, and takes away what
/// leaves no room for that.
void shorten(const LayoutOptions& options,
             const Painter& painter,
             Text text,
             Q26_6 width,
             TextLine& line) noexcept;

/// Glyphs of a line from left to right, aligned in `width` px, from its left
/// end. Draw them with painter.glyphs(options.face, options.fallback, ...).
/// Blanks have none.
///
/// buffer_small: `out` was too short; `glyphs` is untouched. line.length + 4
/// always suffice.
Status lay_out(const LayoutOptions& options,
               const Painter& painter,
               Text text,
               const TextLine& line,
               Q26_6 width,
               Span<PositionedGlyph> out,
               Span<const PositionedGlyph>& glyphs) noexcept;

/// From a baseline to the next. [px]
Q26_6 line_height(const LayoutOptions& options) noexcept;

/// From the top of a line to its baseline: the font's ascender, and half of
/// what the line is higher than the font. [px, whole with the default height]
Q26_6 baseline(const LayoutOptions& options) noexcept;

}  // namespace inkcell
