// A sum is one word: weights in the upper 12 bits, weights times coverage in
// the lower 20, so that a sample is one addition. A sample's weight is the
// filter at its distance times the area it stands for; all of the filter is
// 2048. Sums of them come close to that, because squares do not overlap, and
// what would take one beyond 4095 is left out: 255 times that is below 2^20.
//
// Squares below a quarter of a pixel are not divided further: they are one
// sample each, at the centre, whatever is in them. So work is bounded by the
// pixels and, for each block of them, by the tiles, whatever the bytes say.
#include "inkcell/field/splat.hpp"

#include "base/math.hpp"
#include "field_source.hpp"
#include "inkcell/field/cell.hpp"
#include "outlines/outline_glyph.hpp"
#include "place/style_parts.hpp"

namespace inkcell {
namespace {

using detail::FieldJob;
using detail::max;
using detail::min;

constexpr uint32_t kCoverageBits = 20;
constexpr uint32_t kAll = 2048;
constexpr uint32_t kMost = 4095;

// 256 * 2^(-3 (i + 1/2) / 32): the filter over the square of the distance.
constexpr uint32_t kSteps = 32;
constexpr uint8_t kFall[kSteps] = {248, 232, 218, 204, 191, 179, 168, 157,
                                   147, 138, 129, 121, 113, 106, 99,  93,
                                   87,  82,  76,  72,  67,  63,  59,  55,
                                   52,  48,  45,  43,  40,  37,  35,  33};

// A place on the screen from the centre of a block's first pixel, y down. [px]
struct FinePlace {
  int32_t x_q10;
  int32_t y_q10;
};

using Square = detail::FieldSquare;

// The pixels that the buffer holds.
class Block {
 public:
  Block(const Splat& splat, const FieldJob& job) noexcept;

  // Adds what the small cells say to the sums of these pixels, which were 0.
  void splat(const Rect& pixels) noexcept;
  // What is left of each pixel's filter has the coverage of its own sample.
  void blend(uint8_t* coverage, int32_t stride) const noexcept;

 private:
  int32_t width() const noexcept { return pixels_.x1 - pixels_.x0; }
  int32_t height() const noexcept { return pixels_.y1 - pixels_.y0; }
  FinePlace centre_of(const Square& square) const noexcept;
  bool is_near(const FinePlace& centre, uint32_t log2) const noexcept;
  bool visit(uint32_t reference, const Square& square) noexcept;
  void visit_tile(const Square& tile) noexcept;
  void add_centre(const Square& square) noexcept;
  void add(const FinePlace& centre, uint32_t log2, uint32_t coverage) noexcept;

  detail::FieldTree tree_;
  const Style& style_;
  const Splat& options_;
  const detail::Placed& placed_;
  Rect pixels_;
  FinePlace origin_ = {0, 0};
  uint32_t least_log2_ = 0;  // of the least squares
  uint32_t wide_log2_ = 0;   // of the least that are wider than the radius
  uint32_t weight_q8_ = 0;   // of the least, at a pixel's centre
  uint32_t steps_q16_;       // from squares, in 1/128 px, to kSteps
};

Block::Block(const Splat& splat, const FieldJob& job) noexcept
    : tree_{job.field},
      style_(*job.style),
      options_(splat),
      placed_(job.placed) {
  const auto size_q6 = static_cast<uint32_t>(style_.size().raw);
  const auto radius_q10 = static_cast<uint32_t>(options_.radius_q10);
  // 1 u, or at most a quarter of a px.
  while ((size_q6 << (least_log2_ + 1)) <= 256 << 6) {
    ++least_log2_;
  }
  while ((size_q6 << wide_log2_) <= radius_q10 << 6) {
    ++wide_log2_;
  }
  // The filter's integral is 1.322 times the square of its radius.
  const uint32_t side_q10 = (size_q6 << least_log2_) >> 6;
  weight_q8_ = side_q10 * side_q10 * 1549 / ((radius_q10 * radius_q10) >> 8);
  const uint32_t square_q14 = (radius_q10 >> 3) * (radius_q10 >> 3);
  steps_q16_ = ((kSteps << 16) + square_q14 - 1) / square_q14;
}

FinePlace Block::centre_of(const Square& square) const noexcept {
  const GlyphField& field = tree_.field;
  const int32_t size_q6 = style_.size().raw;
  const int32_t size_u = int32_t{1} << square.log2;
  const int32_t x_q10 =
      ((2 * (field.x0_u + static_cast<int32_t>(square.x)) + size_u) *
       size_q6) >>
      7;
  const int32_t y_q10 =
      ((2 * (field.y0_u + static_cast<int32_t>(square.y)) + size_u) *
       size_q6) >>
      7;
  if (style_.is_upright()) {
    return {origin_.x_q10 + x_q10, origin_.y_q10 - y_q10};
  }
  const FinePoint at = detail::StyleParts::slant(style_).place(
      style_, {origin_.x_q10, origin_.y_q10}, x_q10, y_q10);
  return {static_cast<int32_t>(at.x_q10), static_cast<int32_t>(at.y_q10)};
}

// Whether anything in a square may be within the radius of a pixel.
bool Block::is_near(const FinePlace& centre, uint32_t log2) const noexcept {
  // Half a diagonal is 91/128.
  const int32_t side_q10 = static_cast<int32_t>(
      (static_cast<uint32_t>(style_.size().raw) << log2) >> 6);
  const int32_t reach_q10 =
      options_.radius_q10 +
      (style_.is_upright() ? side_q10 >> 1 : ((side_q10 >> 4) * 91 >> 3)) + 16;
  return centre.x_q10 > -reach_q10 && centre.y_q10 > -reach_q10 &&
         centre.x_q10 < (width() - 1) * 1024 + reach_q10 &&
         centre.y_q10 < (height() - 1) * 1024 + reach_q10;
}

// Adds a sample to all pixels within the radius.
void Block::add(const FinePlace& centre,
                uint32_t log2,
                uint32_t coverage) noexcept {
  const uint32_t weight_q8 = weight_q8_ << 2 * (log2 - least_log2_);
  const int32_t radius_q10 = options_.radius_q10;
  const auto first = [radius_q10](int32_t place_q10) noexcept {
    return max((place_q10 - radius_q10 + 1023) >> 10, 0);
  };
  const auto end = [radius_q10](int32_t place_q10, int32_t most) noexcept {
    return min(((place_q10 + radius_q10) >> 10) + 1, most);
  };
  const int32_t left = first(centre.x_q10);
  const int32_t right = end(centre.x_q10, width());
  const int32_t bottom = end(centre.y_q10, height());
  const uint32_t sample = (1u << kCoverageBits) + coverage;
  for (int32_t y = first(centre.y_q10); y < bottom; ++y) {
    const int32_t down_q7 = (y * 1024 - centre.y_q10) >> 3;
    const int32_t down_square = down_q7 * down_q7;
    int32_t right_q7 = (left * 1024 - centre.x_q10) >> 3;
    uint32_t* sum = options_.sums.data + (y * width() + left);
    for (int32_t x = left; x < right; ++x, ++sum, right_q7 += 128) {
      const auto square =
          static_cast<uint32_t>(right_q7 * right_q7 + down_square);
      const uint32_t step = (square * steps_q16_) >> 16;
      if (step < kSteps) {
        const uint32_t weight = (kFall[step] * weight_q8 + (1 << 15)) >> 16;
        if (weight + (*sum >> kCoverageBits) <= kMost) {
          *sum += weight * sample;
        }
      }
    }
  }
}

// What the field says of the centre of a square.
void Block::add_centre(const Square& square) noexcept {
  const uint32_t half = square.log2 == 0 ? 0 : 1u << (square.log2 - 1);
  const Cell cell = locate(
      tree_.field, tree_.field.x0_u + static_cast<int32_t>(square.x + half),
      tree_.field.y0_u + static_cast<int32_t>(square.y + half));
  uint32_t coverage = cell.inside ? 255 : 0;
  if (cell.samples != nullptr) {
    const auto place = [&cell, &square](uint32_t at) noexcept {
      return static_cast<int32_t>(((at << 16) + (1u << (square.log2 + 15))) &
                                  ((1u << (cell.size_log2 + 16)) - 1));
    };
    coverage = style_.filter().coverage(
        style_.to_px_q10(samples_distance(cell.samples, cell.size_log2,
                                          place(square.x), place(square.y))
                             .raw));
  }
  add(centre_of(square), square.log2, coverage);
}

// Visits a square. True: its children are to be visited.
bool Block::visit(uint32_t reference, const Square& square) noexcept {
  const uint32_t log2 = square.log2;
  const bool is_node = tree_.is_node(reference) && log2 > 0;
  if (!is_node && log2 >= wide_log2_) {
    return false;
  }
  if (!is_near(centre_of(square), log2)) {
    return false;
  }
  if (is_node && log2 > least_log2_) {
    return true;
  }
  if (is_node || log2 + 1 < wide_log2_ || log2 == least_log2_) {
    add_centre(square);
    return false;
  }
  // One sample would stand for too much.
  const uint32_t half = 1u << (log2 - 1);
  for (uint32_t i = 0; i < 4; ++i) {
    add_centre(
        {square.x + (i & 1) * half, square.y + (i >> 1) * half, log2 - 1});
  }
  return false;
}

// Not inline: the walk has a stack of its own.
__attribute__((noinline)) void Block::visit_tile(const Square& tile) noexcept {
  walk_tile(tree_, tile, [this](uint32_t reference, const Square& square) {
    return visit(reference, square);
  });
}

void Block::splat(const Rect& pixels) noexcept {
  pixels_ = pixels;
  origin_ = {placed_.x_q10 - pixels.x0 * 1024 - 512,
             placed_.y_q10 - pixels.y0 * 1024 - 512};
  for (int32_t i = 0; i < width() * height(); ++i) {
    options_.sums.data[i] = 0;
  }
  const GlyphField& field = tree_.field;
  const uint32_t log2 = field.tile_log2;
  // Tiles below the least square are not told apart.
  const uint32_t step_log2 = log2 < least_log2_ ? least_log2_ : log2;
  const auto width_u = static_cast<uint32_t>(field.tiles_x) << log2;
  const auto height_u = static_cast<uint32_t>(field.tiles_y) << log2;
  for (uint32_t y = 0; y < height_u; y += 1u << step_log2) {
    for (uint32_t x = 0; x < width_u; x += 1u << step_log2) {
      const Square square = {x, y, step_log2};
      if (step_log2 == log2) {
        visit_tile(square);
      } else if (is_near(centre_of(square), step_log2)) {
        add_centre(square);
      }
    }
  }
}

void Block::blend(uint8_t* coverage, int32_t stride) const noexcept {
  constexpr uint32_t kMask = (1u << kCoverageBits) - 1;
  const uint32_t* sum = options_.sums.data;
  for (int32_t y = 0; y < height(); ++y, coverage += stride) {
    for (int32_t x = 0; x < width(); ++x, ++sum) {
      const uint32_t weight = *sum >> kCoverageBits;
      uint32_t covered = *sum & kMask;
      if (weight < kAll) {
        covered += (kAll - weight) * coverage[x];
      }
      const uint32_t all = weight < kAll ? kAll : weight;
      coverage[x] = static_cast<uint8_t>((covered + all / 2) / all);
    }
  }
}

void plan_splat(const Effect& effect, const Style&, BandPlan& plan) noexcept {
  plan.ink_margin_q8 += static_cast<const Splat&>(effect).radius_q10 >> 2;
}

// In as many parts as the buffer of sums asks for.
void mix_splat(const Effect& effect, GlyphBand& band) noexcept {
  const auto& splat = static_cast<const Splat&>(effect);
  const Rect& all = band.pixels();
  band.cover();
  Block block(splat, static_cast<const FieldJob&>(band));
  const auto most = static_cast<int32_t>(
      splat.sums.size < (1 << 20) ? splat.sums.size : 1 << 20);
  const int32_t columns = min(all.x1 - all.x0, most);
  const int32_t rows = most / columns;
  for (int32_t y = all.y0; y < all.y1; y += rows) {
    for (int32_t x = all.x0; x < all.x1; x += columns) {
      block.splat(intersect(all, {x, y, x + columns, y + rows}));
      block.blend(band.row(y) + (x - all.x0), band.stride());
    }
  }
  band.emit();
}

bool can_splat(const Effect& effect,
               const Style& style,
               bool is_field) noexcept {
  return is_field && !style.is_stretched() &&
         static_cast<const Splat&>(effect).sums.size >= kMinSplatSums;
}

}  // namespace

const Mixer detail::kSplatMixer = {nullptr, plan_splat, mix_splat, can_splat};

}  // namespace inkcell
