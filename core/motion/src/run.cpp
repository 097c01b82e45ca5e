// Lays out words and lines, and places them on straight lines.
#include "inkcell/motion/run.hpp"

#include "as_designed.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

bool has_ink(const Font& font, uint16_t glyph) noexcept {
  GlyphMetrics metrics;
  return font.glyph_metrics(glyph, metrics) == Status::ok &&
         metrics.x_min < metrics.x_max && metrics.y_min < metrics.y_max;
}

// [Q6]
int32_t clamped_size(Q26_6 size) noexcept {
  return clamp(size.raw, 0, kMaxSize.raw);
}

// Removes the first line and its line feed from `text` and returns the line.
Text next_line(Text& text) noexcept {
  size_t size = 0;
  while (size < text.size && text.data[size] != '\n') {
    ++size;
  }
  const Text line(text.data, size);
  size += size < text.size ? 1 : 0;
  text = Text(text.data + size, text.size - size);
  return line;
}

// Shifts a line that starts at 0 to its anchor.
void anchor_line(Anchor anchor, int32_t width, Span<RunGlyph> line) noexcept {
  const int32_t first = line.size == 0 ? 0 : line[0].letter;
  const int32_t gaps = line.size == 0 ? 0 : line[line.size - 1].letter - first;
  const int32_t parts = static_cast<int32_t>(anchor);  // in halves
  for (RunGlyph& glyph : line) {
    glyph.x -= width * parts / 2;
    glyph.half_gaps =
        static_cast<int16_t>(2 * (glyph.letter - first) - gaps * parts);
  }
}

// lay_out() of a painter for motion. Not inline: a frame of its own.
__attribute__((noinline)) Status lay_out_by(const Painter& designing,
                                            const Font& font,
                                            Text text,
                                            Anchor anchor,
                                            Span<RunGlyph> out,
                                            Run& run) noexcept {
  const FontMetrics metrics = font.metrics();
  Run result;
  result.line_height = metrics.ascender - metrics.descender + metrics.line_gap;
  size_t count = 0;
  uint16_t word = 0;
  do {
    TextCursor cursor(designing, font, next_line(text), kAsDesigned);
    const size_t first = count;
    bool in_word = false;
    int32_t offset = -1;  // of the letter before
    PositionedGlyph glyph;
    while (cursor.next(glyph)) {
      if (!has_ink(font, glyph.glyph)) {
        word = static_cast<uint16_t>(word + (in_word ? 1 : 0));
        in_word = false;
        continue;
      }
      // half_gaps holds twice the count.
      if (count == out.size || count - first == 0x3fff) {
        return Status::buffer_small;
      }
      in_word = true;
      result.letters = static_cast<uint16_t>(result.letters +
                                             (glyph.offset != offset ? 1 : 0));
      offset = glyph.offset;
      const LetterEdges letter = cursor.letter();
      out[count++] = {glyph.x,
                      glyph.y - result.lines * result.line_height,
                      letter.begin + letter.end - 2 * glyph.x,
                      glyph.glyph,
                      word,
                      result.lines,
                      0,
                      static_cast<uint16_t>(result.letters - 1)};
    }
    word = static_cast<uint16_t>(word + (in_word ? 1 : 0));
    const int32_t width = cursor.advance();
    anchor_line(anchor, width, {out.data + first, count - first});
    result.width = width > result.width ? width : result.width;
    ++result.lines;
  } while (text.size != 0 && result.lines != 0xffff);
  result.words = word;
  result.glyphs = {out.data, count};
  run = result;
  return Status::ok;
}

// Of a glyph's origin above the baseline of its line. [font units]
int32_t rise_of(const Run& run, const RunGlyph& glyph) noexcept {
  return glyph.y + glyph.line * run.line_height;
}

}  // namespace

Status lay_out(const Font& font,
               Text text,
               Anchor anchor,
               Span<RunGlyph> out,
               Run& run) noexcept {
  return lay_out(Painter(), font, text, anchor, out, run);
}

Status lay_out(const Painter& painter,
               const Font& font,
               Text text,
               Anchor anchor,
               Span<RunGlyph> out,
               Run& run) noexcept {
  return lay_out_by(painter.for_motion(), font, text, anchor, out, run);
}

Status lay_out(const Font& font,
               const ShapedRun& text,
               Anchor anchor,
               Span<RunGlyph> out,
               Run& run) noexcept {
  constexpr int64_t kFar = 1 << 24;  // as lay_out() of PositionedGlyph has it
  const FontMetrics metrics = font.metrics();
  Run result;
  result.line_height = metrics.ascender - metrics.descender + metrics.line_gap;
  size_t count = 0;
  int32_t x = 0;
  for (const ShapedGlyph& glyph : text.glyphs) {
    x = clamp_i64(int64_t{x} + glyph.x, -kFar, kFar);
    if (!has_ink(font, glyph.glyph)) {
      continue;
    }
    if (count == out.size || count == 0x3fff) {
      return Status::buffer_small;
    }
    out[count] = {x, glyph.y, font.advance(glyph.glyph), glyph.glyph};
    out[count].letter = static_cast<uint16_t>(count);
    ++count;
  }
  result.letters = static_cast<uint16_t>(count);
  result.width = clamp_i64(text.advance, -kFar, kFar);
  anchor_line(anchor, result.width, {out.data, count});
  result.words = count != 0 ? 1 : 0;
  result.lines = 1;
  result.glyphs = {out.data, count};
  run = result;
  return Status::ok;
}

uint32_t unit_count(const Run& run, Unit unit) noexcept {
  return unit == Unit::glyph  ? run.letters
         : unit == Unit::word ? run.words
                              : run.lines;
}

uint32_t unit_of(const Run& run, Unit unit, size_t index) noexcept {
  return unit == Unit::glyph  ? run.glyphs[index].letter
         : unit == Unit::word ? run.glyphs[index].word
                              : run.glyphs[index].line;
}

Q16_16 pivot_height_px(Q26_6 size, int16_t height) noexcept {
  constexpr int32_t kLimit = 32767 << 6;
  const int32_t px_q6 = clamped_size(size) * height / 1000;
  return Q16_16::from_raw(clamp(px_q6, -kLimit, kLimit) * (1 << 10));
}

Q16_16 to_px_q16(const Font& font, Q26_6 size, int32_t units) noexcept {
  // Px to the unit in Q21: a division of 32 bits, exact to 1/65536 px a unit.
  const auto size_q6 = static_cast<uint32_t>(clamped_size(size));
  const uint32_t em = font.units_per_em() == 0 ? 1 : font.units_per_em();
  const uint32_t scale_q21 = ((size_q6 << 15) + em / 2) / em;
  const int64_t px_q16 = (int64_t{units} * scale_q21 + (1 << 4)) >> 5;
  constexpr int32_t kLimit = 32767 << 16;
  return Q16_16::from_raw(clamp_i64(px_q16, -kLimit, kLimit));
}

PosedGlyph place(const Font& font,
                 const Run& run,
                 size_t index,
                 const RunPlace& where,
                 const Pose& pose) noexcept {
  const RunGlyph& glyph = run.glyphs[index];
  PosedGlyph posed;
  posed.glyph = glyph.glyph;
  posed.pose = pose;
  posed.pivot_x.raw = to_px_q16(font, where.size, glyph.advance).raw / 2;
  // Marks turn with their letters.
  posed.pivot_y.raw = pivot_height_px(where.size, where.pivot_height).raw -
                      to_px_q16(font, where.size, rise_of(run, glyph)).raw;
  const int64_t x_q16 =
      int64_t{to_px_q16(font, where.size, glyph.x).raw} + posed.pivot_x.raw +
      int64_t{where.tracking.raw} * glyph.half_gaps * (1 << 9);
  const int64_t y_q16 =
      int64_t{to_px_q16(font, where.size, glyph.y).raw} + posed.pivot_y.raw;
  posed.at.x.raw =
      static_cast<int32_t>(where.origin.x.raw + ((x_q16 + (1 << 9)) >> 10));
  posed.at.y.raw =
      static_cast<int32_t>(where.origin.y.raw - ((y_q16 + (1 << 9)) >> 10));
  return posed;
}

}  // namespace inkcell::motion
