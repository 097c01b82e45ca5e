// The code of docs/ANIMATING.md that is a function of time. build.docs_code
// looks for it here.
#include "animating_input.hpp"
#include "inkcell/field/generate.hpp"
#include "inkcell/motion/morph.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/motion/timeline.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace animating_input;

constexpr Point to = {Q26_6::from_int(44), Q26_6::from_int(30)};

Status draw_poses(int32_t now_ms, const Painter& painter) {
  constexpr PoseKey keys[] = {{0, {}, kOvershoot}, {500, {}, kLinear}};
  const RunPlace where = {from, size, {}, 250};
  RunGlyph glyphs[16];
  PosedGlyph posed[16];
  Run run;
  INKCELL_TRY(lay_out(font, "ABCD", Anchor::left, glyphs, run));
  PoseRenderer renderer(font, size);
  for (size_t i = 0; i < run.glyphs.size; ++i) {
    const int32_t delay =
        delay_of({40, StaggerOrder::from_centre, 0}, i, run.glyphs.size);
    posed[i] = place(font, run, i, where, pose_at(keys, now_ms - delay));
  }
  renderer.draw({posed, run.glyphs.size}, painter);  // for each strip
  constexpr Point control1 = {Q26_6::from_int(14), Q26_6::from_int(10)};
  constexpr Point control2 = {Q26_6::from_int(34), Q26_6::from_int(50)};
  PathPoint points[40];
  Path path(points);
  INKCELL_TRY(path.move_to(from));
  INKCELL_TRY(path.cubic_to(control1, control2, to, 32));
  PathPlace along;
  along.size = size;
  for (size_t i = 0; i < run.glyphs.size; ++i) {
    posed[i] = place(font, run, i, path, along, Pose());
  }
  renderer.draw({posed, run.glyphs.size}, painter);
  return Status::ok;
}

Status draw_morph(int32_t now_ms, const Painter& painter) {
  const int32_t x = 4;
  const int32_t y = 4;
  constexpr MorphBox box = {24, 24, 20, 0};  // width, height, baseline [px]
  static int8_t grids[morph_bytes(box)];
  GridHistogram scratch;
  GlyphMorph digit(font, size, kFilterMotion, box, grids);
  INKCELL_TRY(digit.set(font.glyph_or_notdef('A'), font.glyph_or_notdef('C')));
  digit.step(ease(kEaseInOut, fraction(0, 600, now_ms)), scratch);
  digit.draw(x, y, painter);  // for each strip
  return Status::ok;
}

Status draw_outlines(const Painter& painter, Q16_16 progress) {
  const uint16_t four = font.glyph_or_notdef('A');
  const uint16_t five = font.glyph_or_notdef('C');
  const Style style(size);
  const Point origin = from;
  OutlineMorph digit;
  INKCELL_TRY(OutlineMorph::open(font, four, five, digit));
  digit.draw(painter, style, origin, progress);  // for each strip
  return Status::ok;
}

Status draw_bolder(const Painter& painter, Point& origin, Q16_16 weight) {
  const uint16_t glyph = font.glyph_or_notdef('A');
  const Style style(size);
  OutlineMorph letter;  // of a glyph
  INKCELL_TRY(OutlineMorph::open_master(font, glyph, letter));
  letter.draw(painter, style, origin, weight);  // 0: light, 1: bold
  origin.x.raw += letter.advance(style, weight).raw;
  return Status::ok;
}

Status ask_field(uint16_t glyph, Q16_16 x, Q16_16 y, FieldPoint& out) {
  alignas(4) static uint8_t ram[16384];
  FieldLimits limits;
  limits.fills_em = true;
  GlyphField field;
  INKCELL_TRY(open_field(font, glyph, limits, ram, field));
  const FieldPoint at = point_at(field, x, y);  // u, y up
  out = at;
  return Status::ok;
}

}  // namespace

TEST(poses_and_paths_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_poses(300, sink));
  CHECK(ink.sum > 255 * 100);
}

TEST(morphs_draw) {
  const Sink sink = counting_sink();
  CHECK_OK(draw_morph(300, sink));
  CHECK(ink.sum > 255 * 20);
}

TEST(outlines_morph_if_the_font_holds_the_pair) {
  const Sink sink = counting_sink();
  CHECK(draw_outlines(Painter(sink), Q16_16::from_int(0)) == Status::no_glyph);
  Point at;
  CHECK(draw_bolder(Painter(sink), at, Q16_16::from_int(0)) ==
        Status::no_glyph);
  CHECK_EQ(at.x.raw, 0);
  CHECK_EQ(ink.sum, 0);
}

TEST(fields_answer) {
  // Left of the disc about (384, 384).
  FieldPoint at;
  CHECK_OK(ask_field(1, Q16_16::from_int(20), Q16_16::from_int(384), at));
  CHECK(!at.is_bound);
  CHECK(at.distance.raw < -40 * 1024);
  CHECK(at.gradient.x.raw > 16000);
}
