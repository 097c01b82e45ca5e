#include "inkcell/crisp.hpp"

#include "distance/sampler.hpp"
#include "raster/draw_cells.hpp"
#include "sink/row_writer.hpp"

namespace inkcell {
namespace {

using detail::CellSampler;
using detail::GlyphPoint;
using detail::RowWriter;

// Of two neighbours with a stroke between them, the nearer one's distance.
constexpr int32_t kFarthestQ10 = -(1 << 9);  // [px]

// The glyph around a pixel: distances from the threshold.
class Neighbourhood {
 public:
  Neighbourhood(const GlyphField& field,
                const TextStyle& style,
                const FinePoint& origin,
                int32_t threshold_q10) noexcept
      : walk_(field, style, detail::kNoReach),
        style_(style),
        origin_(origin),
        threshold_q10_(threshold_q10) {}

  GlyphPoint position(int32_t x,
                      int32_t y,
                      int32_t right_q10,
                      int32_t down_q10) const noexcept {
    return walk_.point(origin_, x, y, {right_q10, -down_q10});
  }

  GlyphPoint next(const GlyphPoint& at) const noexcept {
    return detail::moved(at, detail::offset_of(style_, {1 << 10, 0}));
  }
  uint8_t covered(int32_t value_q10) const noexcept {
    return style_.filter().coverage(value_q10 + threshold_q10_);
  }

  int32_t value_at(const GlyphPoint& at) noexcept {
    return walk_.distance_q10(at) - threshold_q10_;
  }

  // Whether pixel (x, y), of this value below 0, must stand for a stroke that
  // passes between it and a neighbour.
  __attribute__((noinline)) bool is_bridge(int32_t x,
                                           int32_t y,
                                           int32_t value_q10) noexcept {
    return passes_between(x, y, 1, 0, value_q10) ||
           passes_between(x, y, 0, 1, value_q10) ||
           passes_between(x, y, -1, 0, value_q10) ||
           passes_between(x, y, 0, -1, value_q10);
  }

 private:
  // Whether a stroke passes between the pixel and its neighbour in direction
  // (right, down), nearer to the pixel. Both decide alike: of two that are
  // equally near the left or upper one is drawn.
  __attribute__((noinline)) bool passes_between(int32_t x,
                                                int32_t y,
                                                int32_t right,
                                                int32_t down,
                                                int32_t value_q10) noexcept {
    const int32_t other_q10 = value_at(position(x + right, y + down, 0, 0));
    const bool is_first = right + down > 0;
    if (other_q10 >= 0 || value_q10 < other_q10 ||
        (value_q10 == other_q10 && !is_first)) {
      return false;
    }
    // Ink is no nearer to either than its distance says:
    //
    //   pixel |--value--|  1 3 5 of 6  |---other---| neighbour
    const int32_t room_q10 = (1 << 10) + value_q10 + other_q10;
    for (int32_t sixth = 1; room_q10 >= 0 && sixth <= 5; sixth += 2) {
      const int32_t way_q10 = room_q10 * sixth / 6 - value_q10;
      if (value_at(position(x, y, right * way_q10, down * way_q10)) >= 0) {
        return true;
      }
    }
    return false;
  }

  CellSampler walk_;
  const TextStyle& style_;
  const FinePoint& origin_;
  int32_t threshold_q10_;
};

uint8_t nearest_level(uint8_t coverage) noexcept {
  return static_cast<uint8_t>((coverage + 42) / 85 * 85);
}

// In a frame of its own, so that none is large.
__attribute__((noinline)) void draw_rows(Neighbourhood& glyph,
                                         const CrispOptions& crisp,
                                         const Rect& box,
                                         const Sink& sink) noexcept {
  const bool has_greys = crisp.levels > 2;
  const uint8_t bridge = has_greys ? 170 : 255;
  RowWriter writer(sink, box.y0);
  for (int32_t y = box.y0; y < box.y1; ++y) {
    GlyphPoint at = glyph.position(box.x0, y, 0, 0);
    for (int32_t x = box.x0; x < box.x1; ++x) {
      const int32_t value_q10 = glyph.value_at(at);
      uint8_t coverage = value_q10 >= 0 ? 255 : 0;
      if (has_greys) {
        coverage = nearest_level(glyph.covered(value_q10));
      }
      if (coverage < bridge && value_q10 < 0 && value_q10 >= kFarthestQ10 &&
          glyph.is_bridge(x, y, value_q10)) {
        coverage = bridge;
      }
      writer.put(x, coverage);
      at = glyph.next(at);
    }
    writer.next_row();
  }
}

}  // namespace

void detail::paint_crisp(const GlyphField& field,
                         const TextStyle& style,
                         const void* options,
                         const FinePoint& origin,
                         const Sink& sink) {
  const CrispOptions& crisp = *static_cast<const CrispOptions*>(options);
  constexpr int32_t kMostThreshold = 1 << 9;
  int32_t threshold = crisp.threshold_px.raw;
  threshold = threshold < -kMostThreshold ? -kMostThreshold : threshold;
  threshold = threshold > kMostThreshold ? kMostThreshold : threshold;
  Neighbourhood glyph(field, style, origin, threshold);
  // Beyond the ramp of the filter, by what the threshold and bridges reach.
  draw_rows(glyph, crisp,
            detail::visible_pixels(field, style, origin, sink.window), sink);
}

}  // namespace inkcell
