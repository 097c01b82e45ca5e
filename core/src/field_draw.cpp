// Rows of cells of fields, fast.
//
// A cell's share of a row is set up once and then costs an addition for each
// plane and pixel, two products more for each bent one. Runs of some length are
// looked at as a whole first: fields that cannot change coverage are dropped,
// and with them most runs that show no edge. All steps are exact modulo 2^32,
// so that no pixel depends on where a run begins.
#include "field_draw.hpp"

#include "cell_access.hpp"

namespace inkcell {
namespace detail {
namespace {

// What pixels show: nothing, all, or what their distances say.
enum class Side : int8_t { outside = -1, edge = 0, inside = 1 };

Side opposite(Side side) noexcept {
  return static_cast<Side>(-static_cast<int8_t>(side));
}

// Runs are cut after this many pixels: a plane, of slope 2 at most, cannot wrap
// from one side to the other unseen.
constexpr int32_t kMaxRun = 128;

// Fewer saturated pixels than this stay in the span around them.
constexpr int32_t kMinSolid = 4;

// Runs of several fields that are shorter than this are drawn pixel by pixel.
constexpr int32_t kMinSkipped = 8;

// Course::skip_log2 of a field that may change by any amount.
constexpr uint8_t kNoSkip = 31;

int32_t magnitude(int32_t value) noexcept {
  return value < 0 ? -value : value;
}

int32_t greater(int32_t a, int32_t b) noexcept {
  return a > b ? a : b;
}

// A field along a run.
struct Course {
  Side side = Side::edge;
  // The distance changes by at most 2^skip_log2 a pixel. [Q22]
  uint8_t skip_log2 = kNoSkip;
};

// What `last` more pixels of a field show, if coverage does not change beyond
// `reach_q22`.
Course course_of(const FieldTerm& term,
                 int32_t last,
                 int32_t bend_log2,
                 int32_t reach_q22) noexcept {
  constexpr int32_t kFar = 1 << 30;
  Course course;
  const int32_t first_q22 = term.value_q22(bend_log2);
  if (last == 0) {
    if (first_q22 >= reach_q22 || first_q22 <= -reach_q22) {
      course.side = first_q22 < 0 ? Side::outside : Side::inside;
    }
    return course;
  }
  int32_t last_q22 = wrapped(
      term.plane_q22 + times(term.nx_q14, static_cast<uint32_t>(last) << 8));
  int32_t slope_q14 = magnitude(term.nx_q14);
  int32_t sag_q22 = 0;
  if (term.bend != 0) {
    FieldTerm end = term;
    end.step_right(last);
    last_q22 = end.value_q22(bend_log2);
    // Nothing wraps from one end of the run to the other: w stays below 256 px
    // and k w below 1.
    const int32_t along_q8 =
        greater(magnitude(term.along_q8()), magnitude(end.along_q8()));
    const int32_t first_slope = term.slope_q15(bend_log2);
    const int32_t last_slope = end.slope_q15(bend_log2);
    const int32_t steepest =
        greater(magnitude(first_slope), magnitude(last_slope));
    if (along_q8 >= 1 << 16 || steepest >= 1 << 15 ||
        magnitude(term.bend >> 4) * along_q8 >= 1 << 27 || first_q22 >= kFar ||
        first_q22 <= -kFar || last_q22 >= kFar || last_q22 <= -kFar) {
      return course;
    }
    // A parabola stays within a quarter of the change of its slope times the
    // way along it, k (dw)^2 / 4, of the chord. Roundings take less than 1/16.
    const auto change =
        static_cast<uint32_t>(magnitude(last_slope - first_slope));
    const auto way_q8 =
        static_cast<uint32_t>(magnitude(term.ny_q14) * last) >> 6;
    sag_q22 = static_cast<int32_t>((change * way_q8) >> 3) + (1 << 18);
    slope_q14 += 2 * steepest;  // |ny| may be as much as 2
  }
  const int32_t bound_q22 = reach_q22 + sag_q22;
  if (first_q22 >= bound_q22 && last_q22 >= bound_q22) {
    course.side = Side::inside;
  } else if (first_q22 <= -bound_q22 && last_q22 <= -bound_q22) {
    course.side = Side::outside;
  }
  // From less than 256 px away nothing wraps within a run.
  if (slope_q14 <= 1 << 15 && first_q22 < kFar && first_q22 > -kFar) {
    course.skip_log2 = slope_q14 <= 1 << 14 ? 22 : 23;
  }
  return course;
}

// Sets up the fields of a cell that may change the coverage of a pixel and the
// `last` ones after it. What they all show; if that is an edge, at least one
// field is left, and `skip_log2`, 0 before, is the most of those seen.
//
// Values are negated in thought where the operator asks for the greatest.
// Not inline: what it needs of the stack is free again when pixels are drawn.
__attribute__((noinline)) Side set_up_run(FieldTerms& terms,
                                          const GlyphField& field,
                                          const Cell& cell,
                                          uint32_t x_q8,
                                          uint32_t y_q8,
                                          const FieldScale& scale,
                                          int32_t last,
                                          int32_t reach_q22,
                                          uint8_t& skip_log2) noexcept {
  const bool is_negated = (static_cast<uint8_t>(cell.op) & 1) != 0;
  const bool is_nested = cell.op >= FieldOperator::least_of_greater;
  const Side empty = is_negated ? Side::inside : Side::outside;
  bool is_first_kept = false;
  terms.count = 0;
  terms.op = cell.op;
  for (uint32_t i = 0; i < cell.field_count; ++i) {
    FieldTerm& term = terms.term[terms.count];
    set_up_term(term, field, cell.fields[i], x_q8, y_q8, scale);
    const Course course = course_of(term, last, scale.bend_log2, reach_q22);
    if (course.side == Side::edge) {
      is_first_kept = is_first_kept || i == 0;
      skip_log2 = course.skip_log2 > skip_log2 ? course.skip_log2 : skip_log2;
      ++terms.count;
    } else if (is_nested && i != 0) {
      if (course.side != empty) {
        // The greater of these two is far inside.
        terms.count = is_first_kept ? 1 : 0;
        break;
      }
      if (i == 2 && terms.count == (is_first_kept ? 1 : 0)) {
        return empty;  // so is the other
      }
    } else if (course.side == empty) {
      return empty;
    }
  }
  if (terms.count == 0) {
    return opposite(empty);
  }
  if (is_nested && terms.count < 3) {
    // Either the first is left, or the greater of the others is all.
    terms.op = is_first_kept == is_negated ? FieldOperator::greatest
                                           : FieldOperator::least;
  }
  return Side::edge;
}

// How many pixels lie before a place `way_q16` further on, the first of them at
// 0; `most` or kMaxRun at the most. [u]
int32_t pixels_before(int32_t way_q16,
                      const Brush& brush,
                      int32_t most) noexcept {
  most = most < kMaxRun ? most : kMaxRun;
  // A guess that is not too high, from a px being 65536 u / size. Beyond 256 u,
  // where it would wrap, it stops.
  int32_t way_q6 = way_q16 >> 10;
  way_q6 = way_q6 < 256 << 6 ? way_q6 : (256 << 6) - 1;
  int32_t count = (way_q6 * brush.size().raw) >> 22;
  count = count < most ? count : most;
  const int32_t step = brush.step_along_q16();
  for (int32_t at = count * step; count < most && at < way_q16; at += step) {
    ++count;
  }
  return count;
}

// Pixels of a cell that show an edge or may.
void draw_run(FieldTerms& terms,
              const Brush& brush,
              int32_t reach_q22,
              Range pixels,
              uint8_t skip_log2,
              SpanWriter& writer) noexcept {
  // Roundings of bent planes do not reach so far.
  constexpr int32_t kMargin = 1 << 20;
  const int32_t bend_log2 = brush.bend_log2();
  const bool is_lone = terms.count == 1;
  int32_t x = pixels.begin;
  if (!is_lone && pixels.end - x < kMinSkipped) {
    skip_log2 = kNoSkip;
  }
  const bool is_plain_first = !is_lone && skip_log2 != kNoSkip;
  const int32_t first_reach_q22 = is_plain_first ? 0 : reach_q22;
  while (true) {
    // Where pixels may be skipped, without rounding: the lesser of several
    // values changes no faster than each of them, but what is rounded may jump.
    int32_t value_q22 = is_lone
                            ? terms.term[0].value_q22(bend_log2)
                            : combine_q22(terms, bend_log2, first_reach_q22);
    int32_t count = 1;
    if (value_q22 >= reach_q22 || value_q22 <= -reach_q22) {
      const uint32_t away = value_q22 < 0
                                ? 0u - static_cast<uint32_t>(value_q22)
                                : static_cast<uint32_t>(value_q22);
      const uint32_t sure = static_cast<uint32_t>(reach_q22 + kMargin);
      const uint32_t room = static_cast<uint32_t>(pixels.end - x);
      const uint32_t saturated =
          away > sure ? ((away - sure) >> skip_log2) + 1 : 1;
      count = static_cast<int32_t>(saturated < room ? saturated : room);
      if (count < kMinSolid) {
        for (int32_t i = 0; i < count; ++i) {
          writer.put(x + i, value_q22 < 0 ? 0 : 255);
        }
      } else if (value_q22 < 0) {
        writer.flush();
      } else {
        writer.solid(x, count);
      }
    } else {
      if (is_plain_first) {
        value_q22 = combine_q22(terms, bend_log2, reach_q22);
      }
      writer.put(x, brush.filter().coverage(value_q22 >> 12));
    }
    x += count;
    if (x >= pixels.end) {
      return;
    }
    for (uint32_t i = 0; i < terms.count; ++i) {
      terms.term[i].step_right(count);
    }
  }
}

}  // namespace

void draw_fields_row(const GlyphField& field,
                     const Brush& brush,
                     Range pixels,
                     FieldPosition at,
                     SpanWriter& writer) noexcept {
  const FieldScale scale = scale_of(brush);
  const int32_t reach_q22 = reach_of(brush.filter());
  const int32_t step = brush.step_along_q16();
  int32_t x = pixels.begin;
  while (x < pixels.end) {
    const Cell cell = locate_fields(field, at.x_q16 >> 16, at.y_q16 >> 16);
    const int32_t right_q16 =
        (cell.x0_u + (int32_t{1} << cell.size_log2)) * (1 << 16);
    const int32_t first = x;
    const uint32_t x_q8 = q8_of(at.x_q20);
    const int32_t count =
        pixels_before(right_q16 - at.x_q16, brush, pixels.end - x);
    x += count;
    at.x_q16 += count * step;
    at.x_q20 += static_cast<uint32_t>(x - first) << 20;
    Side side = cell.inside ? Side::inside : Side::outside;
    FieldTerms terms;
    uint8_t skip_log2 = 0;
    if (cell.field_count != 0) {
      side = set_up_run(terms, field, cell, x_q8, q8_of(at.y_q20), scale,
                        x - first - 1, reach_q22, skip_log2);
    }
    if (side == Side::edge) {
      draw_run(terms, brush, reach_q22, {first, x}, skip_log2, writer);
    } else if (side == Side::inside) {
      writer.solid(first, x - first);
    } else {
      writer.flush();
    }
  }
}

int32_t fields_distance_q10(const GlyphField& field,
                            const Brush& brush,
                            const FieldPosition& at,
                            int32_t reach_q22) noexcept {
  const int32_t x_u = at.x_q16 >> 16;
  const int32_t y_u = at.y_q16 >> 16;
  Cell cell;
  if (in_grid(field, x_u, y_u)) {
    cell = locate_fields(field, x_u, y_u);
  }
  if (cell.field_count == 0) {
    return brush.to_px_q10(cell.inside ? kSaturatedDistanceQ10
                                       : -kSaturatedDistanceQ10);
  }
  FieldTerms terms;
  set_up_terms(terms, field, cell, q8_of(at.x_q20), q8_of(at.y_q20),
               scale_of(brush));
  return combine_q22(terms, brush.bend_log2(), reach_q22) >> 12;
}

}  // namespace detail
}  // namespace inkcell
