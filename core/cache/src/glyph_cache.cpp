#include "inkcell/cache/glyph_cache.hpp"

#include "base/math.hpp"
#include "glyph_store.hpp"
#include "inkcell/assert.hpp"
#include "row_codes.hpp"
#include "rows/source.hpp"
#include "text/glyph_run.hpp"

namespace inkcell {

using detail::CachedGlyph;
using detail::GlyphRun;
using detail::GlyphStore;
using detail::kMostRowValues;
using detail::max;
using detail::min;
using detail::most_row_bytes;
using detail::Packing;
using detail::Placed;

namespace {

// Data is found by 16 bits.
constexpr size_t kMostBytes = 65535;

// Rows of a glyph: a byte counts them.
constexpr int32_t kMostRows = 255;

// Rows that are drawn at once, if there is room for them.
constexpr int32_t kRowsAtOnce = 32;

// A glyph of a run to draw.
struct Call {
  GlyphStore& store;
  GlyphRun& run;
  Packing packing = {8, 1};

  const Sink& sink() const noexcept { return run.painter.sink(); }

  Call(GlyphStore& cache, GlyphRun& glyphs) noexcept
      : store(cache), run(glyphs) {
    if (sink().coverage_rgb != nullptr && run.style->effect() != nullptr) {
      packing.channels = 3;
    }
    packing.bits = store.options().bits;
    if (run.state == 0) {
      run.state = store.slot_of(*run.font, *run.style, packing.channels) + 1;
    }
  }
  uint32_t slot() const noexcept { return run.state - 1; }
};

// Where a glyph is drawn: the pixel of its origin, and the phase in it. [Q10]
struct GlyphPlace {
  int32_t x;
  int32_t y;
  int32_t x_q10;
  int32_t y_q10;

  explicit GlyphPlace(const Placed& at) noexcept
      : x(at.x_q10 >> 10),
        y(at.y_q10 >> 10),
        x_q10(at.x_q10 & 1023),
        y_q10(at.y_q10 & 1023) {}

  // Phases are at least 1/64 px.
  Point origin() const noexcept {
    return {Q26_6::from_raw(x_q10 >> 4), Q26_6::from_raw(y_q10 >> 4)};
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
  GlyphStore& store = call.store;
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
    Painter(sink, call.run.painter.ram())
        .glyph(*call.run.font, *call.run.style, origin,
               static_cast<uint16_t>(key));
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

// Draws a glyph that is not held into an entry; null: it is too large for one
// and was drawn, or it does not show.
__attribute__((noinline)) const CachedGlyph* draw_new(
    const Call& call, uint32_t key, const Placed& at) noexcept {
  const auto glyph = static_cast<uint16_t>(key);
  const Rect shown = detail::box_of(call.run, glyph, at);
  if (is_empty(intersect(shown, call.sink().window))) {
    INKCELL_ASSERT(call.run.font->check(*call.run.style) == Status::ok);
    return nullptr;
  }
  const GlyphPlace place(at);
  const CachedGlyph* const kept =
      record(call, key, place.origin(),
             {shown.x0 - place.x, shown.y0 - place.y, shown.x1 - place.x,
              shown.y1 - place.y});
  call.store.count_drawn(kept != nullptr);
  if (kept == nullptr) {
    detail::draw_plain(call.run, glyph, at);
  }
  return kept;
}

}  // namespace

void GlyphCache::draw_kept(GlyphRun& run,
                           uint16_t glyph,
                           const Placed& placed) noexcept {
  const auto& self = static_cast<const GlyphCache&>(run.painter.drawer());
  const detail::Source* const source = run.font->source();
  // Pictures that a font has anyway are not kept once more.
  if (self.store_ == nullptr || source == nullptr ||
      source->kind == detail::SourceKind::strikes) {
    detail::draw_plain(run, glyph, placed);
    return;
  }
  const Call call(*self.store_, run);
  const uint32_t shift = self.phase_shift;
  const Placed at = detail::at_phase(placed, shift);
  const GlyphPlace place(at);
  const uint32_t key =
      call.slot() << 28 | static_cast<uint32_t>(place.y_q10) >> shift << 22 |
      static_cast<uint32_t>(place.x_q10) >> shift << 16 | glyph;
  const CachedGlyph* held = call.store.find(key);
  if (held != nullptr) {
    call.store.count_hit();
  } else {
    held = draw_new(call, key, at);
    if (held == nullptr) {
      return;
    }
  }
  const int32_t x = place.x + held->x0;
  const int32_t y = place.y + held->y0;
  detail::replay(call.store.begin_of(*held), call.packing,
                 {x, y, x + held->width, y + held->rows}, call.sink());
}

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
  GlyphCache made;
  made.store_ = reinterpret_cast<GlyphStore*>(ram.data);
  made.store_->open({ram.data, ram.size < kMostBytes ? ram.size : kMostBytes},
                    options);
  made.phase_shift = static_cast<uint8_t>(made.store_->phase_shift());
  out = made;
  return Status::ok;
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
