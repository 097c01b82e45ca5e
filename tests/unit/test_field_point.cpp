// Distance and gradient by one question: of cells, beyond them, and everywhere
// in the em box against all edges of an outline.
#include "any_record.hpp"
#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/generate.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "outline_record.hpp"
#include "outline_truth.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using outline_record::OutlinePoint;

constexpr uint16_t kDiscGlyph = 1;
constexpr uint16_t kEmptyGlyph = 7;
constexpr Span<const OutlinePoint> kOutlines[] = {
    {outline_record::kBar, 4},    {outline_record::kDisc, 13},
    {outline_record::kBar, 4},    {outline_record::kEll, 6},
    {outline_record::kFrame, 12}, {outline_record::kLeaf, 4}};
constexpr size_t kRamBytes = 20480;

alignas(4) uint8_t rom[outline_record::kSampleFontBytes];
alignas(4) uint8_t ram[kRamBytes];
outline_truth::Truth truth;
font_builder::Record samples;

Font open_outlines() {
  Font font;
  CHECK_OK(open_any_font({rom, outline_record::build_sample_font(rom)}, font));
  return font;
}

// At a place of the grid: what the two questions tell.
void check_both(const GlyphField& field, Q16_16 x, Q16_16 y) {
  const FieldPoint point = point_at(field, x, y);
  const Q22_10 distance = distance_at(field, x, y);
  const Gradient gradient = gradient_at(field, x, y);
  const bool is_saturated = distance.raw == kSaturatedDistanceQ10 ||
                            distance.raw == -kSaturatedDistanceQ10;
  if (point.is_bound) {
    CHECK(is_saturated);  // the band is not known
    CHECK(point.distance.raw == 0 ||
          (point.distance.raw > 0) == (distance.raw > 0));
    return;
  }
  constexpr int32_t kPart = 64;  // 1/256
  const int32_t x_error = point.gradient.x.raw - gradient.x.raw;
  const int32_t y_error = point.gradient.y.raw - gradient.y.raw;
  CHECK_EQ(point.distance.raw, distance.raw);
  CHECK(x_error <= kPart && x_error >= -kPart);
  CHECK(y_error <= kPart && y_error >= -kPart);
}

TEST(one_question_tells_what_two_do) {
  Random random(3);
  for (int32_t round = 0; round < 300 && !check::failed(); ++round) {
    GlyphField field;
    make_any(samples, random);
    samples.write(ram);
    CHECK_OK(GlyphField::open({ram, samples.size()}, field));
    for (int32_t i = 0; i < 20; ++i) {
      const int32_t x = random.between(field.x0_u - 9, field.x1_u() + 9);
      const int32_t y = random.between(field.y0_u - 9, field.y1_u() + 9);
      check_both(field, Q16_16::from_raw(x * 65536 + random.between(0, 65535)),
                 Q16_16::from_raw(y * 65536 + random.between(0, 65535)));
    }
  }
}

// The em box in steps of a prime.
TEST(fields_are_good_everywhere_in_the_em_box) {
  const Font font = open_outlines();
  FieldLimits limits;
  limits.fills_em = true;
  // Twice the tolerance between the points of the test, and the chords.
  constexpr double kNear_u = 2.5;
  constexpr double kFarPart = 2.0 / 64;
  const int32_t step = INKCELL_BOARD_FIRMWARE ? 97 : 13;
  for (uint16_t glyph = 0; glyph < 6; ++glyph) {
    truth.set(kOutlines[glyph], 1, 0, 0, glyph == 5 ? 32 : 8);
    GlyphField field;
    CHECK_OK(open_field(font, glyph, limits, ram, field));
    CHECK_EQ(field.band_u, FieldLimits::kMaxFar);
    for (int32_t y = -256; y < 768 && !check::failed(); y += step) {
      for (int32_t x = 0; x < 1024; x += step) {
        const FieldPoint point =
            point_at(field, Q16_16::from_int(x), Q16_16::from_int(y));
        const double found = point.distance.raw / 1024.0;
        const double expected = truth.distance(x, -y);
        const double limit = kNear_u + kFarPart * magnitude(expected);
        CHECK((found > 0) == (expected > 0) || magnitude(expected) < 2.5);
        CHECK(magnitude(found) < magnitude(expected) + limit);
        CHECK(magnitude(expected) > FieldLimits::kMaxFar ||
              magnitude(found - expected) < limit);
        CHECK(magnitude(expected) < FieldLimits::kMaxFar ||
              magnitude(found) >
                  FieldLimits::kMaxFar * (1 - kFarPart) - kNear_u);
      }
    }
  }
}

// A step against the gradient by the distance ends near the edge: directions
// are within 7 degrees.
TEST(gradients_lead_to_the_edge) {
  const Font font = open_outlines();
  FieldLimits limits;
  limits.fills_em = true;
  GlyphField field;
  CHECK_OK(open_field(font, kDiscGlyph, limits, ram, field));
  Random random(5);
  for (int32_t i = 0; i < 300; ++i) {
    const int32_t x = random.between(0, 1023);
    const int32_t y = random.between(-256, 767);
    const FieldPoint point =
        point_at(field, Q16_16::from_int(x), Q16_16::from_int(y));
    const int32_t from_middle = (x - 384) * (x - 384) + (y - 384) * (y - 384);
    if (point.is_bound || from_middle < 100 * 100) {
      continue;  // where gradients of a disc turn fast
    }
    const auto moved = [&point](int32_t at, int32_t slope) {
      return Q16_16::from_raw(
          at * 65536 -
          static_cast<int32_t>(int64_t{point.distance.raw} * slope / (1 << 8)));
    };
    const FieldPoint there = point_at(field, moved(x, point.gradient.x.raw),
                                      moved(y, point.gradient.y.raw));
    CHECK(magnitude(there.distance.raw / 1024.0) <
          4 + magnitude(point.distance.raw / 1024.0) / 8);
  }
}

TEST(what_lies_beyond_is_bounded_by_the_box) {
  const Font font = open_outlines();
  GlyphField field;
  FieldLimits limits;
  limits.band_u = 16;
  CHECK_OK(open_field(font, kDiscGlyph, limits, ram, field));
  const FieldPoint left = point_at(
      field, Q16_16::from_int(field.ink.x0_u - 300), Q16_16::from_int(384));
  CHECK(left.is_bound);
  CHECK_EQ(left.distance.raw, -300 * 1024);
  CHECK_EQ(left.gradient.x.raw, 1 << 14);
  CHECK_EQ(left.gradient.y.raw, 0);
  const FieldPoint corner =
      point_at(field, Q16_16::from_int(field.ink.x0_u - 300),
               Q16_16::from_int(field.ink.y0_u - 400));
  CHECK_EQ(corner.distance.raw, -500 * 1024);
  const FieldPoint centre =
      point_at(field, Q16_16::from_int(384), Q16_16::from_int(384));
  CHECK(centre.is_bound);
  CHECK_EQ(centre.distance.raw, 16 * 1024);
  const FieldPoint far =
      point_at(field, Q16_16::from_int(-32768), Q16_16::from_int(32767));
  CHECK_EQ(far.distance.raw, -kSaturatedDistanceQ10);
}

TEST(fonts_that_know_too_little_are_refused) {
  static uint8_t bytes[8192];
  font_builder::GlyphSpec glyphs[1] = {};
  samples.reset();
  samples.fill(font_builder::disc);
  CHECK(samples.size() <= kRamBytes);
  samples.write(ram);
  glyphs[0].bytes = {ram, samples.size()};
  font_builder::FontSpec spec;
  spec.glyphs = {glyphs, 1};
  Font font;
  CHECK_OK(open_any_font({bytes, font_builder::build_font(spec, bytes)}, font));
  const int32_t band_u = font.range().band_u;
  GlyphField field;
  FieldLimits limits;
  limits.band_u = band_u;
  CHECK_OK(open_field(font, 0, limits, {}, field));
  CHECK_EQ(field.band_u, band_u);
  CHECK(field.cells >= bytes && field.cells < bytes + sizeof bytes);
  limits.band_u = band_u + 1;
  CHECK_EQ(open_field(font, 0, limits, {}, field), Status::beyond_band);
  limits.band_u = band_u;
  limits.fills_em = true;
  CHECK_EQ(open_field(font, 0, limits, {}, field), Status::beyond_band);
  limits.band_u = 0;
  CHECK_EQ(open_field(font, 0, limits, {}, field), Status::bad_argument);
  CHECK_EQ(open_field(open_outlines(), kEmptyGlyph, {}, {}, field), Status::ok);
}

}  // namespace
