// A sum is one word: weights in the upper 12 bits, weights times coverage in
// the lower 20, so that a sample is one addition. A sample's weight is the
// filter at its distance times the area it stands for; all of the filter is
// 2048. Sums of them come close to that, because squares do not overlap, and
// what would take one beyond 4095 is left out: 255 times that is below 2^20.
//
// Squares below a quarter of a pixel are not divided further: they are one
// sample each, at the centre, whatever is in them. So work is bounded by the
// pixels and, for each block of them, by the tiles, whatever the bytes say.
#include "inkcell/splat.hpp"

#include "base/math.hpp"
#include "cells/leaf_reader.hpp"
#include "distance/sampler.hpp"
#include "raster/draw_cells.hpp"
#include "sink/row_writer.hpp"

namespace inkcell {
namespace {

using detail::max;
using detail::min;
using detail::RowWriter;
using detail::SamplesTree;

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
struct Place {
  int32_t x_q10;
  int32_t y_q10;
};

// The pixels that the buffer holds, and what goes on to them.
class Block {
 public:
  Block(const GlyphField& field,
        const TextStyle& style,
        const Splats& splats) noexcept;

  // Goes on to a window.
  void start(const FinePoint& origin, const Rect& pixels) noexcept;
  // Adds what the small cells say.
  void splat() noexcept;
  // Takes what plain drawing says.
  Sink own_sink() noexcept { return {pixels_, this, add_own, add_solid}; }
  void draw(const Sink& sink) const noexcept;

 private:
  static void add_own(void* context,
                      int32_t x,
                      int32_t y,
                      const uint8_t* coverage,
                      int32_t count);
  static void add_solid(void* context, int32_t x, int32_t y, int32_t count);
  uint32_t* sums_at(int32_t x, int32_t y) const noexcept {
    return splats_.sums.data + static_cast<uint32_t>(y - pixels_.y0) * width() +
           static_cast<uint32_t>(x - pixels_.x0);
  }
  uint32_t width() const noexcept {
    return static_cast<uint32_t>(pixels_.x1 - pixels_.x0);
  }
  Place centre_of(uint32_t x, uint32_t y, uint32_t log2) const noexcept;
  bool is_near(const Place& centre, uint32_t log2) const noexcept;
  uint32_t coverage_at(uint32_t x, uint32_t y, uint32_t log2) const noexcept;
  bool visit(uint32_t reference,
             uint32_t x,
             uint32_t y,
             uint32_t log2) noexcept;
  void visit_tile(uint32_t reference, uint32_t x, uint32_t y) noexcept;
  void add(const Place& centre, uint32_t log2, uint32_t coverage) noexcept;

  SamplesTree tree_;
  const TextStyle& style_;
  const Splats& splats_;
  Rect pixels_;
  Place origin_ = {0, 0};
  uint32_t least_log2_ = 0;  // of the least squares
  uint32_t wide_log2_ = 0;   // of the least that are wider than the radius
  uint32_t weight_q8_ = 0;   // of the least, at a pixel's centre
};

Block::Block(const GlyphField& field,
             const TextStyle& style,
             const Splats& splats) noexcept
    : tree_{field}, style_(style), splats_(splats) {
  const auto size_q6 = static_cast<uint32_t>(style.size().raw);
  const auto radius_q10 = static_cast<uint32_t>(splats.radius_q10);
  // Of 1 u or of at most a quarter of a px.
  while ((size_q6 << (least_log2_ + 1)) <= 256 << 6) {
    ++least_log2_;
  }
  while ((size_q6 << wide_log2_) <= radius_q10 << 6) {
    ++wide_log2_;
  }
  // The filter's integral is 1.322 times the square of its radius.
  const uint32_t side_q10 = (size_q6 << least_log2_) >> 6;
  weight_q8_ = side_q10 * side_q10 * 1549 / ((radius_q10 * radius_q10) >> 8);
}

void Block::start(const FinePoint& origin, const Rect& pixels) noexcept {
  pixels_ = pixels;
  origin_ = {static_cast<int32_t>(origin.x_q10 - pixels.x0 * 1024 - 512),
             static_cast<int32_t>(origin.y_q10 - pixels.y0 * 1024 - 512)};
  const uint32_t count = width() * static_cast<uint32_t>(pixels.y1 - pixels.y0);
  for (uint32_t i = 0; i < count; ++i) {
    splats_.sums.data[i] = 0;
  }
}

// Of a square of the grid, from the grid's corner.
Place Block::centre_of(uint32_t x, uint32_t y, uint32_t log2) const noexcept {
  const GlyphField& field = tree_.field;
  const int32_t size_q6 = style_.size().raw;
  const int32_t size_u = int32_t{1} << log2;
  const int32_t x_q10 =
      ((2 * (field.x0_u + static_cast<int32_t>(x)) + size_u) * size_q6) >> 7;
  const int32_t y_q10 =
      ((2 * (field.y0_u + static_cast<int32_t>(y)) + size_u) * size_q6) >> 7;
  if (style_.is_upright()) {
    return {origin_.x_q10 + x_q10, origin_.y_q10 - y_q10};
  }
  const TextStyle::Axes& axes = style_.axes();
  const int64_t right =
      int64_t{x_q10} * axes.x_right.raw + int64_t{y_q10} * axes.y_right.raw;
  const int64_t up =
      int64_t{x_q10} * axes.x_up.raw + int64_t{y_q10} * axes.y_up.raw;
  return {origin_.x_q10 + static_cast<int32_t>(right >> 30),
          origin_.y_q10 - static_cast<int32_t>(up >> 30)};
}

// Whether anything in a square may be within the radius of a pixel.
bool Block::is_near(const Place& centre, uint32_t log2) const noexcept {
  // Half a diagonal is 91/128.
  const int32_t side_q10 = static_cast<int32_t>(
      (static_cast<uint32_t>(style_.size().raw) << log2) >> 6);
  const int32_t way_q10 =
      splats_.radius_q10 +
      (style_.is_upright() ? side_q10 >> 1 : ((side_q10 >> 4) * 91 >> 3)) + 16;
  return centre.x_q10 > -way_q10 && centre.y_q10 > -way_q10 &&
         centre.x_q10 < (pixels_.x1 - pixels_.x0 - 1) * 1024 + way_q10 &&
         centre.y_q10 < (pixels_.y1 - pixels_.y0 - 1) * 1024 + way_q10;
}

// Adds a sample to all pixels within the radius.
void Block::add(const Place& centre,
                uint32_t log2,
                uint32_t coverage) noexcept {
  const uint32_t weight_q8 = weight_q8_ << 2 * (log2 - least_log2_);
  const int32_t radius_q10 = splats_.radius_q10;
  const auto first = [radius_q10](int32_t place_q10) noexcept {
    return max((place_q10 - radius_q10 + 1023) >> 10, 0);
  };
  const auto end = [radius_q10](int32_t place_q10, int32_t most) noexcept {
    return min(((place_q10 + radius_q10) >> 10) + 1, most);
  };
  const int32_t left = first(centre.x_q10);
  const int32_t right = end(centre.x_q10, pixels_.x1 - pixels_.x0);
  const int32_t bottom = end(centre.y_q10, pixels_.y1 - pixels_.y0);
  const uint32_t sample = (1u << kCoverageBits) + coverage;
  const uint32_t steps_q16 = splats_.steps_q16;
  for (int32_t y = first(centre.y_q10); y < bottom; ++y) {
    const int32_t down_q7 = (y * 1024 - centre.y_q10) >> 3;
    const int32_t down_square = down_q7 * down_q7;
    int32_t right_q7 = (left * 1024 - centre.x_q10) >> 3;
    uint32_t* sum = splats_.sums.data + static_cast<uint32_t>(y) * width() +
                    static_cast<uint32_t>(left);
    for (int32_t x = left; x < right; ++x, ++sum, right_q7 += 128) {
      const auto square =
          static_cast<uint32_t>(right_q7 * right_q7 + down_square);
      const uint32_t step = (square * steps_q16) >> 16;
      if (step < kSteps) {
        const uint32_t weight = (kFall[step] * weight_q8 + (1 << 15)) >> 16;
        if (weight + (*sum >> kCoverageBits) <= kMost) {
          *sum += weight * sample;
        }
      }
    }
  }
}

// At the centre of a square.
uint32_t Block::coverage_at(uint32_t x,
                            uint32_t y,
                            uint32_t log2) const noexcept {
  const uint32_t half_q16 = 1u << (log2 + 15);
  detail::CellSampler sampler(tree_.field);
  return style_.coverage(
      sampler.distance_q10({(x << 16) + half_q16, (y << 16) + half_q16, 0, 0}));
}

// Visits a square. True: its children are to be visited.
bool Block::visit(uint32_t reference,
                  uint32_t x,
                  uint32_t y,
                  uint32_t log2) noexcept {
  const bool is_node = tree_.is_node(reference) && log2 > 0;
  if (!is_node && log2 >= wide_log2_) {
    return false;
  }
  const Place centre = centre_of(x, y, log2);
  if (!is_near(centre, log2)) {
    return false;
  }
  if (is_node && log2 > least_log2_) {
    return true;
  }
  if (is_node) {
    add(centre, log2, coverage_at(x, y, log2));
    return false;
  }
  const uint8_t* const samples = tree_.samples(reference);
  const uint32_t saturated = reference == format::glyph::kInside ? 255 : 0;
  if (log2 + 1 < wide_log2_ || log2 == least_log2_) {
    // What a cell says of its centre it says without an equation.
    add(centre, log2,
        samples != nullptr ? style_.coverage(detail::centre_q10(samples))
                           : saturated);
    return false;
  }
  // One sample would stand for too much.
  const uint32_t half_log2 = log2 - 1;
  for (uint32_t i = 0; i < 4; ++i) {
    const uint32_t right = i & 1;
    const uint32_t up = i >> 1;
    // A quarter or three of the cell.
    const auto place = [log2](uint32_t part) noexcept {
      return static_cast<int32_t>((2 * part + 1) << (log2 + 14));
    };
    add(centre_of(x + (right << half_log2), y + (up << half_log2), half_log2),
        half_log2,
        samples != nullptr
            ? style_.coverage(samples_distance(samples,
                                               static_cast<uint8_t>(log2),
                                               place(right), place(up))
                                  .raw)
            : saturated);
  }
  return false;
}

// All squares of a tile, child after child.
__attribute__((noinline)) void Block::visit_tile(uint32_t reference,
                                                 uint32_t x,
                                                 uint32_t y) noexcept {
  const uint32_t tile_log2 = tree_.field.tile_log2;
  uint16_t path[format::glyph::kMaxTileLog2 + 1];
  uint32_t log2 = tile_log2;
  while (true) {
    if (visit(reference, x, y, log2)) {
      path[log2] = static_cast<uint16_t>(reference);
      --log2;
      reference = tree_.child(reference, 0);
      continue;
    }
    // On to the next one: x first, then y, then up.
    for (; log2 < tile_log2; ++log2) {
      const uint32_t size = 1u << log2;
      x ^= size;
      if ((x & size) != 0) {
        break;
      }
      y ^= size;
      if ((y & size) != 0) {
        break;
      }
    }
    if (log2 >= tile_log2) {
      return;
    }
    reference =
        tree_.child(path[log2 + 1], ((y >> log2) & 1) * 2 + ((x >> log2) & 1));
  }
}

void Block::splat() noexcept {
  const GlyphField& field = tree_.field;
  const uint32_t log2 = field.tile_log2;
  // Tiles below the least square are not told apart.
  const uint32_t step_log2 = log2 < least_log2_ ? least_log2_ : log2;
  const auto width_u = static_cast<uint32_t>(field.tiles_x) << log2;
  const auto height_u = static_cast<uint32_t>(field.tiles_y) << log2;
  for (uint32_t y = 0; y < height_u; y += 1u << step_log2) {
    for (uint32_t x = 0; x < width_u; x += 1u << step_log2) {
      if (step_log2 == log2) {
        visit_tile(tree_.tile((y >> log2) * field.tiles_x + (x >> log2)), x, y);
      } else if (const Place centre = centre_of(x, y, step_log2);
                 is_near(centre, step_log2)) {
        add(centre, step_log2, coverage_at(x, y, step_log2));
      }
    }
  }
}

// What is left of the filter has the coverage of the pixel's own sample.
void Block::add_own(void* context,
                    int32_t x,
                    int32_t y,
                    const uint8_t* coverage,
                    int32_t count) {
  uint32_t* const sums = static_cast<Block*>(context)->sums_at(x, y);
  for (int32_t i = 0; i < count; ++i) {
    const uint32_t weight = sums[i] >> kCoverageBits;
    if (weight < kAll) {
      sums[i] += (kAll - weight) * coverage[i];
    }
  }
}

void Block::add_solid(void* context, int32_t x, int32_t y, int32_t count) {
  constexpr uint8_t kFull = 255;
  for (int32_t i = 0; i < count; ++i) {
    add_own(context, x + i, y, &kFull, 1);
  }
}

__attribute__((noinline)) void Block::draw(const Sink& sink) const noexcept {
  constexpr uint32_t kMask = (1u << kCoverageBits) - 1;
  RowWriter writer(sink, pixels_.y0);
  const uint32_t* sum = splats_.sums.data;
  for (int32_t y = pixels_.y0; y < pixels_.y1; ++y) {
    for (int32_t x = pixels_.x0; x < pixels_.x1; ++x) {
      const uint32_t weight = *sum >> kCoverageBits;
      const uint32_t covered = *sum & kMask;
      // Most sums need no division.
      const uint32_t coverage = weight <= kAll
                                    ? (covered + kAll / 2) / kAll
                                    : (covered + weight / 2) / weight;
      writer.put(x, static_cast<uint8_t>(coverage));
      ++sum;
    }
    writer.next_row();
  }
}

}  // namespace

Status make_splats(Span<uint32_t> sums, Q6_10 radius, Splats& out) noexcept {
  if (sums.size < kMinSplatSums) {
    return Status::buffer_small;
  }
  if (radius.raw < kMinSplatRadius.raw || radius.raw > kMaxSplatRadius.raw) {
    return Status::bad_argument;
  }
  const auto radius_q7 = static_cast<uint32_t>(radius.raw) >> 3;
  const uint32_t square = radius_q7 * radius_q7;
  out.sums = sums;
  out.radius_q10 = radius.raw;
  out.steps_q16 = static_cast<uint16_t>(((kSteps << 16) + square - 1) / square);
  return Status::ok;
}

void detail::paint_splats(const GlyphField& field,
                          const TextStyle& style,
                          const void* options,
                          const FinePoint& origin,
                          const Sink& sink) {
  const auto& splats = *static_cast<const Splats*>(options);
  detail::Placed placed;
  if (!placed.set_near(origin)) {
    return;
  }
  if (detail::has_fields(field)) {
    detail::draw_plain(field, style, placed, sink);
    return;
  }
  const Rect all = detail::visible_pixels(field, style, origin, sink.window);
  if (is_empty(all)) {
    return;
  }
  Block block(field, style, splats);
  // As many rows at once as there are sums for, or a part of one.
  const auto most = static_cast<int32_t>(
      splats.sums.size < (1u << 20) ? splats.sums.size : 1u << 20);
  const int32_t columns = min(all.x1 - all.x0, most);
  const int32_t height = most / columns;
  for (int32_t y = all.y0; y < all.y1; y += height) {
    for (int32_t x = all.x0; x < all.x1; x += columns) {
      block.start(origin, intersect(all, {x, y, x + columns, y + height}));
      block.splat();
      detail::draw_plain(field, style, placed, block.own_sink());
      block.draw(sink);
    }
  }
}

}  // namespace inkcell
