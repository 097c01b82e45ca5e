#include "distance/sampler.hpp"

#include "inkcell/render.hpp"
#include "place/cell_raster.hpp"

namespace inkcell {
namespace detail {
namespace {

// Two components below 2 times a sine and a cosine.
int16_t turned_q14(int32_t a_q14,
                   Fixed<int32_t, 30> p,
                   int32_t b_q14,
                   Fixed<int32_t, 30> q) noexcept {
  const int32_t sum = a_q14 * (p.raw >> 16) + b_q14 * (q.raw >> 16);
  return static_cast<int16_t>(
      min(max(sum >> 14, INT16_MIN), int32_t{INT16_MAX}));
}

}  // namespace

GlyphPoint offset_of(const TextStyle& style, ScreenOffset offset) noexcept {
  const auto sum = [&offset](int32_t right, int32_t up) noexcept {
    return static_cast<uint32_t>(
        (int64_t{right} * offset.right_q10 + int64_t{up} * offset.up_q10) >>
        10);
  };
  const GlyphStep& right = style.right();
  const GlyphStep& up = style.up();
  return {sum(right.x_q16, up.x_q16), sum(right.y_q16, up.y_q16),
          sum(right.x_q20, up.x_q20), sum(right.y_q20, up.y_q20)};
}

CellSampler::CellSampler(const GlyphField& field,
                         const FieldScale& scale,
                         const TextStyle* style,
                         int32_t reach_q22) noexcept
    : field_(field), style_(style), csg_(scale, reach_q22) {
  leaf_.size_log2 = 0;
  leaf_.saturate(false);
}

CellSampler::CellSampler(const GlyphField& field,
                         const TextStyle& style,
                         int32_t reach_q22) noexcept
    : CellSampler(field, scale_of(style), &style, reach_q22) {
  if (!style.is_upright() && style.slanted_cells().stretching != nullptr) {
    csg_.set_stretching(*style.slanted_cells().stretching, style);
  }
}

bool CellSampler::find(const FinePoint& origin,
                       int32_t x,
                       int32_t y,
                       ScreenOffset offset,
                       GlyphPoint& out) const noexcept {
  return find_point(
      field_, style_->right(), style_->up(),
      {origin.x_q10 - offset.right_q10, origin.y_q10 + offset.up_q10}, x, y,
      out);
}

void CellSampler::seek(const GlyphPoint& at) noexcept {
  const uint32_t x = at.x_q16 >> 16;
  const uint32_t y = at.y_q16 >> 16;
  if (((x ^ x_u_) | (y ^ y_u_)) >> leaf_.size_log2 == 0) {
    return;
  }
  x_u_ = x;
  y_u_ = y;
  has_row_ = false;
  if (!is_in_grid(field_, at)) {
    leaf_.size_log2 = 0;
    leaf_.saturate(false);
    return;
  }
  find_leaf(field_, x, y, leaf_);
  if (leaf_.has_primitives()) {
    for (uint32_t i = 0; i < leaf_.count; ++i) {
      parts_[i] = ArcValue(leaf_.parts[i], csg_.scale(), 0);
    }
  }
}

void CellSampler::evaluate(const PixelPlace& at,
                           int32_t* values) const noexcept {
  for (uint32_t i = 0; i < leaf_.count; ++i) {
    values[i] = parts_[i].at(at, csg_.bend_shift(), leaf_.sign);
  }
}

int32_t CellSampler::distance_q10(const GlyphPoint& at) noexcept {
  seek(at);
  const Stretching* const stretching = csg_.stretching();
  if (leaf_.count == 0) {
    const int32_t far_q10 =
        stretching != nullptr ? kMaxFarQ22 >> 12 : kSaturatedDistanceQ10;
    const int32_t signed_q10 = leaf_.is_inside ? far_q10 : -far_q10;
    return stretching != nullptr ? signed_q10 : to_px_q10(signed_q10);
  }
  const PixelPlace place = at.place();
  if (stretching != nullptr) {
    const int32_t distance_q22 =
        leaf_.has_samples()
            ? stretching->samples_value(csg_, leaf_, at.x_q16 & mask(),
                                        at.y_q16 & mask())
            : stretching->value(csg_, leaf_, place);
    return distance_q22 >> 12;
  }
  if (!leaf_.has_primitives()) {
    const uint32_t y_q16 = at.y_q16 & mask();
    if (!has_row_ || y_q16 != row_y_q16_) {
      set_up_row(row_, leaf_.parts[0], leaf_.size_log2,
                 static_cast<int32_t>(y_q16));
      row_y_q16_ = y_q16;
      has_row_ = true;
    }
    return to_px_q10(
        row_.distance_q10(static_cast<int32_t>(at.x_q16 & mask())));
  }
  int32_t values[3];
  evaluate(place, values);
  return csg_.combine(leaf_, values, place) >> 12;
}

Gradient CellSampler::glyph_gradient(const GlyphPoint& at) noexcept {
  seek(at);
  if (leaf_.count == 0) {
    return {};
  }
  if (!leaf_.has_primitives()) {
    return samples_gradient(leaf_.parts[0], leaf_.size_log2, at.x_q16 & mask(),
                            at.y_q16 & mask());
  }
  leaf_.place = at.place();
  int32_t values[3];
  evaluate(leaf_.place, values);
  return csg_.gradient(leaf_, values);
}

FieldPoint CellSampler::glyph_point(const GlyphPoint& at) noexcept {
  seek(at);
  if (leaf_.count == 0) {
    return {};
  }
  if (!leaf_.has_primitives()) {
    return samples_point(leaf_.parts[0], leaf_.size_log2, at.x_q16 & mask(),
                         at.y_q16 & mask());
  }
  leaf_.place = at.place();
  int32_t values[3];
  evaluate(leaf_.place, values);
  FieldPoint point;
  point.distance.raw = csg_.combine(leaf_, values, leaf_.place) >> 12;
  point.gradient = csg_.gradient(leaf_, values);
  return point;
}

ScreenGradient CellSampler::gradient(const GlyphPoint& at) noexcept {
  const Gradient gradient = glyph_gradient(at);
  if (style_->is_upright()) {
    return {gradient.x.raw, gradient.y.raw};
  }
  const Direction turn = style_->direction();
  const Fixed<int32_t, 30> minus_sine =
      Fixed<int32_t, 30>::from_raw(-turn.sine.raw);
  return {turned_q14(gradient.x.raw, turn.cosine, gradient.y.raw, minus_sine),
          turned_q14(gradient.x.raw, turn.sine, gradient.y.raw, turn.cosine)};
}

// A primitive that is bent by no more than 1/32 px, or several of which the
// same one decides everywhere: each changes by no more than the radius.
bool CellSampler::are_primitives_plane(const GlyphPoint& at,
                                       int32_t radius_q10) const noexcept {
  constexpr int32_t kMaxSagQ22 = 1 << 17;
  if (leaf_.count == 1) {
    const int32_t radius_q8 = radius_q10 >> 2;
    const int32_t slope_q15 = (parts_[0].bend * radius_q8) >> csg_.bend_shift();
    return abs((slope_q15 * radius_q8) >> 1) < kMaxSagQ22;
  }
  int32_t values[3];
  evaluate(at.place(), values);
  const int64_t apart = int64_t{radius_q10} << 13;
  const auto differ = [&values, apart](uint32_t i, uint32_t j) noexcept {
    const int64_t difference = int64_t{values[i]} - values[j];
    return difference >= apart || difference <= -apart;
  };
  if (leaf_.count == 2) {
    return differ(0, 1);
  }
  if (leaf_.is_nested) {
    return differ(0, 1) && differ(0, 2) && differ(1, 2);
  }
  uint32_t least = values[1] < values[0] ? 1 : 0;
  least = values[2] < values[least] ? 2 : least;
  return differ(least, (least + 1) % 3) && differ(least, (least + 2) % 3);
}

// Nine samples that lie on a plane: where they do not, their second differences
// over the cell shrink with the square of the distance that is asked for.
bool CellSampler::are_samples_plane(int32_t radius_q10) const noexcept {
  constexpr int32_t kMaxSagQ10 = 1 << 5;
  const int32_t cell_q10 = to_px_q10(int32_t{1} << (10 + leaf_.size_log2));
  if (cell_q10 <= 2 * radius_q10) {
    return false;
  }
  const uint8_t* const at = leaf_.parts[0] + format::samples::kOffsets;
  const auto offset = [at](int32_t place) noexcept {
    // The centre, the fifth of nine, is not stored: it is 0.
    return place == 4 ? 0
                      : int32_t{static_cast<int8_t>(
                            at[place < 4 ? place : place - 1])};
  };
  int32_t most = 0;
  for (int32_t i = 0; i < 3; ++i) {
    const int32_t across =
        offset(3 * i) + offset(3 * i + 2) - 2 * offset(3 * i + 1);
    const int32_t along = offset(i) + offset(i + 6) - 2 * offset(i + 3);
    most = max(most, max(abs(across), abs(along)));
  }
  // Quanta are 1/128 of the cell; the differences are those of half a cell.
  const int64_t sag_q10 = (int64_t{most} * cell_q10) >> 8;
  const int64_t part_q10 = (int64_t{radius_q10} << 11) / cell_q10;
  return (sag_q10 * part_q10 * part_q10) >> 20 < kMaxSagQ10;
}

bool CellSampler::is_plane_around(const GlyphPoint& at,
                                  const Surroundings& around) const noexcept {
  // Beyond the grid a cell has no room for anything.
  const auto has_room = [this](uint32_t place_q16, uint32_t room) noexcept {
    place_q16 &= mask();
    return place_q16 >= room && place_q16 + room <= mask();
  };
  if (!has_room(at.x_q16, around.x_q16) || !has_room(at.y_q16, around.y_q16)) {
    return false;
  }
  return leaf_.count == 0 ||
         (leaf_.has_samples() ? are_samples_plane(around.radius_q10)
                              : are_primitives_plane(at, around.radius_q10));
}

}  // namespace detail
}  // namespace inkcell
