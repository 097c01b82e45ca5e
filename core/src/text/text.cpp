#include "inkcell/text.hpp"

#include "base/math.hpp"
#include "inkcell/assert.hpp"
#include "inkcell/painter.hpp"
#include "text/blank.hpp"
#include "text/glyph_run.hpp"

namespace inkcell {
namespace {

using detail::Advances;
using detail::clamp;
using detail::UnitScale;

constexpr uint32_t kReplacement = 0xfffd;

uint32_t byte_at(const Text& text, size_t i) noexcept {
  return static_cast<uint8_t>(text.data[i]);
}

void take(Text& text, size_t count) noexcept {
  text.data += count;
  text.size -= count;
}

// How many bytes follow a lead byte; 0: it is none.
uint32_t following(uint32_t lead) noexcept {
  if (lead < 0xc2 || lead > 0xf4) {
    return 0;
  }
  return lead < 0xe0 ? 1 : (lead < 0xf0 ? 2 : 3);
}

// Whether the first two bytes of `count` and one begin a code point; `bits`:
// those that they give. Excludes overlong forms, surrogates and what lies above
// U+10FFFF (Unicode, table 3-7).
bool begins_well(uint32_t count, uint32_t bits) noexcept {
  if (count == 2) {
    return bits >= 0x800 >> 6 && bits >> 5 != 0xd800 >> 11;
  }
  return count == 1 || bits - (0x10000 >> 12) < 0x100000 >> 12;
}

// False: nothing is to be drawn. Only characters that show something are
// missing where the font lacks them.
bool find_glyph(const Font& font,
                uint32_t code_point,
                TextReport* report,
                uint16_t& glyph) noexcept {
  const detail::Shown shown = detail::shown_as(code_point);
  if (shown == detail::Shown::nothing) {
    return false;
  }
  if (code_point == '\t') {
    code_point = ' ';
  }
  if (font.glyph_of(code_point, glyph) == Status::ok) {
    return true;
  }
  if (shown == detail::Shown::glyph) {
    return report == nullptr ||
           report->replace(*report, font, code_point, glyph);
  }
  return shown == detail::Shown::space &&
         font.glyph_of(' ', glyph) == Status::ok;
}

}  // namespace

uint32_t next_code_point(Text& text) noexcept {
  INKCELL_ASSERT(text.size != 0);
  const uint32_t first = byte_at(text, 0);
  if (first < 0x80) {
    take(text, 1);
    return first;
  }
  const uint32_t count = following(first);
  uint32_t code_point = first & (0x3f >> count);
  size_t used = 1;
  for (; used <= count && used < text.size; ++used) {
    const uint32_t next = byte_at(text, used);
    const uint32_t bits = code_point << 6 | (next & 0x3f);
    if (next >> 6 != 2 || (used == 1 && !begins_well(count, bits))) {
      break;
    }
    code_point = bits;
  }
  take(text, used);
  return count > 0 && used == count + size_t{1} ? code_point : kReplacement;
}

Text cut(Text text, size_t most) noexcept {
  if (text.size > most) {
    text.size = most;
    // At most 3 bytes continue a character.
    const size_t least = most < 3 ? 0 : most - 3;
    while (text.size > least && (byte_at(text, text.size) & 0xc0) == 0x80) {
      --text.size;
    }
  }
  return text;
}

bool detail::replace_missing(TextReport& report,
                             const Font& font,
                             uint32_t code_point,
                             uint16_t& glyph) noexcept {
  return report.find_instead(code_point, [&](uint32_t other) noexcept {
    return font.glyph_of(other, glyph) == Status::ok;
  });
}

bool needs_glyph(uint32_t code_point) noexcept {
  return detail::shown_as(code_point) == detail::Shown::glyph;
}

TextCursor::TextCursor(const Font& font,
                       Text text,
                       const Style& style,
                       TextReport* report) noexcept
    : TextCursor(font, text, report) {
  set_style(style);
}

TextCursor::TextCursor(const Painter& painter,
                       const Font& font,
                       Text text,
                       const Style& style) noexcept
    : TextCursor(font, text, painter.report()) {
  set_style(style);
  setter_ = painter.line_setter();
  if (setter_ != nullptr) {
    setter_->begin(*setter_, painter, *this);
  }
}

int32_t TextCursor::advance() const noexcept {
  if (setter_ != nullptr) {
    return setter_->letter(*setter_).end;
  }
  return Advances(font_, style_, fitter_).to_units(advance_);
}

LetterEdges TextCursor::letter() const noexcept {
  if (setter_ != nullptr) {
    return setter_->letter(*setter_);
  }
  const Advances advances(font_, style_, fitter_);
  const int32_t width =
      previous_ < 0 ? 0 : advances.advance(static_cast<uint16_t>(previous_));
  return {advances.to_units(advance_ - width), advances.to_units(advance_),
          false};
}

bool TextCursor::next(PositionedGlyph& out) noexcept {
  if (setter_ != nullptr) {
    return setter_->next(*setter_, out);
  }
  while (text_.size != 0) {
    const size_t offset = size_ - text_.size;
    if (!find_glyph(font_, next_code_point(text_), report_, out.glyph)) {
      continue;
    }
    const uint16_t glyph = out.glyph;
    const Advances advances(font_, style_, fitter_);
    const int32_t kerning =
        previous_ >= 0 ? advances.kerning(static_cast<uint16_t>(previous_),
                                          glyph, drift_q6_)
                       : 0;
    const int32_t limit = advances.limit();
    const int32_t at = clamp(advance_ + kerning, -limit, limit);
    // Positions are sums of advances, each converted by itself: nothing
    // accumulates.
    out.x = advances.to_units(at);
    out.y = 0;
    out.offset = static_cast<uint16_t>(offset);
    out.face = 0;
    advance_ = at + advances.advance(glyph);
    previous_ = glyph;
    if (advance_ >= limit) {
      advance_ = limit;
      if (report_ != nullptr) {
        report_->note(Status::cut);
      }
    }
    return true;
  }
  return false;
}

TextMeasure measure(const Font& font, TextCursor cursor) noexcept {
  return detail::measure_line(font, cursor);
}

Q26_6 to_px(const Font& font, const Style& style, int32_t units) noexcept {
  const int64_t fine = UnitScale(font, style).to_px_q10(units);
  return Q26_6::from_raw(
      detail::clamp_i64((fine + 8) >> 4, INT32_MIN, INT32_MAX));
}

PixelMeasure to_px(const Font& font,
                   const Style& style,
                   const TextMeasure& measure) noexcept {
  const auto px = [&](int32_t units) noexcept {
    return to_px(font, style, units);
  };
  return {px(measure.advance), px(measure.x_min), px(-measure.y_max),
          px(measure.x_max), px(-measure.y_min)};
}

}  // namespace inkcell
