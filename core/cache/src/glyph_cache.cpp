#include "inkcell/cache/glyph_cache.hpp"

#include "base/math.hpp"
#include "glyph_store.hpp"
#include "row_codes.hpp"
#include "text/text_place.hpp"

namespace inkcell {

using detail::CachedGlyph;
using detail::GlyphStore;
using detail::kMostRowValues;
using detail::max;
using detail::min;
using detail::most_row_bytes;
using detail::Packing;
using detail::place_near;
using detail::Placed;
using detail::run_origin;
using detail::UnitScale;

namespace {

// Data is found by 16 bits.
constexpr size_t kMostBytes = 65535;

// Rows of a glyph: a byte counts them.
constexpr int32_t kMostRows = 255;

// Rows that are drawn at once, if there is room for them.
constexpr int32_t kRowsAtOnce = 32;

// One call of draw().
struct Call {
  GlyphStore* store;  // null: nothing is kept
  const Font& font;
  const Style& style;
  const Sink& sink;
  Workspace workspace;
  uint32_t slot = 0;
  uint32_t shift = 0;  // from px, Q10, to phases
  Packing packing = {8, 1};

  void open() noexcept {
    if (sink.coverage_rgb != nullptr && style.effect() != nullptr) {
      packing.channels = 3;
    }
    packing.bits = store->options().bits;
    shift = store->phase_shift();
    slot = store->slot_of(font, style, packing.channels);
  }
};

// Where a glyph is drawn: the pixel of its origin, and the phase in it.
struct Place {
  uint32_t shift;
  int32_t x;
  int32_t y;
  uint32_t x_phase;
  uint32_t y_phase;

  Place(const Placed& placed, uint32_t phase_shift) noexcept
      : shift(phase_shift) {
    const int32_t half = (1 << shift) >> 1;
    const int32_t x_q10 = placed.x_q10 + half;
    const int32_t y_q10 = placed.y_q10 + half;
    x = x_q10 >> 10;
    y = y_q10 >> 10;
    x_phase = (static_cast<uint32_t>(x_q10) & 1023) >> shift;
    y_phase = (static_cast<uint32_t>(y_q10) & 1023) >> shift;
  }

  // The origin of a glyph whose pixel is (`x_px`, `y_px`).
  Point origin(int32_t x_px, int32_t y_px) const noexcept {
    const auto at = [this](int32_t px, uint32_t phase) noexcept {
      return Q26_6::from_raw(px * 64 +
                             static_cast<int32_t>(phase << shift >> 4));
    };
    return {at(x_px, x_phase), at(y_px, y_phase)};
  }
};

// A sink of rows of bytes.
struct Recorder {
  uint8_t* rows;
  int32_t stride;
  Rect window;
  int32_t channels;

  uint8_t* at(int32_t x, int32_t y) const noexcept {
    return rows + (y - window.y0) * stride + (x - window.x0) * channels;
  }

  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    const auto& self = *static_cast<const Recorder*>(context);
    uint8_t* to = self.at(x, y);
    for (; count != 0; --count) {
      for (int32_t i = 0; i < self.channels; ++i) {
        *to++ = *coverage;
      }
      ++coverage;
    }
  }
  static void coverage_rgb(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* coverage,
                           int32_t count) {
    const auto& self = *static_cast<const Recorder*>(context);
    __builtin_memcpy(self.at(x, y), coverage, static_cast<size_t>(count) * 3);
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    const auto& self = *static_cast<const Recorder*>(context);
    __builtin_memset(self.at(x, y), 255,
                     static_cast<size_t>(count * self.channels));
  }
};

// Draws a glyph into an entry of its own; null if that does not fit. Whether it
// does depends on the glyph alone. Not inline: glyphs that are held do not need
// its part of the stack.
__attribute__((noinline)) const CachedGlyph* record(const Call& call,
                                                    uint32_t key,
                                                    const Point& origin,
                                                    const Rect& box) noexcept {
  GlyphStore& store = *call.store;
  const int32_t width = box.x1 - box.x0;
  const int32_t rows = box.y1 - box.y0;
  const int32_t stride = width * call.packing.channels;
  if (stride > kMostRowValues || rows > kMostRows ||
      box.x0 != static_cast<int16_t>(box.x0) ||
      box.y0 != static_cast<int16_t>(box.y0)) {
    return nullptr;
  }
  constexpr auto kEntry = static_cast<int32_t>(sizeof(CachedGlyph));
  const int32_t row_bytes = most_row_bytes(width, call.packing);
  // Rows that are drawn at once lie between the data and the entries. How many
  // they may be, and how many there is room for.
  const int32_t most =
      min(min(rows, kRowsAtOnce),
          (store.capacity() - rows * row_bytes - kEntry) / stride);
  if (most < 1) {
    return nullptr;
  }
  const auto fitting = [&]() noexcept {
    return (store.room() - kEntry - row_bytes) / stride;
  };
  const int32_t least = min(most, 2);
  while (fitting() < least && store.evict(0)) {
  }
  // Most of the room is for the data.
  const int32_t drawn = min(most, max(least, fitting() / 4));
  store.add({key, 0, 0, static_cast<int16_t>(box.x0),
             static_cast<int16_t>(box.y0), static_cast<uint8_t>(width),
             static_cast<uint8_t>(rows)});
  // They stay there, whatever is removed of both.
  uint8_t* const bytes = store.data_end() + store.room() - drawn * stride;
  Recorder recorder = {bytes, stride, box, call.packing.channels};
  Sink sink;
  sink.context = &recorder;
  sink.coverage = Recorder::coverage;
  sink.solid = Recorder::solid;
  sink.coverage_rgb =
      call.packing.channels == 1 ? nullptr : Recorder::coverage_rgb;
  int32_t last_bytes = 0;  // of the last group
  for (int32_t y = box.y0; y < box.y1; y += drawn) {
    recorder.window.y0 = y;
    recorder.window.y1 = min(y + drawn, box.y1);
    sink.window = recorder.window;
    __builtin_memset(bytes, 0, static_cast<size_t>(drawn * stride));
    draw_glyph(call.font, static_cast<uint16_t>(key), call.style, origin, sink,
               call.workspace);
    for (int32_t row = y; row < recorder.window.y1; ++row) {
      while (bytes - store.data_end() < row_bytes && store.evict(1)) {
      }
      uint8_t* const end = store.data_end();
      const auto added = static_cast<int32_t>(
          detail::record_row(recorder.at(box.x0, row), width, call.packing,
                             last_bytes == 0 ? nullptr : end - last_bytes,
                             end) -
          end);
      store.add_bytes(static_cast<size_t>(added));
      last_bytes = added == 0 ? last_bytes : added;
    }
  }
  return &store.last();
}

void draw_kept(const Call& call,
               const CachedGlyph& glyph,
               const Place& place) noexcept {
  const int32_t x = place.x + glyph.x0;
  const int32_t y = place.y + glyph.y0;
  detail::replay(call.store->begin_of(glyph), call.packing,
                 {x, y, x + glyph.width, y + glyph.rows}, call.sink);
}

// Draws a glyph that is not held into an entry; null: it is too large for one
// and was drawn, or it does not show.
__attribute__((noinline)) const CachedGlyph* draw_new(
    const Call& call, uint32_t key, const Place& place) noexcept {
  const auto glyph = static_cast<uint16_t>(key);
  if (call.store != nullptr) {
    const Point origin = place.origin(0, 0);
    const Rect box = glyph_box(call.font, glyph, call.style, origin);
    const Rect shown = {box.x0 + place.x, box.y0 + place.y, box.x1 + place.x,
                        box.y1 + place.y};
    if (is_empty(box) || is_empty(intersect(shown, call.sink.window))) {
      return nullptr;
    }
    const CachedGlyph* const kept = record(call, key, origin, box);
    call.store->count_drawn(kept != nullptr);
    if (kept != nullptr) {
      return kept;
    }
  }
  draw_glyph(call.font, glyph, call.style, place.origin(place.x, place.y),
             call.sink, call.workspace);
  return nullptr;
}

void draw_placed(const Call& call,
                 uint16_t glyph,
                 const Placed& placed) noexcept {
  const Place place(placed, call.shift);
  const uint32_t key =
      call.slot << 28 | place.y_phase << 22 | place.x_phase << 16 | glyph;
  const CachedGlyph* held =
      call.store == nullptr ? nullptr : call.store->find(key);
  if (held != nullptr) {
    call.store->count_hit();
  } else {
    held = draw_new(call, key, place);
    if (held == nullptr) {
      return;
    }
  }
  draw_kept(call, *held, place);
}

// Draws the glyphs that `next` gives, which `run` places. A call that draws
// none takes no slot from other styles.
template <typename Next>
void draw_run(Call&& call, const Face& run, Point origin, Next next) noexcept {
  PositionedGlyph at;
  if (!next(at)) {
    return;
  }
  if (call.store != nullptr) {
    call.open();
  }
  const UnitScale scale(*run.font, *run.style);
  origin = run_origin(*run.style, origin);
  Placed placed;
  do {
    if (place_near(scale, *run.style, origin, at, placed)) {
      draw_placed(call, at.glyph, placed);
    }
  } while (next(at));
}

}  // namespace

Status GlyphCache::make(Span<uint8_t> ram,
                        const GlyphCacheOptions& options,
                        GlyphCache& out) noexcept {
  const bool is_power = (options.phases & (options.phases - 1)) == 0;
  if ((options.bits != 4 && options.bits != 8) || options.phases == 0 ||
      options.phases > 64 || !is_power || options.styles == 0 ||
      options.styles > 16) {
    return Status::bad_argument;
  }
  if (reinterpret_cast<uintptr_t>(ram.data) % alignof(GlyphStore) != 0) {
    return Status::misaligned;
  }
  if (ram.size < options.styles * kMinBytes) {
    return Status::buffer_small;
  }
  out.store_ = reinterpret_cast<GlyphStore*>(ram.data);
  out.store_->open({ram.data, ram.size < kMostBytes ? ram.size : kMostBytes},
                   options);
  return Status::ok;
}

void GlyphCache::draw(const Font& font,
                      Span<const PositionedGlyph> glyphs,
                      const Style& style,
                      Point origin,
                      const Sink& sink,
                      Workspace workspace) noexcept {
  draw(Face{&font, &style}, {}, glyphs, origin, sink, workspace);
}

void GlyphCache::draw(const Face& face,
                      Span<const Face> fallback,
                      Span<const PositionedGlyph> glyphs,
                      Point origin,
                      const Sink& sink,
                      Workspace workspace) noexcept {
  // Face by face, so that each looks for its slot once.
  for (uint32_t i = 0; i <= fallback.size; ++i) {
    const Face& own = i == 0 ? face : fallback[i - 1];
    const PositionedGlyph* at = glyphs.begin();
    const auto next = [&](PositionedGlyph& out) noexcept {
      while (at != glyphs.end() && at->face != i) {
        ++at;
      }
      const bool is_glyph = at != glyphs.end();
      if (is_glyph) {
        out = *at++;
      }
      return is_glyph;
    };
    draw_run(Call{store_, *own.font, *own.style, sink, workspace}, face, origin,
             next);
  }
}

void GlyphCache::draw_text(const Font& font,
                           Text text,
                           const Style& style,
                           Point origin,
                           const Sink& sink,
                           Workspace workspace) noexcept {
  TextCursor cursor(font, text, style);
  draw_run(
      Call{store_, font, style, sink, workspace}, Face{&font, &style}, origin,
      [&cursor](PositionedGlyph& out) noexcept { return cursor.next(out); });
}

void GlyphCache::clear() noexcept {
  if (store_ != nullptr) {
    store_->clear();
  }
}

GlyphCacheStats GlyphCache::stats() const noexcept {
  return store_ == nullptr ? GlyphCacheStats{} : store_->stats();
}

}  // namespace inkcell
