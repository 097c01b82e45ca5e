// Sub-pixels: coverage of each stripe.
#include "inkcell/lcd.hpp"

#include "base/math.hpp"
#include "base/words.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {
namespace {

// The mean of three to within a level, without a division.
uint8_t third(int32_t sum) noexcept {
  return static_cast<uint8_t>((sum * 171 + 85) >> 9);
}
uint8_t mean(int32_t a, int32_t b, int32_t c) noexcept {
  return third(a + b + c);
}

bool is_vertical(SubPixels order) noexcept {
  return order == SubPixels::rgb_vertical || order == SubPixels::bgr_vertical;
}

bool is_red_first(SubPixels order) noexcept {
  return order == SubPixels::rgb || order == SubPixels::rgb_vertical;
}

// Emits pixels of three coverages, which may be changed.
__attribute__((noinline)) void emit_channels(const Sink& sink,
                                             const Lcd& lcd,
                                             int32_t x,
                                             int32_t y,
                                             uint8_t* rgb,
                                             int32_t count) noexcept {
  const bool is_grey = sink.coverage_rgb == nullptr;
  if (is_grey || lcd.colour != 255) {
    for (int32_t i = 0; i < count; ++i) {
      uint8_t* const pixel = rgb + 3 * i;
      const int32_t grey = mean(pixel[0], pixel[1], pixel[2]);
      for (int32_t j = 0; j < 3; ++j) {
        pixel[j] =
            static_cast<uint8_t>(grey + (pixel[j] - grey) * lcd.colour / 255);
      }
    }
  }
  if (!is_grey) {
    sink.coverage_rgb(sink.context, x, y, rgb, count);
    return;
  }
  for (int32_t i = 0; i < count; ++i) {
    rgb[i] = mean(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
  }
  sink.coverage(sink.context, x, y, rgb, count);
}

// How stripes lie in a band. [bytes]
struct StripeSteps {
  int32_t before;  // from a pixel's first stripe to the one before it
  int32_t stripe;  // to the next one
  int32_t behind;  // to the first one that is not the pixel's
  int32_t pixel;   // to the next pixel's
  int32_t row;     // to that of the pixel below
};

void plan_lcd(const Effect& effect, const Style&, BandPlan& plan) noexcept {
  // A channel is the mean of a stripe and the two beside it.
  plan.ink_margin_q8 += 86;
  if (is_vertical(static_cast<const Lcd&>(effect).order)) {
    plan.rows = 3;
    plan.margin_y = 1;
  } else {
    plan.columns = 3;
    plan.margin_x = 1;
  }
}

// A straight edge's coverage as the filter's table has it.
void map_stripes(const Band& band, const Filter& filter) noexcept {
  uint8_t* at = band.bytes;
  for (uint8_t* const end = at + band.rows * band.stride; at != end; at += 4) {
    const uint32_t word = load_pixels(at);
    if (word != 0 && word != 0xffffffff) {
      for (int32_t i = 0; i != 4; ++i) {
        at[i] = at[i] == 0 || at[i] == 255 ? at[i] : filter.table[at[i]];
      }
    }
  }
}

// Up to kMaxSpan pixels from `at` on, as long as they are of one kind: none,
// all, or what lies between. Returns how many.
//
//   | . . 0 | 1 2 3 | 4 . . |     red is the mean of 0, 1 and 2
//
__attribute__((noinline)) int32_t mix_span(const Lcd& lcd,
                                           const Sink& sink,
                                           const StripeSteps& steps,
                                           const uint8_t* at,
                                           int32_t x,
                                           int32_t y,
                                           int32_t count) noexcept {
  constexpr int32_t kFull = 3 * 255;
  const bool is_red_first = detail::is_red_first(lcd.order);
  uint8_t rgb[3 * kMaxSpan];
  uint8_t* out = rgb;
  int32_t done = 0;
  int32_t all_sum = -1;
  for (; done != count; ++done) {
    // The sums of the pixel's channels, 0 to 765.
    const int32_t own = at[0];
    const int32_t middle = at[steps.stripe];
    const int32_t last = at[2 * steps.stripe];
    const int32_t a = at[steps.before] + own + middle;
    const int32_t b = own + middle + last;
    const int32_t c = middle + last + at[steps.behind];
    const int32_t sum = a + b + c;
    const int32_t kind = sum == 0 || sum == 3 * kFull ? sum : 1;
    if (all_sum >= 0 && kind != all_sum) {
      break;
    }
    all_sum = kind;
    at += steps.pixel;
    if (kind == 1) {
      out[0] = third(is_red_first ? a : c);
      out[1] = third(b);
      out[2] = third(is_red_first ? c : a);
      out += 3;
    }
  }
  if (all_sum == 3 * kFull) {
    sink.solid(sink.context, x, y, done);
  } else if (all_sum == 1) {
    emit_channels(sink, lcd, x, y, rgb, done);
  }
  return done;
}

// Makes channels of a band of stripes' coverages, each the mean of three, and
// emits them.
void mix_stripes(const Lcd& lcd,
                 const GlyphJob& job,
                 const StripeSteps& steps) noexcept {
  const Rect& pixels = job.pixels;
  const uint8_t* row = job.band.row(job.row) + job.column;
  for (int32_t y = pixels.y0; y != pixels.y1; ++y, row += steps.row) {
    for (int32_t x = pixels.x0; x != pixels.x1;) {
      x += mix_span(lcd, *job.sink, steps, row + (x - pixels.x0) * steps.pixel,
                    x, y, min(kMaxSpan, pixels.x1 - x));
    }
  }
}

void mix_lcd(const Effect& effect, GlyphBand& band) noexcept {
  const auto& lcd = static_cast<const Lcd&>(effect);
  const auto& job = static_cast<const GlyphJob&>(band);
  const Filter& filter = job.style->filter();
  band.cover();
  if (!filter.is_linear) {
    map_stripes(job.band, filter);
  }
  const int32_t stride = job.band.stride;
  if (is_vertical(lcd.order)) {
    mix_stripes(lcd, job, {-stride, stride, 3 * stride, 1, 3 * stride});
  } else {
    mix_stripes(lcd, job, {-1, 1, 3, 3, stride});
  }
}

}  // namespace

const Mixer kLcdMixer = {kAreas, plan_lcd, mix_lcd};

}  // namespace inkcell::detail
