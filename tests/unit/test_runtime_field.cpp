// Fields made of outlines in RAM, against distances from all of their edges.
#include "inkcell/field/generate.hpp"

#include "check.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/filter.hpp"
#include "outline_record.hpp"
#include "outline_truth.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using outline_record::OutlinePoint;
using outline_truth::Truth;

constexpr size_t kFontBytes = outline_record::kSampleFontBytes;
constexpr size_t kRamBytes = 20480;
alignas(4) uint8_t rom[kFontBytes];
alignas(4) uint8_t ram[kRamBytes];
alignas(4) uint8_t spare[kRamBytes];
Truth truth;

// Glyphs of the font of fields.
constexpr uint16_t kDiscGlyph = 1;
constexpr uint16_t kCompositeGlyph = 6;
constexpr uint16_t kEmptyGlyph = 7;
constexpr Span<const OutlinePoint> kOutlines[] = {
    {outline_record::kBar, 4},    {outline_record::kDisc, 13},
    {outline_record::kBar, 4},    {outline_record::kEll, 6},
    {outline_record::kFrame, 12}, {outline_record::kLeaf, 4}};

// The truth's edges are up to 0.3 u off their curves; those of the leaf are
// long.
constexpr uint16_t kLeafGlyph = 5;
constexpr int32_t kLeafSteps = 32;
// That and roundings. [u]
constexpr double kSlack = 0.4;

// The factor by which cells may be worse between the points of their test.
constexpr double kBetween = 2;

void set_truth(uint16_t glyph, double scale, double x, double y) {
  truth.set(kOutlines[glyph], scale, x, y,
            glyph == kLeafGlyph ? kLeafSteps : outline_truth::kSteps);
}

// Opens the font of fields.
Font open_font() {
  const size_t size = outline_record::build_sample_font(rom);
  Font font;
  CHECK_OK(open_any_font({rom, size}, font));
  return font;
}

FieldLimits limits_of(int32_t tolerance_q10, int32_t band_u) {
  FieldLimits limits;
  limits.tolerance.raw = tolerance_q10;
  limits.band_u = band_u;
  return limits;
}

double clamped(double distance, double band) {
  return distance > band ? band : (distance < -band ? -band : distance);
}

// The distance of a shape as a test sees it. [u, y up]
double simple_distance(double x, double y) {
  return truth.distance(x, -y);
}

// Compares a field with distances at `points` places around it.
template <typename Distance>
void check_field(const GlyphField& field,
                 const FieldLimits& limits,
                 int32_t points,
                 Random& random,
                 Distance distance) {
  const double tolerance = limits.tolerance.raw / 1024.0;
  const double band = limits.band_u;
  const int32_t reach = limits.band_u + 20;
  for (int32_t i = 0; i < points && !check::failed(); ++i) {
    const int32_t x_q4 = random.between((field.ink.x0_u - reach) * 16,
                                        (field.ink.x1_u + reach) * 16);
    const int32_t y_q4 = random.between((field.ink.y0_u - reach) * 16,
                                        (field.ink.y1_u + reach) * 16);
    const double expected = distance(x_q4 / 16.0, y_q4 / 16.0);
    const double found = distance_at(field, Q16_16::from_raw(x_q4 * 4096),
                                     Q16_16::from_raw(y_q4 * 4096))
                             .raw /
                         1024.0;
    const double error = clamped(found, band) - clamped(expected, band);
    const double limit = kBetween * tolerance + kSlack;
    CHECK(error <= limit && error >= -limit);
  }
}

TEST(fields_are_as_good_as_asked_for) {
  const FieldLimits kLimits[] = {limits_of(768, 16), limits_of(1024, 32),
                                 limits_of(4096, 100)};
  const Font font = open_font();
  Random random(1);
  for (uint16_t glyph = 0; glyph < 6; ++glyph) {
    set_truth(glyph, 1, 0, 0);
    for (const FieldLimits& limits : kLimits) {
      GlyphField field;
      CHECK_OK(generate_field(font, glyph, limits, ram, field));
      CHECK(record_bytes(field) < kRamBytes);
      check_field(field, limits, 300, random, simple_distance);
    }
  }
}

// Beyond the band all is on its side.
TEST(saturated_cells_know_their_side) {
  const Font font = open_font();
  GlyphField field;
  CHECK_OK(generate_field(font, kDiscGlyph, limits_of(1024, 8), ram, field));
  const auto at = [&field](int32_t x_u, int32_t y_u) {
    return distance_at(field, Q16_16::from_int(x_u), Q16_16::from_int(y_u)).raw;
  };
  CHECK_EQ(at(384, 384), kSaturatedDistanceQ10);
  CHECK_EQ(at(90, 90), -kSaturatedDistanceQ10);
  CHECK_EQ(at(5000, 384), -kSaturatedDistanceQ10);
}

// The disc where it is, and the leaf turned by a quarter and half as large.
TEST(composites_have_fields) {
  const Font font = open_font();
  static Truth leaf;
  truth.set({outline_record::kDisc, 13}, 1, 0, 0);
  leaf.set({outline_record::kLeaf, 4}, 0.5, 0, 0, kLeafSteps);
  const auto distance = [](double x, double y) {
    const double disc = simple_distance(x, y);
    const double turned = leaf.distance(y - 300, x - 1100);
    return disc > turned ? disc : turned;
  };
  Random random(2);
  const FieldLimits limits = limits_of(1024, 32);
  GlyphField field;
  CHECK_OK(generate_field(font, kCompositeGlyph, limits, ram, field));
  check_field(field, limits, 1000, random, distance);
}

// The format's own checks, by way of a font that consists of the record.
TEST(records_are_of_the_format) {
  const Font font = open_font();
  for (uint16_t glyph = 0; glyph < 6; ++glyph) {
    GlyphField field;
    CHECK_OK(generate_field(font, glyph, limits_of(4096, 32), ram, field));
    font_builder::GlyphSpec glyphs[1] = {};
    glyphs[0].bytes = {ram, record_bytes(field)};
    font_builder::FontSpec spec;
    spec.glyphs = {glyphs, 1};
    const size_t size = font_builder::build_font(spec, spare);
    Font made;
    CHECK_OK(open_any_font({spare, size}, made));
    CHECK_OK(made.verify());
  }
}

TEST(buffers_are_used_whole_or_not_at_all) {
  const Font font = open_font();
  const FieldLimits limits = limits_of(4096, 32);
  GlyphField whole;
  CHECK_OK(generate_field(font, kDiscGlyph, limits, ram, whole));
  const size_t bytes = record_bytes(whole);
  __builtin_memcpy(spare, ram, bytes);
  size_t size = 0;
  Status status = Status::buffer_small;
  for (; status == Status::buffer_small && size < kRamBytes; size += 28) {
    GlyphField field;
    ram[size] = 0xa5;
    status = generate_field(font, kDiscGlyph, limits, {ram, size}, field);
    CHECK_EQ(ram[size], 0xa5);
    CHECK((field.references == nullptr) == (status != Status::ok));
    CHECK(status != Status::ok || __builtin_memcmp(ram, spare, bytes) == 0);
  }
  CHECK_OK(status);
  CHECK(size > bytes);
}

TEST(pictures_are_those_of_the_distance) {
  const Font font = open_font();
  constexpr int32_t kPx = 24;
  constexpr int32_t kTolerance = 8;  // and what is between and beside it
  constexpr int32_t kWorst = 20;
  Style style(Q26_6::from_int(kPx), kFilterText);
  // The filter reaches a pixel: 1024 u over the size.
  const FieldLimits limits =
      limits_of(kTolerance * (1 << 20) / (255 * kPx), (1024 + kPx - 1) / kPx);
  for (uint16_t glyph = 0; glyph < 6; ++glyph) {
    GlyphField field;
    CHECK_OK(generate_field(font, glyph, limits, ram, field));
    Picture<kPx, kPx> picture;
    draw_field(field, style, FinePoint(1024, 20 * 1024), picture.sink());
    set_truth(glyph, kPx / 1024.0, 1, 20);
    for (const auto [x, y] : pixels_of(kPx, kPx)) {
      const double px = truth.distance(x + 0.5, y + 0.5);
      const int32_t expected =
          style.filter().coverage(static_cast<int32_t>(clamped(px, 4) * 1024));
      const int32_t error = picture.at(x, y) - expected;
      CHECK(error <= kWorst && error >= -kWorst);
    }
  }
}

TEST(wrong_arguments_are_refused) {
  const Font font = open_font();
  GlyphField field;
  field.x0_u = 1234;
  CHECK_EQ(generate_field(font, 99, {}, ram, field), Status::no_glyph);
  CHECK_EQ(generate_field(font, 1, limits_of(63, 32), ram, field),
           Status::bad_argument);
  CHECK_EQ(generate_field(font, 1, limits_of((64 << 10) + 1, 32), ram, field),
           Status::bad_argument);
  CHECK_EQ(generate_field(font, 1, limits_of(1024, 0), ram, field),
           Status::bad_argument);
  CHECK_EQ(generate_field(font, 1, limits_of(1024, 257), ram, field),
           Status::bad_argument);
  CHECK_EQ(generate_field(font, 1, {}, {ram + 2, 4096}, field),
           Status::misaligned);
  CHECK_EQ(generate_field(font, 1, {}, {}, field), Status::buffer_small);
  CHECK_EQ(field.x0_u, 1234);
  CHECK_OK(generate_field(font, kEmptyGlyph, {}, {}, field));
  CHECK_EQ(record_bytes(field), 0u);
}

// Whatever the bytes are, nothing behind the buffer is touched, and what comes
// of it is safe to read.
TEST(any_bytes_are_safe) {
  const Font font = open_font();
  constexpr uint32_t kHeader = 64;
  for (Random& random : Rounds(3, 300)) {
    const size_t size = outline_record::build_sample_font(rom);
    for (uint32_t i = 1 + random.below(12); i != 0; --i) {
      const uint32_t at = random.below(static_cast<uint32_t>(size) - kHeader);
      rom[kHeader + at] = static_cast<uint8_t>(random.next() >> 13);
    }
    const size_t room = 4 * size_t{random.below(400)};
    ram[room] = 0x5a;
    GlyphField field;
    const Status status = generate_field(
        font, static_cast<uint16_t>(random.below(8)),
        limits_of(random.between(64, 65536), random.between(1, 256)),
        {ram, room}, field);
    CHECK_EQ(ram[room], 0x5a);
    CHECK(status != Status::ok || record_bytes(field) <= room);
    for (int32_t i = 0; i < 8; ++i) {
      const int32_t distance =
          distance_at(field, Q16_16::from_int(random.between(-900, 2000)),
                      Q16_16::from_int(random.between(-900, 2000)))
              .raw;
      CHECK(distance >= -kSaturatedDistanceQ10 &&
            distance <= kSaturatedDistanceQ10);
    }
  }
}

}  // namespace
