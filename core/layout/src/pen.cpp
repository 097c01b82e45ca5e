#include "pen.hpp"

namespace inkcell::detail {
namespace {

int64_t em_q6_of(const Face& face) noexcept {
  return face.font->units_per_em() * int64_t{64};
}

// Rounded to the nearest; the divisor is positive.
int64_t divide(int64_t dividend, int64_t divisor) noexcept {
  const int64_t half = divisor / 2;
  return (dividend < 0 ? dividend - half : dividend + half) / divisor;
}

// Spaces that are as wide as the em, or half of it, where a font lacks them.
uint32_t halves_of_em(uint32_t code_point) noexcept {
  if (code_point - 0x2000 < 4) {
    return 1 + code_point % 2;
  }
  return code_point == 0x3000 ? 2 : 0;
}

// Letters that join their neighbours: Arabic, Syriac, N'Ko, Mandaic, jamo,
// Mongolian, Phags-pa.
bool joins(uint32_t code_point) noexcept {
  constexpr uint16_t kRanges[][2] = {
      {0x0620, 0x064a}, {0x066e, 0x06d3}, {0x06fa, 0x077f}, {0x07ca, 0x07ea},
      {0x0840, 0x08c9}, {0x1100, 0x11ff}, {0x1807, 0x18aa}, {0xa840, 0xa873}};
  bool is_found = false;
  for (const uint16_t(&range)[2] : kRanges) {
    is_found |= code_point >= range[0] && code_point <= range[1];
  }
  return is_found;
}

}  // namespace

uint32_t previous(const Text& text, uint32_t begin, uint32_t at) noexcept {
  for (uint32_t size = 1; size <= 4 && size <= at - begin; ++size) {
    const uint32_t from = at - size;
    if ((static_cast<uint8_t>(text.data[from]) & 0xc0) != 0x80) {
      Text part(text.data + from, size);
      static_cast<void>(next_code_point(part));
      return part.size == 0 ? from : at - 1;
    }
  }
  return at - 1;
}

bool is_gap(uint32_t code_point) noexcept {
  constexpr uint32_t kCjk = 0x2e80;
  if (code_point < kCjk) {
    return code_point == ' ' || code_point == 0xa0;
  }
  const LineClass c = line_class(code_point);
  return c == LineClass::id || c == LineClass::ns || c == LineClass::cl ||
         c == LineClass::ex || c == LineClass::h2 || c == LineClass::h3;
}

Pen::Pen(const Setting& setting, Order order) noexcept
    : setting_(setting),
      advances_(setting.advances(0)),
      is_visual_(order == visual),
      keeps_length_(setting.options.wraps ||
                    setting.options.ellipsis != Ellipsis::middle) {
  const int32_t px_q6 = options().letter_spacing.raw;
  if (px_q6 != 0) {
    spacing_ = from_px(Q26_6::from_raw(px_q6 < 0 ? -px_q6 : px_q6));
    spacing_ = px_q6 < 0 ? -spacing_ : spacing_;
  }
}

int32_t Pen::from_px(Q26_6 px) const noexcept {
  if (advances_.is_whole()) {
    return clamp_to(px.raw >> 6, kMaxPx);
  }
  const int64_t units = int64_t{px.raw} * setting_.face().font->units_per_em();
  return clamp_to(units / setting_.face().style->size().raw, kMaxUnits);
}

Q26_6 Pen::to_px(int32_t length) const noexcept {
  return advances_.is_whole() ? Q26_6::from_int(length)
                              : inkcell::to_px(*setting_.face().font,
                                               *setting_.face().style, length);
}

int32_t Pen::from_units(int32_t units) const noexcept {
  if (!advances_.is_whole()) {
    return units;
  }
  return clamp_to(divide(int64_t{units} * setting_.face().style->size().raw,
                         em_q6_of(setting_.face())),
                  kMaxPx);
}

int32_t Pen::em() const noexcept {
  return advances_.is_whole() ? (setting_.face().style->size().raw + 32) >> 6
                              : setting_.face().font->units_per_em();
}

// False: the character is not shaped. Not inline: one place that calls it.
__attribute__((noinline)) bool Pen::put_word(const WordPart& part,
                                             uint32_t code_point,
                                             uint8_t level,
                                             LineCell& cell) noexcept {
  const ShapedWords* const words = options().words();
  return words != nullptr && words->put(*this, part, code_point, level, cell);
}

Pen::Glyph Pen::find(uint32_t code_point) const noexcept {
  Glyph found;
  uint32_t faces = static_cast<uint32_t>(options().fallback.size);
  faces = (faces < 255 ? faces : 255) + 1;
  for (uint32_t i = 0; i != faces; ++i) {
    if (setting_.face(i).font->glyph_of(code_point, found.id) == Status::ok) {
      found.face = static_cast<uint8_t>(i);
      found.is_found = true;
      break;
    }
  }
  return found;
}

// The glyph to draw, .notdef where a character shows something that no face
// has; not found: there is none, but perhaps an advance. That becomes `x_end`.
Pen::Glyph Pen::find_shown(uint32_t code_point,
                           Shown shown,
                           LineCell& cell) const noexcept {
  cell.x_end = 0;
  if (shown == Shown::nothing) {
    return {};
  }
  Glyph glyph = find_in(code_point, cell);
  if (shown == Shown::space && !glyph.is_found) {
    const uint32_t halves = halves_of_em(code_point);
    if (halves != 0) {
      cell.x_end = em() * static_cast<int32_t>(halves) / 2;
      return {};
    }
    glyph = find(' ');
    if (!glyph.is_found) {
      return {};
    }
  }
  if (shown == Shown::mark && !glyph.is_found) {
    return {};
  }
  if (!glyph.is_found && setting_.painter.report() != nullptr) {
    replace(code_point, glyph);
    if (!glyph.is_found) {
      return {};
    }
  }
  glyph.is_found = true;
  cell.x_end = advance(glyph);
  return glyph;
}

// What a painter's report draws for a character that no face has.
void Pen::replace(uint32_t code_point, Glyph& glyph) const noexcept {
  glyph.is_found = setting_.painter.report()->find_instead(
      code_point, [&](uint32_t other) noexcept {
        glyph = find(other);
        return glyph.is_found;
      });
}

int32_t Pen::advance(const Glyph& glyph) const noexcept {
  if (glyph.face == 0) {
    return advances_.advance(glyph.id);
  }
  const Advances advances = setting_.advances(glyph.face);
  return from_face(glyph.face, advances.advance(glyph.id), advances.is_whole());
}

// From whole px or units of a face to units of the pen.
int32_t Pen::from_face(uint32_t face,
                       int32_t length,
                       bool is_whole) const noexcept {
  if (face == 0 && is_whole == advances_.is_whole()) {
    return length;
  }
  const Face& own = setting_.face(face);
  int64_t dividend = length;
  int64_t divisor = 1;
  if (!is_whole) {  // to px
    dividend *= own.style->size().raw;
    divisor = em_q6_of(own);
  }
  if (!advances_.is_whole()) {  // from px
    dividend *= em_q6_of(setting_.face());
    divisor *= setting_.face().style->size().raw;
  }
  return clamp_to(divide(dividend, divisor), advances_.limit());
}

// Glyphs of other faces are not kerned. A pair is in the order of the screen.
// Where that may differ from the text's order, or the text is cut, each pair
// stands for itself.
int32_t Pen::kerning(const LineCell& cell) noexcept {
  if (cell.kind != CellKind::kerned || !previous_.is_found ||
      previous_.face != 0 || cell.face != 0) {
    return 0;
  }
  const bool is_rtl = cell.level % 2 != 0;
  if (is_rtl || !keeps_length_) {
    drift_q6_ = 0;
  }
  const bool is_turned = is_rtl && !is_visual_;
  return advances_.kerning(is_turned ? cell.glyph : previous_.id,
                           is_turned ? previous_.id : cell.glyph, drift_q6_);
}

int32_t Pen::digit_width() noexcept {
  if (digit_width_ < 0) {
    digit_width_ = 0;
    for (uint32_t digit = '0'; digit <= '9'; ++digit) {
      const int32_t width = advance(find(digit));  // perhaps of .notdef
      digit_width_ = width > digit_width_ ? width : digit_width_;
    }
  }
  return digit_width_;
}

int32_t Pen::tab_step() const noexcept {
  if (options().tab_width.raw != 0) {
    return from_px(options().tab_width);
  }
  const Glyph space = find(' ');
  return space.is_found ? clamp_to(8 * advance(space), kMaxPx) : em();
}

// `step` is that of stops behind the last one of the options.
int32_t Pen::next_tab(int32_t step) const noexcept {
  const int32_t limit = advances_.limit();
  if (!has_stops_) {
    return clamp_to(at_ + step, limit);
  }
  const int32_t from = at_ - origin_;
  for (const Q26_6 stop : options().tab_stops) {
    const int32_t to = from_px(stop);
    if (to > from) {
      return clamp_to(origin_ + to, limit);
    }
  }
  if (step <= 0) {
    return at_;
  }
  const int32_t steps = from < 0 ? 0 : from / step + 1;
  return clamp_to(origin_ + steps * step, limit);
}

void Pen::begin_cell(uint8_t level, LineCell& cell) noexcept {
  if (level != previous_level_) {
    begin_run();
    previous_level_ = level;
  }
  cell.level = level;
  cell.x_glyph = 0;
  cell.y_glyph = 0;
  cell.more_glyphs = 0;
}

void Pen::look_up_tab(uint8_t level, LineCell& cell) noexcept {
  begin_cell(level, cell);
  cell.kind = CellKind::other;
  cell.has_ink = false;
  cell.x_end = next_tab(tab_step()) - at_;
  begin_run();
  has_begun_ = false;
}

// Finds the glyph and its advance, which `x_end` then holds; `x_glyph` counts
// from `x`. Widths are the same in both orders: marks neither take part in
// kerning nor in spacing, and nothing reaches over a tab.
void Pen::look_up(uint32_t code_point, uint8_t level, LineCell& cell) noexcept {
  begin_cell(level, cell);
  const bool is_mark_itself = is_mark(code_point);
  if (level % 2 != 0 && options().order() != nullptr) {
    code_point = options().order()->mirrored(code_point);
  }
  const Shown shown = shown_as(code_point);
  const bool is_placed =
      shown == Shown::mark || (shown == Shown::glyph && is_mark_itself);
  if (setting_.painter.report() != nullptr &&
      (is_placed || joins(code_point))) {
    setting_.painter.report()->note(Status::needs_shaping);
  }
  const Glyph glyph = find_shown(code_point, shown, cell);
  cell.glyph = glyph.id;
  cell.face = glyph.face;
  cell.has_ink = glyph.is_found && shown != Shown::space;
  const bool is_tabular =
      options().tabular_digits && code_point - '0' < 10 && glyph.is_found;
  cell.kind = is_mark_itself                      ? CellKind::mark
              : glyph.is_found && !is_tabular     ? CellKind::kerned
              : glyph.is_found || cell.x_end != 0 ? CellKind::base
                                                  : CellKind::other;
  if (is_tabular) {
    cell.x_glyph = (digit_width() - cell.x_end) / 2;
    cell.x_end = digit_width();
  }
}

void Pen::place(int32_t kerning, LineCell& cell) noexcept {
  if (cell.is_base()) {
    move((has_begun_ ? spacing_ : 0) + kerning);
    has_begun_ = true;
    previous_ = {cell.glyph, cell.face, cell.kind == CellKind::kerned};
  }
  cell.x = at_;
  cell.x_glyph += at_;
  move(cell.x_end);
  cell.x_end = at_;
}

Pen::Sign Pen::sign(uint32_t code_point,
                    uint32_t other,
                    uint32_t count) const noexcept {
  Glyph glyph = find(code_point);
  Sign found = {code_point, 1, 0};
  if (!glyph.is_found) {
    glyph = find(other);
    found = {other, glyph.is_found ? count : 0, 0};
  }
  const auto signs = static_cast<int32_t>(found.count);
  found.width = signs * (spacing_ + advance(glyph));
  return found;
}

Pen::Sign Pen::ellipsis() const noexcept {
  return sign(0x2026, '.', 3);
}

Pen::Sign Pen::hyphen() const noexcept {
  return sign(0x2010, '-', 1);
}

}  // namespace inkcell::detail
