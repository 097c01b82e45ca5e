#include "inkcell/layout/line_shaper.hpp"

#include "line_cursor.hpp"
#include "next_line.hpp"

namespace inkcell {

// The line of a cursor, up to its glyph at hand.
struct LineShaper::Line {
  const Text text;
  const detail::Setting setting;
  const TextLine line;
  detail::LineCursor cursor;
  detail::LineCell cell;
  bool has_glyph = false;
  bool is_done = false;

  Line(const LayoutOptions& options, const Painter& painter, Text given)
      : text(given),
        setting{options, painter},
        line(detail::first_line(setting, text)),
        cursor(setting, text, line) {}

  static void* operator new(size_t, uint8_t* room) noexcept { return room; }

  // The next glyph, or a blank that takes room.
  bool next() noexcept {
    has_glyph = has_glyph && cursor.next_glyph(cell);
    while (!has_glyph && !is_done) {
      is_done = !cursor.next(cell);
      has_glyph = !is_done && (cell.has_ink || takes_room());
    }
    return has_glyph;
  }

  LetterEdges letter() const noexcept {
    if (is_done) {
      return {0, line.width, false};
    }
    const int32_t left = cursor.pen().to_units(cell.x);
    const int32_t right = cursor.pen().to_units(cell.x_end);
    const bool is_rtl = cell.level % 2 != 0;
    return {is_rtl ? right : left, is_rtl ? left : right, is_rtl};
  }

 private:
  // A blank is drawn as a space.
  bool takes_room() noexcept {
    const detail::Pen::Glyph space = cursor.pen().find(' ');
    cell.glyph = space.id;
    return space.is_found && cell.x_end != cell.x;
  }
};

LineShaper::LineShaper(WordShaper& shaper, Bidi& bidi) noexcept
    : LineSetter{begin_line, next_glyph, letter_of} {
  options_.wraps = false;
  options_.set_bidi(bidi);
  options_.set_shaper(shaper);
}

void LineShaper::begin_line(LineSetter& self,
                            const Painter& painter,
                            const TextCursor& line) noexcept {
  auto& own = static_cast<LineShaper&>(self);
  static_assert(sizeof(Line) <= kLineBytes, "too little room");
  own.options_.face = face_of(line);
  static_cast<void>(new (own.line_) Line(own.options_, painter, text_of(line)));
}

bool LineShaper::next_glyph(LineSetter& self, PositionedGlyph& out) noexcept {
  Line& own = static_cast<LineShaper&>(self).line();
  if (!own.next()) {
    return false;
  }
  out = detail::positioned(own.cursor.pen(), own.line, own.cell);
  return true;
}

LetterEdges LineShaper::letter_of(const LineSetter& self) noexcept {
  const auto& own = static_cast<const LineShaper&>(self);
  return reinterpret_cast<const Line*>(own.line_)->letter();
}

}  // namespace inkcell
