#include "reference/cell_distance.hpp"

#include "inkcell/format/cell.hpp"
#include "inkcell/format/rom.hpp"

namespace reference {
namespace {

using namespace inkcell;

// All sums are modulo 2^32.
uint32_t times(int32_t a, uint32_t b) {
  return static_cast<uint32_t>(a) * b;
}
int32_t wrapped(uint32_t value) {
  return static_cast<int32_t>(value);
}
int32_t negated(int32_t value) {
  return wrapped(0u - static_cast<uint32_t>(value));
}

int32_t number_at(const uint8_t* at) {
  return static_cast<int16_t>(at[0] | at[1] << 8);
}

struct Vector {
  int32_t x_q14;
  int32_t y_q14;
};

// One primitive at a point: its value and its gradient.
struct Value {
  int32_t value_q22;
  Vector gradient;
};

Value value_of(const uint8_t* record,
               bool is_arc,
               const TextStyle& style,
               uint32_t x_q8,
               uint32_t y_q8) {
  namespace layout = format::edges;
  const uint32_t size_q8 = static_cast<uint32_t>(style.size().raw) << 2;
  const int32_t nx = number_at(record + layout::kNormalX);
  const int32_t ny = number_at(record + layout::kNormalY);
  const uint32_t plane_q22 =
      times(nx, x_q8) + times(ny, y_q8) +
      times(number_at(record + layout::kOffset), size_q8);
  if (!is_arc) {
    return {wrapped(plane_q22), {nx, ny}};
  }
  const uint32_t along_q22 = times(nx, y_q8) - times(ny, x_q8) + (1 << 13) +
                             times(number_at(record + layout::kAlong), size_q8);
  const int32_t bend =
      (number_at(record + layout::kBend) * style.bend_q14() + (1 << 10)) >> 11;
  const auto along_q8 = static_cast<uint32_t>(wrapped(along_q22) >> 14);
  const int32_t slope_q15 =
      wrapped(times(bend, along_q8)) >> style.bend_shift();
  const auto slope = static_cast<uint32_t>(slope_q15);
  const int32_t sag_q22 = wrapped(times(slope_q15, along_q8)) >> 1;
  return {wrapped(plane_q22 + static_cast<uint32_t>(sag_q22)),
          {nx - (wrapped(times(ny, slope)) >> 14),
           ny + (wrapped(times(nx, slope)) >> 14)}};
}

uint32_t root(uint32_t value) {
  uint32_t result = 0;
  for (uint32_t bit = 1u << 15; bit != 0; bit >>= 1) {
    const uint32_t next = result | bit;
    result = next * next <= value ? next : result;
  }
  return result;
}

// The lesser of two values; the distance to their vertex where that is nearest.
int32_t least_of(const Value& first, const Value& second) {
  const bool in_order = first.value_q22 <= second.value_q22;
  const int32_t low = in_order ? first.value_q22 : second.value_q22;
  const int32_t high = in_order ? second.value_q22 : first.value_q22;
  if (low >= 0 || low <= -INT32_MAX || high >= -low) {
    return low;
  }
  const Vector& g = first.gradient;
  const Vector& h = second.gradient;
  const int32_t c_q14 =
      wrapped(times(g.x_q14, static_cast<uint32_t>(h.x_q14)) +
              times(g.y_q14, static_cast<uint32_t>(h.y_q14)) + (1 << 13)) >>
      14;
  constexpr int32_t kMostCosine = 16202;
  if (c_q14 > kMostCosine || c_q14 < -kMostCosine) {
    return low;
  }
  const auto size = static_cast<uint32_t>(-low);
  int32_t log2 = 0;
  while (size >> log2 >= 1u << 12) {
    ++log2;
  }
  const int32_t a = low >> log2;
  const int32_t b = high >> log2;
  const int32_t a_bc_q14 = a * (1 << 14) - c_q14 * b;
  const int32_t b_ac_q14 = b * (1 << 14) - c_q14 * a;
  if (a_bc_q14 > 0 || b_ac_q14 > 0) {
    return low;
  }
  const uint32_t sine_q14 =
      root(static_cast<uint32_t>((1 << 28) - c_q14 * c_q14));
  const uint32_t other = static_cast<uint32_t>(-b_ac_q14) / sine_q14;
  const uint32_t length = root(static_cast<uint32_t>(a * a) + other * other);
  return length > static_cast<uint32_t>(INT32_MAX) >> log2
             ? -INT32_MAX
             : -static_cast<int32_t>(length << log2);
}

Value negated(Value value) {
  value.value_q22 = negated(value.value_q22);
  return value;
}

// Minimum is the intersection. The greatest is the least of negated values; a
// gradient turns no vertex, so that its sign does not matter.
int32_t combined(const Cell& cell, const Value* plain) {
  const bool is_negated = (static_cast<uint8_t>(cell.op) & 1) != 0;
  Value v[3];
  for (int i = 0; i < cell.field_count; ++i) {
    v[i] = is_negated ? negated(plain[i]) : plain[i];
  }
  int32_t result = v[0].value_q22;
  if (cell.field_count == 2) {
    result = least_of(v[0], v[1]);
  } else if (cell.field_count == 3 && cell.op >= Csg::intersection_of_union) {
    const bool is_second = v[1].value_q22 >= v[2].value_q22;
    Value inner = is_second ? v[1] : v[2];
    inner.value_q22 = negated(least_of(negated(v[1]), negated(v[2])));
    result = least_of(v[0], inner);
  } else if (cell.field_count == 3) {
    // Without the greatest.
    int out = 2;
    if (v[0].value_q22 > v[1].value_q22 && v[0].value_q22 > v[2].value_q22) {
      out = 0;
    } else if (v[1].value_q22 > v[2].value_q22) {
      out = 1;
    }
    result = least_of(v[out == 0 ? 1 : 0], v[out == 2 ? 1 : 2]);
  }
  return is_negated ? negated(result) : result;
}

// Steps to the right and up times that many px. [Q10]
int64_t sum_of(int64_t right_q10, int32_t right, int64_t up_q10, int32_t up) {
  return (right_q10 * right + up_q10 * up) >> 10;
}

}  // namespace

int32_t distance_q10(const GlyphField& field,
                     const TextStyle& style,
                     FinePoint origin,
                     int32_t x,
                     int32_t y) {
  namespace linked = format::linked;
  const int64_t right_q10 = int64_t{x} * 1024 + 512 - origin.x_q10;
  const int64_t up_q10 = origin.y_q10 - (int64_t{y} * 1024 + 512);
  const GlyphStep& right = style.right();
  const GlyphStep& up = style.up();
  const int64_t x_q16 = sum_of(right_q10, right.x_q16, up_q10, up.x_q16);
  const int64_t y_q16 = sum_of(right_q10, right.y_q16, up_q10, up.y_q16);
  const int64_t x_u = x_q16 >> 16;
  const int64_t y_u = y_q16 >> 16;
  if (x_u < field.x0_u || x_u >= field.x1_u() || y_u < field.y0_u ||
      y_u >= field.y1_u()) {
    return style.to_px_q10(-kSaturatedDistanceQ10);
  }
  const Cell cell =
      locate(field, static_cast<int32_t>(x_u), static_cast<int32_t>(y_u));
  if (cell.samples != nullptr) {
    return style.to_px_q10(
        samples_distance(cell.samples, cell.size_log2,
                         static_cast<int32_t>(x_q16) - cell.x0_u * 65536,
                         static_cast<int32_t>(y_q16) - cell.y0_u * 65536)
            .raw);
  }
  if (cell.is_saturated()) {
    return style.to_px_q10(cell.inside ? kSaturatedDistanceQ10
                                       : -kSaturatedDistanceQ10);
  }
  // To the nearest 1/256 px.
  const auto q8 = [](int64_t position_q20) {
    return static_cast<uint32_t>((position_q20 + (1 << 11)) >> 12);
  };
  const uint32_t x_q8 = q8(sum_of(right_q10, right.x_q20, up_q10, up.x_q20));
  const uint32_t y_q8 = q8(sum_of(right_q10, right.y_q20, up_q10, up.y_q20));
  Value values[3];
  for (int i = 0; i < cell.field_count; ++i) {
    const uint32_t unit = cell.fields[i];
    values[i] = value_of(field.cells + 2 * (unit & linked::kOffsetMask),
                         (unit & linked::kArcField) != 0, style, x_q8, y_q8);
  }
  return combined(cell, values) >> 12;
}

}  // namespace reference
