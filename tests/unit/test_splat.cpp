// Splats: what they are the mean of, and that no picture depends on how it is
// cut or on how many sums there are.
#include "inkcell/field/splat.hpp"

#include "any_record.hpp"
#include "check.hpp"
#include "effect_canvas.hpp"
#include "effect_glyph.hpp"
#include "font_builder.hpp"
#include "ink.hpp"
#include "inkcell/field/cell.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace effect;

// Px to the em where the cells of shapes, 64 u wide, are splatted.
constexpr int32_t kSizes[] = {6, 9, 15, 20};

// Enough for most glyphs at once, on a small board.
uint32_t sums[24 * 24];

Splat splat_of(size_t count = 24 * 24, Q6_10 radius = kSplatRadius) {
  return Splat(Span<uint32_t>(sums, count), radius);
}

void check_as_without(const GlyphField& field, Style style, FinePoint origin) {
  draw(field, style, origin);
  whole = picture;
  CHECK(whole.ink() > 0);
  const Splat splat = splat_of();
  style.set_effect(splat);
  draw(field, style, origin);
  CHECK(picture == whole);
}

// 2^(-3 t), 0 <= t <= 1.
double fall(double t) {
  const double x = -2.0794415416798357 * t / 8;
  double term = 1;
  double sum = 1;
  for (int i = 1; i < 9; ++i) {
    term *= x / i;
    sum += term;
  }
  const double squared = sum * sum * sum * sum;
  return squared * squared;
}

// What a pixel gathers from all squares around it. [px, y up, from the origin]
class Gathered {
 public:
  Gathered(const GlyphField& field, const Style& style, double x, double y)
      : field_(field),
        style_(style),
        x_(x),
        y_(y),
        px_(style.size().raw / 65536.0) {
    int32_t least = 1;
    while (2 * least * px_ <= 0.25) {
      least *= 2;
    }
    // A cell that counts begins at most two radii away.
    const auto first = [&](double place, int32_t corner) {
      const auto way =
          static_cast<int32_t>((place - 2 * kRadius) / px_) - corner;
      return corner + (way < 0 ? 0 : way / least * least);
    };
    const auto end = [&](double place, int32_t far) {
      const auto last = static_cast<int32_t>((place + kRadius) / px_) + 1;
      return last < far ? last : far;
    };
    const int32_t right = end(x, field.x1_u());
    const int32_t top = end(y, field.y1_u());
    for (int32_t v = first(y, field.y0_u); v < top; v += least) {
      for (int32_t u = first(x, field.x0_u); u < right; u += least) {
        const Cell cell = locate(field, u, v);
        const int32_t size = int32_t{1} << cell.size_log2;
        if (size <= least) {
          add(u, v, least);
        } else if (cell.x0_u == u && cell.y0_u == v && size * px_ <= kRadius) {
          if (2 * size * px_ > kRadius) {
            for (int32_t i = 0; i < 4; ++i) {
              add(u + i % 2 * size / 2, v + i / 2 * size / 2, size / 2);
            }
          } else {
            add(u, v, size);
          }
        }
      }
    }
  }

  double coverage(double own) const {
    return weight_ < 1 ? covered_ + (1 - weight_) * own : covered_ / weight_;
  }
  double weight() const { return weight_; }

 private:
  static constexpr double kRadius = kSplatRadius.raw / 1024.0;

  void add(int32_t x_u, int32_t y_u, int32_t size) {
    const double across = (x_u + size / 2.0) * px_ - x_;
    const double along = (y_u + size / 2.0) * px_ - y_;
    const double t = (across * across + along * along) / (kRadius * kRadius);
    if (t >= 1) {
      return;
    }
    const double side = size * px_;
    const double weight = fall(t) * side * side / (1.322 * kRadius * kRadius);
    const int32_t distance =
        distance_at(field_, Q16_16::from_raw(x_u * 65536 + size * 32768),
                    Q16_16::from_raw(y_u * 65536 + size * 32768))
            .raw;
    weight_ += weight;
    covered_ += weight * style_.filter().coverage(style_.to_px_q10(distance));
  }

  const GlyphField& field_;
  const Style& style_;
  double x_;
  double y_;
  double px_;
  double weight_ = 0;
  double covered_ = 0;
};

}  // namespace

TEST(splats_are_what_pixels_would_gather) {
  const font_builder::Shape shapes[] = {font_builder::ring, font_builder::bar};
  const FinePoint origin(6 * 1024 + 300, 25 * 1024 + 77);
  for (const font_builder::Shape shape : shapes) {
    const GlyphField field = field_of(shape);
    for (const int32_t px : kSizes) {
      Style style = style_of(px * 64, false);
      const Splat splat = splat_of();
      style.set_effect(splat);
      draw(field, style, origin);
      int32_t gathered = 0;
      for (int32_t y = 0; y < kSide; ++y) {
        Q6_10 own[kSide];
        distance_row(field, style, origin, kAll.x0, y + kAll.y0, {own, kSide});
        for (int32_t x = y % 3; x < kSide; x += 3) {
          const Gathered pixel(
              field, style,
              x + kAll.x0 + 0.5 - static_cast<double>(origin.x_q10) / 1024,
              static_cast<double>(origin.y_q10) / 1024 - y - kAll.y0 - 0.5);
          const auto coverage = static_cast<int32_t>(
              pixel.coverage(style.filter().coverage(own[x].raw)) + 0.5);
          CHECK(magnitude(picture.at(x + kAll.x0, y + kAll.y0) - coverage) <=
                8);
          gathered += pixel.weight() > 0.5 && coverage > 0 ? 1 : 0;
        }
      }
      CHECK(gathered > 5);
    }
  }
}

TEST(wide_cells_look_as_without) {
  const GlyphField field = field_of(font_builder::ring);
  for (int turned = 0; turned < 2; ++turned) {
    check_as_without(field, style_of(40 * 64, turned != 0),
                     {3 * 1024 + 300, 33 * 1024 + 77});
  }
}

TEST(windows_and_sums_do_not_change_the_picture) {
  const GlyphField field = field_of(font_builder::ring);
  const FinePoint origin(6 * 1024 + 300, 25 * 1024 + 77);
  for (int turned = 0; turned < 2; ++turned) {
    for (const int32_t px : kSizes) {
      Style style = style_of(px * 64, turned != 0);
      const Splat large = splat_of();
      style.set_effect(large);
      check_windows(field, style, origin);
      CHECK(picture.ink() > 0);
      for (size_t count = kMinSplatSums; count < 100; count += 7) {
        const Splat small = splat_of(count);
        style.set_effect(small);
        draw(field, style, origin);
        CHECK(picture == whole);
      }
    }
  }
}

TEST(any_cells_are_drawn_in_the_window) {
  font_builder::Record& record = glyph_record;
  Rounds rounds(7, 60);
  for (Random& random : rounds) {
    make_any(record, random);
    const GlyphField field = open_glyph();
    Style style =
        style_of(random.between(4 * 64, 90 * 64), rounds.number % 2 != 0);
    const Splat splat =
        splat_of(kMinSplatSums + random.below(300),
                 Q6_10::from_raw(static_cast<int16_t>(random.between(
                     kMinSplatRadius.raw, kMaxSplatRadius.raw))));
    style.set_effect(splat);
    check_windows(field, style,
                  {random.between(-9999, 30000), random.between(-9999, 40000)});
  }
}

TEST(radii_are_clamped_and_few_sums_refused) {
  CHECK_EQ(splat_of(64, Q6_10::from_raw(-5)).radius_q10, kMinSplatRadius.raw);
  CHECK_EQ(splat_of(64, Q6_10::from_raw(767)).radius_q10, kMinSplatRadius.raw);
  CHECK_EQ(splat_of(64, Q6_10::from_raw(1537)).radius_q10, kMaxSplatRadius.raw);
  const Splat few = splat_of(kMinSplatSums - 1);
  Style style = style_of(20 * 64, false);
  style.set_effect(few);
  const FinePoint origin(6 * 1024, 25 * 1024);
  const GlyphField field = field_of(font_builder::ring);
  CHECK(is_empty(field_box(field, style, origin)));
  const Splat enough = splat_of(kMinSplatSums);
  style.set_effect(enough);
  CHECK(!is_empty(field_box(field, style, origin)));
}

// A buffer that is narrower than a row of the glyph.
TEST(glyphs_may_be_wider_than_the_sums) {
  constexpr int32_t kWidth = 200;
  font_builder::Record& record = glyph_record;
  record.reset();
  record.tile_log2 = 11;
  record.tiles_x = 14;
  record.tiles_y = 1;
  record.x0_u = -14336;
  record.y0_u = 0;
  record.reference_count = record.tiles_x;
  for (uint32_t i = 0; i < record.reference_count; ++i) {
    record.references[i] = format::glyph::kInside;
  }
  const GlyphField wide = open_glyph();
  Style style = style_of(20 * 64, false);
  const Splat splat = splat_of(kMinSplatSums);
  style.set_effect(splat);
  Ink ink;
  draw_field(wide, style, {250 * 1024, 9 * 1024}, ink.sink({0, 0, kWidth, 10}));
  CHECK_EQ(ink.sum, 255 * kWidth * 9);
}

TEST(small_tiles_look_like_larger_ones) {
  for (uint32_t log2 = 6; log2 >= 5; --log2) {
    font_builder::Record& record = glyph_record;
    record.reset();
    record.tile_log2 = static_cast<uint8_t>(log2);
    record.tiles_x = record.tiles_y = static_cast<uint8_t>(512 >> log2);
    record.x0_u = record.y0_u = 0;
    record.reference_count =
        static_cast<uint16_t>(record.tiles_x * record.tiles_y);
    for (uint32_t i = 0; i < record.reference_count; ++i) {
      const uint32_t x = i % record.tiles_x >> (6 - log2);
      const uint32_t y = i / record.tiles_x >> (6 - log2);
      record.references[i] =
          (x + y) % 3 != 0 ? format::glyph::kInside : format::glyph::kOutside;
    }
    const GlyphField field = open_glyph();
    Style style = style_of(4 * 64, false);
    const Splat splat = splat_of();
    style.set_effect(splat);
    draw(field, style, {10 * 1024 + 300, 20 * 1024 + 77});
    CHECK(picture.ink() > 0);
    if (log2 == 6) {
      whole = picture;
    }
    CHECK(picture == whole);
  }
}
