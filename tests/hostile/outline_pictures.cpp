#include "outline_pictures.hpp"

#include <cstring>
#include <memory>

#include "exercise.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/generate.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/supersample.hpp"

namespace hostile {
namespace {

using namespace inkcell;

constexpr auto kColumns = static_cast<size_t>(kPictureWidth);
constexpr auto kRows = static_cast<size_t>(kPictureHeight);

// The planes of a fill's sink: two; else three sub-pixels.
constexpr size_t kPlanes = 3;

// Coverage of a picture, cut into windows.
class Picture {
 public:
  Picture(int32_t x0, int32_t y0)
      : all_{x0, y0, x0 + kPictureWidth, y0 + kPictureHeight} {}

  const Rect& all() const { return all_; }

  // Each pixel may come once from a window.
  Sink sink(const Rect& window, bool takes_blocks) {
    window_ = intersect(window, all_);
    return {window_,
            this,
            coverage<0>,
            solid<0>,
            takes_blocks ? block : nullptr,
            coverage_rgb};
  }
  // A sink for the second colour, over the same window.
  Sink fill_sink(const Rect& window) {
    return {intersect(window, all_), this, coverage<1>, solid<1>};
  }

  bool equals(const Picture& other) const {
    return std::memcmp(pixels_, other.pixels_, sizeof(pixels_)) == 0;
  }

 private:
  void put(int32_t x, int32_t y, size_t plane, uint8_t value) {
    require(y >= window_.y0 && y < window_.y1, "row in the window");
    require(x >= window_.x0 && x < window_.x1, "pixel in the window");
    const auto column = static_cast<size_t>(x - all_.x0);
    const auto row = static_cast<size_t>(y - all_.y0);
    require(!drawn_[plane][row][column], "no pixel twice");
    drawn_[plane][row][column] = true;
    pixels_[plane][row][column] = value;
  }
  static Picture& of(void* context) { return *static_cast<Picture*>(context); }
  template <size_t plane>
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    require(count >= 1 && count <= kMaxSpan, "length of the span");
    for (int32_t i = 0; i < count; ++i) {
      of(context).put(x + i, y, plane, coverage[i]);
    }
  }
  template <size_t plane>
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    require(count >= 1, "length of the run");
    for (int32_t i = 0; i < count; ++i) {
      of(context).put(x + i, y, plane, 255);
    }
  }
  static void coverage_rgb(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* coverage,
                           int32_t count) {
    require(count >= 1 && count <= kMaxSpan, "length of the span");
    for (int32_t i = 0; i < count; ++i) {
      for (size_t plane = 0; plane < kPlanes; ++plane) {
        of(context).put(x + i, y, plane, *coverage++);
      }
    }
  }
  static void block(void* context, const CoverageBlock& block) {
    const Rect& pixels = block.pixels;
    require(!is_empty(pixels), "a block has pixels");
    require(block.stride % 4 == 0 && block.stride >= pixels.x1 - pixels.x0,
            "stride of a block");
    require(((reinterpret_cast<uintptr_t>(block.coverage) -
              static_cast<uintptr_t>(pixels.x0)) &
             3) == 0,
            "alignment of a block");
    // All bytes up to the stride may be read.
    volatile uint8_t last = 0;
    for (int32_t y = pixels.y0; y < pixels.y1; ++y) {
      const uint8_t* const row =
          block.coverage + (y - pixels.y0) * block.stride;
      last = row[block.stride - 1];
      for (int32_t x = pixels.x0; x < pixels.x1; ++x) {
        of(context).put(x, y, 0, row[x - pixels.x0]);
      }
    }
    static_cast<void>(last);
  }

  Rect all_;
  Rect window_;
  uint8_t pixels_[kPlanes][kRows][kColumns] = {};
  bool drawn_[kPlanes][kRows][kColumns] = {};
};

// RAM of exactly this size at an address that is `odd` modulo 4.
class Ram {
 public:
  Ram(uint32_t bytes, uint8_t odd)
      : block_(std::make_unique<uint8_t[]>(bytes + odd)),
        workspace_(block_.get() + odd, bytes) {
    std::memset(block_.get(), 0xb7, bytes + odd);
  }
  Workspace workspace() const { return workspace_; }

 private:
  std::unique_ptr<uint8_t[]> block_;
  Workspace workspace_;
};

constexpr Filter kWide =
    make_filter({Q6_10::from_raw(-4096), Q6_10::from_raw(4096)});
constexpr Filter kBold = with_weight(kFilterText, Q6_10::from_raw(1000));
constexpr Filter kLight = with_weight(kFilterText, Q6_10::from_raw(-700));
constexpr Filter kShadow = shadow_filter(Q6_10::from_raw(2100));
constexpr const Filter* kFilters[kFilterCount] = {
    &kFilterText,      &kFilterMotion, &kFilterPaperDisplay,
    &kFilterPaperBody, &kWide,         &kBold,
    &kLight,           &kShadow,       &kFilterArea};

constexpr int32_t kOne = 1 << 30;
constexpr int32_t kDirections[][2] = {{kOne, 0},
                                      {0, kOne},
                                      {-kOne, 0},
                                      {0, -kOne},
                                      {kOne, 1},
                                      {759250125, -759250125},
                                      {-858993459, 644245094},
                                      {kOne - (1 << 20), 46333952}};
constexpr uint32_t kDirectionCount = sizeof(kDirections) / sizeof(*kDirections);

Q16_16 part(int32_t size_q6, int32_t eighths) {
  return Q16_16::from_raw(size_q6 * 128 * eighths);
}

// Slanted, narrow, mirrored, and turned and narrow; within 4 to 1024 px.
Matrix matrix_of(uint32_t number, int32_t size_q6) {
  const int32_t size = size_q6 < 16 * 64    ? 16 * 64
                       : size_q6 > 700 * 64 ? 700 * 64
                                            : size_q6;
  switch (number) {
    case 0:
      return {part(size, 7), part(size, 0), part(size, 3), part(size, 8)};
    case 1:
      return {part(size, 3), part(size, 0), part(size, 0), part(size, 8)};
    case 2:
      return {part(size, -8), part(size, 0), part(size, 0), part(size, 8)};
    default:
      return {part(size, 2), part(size, 5), part(size, -7), part(size, 3)};
  }
}

Style style_of(const OutlineLook& look) {
  const Q26_6 size = Q26_6::from_raw(look.size_q6);
  const Filter& filter = *kFilters[look.filter];
  if (look.map == 0) {
    return Style(size, filter);
  }
  if (look.map < kDirectionCount) {
    Direction direction;
    direction.cosine.raw = kDirections[look.map][0];
    direction.sine.raw = kDirections[look.map][1];
    return Style(size, filter, direction);
  }
  return Style(matrix_of(look.map - kDirectionCount, look.size_q6), filter);
}

static_assert(kDirectionCount + 4 == kMapCount, "all maps have numbers");

// Everything that an effect refers to.
struct Options {
  Stroke stroke{kFilterText, Q6_10()};
  StrokeAndFill both{stroke};
  Lcd lcd;
  Bilevel bilevel;
  Supersample supersample;
  MotionBlur blur{{Q26_6::from_raw(300), Q26_6::from_raw(-170)}};
  EdgeContrast contrast{255, 255};
  Sink fill = {};
  Fit fit = {};
};

void set_effect(uint8_t number, Options& options, Style& style) {
  constexpr SubPixels kOrders[] = {SubPixels::rgb, SubPixels::bgr,
                                   SubPixels::rgb_vertical,
                                   SubPixels::bgr_vertical};
  if (number == 1) {
    options.stroke =
        Stroke(style.filter(), Q6_10::from_raw(1100), StrokePlace::inner);
    style.set_effect(options.stroke);
  } else if (number == 2) {
    options.stroke =
        Stroke(style.filter(), Q6_10::from_raw(600), StrokePlace::inner);
    options.both.fill = &options.fill;
    style.set_effect(options.both);
  } else if (number >= 3 && number < 7) {
    options.lcd =
        Lcd(kOrders[number - 3], static_cast<uint8_t>(number == 5 ? 90 : 255));
    style.set_effect(options.lcd);
  } else if (number == 7 || number == 8) {
    options.bilevel = Bilevel(static_cast<uint8_t>(number == 7 ? 2 : 4),
                              Q6_10::from_raw(number == 7 ? 120 : -250));
    style.set_effect(options.bilevel);
  } else if (number == 9) {
    style.set_effect(options.supersample);
  } else if (number == 10) {
    style.set_effect(options.blur);
  } else if (number == 11) {
    style.set_effect(options.contrast);
  }
}

static_assert(kEffectCount == 12, "all effects have numbers");

}  // namespace

void check_outline(const Font& font,
                   uint16_t glyph,
                   const OutlineLook& look,
                   const OutlineCut& cut,
                   bool is_exact) {
  Style style = style_of(look);
  Options options;
  if (look.is_fitted && style.is_upright() &&
      Fit::make(font, style, {true, 0, FitOptions::kAll}, options.fit) ==
          Status::ok) {
    style.set_fit(options.fit);
  }
  set_effect(look.effect, options, style);

  const Ram large(cut.whole_bytes, 0);
  Picture whole(cut.x0, cut.y0);
  const Rect& all = whole.all();
  const Sink sink = whole.sink(all, false);
  options.fill = whole.fill_sink(all);
  Painter(sink, large.workspace()).glyph(font, style, cut.origin, glyph);

  const Ram small(cut.part_bytes, cut.odd);
  Picture parts(cut.x0, cut.y0);
  const int32_t x = cut.x0 + cut.x_cut;
  const int32_t y = cut.y0 + cut.y_cut;
  const Rect windows[] = {{all.x0, all.y0, x, y},
                          {x, all.y0, all.x1, y},
                          {all.x0, y, x, all.y1},
                          {x, y, all.x1, all.y1}};
  for (const Rect& window : windows) {
    const Sink part = parts.sink(window, false);
    options.fill = parts.fill_sink(window);
    Painter(part, small.workspace()).glyph(font, style, cut.origin, glyph);
  }
  require(!is_exact || parts.equals(whole), "the same picture in windows");

  Picture blocks(cut.x0, cut.y0);
  const Ram ram(704 + 4 + cut.part_bytes % 512, cut.odd);
  PreparedGlyph prepared;
  const Status status = PreparedGlyph::make(font, glyph, style, cut.origin,
                                            ram.workspace(), prepared);
  if (status == Status::ok) {
    const Rect strips[] = {{all.x0, all.y0, all.x1, y},
                           {all.x0, y, all.x1, all.y1}};
    for (const Rect& window : strips) {
      const Sink part = blocks.sink(window, true);
      options.fill = blocks.fill_sink(window);
      prepared.draw(part);
    }
    require(!is_exact || blocks.equals(whole), "the same picture prepared");
  }
}

void check_generated_field(const Font& font,
                           uint16_t glyph,
                           const OutlineLook& look,
                           const OutlineCut& cut) {
  // From the finest to the coarsest, from the narrowest band to the widest.
  FieldLimits limits;
  limits.tolerance.raw = look.size_q6 < FieldLimits::kMinTolerance.raw
                             ? FieldLimits::kMinTolerance.raw
                             : look.size_q6;
  limits.band_u =
      static_cast<int32_t>(cut.whole_bytes % FieldLimits::kMaxBand) + 1;
  const Ram ram(4 * (cut.part_bytes % 1024), 0);
  const Workspace lent = ram.workspace();
  const Span<uint8_t> buffer = {lent.data, lent.size};
  GlyphField field;
  if (generate_field(font, glyph, limits, buffer, field) != Status::ok ||
      record_bytes(field) == 0) {
    return;
  }
  const size_t bytes = record_bytes(field);
  require(bytes <= buffer.size, "the field fits its buffer");
  GlyphField again;
  require(GlyphField::open({buffer.data, bytes}, again) == Status::ok,
          "the record opens");
  require(again.cells == field.cells, "the record is the field");
  const Style style(Q26_6::from_raw(look.size_q6), kFilterText);
  Picture picture(cut.x0, cut.y0);
  draw_field(field, style, cut.origin, picture.sink(picture.all(), false));
  for (int32_t i = 0; i < 16; ++i) {
    const auto x = Q16_16::from_int(field.x0_u + 61 * i);
    const auto y = Q16_16::from_int(field.y0_u + 37 * i);
    const int32_t distance = distance_at(field, x, y).raw;
    require(
        distance <= kSaturatedDistanceQ10 && distance >= -kSaturatedDistanceQ10,
        "distances are within bounds");
  }
}

}  // namespace hostile
