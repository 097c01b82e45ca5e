// Fields of a real face, everywhere in the em box, against the exact distance
// to the outlines of the font file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "glyph_outlines.hpp"
#include "inkcell/field/generate.hpp"
#include "opened_font.hpp"
#include "pipeline/generate.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen::test {
namespace {

constexpr double kNear_u = 32;

// The errors of a face.
struct Errors {
  double near_u = 0;      // worst within kNear_u of the edge
  double far_part = 0;    // worst beyond, of the distance
  double overstated = 0;  // worst of bounds, of the distance
  double sum = 0;         // of squares near the edge
  size_t near = 0;
  size_t bounds = 0;
  size_t count = 0;
  size_t bytes = 0;
  size_t most_bytes = 0;
};

void compare(const Shape& shape, const GlyphField& field, Errors& errors) {
  constexpr int kStep_u = 16;
  for (int y = -256 + kStep_u / 2; y < 768; y += kStep_u) {
    for (int x = kStep_u / 2; x < 1024; x += kStep_u) {
      const FieldPoint point =
          point_at(field, Q16_16::from_int(x), Q16_16::from_int(y));
      const double found = point.distance.raw / 1024.0;
      const double exact = shape.distance(x, y);
      const double error = std::fabs(found - exact);
      ++errors.count;
      if (point.is_bound) {
        ++errors.bounds;
        EXPECT_LT(exact, -470) << "a bound near the edge";
        errors.overstated = std::max(errors.overstated, found / exact - 1);
      } else if (std::fabs(exact) <= kNear_u) {
        ++errors.near;
        errors.sum += error * error;
        errors.near_u = std::max(errors.near_u, error);
      } else {
        errors.far_part = std::max(errors.far_part, error / std::fabs(exact));
      }
    }
  }
}

Errors measure(const char* file) {
  GenerateRequest request;
  request.font = file;
  request.chars = {"0x21-0x7E"};
  const std::vector<uint8_t> bytes = generate(request).bytes;
  const Font font = opened(bytes);
  FieldLimits limits;
  limits.fills_em = true;
  alignas(4) static uint8_t ram[1 << 17];
  Errors errors;
  const std::vector<uint32_t> characters = ascii();
  const std::vector<Outline> outlines = load_outlines(file, 0, characters);
  for (size_t i = 0; i < characters.size(); ++i) {
    const uint16_t glyph = font.glyph_or_notdef(characters[i]);
    GlyphField field;
    EXPECT_EQ(open_field(font, glyph, limits, ram, field), Status::ok);
    const size_t record = record_bytes(field);
    errors.bytes += record;
    errors.most_bytes = std::max(errors.most_bytes, record);
    compare(Shape(outlines[i]), field, errors);
  }
  errors.bytes /= characters.size();
  std::printf(
      "%s: near RMS %.2f u, worst %.2f u; far %.1f %%; bounds %.1f %% "
      "of points, overstated %.1f %%; RAM %zu B, most %zu B\n",
      file, std::sqrt(errors.sum / static_cast<double>(errors.near)),
      errors.near_u, 100 * errors.far_part,
      100.0 * static_cast<double>(errors.bounds) /
          static_cast<double>(errors.count),
      100 * errors.overstated, errors.bytes, errors.most_bytes);
  return errors;
}

// docs/ANIMATING.md states these limits.
TEST(FieldReach, EmBoxesAreFilled) {
  for (const char* file : {kDejaVuSans, kLiberationSerif}) {
    const Errors errors = measure(file);
    EXPECT_GT(errors.near, 10000u);
    EXPECT_LT(errors.near_u, 3);
    EXPECT_LT(errors.far_part, 0.05);
    EXPECT_LT(errors.overstated, 0.01);
  }
}

}  // namespace
}  // namespace inkcell::gen::test
