#include "shaped_words.hpp"

#include "line_walk.hpp"

namespace inkcell::detail {
namespace {

bool ends_words(uint32_t code_point) noexcept {
  return code_point < ' ' || code_point == 0x85 || code_point - 0x2028 < 2;
}

// Marks, and what shows nothing: of the face of what they follow.
bool follows(uint32_t code_point) noexcept {
  return is_mark(code_point) || shown_as(code_point) == Shown::nothing;
}

// Finds words: characters of one face and direction, which the face's font says
// how to shape.
class WordFinder {
 public:
  WordFinder(const Pen& pen, const WordPart& part, uint8_t level) noexcept
      : pen_(pen),
        part_(part),
        shaper_(*pen.options().shaper()),
        word_(shaper_.at_hand),
        level_(level) {}

  // The word of a character becomes that at hand. False: it is not shaped.
  bool find(uint32_t at) noexcept {
    return at < part_.end && (is_at_hand(at) || look(at)) &&
           shaper_.glyphs.size != 0;
  }

  // Whether the word of the character before goes on with that at an offset.
  bool goes_on(uint32_t at) noexcept { return find(at) && at > word_.begin; }

  // The glyphs of a character, or none.
  void find_cluster(uint32_t at,
                    uint32_t& first,
                    uint32_t& end) const noexcept {
    const Span<const TextGlyph> glyphs = shaper_.glyphs;
    const uint32_t cluster = at - word_.begin;
    first = 0;
    while (first < glyphs.size && glyphs[first].cluster != cluster) {
      ++first;
    }
    end = first;
    while (end < glyphs.size && glyphs[end].cluster == cluster) {
      ++end;
    }
  }

 private:
  bool is_same_font() const noexcept {
    const LayoutOptions& options = pen_.options();
    return word_.text == part_.text.data && word_.level == level_ &&
           word_.face <= options.fallback.size &&
           word_.font == pen_.setting().face(word_.face).font;
  }
  bool is_at_hand(uint32_t at) const noexcept {
    return is_same_font() && at >= word_.begin && at < word_.end &&
           (word_.start == part_.begin ||
            (word_.start > part_.begin && word_.starts_itself)) &&
           (word_.end == word_.part_end ? part_.end == word_.end
                                        : part_.end >= word_.end);
  }
  uint32_t code_point(uint32_t at) const noexcept {
    return read_code_point(part_.text, at);
  }
  Pen::Glyph find_glyph(uint32_t at) const noexcept {
    LineCell cell;
    cell.begin = at;
    return pen_.find_in(code_point(at), cell);
  }
  bool is_within(uint32_t at) const noexcept {
    const uint32_t c = code_point(at);
    if (pen_.setting().level(at) != level_ || ends_words(c) ||
        (c == ' ' && shaper_.parts_at_spaces)) {
      return false;
    }
    if (follows(c)) {
      return true;
    }
    const Pen::Glyph glyph = find_glyph(at);
    return glyph.is_found && glyph.face == face_;
  }

  // Whether the face of a character has a font that is shaped.
  bool open(uint32_t at) noexcept {
    while (at != part_.begin && follows(code_point(at))) {
      at = previous(part_.text, part_.begin, at);
    }
    const Pen::Glyph glyph = find_glyph(at);
    face_ = glyph.face;
    return glyph.is_found &&
           shaper_.open(shaper_, *pen_.setting().face(face_).font);
  }

  bool look(uint32_t at) noexcept {
    if (!open(at) || !is_within(at)) {
      return false;
    }
    uint32_t start = at;
    while (start != part_.begin) {
      const uint32_t before = previous(part_.text, part_.begin, start);
      if (!is_within(before)) {
        break;
      }
      start = before;
    }
    // Marks of a letter that is of no part of the word are not, either.
    for (uint32_t next = start; start != part_.begin && start != at;
         start = next) {
      if (!follows(read_code_point(part_.text, next))) {
        break;
      }
    }
    const bool goes_on = is_same_font() && word_.face == face_ &&
                         word_.start == start && word_.end <= at;
    uint32_t begin = goes_on ? word_.end : start;
    do {
      const uint32_t end = end_from(begin);
      const uint32_t shaped =
          shaper_.shape(shaper_, part_.text, begin, end, level_ % 2 != 0);
      if (shaper_.is_cut) {
        tell_cut();
      }
      word_.begin = begin;
      begin = shaped > begin && shaped < end ? shaped : end;
    } while (begin <= at);
    word_.text = part_.text.data;
    word_.font = pen_.setting().face(face_).font;
    word_.start = start;
    word_.end = begin;
    word_.part_end = part_.end;
    word_.face = static_cast<uint8_t>(face_);
    word_.level = level_;
    word_.starts_itself = start != part_.begin;
    return true;
  }

  void tell_cut() const noexcept {
    TextReport* const report = pen_.setting().painter.report();
    if (report != nullptr) {
      report->note(Status::buffer_small);
    }
  }

  // How far a word goes, or as much of it as is shaped at a time.
  uint32_t end_from(uint32_t begin) const noexcept {
    uint32_t end = begin;
    uint32_t left = shaper_.most_characters;
    do {
      static_cast<void>(read_code_point(part_.text, end));
      --left;
    } while (left != 0 && end < part_.end && is_within(end));
    if (left != 0 || end >= part_.end) {
      return end;
    }
    if (is_within(end)) {
      tell_cut();
    }
    // Letters keep their marks.
    uint32_t whole = end;
    while (whole != begin && follows(code_point(whole))) {
      whole = previous(part_.text, begin, whole);
    }
    return whole == begin ? end : whole;
  }

  const Pen& pen_;
  const WordPart& part_;
  WordShaper& shaper_;
  WordAtHand& word_;
  uint32_t face_ = 0;
  uint8_t level_;
};

int32_t width_within(const Setting& setting,
                     const Text& text,
                     const TextLine& line,
                     uint32_t begin,
                     uint32_t end) noexcept {
  TextLine part = line;
  part.begin = begin;
  LineWalk walk(setting, text, part, end);
  LineCell cell;
  while (walk.next(end, cell)) {
  }
  return walk.pen().at();
}

}  // namespace

// Of joined letters the word's first one alone is spaced from what is before
// it, in the order of the pen.
void Pen::put_cluster(uint32_t code_point,
                      uint8_t level,
                      uint32_t first,
                      uint32_t end,
                      LineCell& cell) noexcept {
  const WordShaper& shaper = *options().shaper();
  const bool begins_word =
      is_visual_ || level % 2 == 0 ? first == 0 : end == shaper.glyphs.size;
  begin_cell(level, cell);
  begin_run();
  cell.face = shaper.at_hand.face;
  const Shown shown = shown_as(code_point);
  cell.has_ink =
      first != end && shown != Shown::space && shown != Shown::nothing;
  cell.kind = first == end || is_mark(code_point) ? CellKind::mark
              : begins_word || !shaper.joins      ? CellKind::base
                                                  : CellKind::other;
  int32_t advance = 0;
  for (uint32_t i = first; i != end; ++i) {
    advance = clamp_to(advance + advance_of(shaper.glyphs[i], cell.face),
                       advances_.limit());
    if (shaper.glyphs[i].glyph == 0 && setting_.painter.report() != nullptr) {
      setting_.painter.report()->note(Status::no_glyph);
    }
  }
  cell.x_end = advance;
  if (options().tabular_digits && code_point - '0' < 10 && first != end) {
    cell.x_end = digit_width();
    cell.x_glyph = (cell.x_end - advance) / 2;
  }
  place(0, cell);
  if (cell.has_ink) {
    const uint32_t more = end - first - 1;
    cell.more_glyphs = static_cast<uint8_t>(more < 255 ? more : 255);
    cell.shaped_glyph = static_cast<uint16_t>(first);
    take_glyph(cell);
  }
}

// Of glyphs in whole pixels marks keep their places on their letters, to the
// nearest.
void Pen::take_glyph(LineCell& cell) const noexcept {
  const TextGlyph& glyph = options().shaper()->glyphs[cell.shaped_glyph];
  cell.glyph = glyph.glyph;
  cell.x_glyph = clamp_to(cell.x_glyph + from_face(cell.face, glyph.x, false),
                          advances_.limit());
  cell.y_glyph = static_cast<int16_t>(
      clamp_to(to_units(from_face(cell.face, glyph.y, false)), INT16_MAX));
}

void Pen::next_glyph(LineCell& cell) const noexcept {
  const TextGlyph& glyph = options().shaper()->glyphs[cell.shaped_glyph];
  cell.x_glyph +=
      advance_of(glyph, cell.face) - from_face(cell.face, glyph.x, false);
  --cell.more_glyphs;
  ++cell.shaped_glyph;
  take_glyph(cell);
}

// What a shaped glyph moves the pen by. Whole pixels keep the kerning of the
// font as of two glyphs.
int32_t Pen::advance_of(const TextGlyph& glyph, uint32_t face) const noexcept {
  const Advances own = setting_.advances(face);
  if (!own.is_whole() || glyph.advance == 0) {
    return from_face(face, glyph.advance, false);
  }
  const int32_t kerning =
      glyph.advance - setting_.face(face).font->advance(glyph.glyph);
  int32_t drift_q6 = 0;
  const int32_t px =
      own.advance(glyph.glyph) +
      (kerning == 0 ? 0
                    : own.join({glyph.glyph, glyph.glyph, kerning}, drift_q6));
  return from_face(face, px, true);
}

const ShapedWords kShapedWords = {
    [](Pen& pen,
       const WordPart& part,
       uint32_t code_point,
       uint8_t level,
       LineCell& cell) {
      WordFinder finder(pen, part, level);
      if (!finder.find(cell.begin)) {
        return false;
      }
      uint32_t first = 0;
      uint32_t end = 0;
      finder.find_cluster(cell.begin, first, end);
      pen.put_cluster(code_point, level, first, end, cell);
      return true;
    },
    [](const Pen& pen, LineCell& cell) { pen.next_glyph(cell); },
    [](const Pen& pen, const WordPart& part, uint8_t level, uint32_t at) {
      WordFinder finder(pen, part, level);
      if (!finder.find(at)) {
        return is_mark(read_code_point(part.text, at));
      }
      uint32_t first = 0;
      uint32_t end = 0;
      finder.find_cluster(at, first, end);
      return first == end;
    },
    [](const Setting& setting, const Text& text, TextLine& line) {
      const Pen pen(setting, Pen::logical);
      const WordPart rest = {text, line.begin,
                             static_cast<uint32_t>(text.size)};
      const uint32_t end = line.end();
      if (line.length == 0 || end == text.size ||
          !WordFinder(pen, rest, setting.level(end)).goes_on(end)) {
        return;
      }
      const int32_t hyphen = line.has_hyphen ? pen.hyphen().width : 0;
      line.width = pen.to_units(
          width_within(setting, text, line, line.begin, line.end()) + hyphen);
    },
    width_within};

}  // namespace inkcell::detail
