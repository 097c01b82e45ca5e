// Styles of any matrix: which are allowed, and that what they draw is as far
// from the edge on the screen as it should be.
#include "check.hpp"
#include "field_record.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/render.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using field_equation::root;
using field_equation::Value;

// In px to the em: rows as the screen has them.
struct Map {
  double x_right;
  double y_right;
  double x_up;
  double y_up;
};

double magnitude(double value) {
  return value < 0 ? -value : value;
}

Q16_16 entry(double px) {
  return Q16_16::from_raw(static_cast<int32_t>(px * 65536));
}

Matrix matrix_of(const Map& map) {
  return {entry(map.x_right), entry(map.x_up), entry(map.y_right),
          entry(map.y_up)};
}

// The map that a matrix holds exactly.
Map map_of(const Matrix& matrix) {
  return {matrix.x_right.raw / 65536.0, matrix.y_right.raw / 65536.0,
          matrix.x_up.raw / 65536.0, matrix.y_up.raw / 65536.0};
}

Status make(const Map& map, TextStyle& out) {
  return TextStyle::make(matrix_of(map), kFilterText, out);
}

// A unit vector in any direction.
struct Turn {
  double cosine;
  double sine;

  explicit Turn(Random& random) {
    const double t = random.between(-1000, 1000) / 1000.0;
    const double sign = (random.next() & 1) != 0 ? 1 : -1;
    cosine = sign * (1 - t * t) / (1 + t * t);
    sine = sign * 2 * t / (1 + t * t);
    if ((random.next() & 1) != 0) {
      const double old = cosine;
      cosine = -sine;
      sine = old;
    }
  }
};

// A turn, a stretch of the axes, and another turn.
Map any_map(Random& random, double most_px, double least_px) {
  const Turn first(random);
  const Turn last(random);
  const double sign = (random.next() & 1) != 0 ? 1 : -1;
  const double x_right = most_px * first.cosine;
  const double y_right = -most_px * first.sine;
  const double x_up = sign * least_px * first.sine;
  const double y_up = sign * least_px * first.cosine;
  return {last.cosine * x_right - last.sine * x_up,
          last.cosine * y_right - last.sine * y_up,
          last.sine * x_right + last.cosine * x_up,
          last.sine * y_right + last.cosine * y_up};
}

}  // namespace

TEST(matrices_have_stretches_within_the_sizes) {
  TextStyle style;
  CHECK_EQ(make({0, 0, 0, 0}, style), Status::bad_argument);
  CHECK_EQ(make({24, 24, 24, 24}, style), Status::bad_argument);
  CHECK_EQ(make({3.9, 0, 0, 24}, style), Status::bad_argument);
  CHECK_EQ(make({24, 0, 0, 1025}, style), Status::bad_argument);
  CHECK_EQ(make({800, 800, -800, 800}, style), Status::bad_argument);
  CHECK_EQ(make({24, 1000, 0, 24}, style), Status::bad_argument);
  const int32_t ends[] = {INT32_MIN, INT32_MAX};
  for (const int32_t a : ends) {
    for (const int32_t b : ends) {
      const Matrix far = {Q16_16::from_raw(a), Q16_16::from_raw(b),
                          Q16_16::from_raw(b), Q16_16::from_raw(a)};
      CHECK_EQ(TextStyle::make(far, kFilterText, style), Status::bad_argument);
    }
  }
  CHECK_EQ(style.size().raw, 16 << 6);  // untouched
  CHECK_OK(make({4, 0, 0, 1024}, style));
  CHECK_EQ(style.size().raw, 1024 << 6);
  CHECK_EQ(style.least_gain_q15(), 1 << 7);
  CHECK_OK(make({0, -4, 4, 0}, style));
  CHECK(!style.is_stretched());
  CHECK_OK(make({-1024, 0, 0, 4}, style));
  CHECK_OK(make({20, 8, 0, 20}, style));
  CHECK(style.is_stretched());
  CHECK(!style.is_upright());
}

// Entries whose squares would wrap to those of a size of about 24 px.
TEST(huge_matrices_do_not_pass_for_small_ones) {
  constexpr int32_t kPx24 = 24 << 16;
  constexpr int32_t kFar[] = {INT32_MIN, INT32_MAX};
  for (const int32_t far : kFar) {
    TextStyle style;
    const Matrix matrix = {Q16_16::from_raw(far), Q16_16::from_raw(kPx24),
                           Q16_16::from_raw(-kPx24), Q16_16::from_raw(far)};
    CHECK_EQ(TextStyle::make(matrix, kFilterText, style), Status::bad_argument);
  }
}

TEST(stretches_are_rounded_to_1_64_px) {
  const auto make_raw = [](int32_t most_q16, int32_t least_q16) {
    TextStyle style;
    return TextStyle::make(
        {Q16_16::from_raw(most_q16), {}, {}, Q16_16::from_raw(least_q16)},
        kFilterText, style);
  };
  CHECK_OK(make_raw((1024 << 16) + 511, (4 << 16) - 512));
  CHECK_EQ(make_raw((1024 << 16) + 512, 4 << 16), Status::bad_argument);
  CHECK_EQ(make_raw(1024 << 16, (4 << 16) - 513), Status::bad_argument);
}

TEST(stretches_within_1_1024_are_alike) {
  constexpr int32_t kMost = 64 << 16;
  constexpr int32_t kPart = kMost / 1024;
  TextStyle style;
  Matrix matrix;
  matrix.x_right.raw = kMost;
  matrix.y_up.raw = kMost - kPart;
  CHECK_OK(TextStyle::make(matrix, kFilterText, style));
  CHECK(!style.is_upright() && !style.is_stretched());
  matrix.y_up.raw = kMost - kPart - 1;
  CHECK_OK(TextStyle::make(matrix, kFilterText, style));
  CHECK(style.is_stretched());
  // Where the size is rounded down the least stretch may be greater.
  matrix.x_right.raw = (4 << 16) + 511;
  matrix.y_up.raw = matrix.x_right.raw - 257;
  CHECK_OK(TextStyle::make(matrix, kFilterText, style));
  CHECK_EQ(style.size().raw, 4 << 6);
  CHECK(style.is_stretched());
  CHECK(style.least_gain_q15() < 1 << 15);
}

TEST(the_upright_matrix_is_upright) {
  TextStyle style;
  TextStyle plain;
  for (int32_t px = 4; px <= 1024; ++px) {
    const double size = px;
    CHECK_OK(make({size, 0, 0, size}, style));
    CHECK_OK(TextStyle::make(Q26_6::from_int(px), kFilterText, plain));
    CHECK(style.is_upright());
    CHECK_EQ(style.size().raw, plain.size().raw);
    CHECK_EQ(style.step_along_q16(), plain.step_along_q16());
    CHECK_EQ(style.transparent_u_q10(), plain.transparent_u_q10());
  }
  CHECK_OK(make({-24, 0, 0, 24}, style));
  CHECK(!style.is_upright());
  CHECK(!style.is_stretched());
  CHECK_OK(make({24, 0, 0, 24.25}, style));
  CHECK(!style.is_upright());
  // Turned by 180 degrees, turned a very little, and a very little larger.
  constexpr int32_t kPx24 = 24 << 16;
  constexpr int32_t kNearly[][2] = {{-kPx24, 0}, {kPx24, 1}, {kPx24 + 1, 0}};
  for (const auto& near : kNearly) {
    const Matrix matrix = {Q16_16::from_raw(near[0]), Q16_16::from_raw(near[1]),
                           Q16_16::from_raw(-near[1]),
                           Q16_16::from_raw(near[0])};
    CHECK_OK(TextStyle::make(matrix, kFilterText, style));
    CHECK_EQ(style.size().raw, 24 << 6);
    CHECK(!style.is_upright());
  }
}

// Steps and axes are each other's inverses, and the size is the greatest
// stretch.
TEST(steps_undo_the_matrix) {
  for (Rounds rounds(71, 2000); rounds.next();) {
    Random& random = rounds.random;
    const double most = random.between(4 * 64, 1024 * 64) / 64.0;
    const double least = 4 + (most - 4) * random.between(0, 1000) / 1000;
    const Map map = any_map(random, most, least);
    TextStyle style;
    const Status status = make(map, style);
    if (least < 4.05 || most > 1023) {
      continue;  // roundings decide
    }
    CHECK_OK(status);
    CHECK(magnitude(style.size().raw / 64.0 - most) < 1.0 / 64);
    const double gain = style.least_gain_q15() / 32768.0;
    CHECK(most - least < most / 500 || magnitude(gain - least / most) < 0.004);
    const double x = random.between(-2000, 2000);
    const double y = random.between(-2000, 2000);
    const Map exact = map_of(matrix_of(map));
    const double right = (exact.x_right * x + exact.y_right * y) / 1024;
    const double up = (exact.x_up * x + exact.y_up * y) / 1024;
    const GlyphStep& to_right = style.right();
    const GlyphStep& to_up = style.up();
    const double px = 1024 * 64.0 / style.size().raw;
    const double x_px =
        (right * to_right.x_q20 + up * to_up.x_q20) / 1048576 * px;
    const double y_px =
        (right * to_right.y_q20 + up * to_up.y_q20) / 1048576 * px;
    CHECK(magnitude(x_px - x) < 0.01 * px && magnitude(y_px - y) < 0.01 * px);
    const double x_u = (right * to_right.x_q16 + up * to_up.x_q16) / 65536;
    const double y_u = (right * to_right.y_q16 + up * to_up.y_q16) / 65536;
    CHECK(magnitude(x_u - x) < 0.1 && magnitude(y_u - y) < 0.1);
  }
}

#if INKCELL_EDGE_CELLS

namespace {

alignas(4) uint8_t bytes[1024];
FieldRecord record;  // too large for the stack of a small board

GlyphField open() {
  GlyphField field;
  CHECK(record.size() <= sizeof(bytes));
  record.write(bytes);
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}

// A value in u as one in px on the screen: gradients by the inverse matrix, but
// of the length that they have in the glyph.
Value on_screen(const Value& at, const Map& map) {
  const double determinant =
      (map.x_right * map.y_up - map.y_right * map.x_up) / 1024;
  const double gx = (map.y_up * at.gx - map.x_up * at.gy) / determinant;
  const double gy = (map.x_right * at.gy - map.y_right * at.gx) / determinant;
  const double length = root(gx * gx + gy * gy);
  const double in_glyph = root(at.gx * at.gx + at.gy * at.gy);
  const double gain = in_glyph / length;
  return {at.f * gain, gx * gain, gy * gain};
}

struct Place {
  double x_u;
  double y_u;
};

Place place_of(const Map& map, const FinePoint& origin, int32_t x, int32_t y) {
  const double right = x + 0.5 - static_cast<double>(origin.x_q10) / 1024;
  const double up = static_cast<double>(origin.y_q10) / 1024 - y - 0.5;
  const double determinant =
      (map.x_right * map.y_up - map.y_right * map.x_up) / 1024;
  return {(map.y_up * right - map.y_right * up) / determinant,
          (map.x_right * up - map.x_up * right) / determinant};
}

// Whether the place is clear of borders of cells.
bool is_in(const GlyphField& field, const Cell& cell, const Place& at) {
  const double side = 1 << cell.size_log2;
  const double margin = 1.0 / 16;
  return at.x_u > field.x0_u + 1 && at.x_u < field.x1_u() - 1 &&
         at.y_u > field.y0_u + 1 && at.y_u < field.y1_u() - 1 &&
         at.x_u > cell.x0_u + margin && at.x_u < cell.x0_u + side - margin &&
         at.y_u > cell.y0_u + margin && at.y_u < cell.y0_u + side - margin;
}

Q6_10 distance_of(const GlyphField& field,
                  const TextStyle& style,
                  const FinePoint& origin,
                  int32_t x,
                  int32_t y) {
  Q6_10 distance;
  distance_row(field, style, origin, x, y, {&distance, 1});
  return distance;
}

// The values of a cell's fields on the screen. False where numbers pass what a
// cell may hold, or two edges are about as parallel as it takes to leave their
// vertex alone.
bool read_values(const Cell& cell,
                 const Map& map,
                 const Place& at,
                 Value (&values)[3]) {
  for (uint32_t i = 0; i < cell.field_count; ++i) {
    const uint32_t number = record.number_of(cell.fields[i]);
    const FieldRecord::Field& f = record.fields[number];
    const bool is_arc = number < record.arc_count;
    const double w = (f.nx * at.y_u - f.ny * at.x_u) / 16384 + f.along / 16.0;
    const double bend = f.bend / 524288.0 * w;
    if (is_arc && (magnitude(w) > 256 || magnitude(bend) > 1)) {
      return false;
    }
    values[i] =
        on_screen(field_equation::value(f, is_arc, at.x_u, at.y_u), map);
    for (uint32_t j = 0; j < i; ++j) {
      const double c =
          values[i].gx * values[j].gx + values[i].gy * values[j].gy;
      if (magnitude(c) > 0.98) {
        return false;
      }
    }
  }
  return true;
}

struct Errors {
  double plain = 0;  // [px]
  double bent = 0;
  int compared = 0;
};

void compare(const GlyphField& field,
             const TextStyle& style,
             const Map& map,
             const FinePoint& origin,
             int32_t x,
             int32_t y,
             Errors& errors) {
  const Place at = place_of(map, origin, x, y);
  if (at.x_u < field.x0_u || at.x_u >= field.x1_u() || at.y_u < field.y0_u ||
      at.y_u >= field.y1_u()) {
    return;
  }
  // Towards minus infinity.
  const Cell cell = locate(field, static_cast<int32_t>(at.x_u + 4096) - 4096,
                           static_cast<int32_t>(at.y_u + 4096) - 4096);
  Value values[3] = {};
  if (cell.is_saturated() || !is_in(field, cell, at) ||
      !read_values(cell, map, at, values)) {
    return;
  }
  const double expected =
      field_equation::combined(values, cell.field_count,
                               static_cast<uint32_t>(cell.op))
          .f;
  if (magnitude(expected) > 2) {
    return;
  }
  const double found = distance_of(field, style, origin, x, y).raw / 1024.0;
  bool is_bent = false;
  for (uint32_t i = 0; i < cell.field_count; ++i) {
    is_bent = is_bent || record.number_of(cell.fields[i]) < record.arc_count;
  }
  double& worst = is_bent ? errors.bent : errors.plain;
  const double error = magnitude(found - expected);
  worst = error > worst ? error : worst;
  ++errors.compared;
}

void make_record(Random& random) {
  record = FieldRecord();
  record.linked = (random.next() & 1) != 0;
  record.tiles_x = static_cast<uint8_t>(1 + random.below(2));
  record.tiles_y = static_cast<uint8_t>(1 + random.below(2));
  record.x0_u = static_cast<int16_t>(random.between(-300, 100));
  record.y0_u = static_cast<int16_t>(random.between(-300, 100));
  record.make(random, 100);
}

int32_t thousandths(double value) {
  return static_cast<int32_t>(value * 1000);
}

}  // namespace

// Distances on the screen against real numbers.
TEST(distances_are_those_of_the_screen) {
  Errors errors;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 40 : 4000;
  for (Rounds rounds(72, round_count); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    make_record(random);
    const GlyphField field = open();
    const double most = random.between(5 * 64, 200 * 64) / 64.0;
    const double least =
        round % 4 == 0 ? most : 4.5 + (most - 4.5) * random.below(1000) / 1000;
    const Map wanted = any_map(random, most, least);
    const Map map = map_of(matrix_of(wanted));
    TextStyle style;
    CHECK_OK(make(wanted, style));
    const FinePoint origin(random.between(-9999, 9999),
                           random.between(-9999, 9999));
    const Rect box = field_box(field, style, origin);
    for (int i = 0; i < 40; ++i) {
      compare(field, style, map, origin, random.between(box.x0, box.x1 - 1),
              random.between(box.y0, box.y1 - 1), errors);
    }
  }
  check::write("largest errors on the screen [px / 1000]: planes ");
  check::write_number(thousandths(errors.plain));
  check::write(", bent ");
  check::write_number(thousandths(errors.bent));
  check::write(", of ");
  check::write_number(errors.compared);
  check::write("\n");
  CHECK(errors.plain <= 1.0 / 64);
  CHECK(errors.bent <= 1.0 / 32);
  CHECK(errors.compared > round_count);
}

namespace {

// How far the curve of a bent field is from a point of the screen: the least
// of many distances, then of many around that. [px]
double distance_from_curve(const FieldRecord::Field& f,
                           const Map& map,
                           const Place& at) {
  const double nx = f.nx / 16384.0;
  const double ny = f.ny / 16384.0;
  const double w = nx * at.y_u - ny * at.x_u + f.along / 16.0;
  double centre = w;
  double step = 1;  // [u]
  double least = 1e9;
  for (int pass = 0; pass < 4; ++pass) {
    double best = centre;
    for (int i = -40; i <= 40; ++i) {
      const double v = centre + step * i;
      const double along = v - f.along / 16.0;
      const double up = -f.c / 16.0 - f.bend / 524288.0 * v * v;
      const double x = up * nx - along * ny - at.x_u;
      const double y = up * ny + along * nx - at.y_u;
      const double right = (map.x_right * x + map.y_right * y) / 1024;
      const double higher = (map.x_up * x + map.y_up * y) / 1024;
      const double square = right * right + higher * higher;
      if (square < least) {
        least = square;
        best = v;
      }
    }
    centre = best;
    step /= 30;
  }
  return root(least + 1e-12);
}

}  // namespace

// Where a bent edge runs about as its normal says, its values are distances.
TEST(bent_edges_are_where_their_curves_are) {
  double worst = 0;
  int compared = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 20 : 2000;
  for (Rounds rounds(73, round_count); rounds.next();) {
    Random& random = rounds.random;
    record = FieldRecord();
    record.arc_count = 1;
    record.line_count = 0;
    record.fields[0] = random_field(random, 128, 128, 30);
    record.fields[0].bend = random.between(-400, 400);
    record.references[0] = record.field_reference(0);
    const GlyphField field = open();
    const double most = random.between(24 * 64, 96 * 64) / 64.0;
    const double least = most * random.between(300, 1000) / 1000;
    const Map wanted = any_map(random, most, least);
    const Map map = map_of(matrix_of(wanted));
    TextStyle style;
    CHECK_OK(make(wanted, style));
    const Rect box = field_box(field, style, {});
    for (int i = 0; i < 40; ++i) {
      const int32_t x = random.between(box.x0, box.x1 - 1);
      const int32_t y = random.between(box.y0, box.y1 - 1);
      const Place at = place_of(map, {}, x, y);
      const FieldRecord::Field& f = record.fields[0];
      const double w = (f.nx * at.y_u - f.ny * at.x_u) / 16384 + f.along / 16.0;
      const double found =
          magnitude(distance_of(field, style, {}, x, y).raw / 1024.0);
      if (at.x_u < 1 || at.x_u > 255 || at.y_u < 1 || at.y_u > 255 ||
          magnitude(f.bend / 262144.0 * w) > 0.1 || found > 0.75) {
        continue;
      }
      const double error = magnitude(found - distance_from_curve(f, map, at));
      worst = error > worst ? error : worst;
      ++compared;
    }
  }
  check::write("largest error of bent edges [px / 1000]: ");
  check::write_number(thousandths(worst));
  check::write(" of ");
  check::write_number(compared);
  check::write("\n");
  CHECK(worst <= 1.0 / 32);
  CHECK(compared > round_count);
}

#endif
