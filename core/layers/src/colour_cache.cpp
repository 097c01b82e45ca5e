#include "inkcell/layers/colour_cache.hpp"

#include "base/math.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "layer_call.hpp"
#include "layer_table.hpp"
#include "picture_rows.hpp"

namespace inkcell {
namespace detail {
namespace {

// A quarter of a pixel. [px, Q10, as a power of 2]
constexpr uint8_t kPicturePhase = 8;

// Sides of a picture: bytes count them.
constexpr int32_t kMostPictureSide = 255;

// The most bytes of a row: pieces of one pixel, mixed and others by turns.
constexpr int32_t kMostPixelBytes = 6;
// What is reckoned with for all rows.
constexpr int32_t kPixelBytes = 3;

// A picture in the RAM, before its pieces.
struct __attribute__((may_alias)) KeptPicture {
  uint32_t key;
  uint32_t used;   // when
  uint16_t words;  // of 4 bytes, with this
  // Its pixels, from that of its origin.
  int16_t x0;
  int16_t y0;
  uint8_t width;
  uint8_t rows;
};

constexpr auto kPictureHead = static_cast<int32_t>(sizeof(KeptPicture));

}  // namespace

// What a ColourCache does.
class ColourPictures {
 public:
  static bool draw(const LayerCall& call) noexcept {
    ColourPictures self(call);
    return self.draw_or_record();
  }

 private:
  explicit ColourPictures(const LayerCall& call) noexcept
      : call_(call), cache_(*call.glyphs.pictures_) {}

  const CanvasColour& canvas() const noexcept { return call_.glyphs.canvas_; }
  const Sink& sink() const noexcept { return call_.run.painter.sink(); }
  int32_t room() const noexcept {
    return static_cast<int32_t>(cache_.size_ - cache_.used_);
  }
  KeptPicture& picture_at(uint32_t at) const noexcept {
    return *reinterpret_cast<KeptPicture*>(cache_.data_ + at);
  }

  bool draw_or_record() noexcept {
    const Style& style = *call_.run.style;
    if (cache_.data_ == nullptr || canvas().put == nullptr ||
        sink().context != canvas().canvas || style.effect() != nullptr) {
      return false;
    }
    renew(style);
    const uint32_t shift = call_.glyphs.phase_shift;
    const int32_t x = call_.at.x_q10 >> 10;
    const int32_t y = call_.at.y_q10 >> 10;
    const auto phase = [shift](int32_t q10) noexcept {
      return static_cast<uint32_t>(q10 & 1023) >> shift;
    };
    const uint32_t key =
        phase(call_.at.y_q10) << 24 | phase(call_.at.x_q10) << 16 | call_.glyph;
    const KeptPicture* kept = find(key);
    if (kept != nullptr) {
      ++cache_.hits_;
    } else {
      kept = make(key, x, y);
      if (kept == nullptr) {
        return false;
      }
    }
    const int32_t x0 = x + kept->x0;
    const int32_t y0 = y + kept->y0;
    canvas().put(canvas().canvas,
                 {reinterpret_cast<const uint16_t*>(kept + 1),
                  {x0, y0, x0 + kept->width, y0 + kept->rows}},
                 sink().window);
    return true;
  }

  // A new picture of a glyph whose origin is at (x, y); null: it is drawn in
  // another way. Not inline: pictures that are held do not need its part of the
  // stack.
  __attribute__((noinline)) const KeptPicture* make(uint32_t key,
                                                    int32_t x,
                                                    int32_t y) const noexcept {
    const LayerTable table(*call_.run.font, call_.glyphs.stored_);
    const LayerTable::Range range = table.layers_of(call_.glyph);
    const Rect box = box_of(call_.run, call_.glyph, call_.at);
    if (range.first == range.end || is_empty(intersect(box, sink().window))) {
      return nullptr;
    }
    const KeptPicture* const kept =
        has_own_colours(table, range)
            ? record(key, {box.x0 - x, box.y0 - y, box.x1 - x, box.y1 - y},
                     table, range)
            : nullptr;
    ++(kept == nullptr ? cache_.bypasses_ : cache_.misses_);
    return kept;
  }

  // Empties a cache of other pictures.
  void renew(const Style& style) noexcept {
    const ColourGlyphs& glyphs = call_.glyphs;
    const uint8_t* const rom = call_.run.font->rom().data;
    if (cache_.rom_ != rom || cache_.palette_ != glyphs.palette_ ||
        cache_.colours_ != glyphs.colours_.data ||
        cache_.colour_count_ != glyphs.colours_.size ||
        !is_same(cache_.style_, style)) {
      cache_.clear();
      cache_.rom_ = rom;
      cache_.palette_ = glyphs.palette_;
      cache_.colours_ = glyphs.colours_.data;
      cache_.colour_count_ = glyphs.colours_.size;
      cache_.style_ = style;
    }
  }

  static bool has_own_colours(const LayerTable& table,
                              const LayerTable::Range& range) noexcept {
    for (uint32_t i = range.first; i != range.end; ++i) {
      if (table.layer(i).colour >= table.colours) {
        return false;
      }
    }
    return true;
  }

  const KeptPicture* find(uint32_t key) const noexcept {
    for (uint32_t at = 0; at != cache_.used_;) {
      KeptPicture& picture = picture_at(at);
      if (picture.key == key) {
        picture.used = ++cache_.clock_;
        return &picture;
      }
      at += 4u * picture.words;
    }
    return nullptr;
  }

  // Removes the picture that was drawn longest ago, of those before `end`.
  uint32_t evict(uint32_t end) const noexcept {
    uint32_t oldest = 0;
    for (uint32_t at = 0; at != end; at += 4u * picture_at(at).words) {
      if (cache_.clock_ - picture_at(at).used >
          cache_.clock_ - picture_at(oldest).used) {
        oldest = at;
      }
    }
    const uint32_t bytes = 4u * picture_at(oldest).words;
    cache_.used_ -= bytes;
    __builtin_memmove(cache_.data_ + oldest, cache_.data_ + oldest + bytes,
                      cache_.used_ - oldest);
    return bytes;
  }

  // Draws a picture into the cache; null: it is too large.
  const KeptPicture* record(uint32_t key,
                            const Rect& box,
                            const LayerTable& table,
                            const LayerTable::Range& range) const noexcept {
    const int32_t width = box.x1 - box.x0;
    const int32_t rows = box.y1 - box.y0;
    if (width > kMostPictureSide || rows > kMostPictureSide ||
        box.x0 != static_cast<int16_t>(box.x0) ||
        box.y0 != static_cast<int16_t>(box.y0)) {
      return nullptr;
    }
    const int32_t row_bytes = kPaintBytes * width;
    const int32_t pieces_bytes =
        kPictureHead + (rows * kPixelBytes + kMostPixelBytes) * width + 4;
    const auto size = static_cast<int32_t>(cache_.size_);
    if (size < pieces_bytes + row_bytes) {
      return nullptr;
    }
    while (room() < min(size, pieces_bytes + rows * row_bytes)) {
      evict(cache_.used_);
    }
    const int32_t drawn = min(rows, (room() - pieces_bytes) / row_bytes);
    const uint32_t begin = cache_.used_;
    KeptPicture& picture = picture_at(begin);
    picture = {key,
               ++cache_.clock_,
               0,
               static_cast<int16_t>(box.x0),
               static_cast<int16_t>(box.y0),
               static_cast<uint8_t>(width),
               static_cast<uint8_t>(rows)};
    uint8_t* const paint = cache_.data_ + (cache_.size_ & ~3u) -
                           static_cast<uint32_t>(drawn * row_bytes);
    auto* pieces = reinterpret_cast<uint16_t*>(&picture + 1);
    for (int32_t y = box.y0; y < box.y1; y += drawn) {
      const Rect band = {box.x0, y, box.x1, min(y + drawn, box.y1)};
      draw_rows(paint, band, table, range);
      for (int32_t row = 0; row != band.y1 - band.y0; ++row) {
        if (paint - reinterpret_cast<uint8_t*>(pieces) <
            kMostPixelBytes * width + 4) {
          return nullptr;
        }
        pieces = PieceWriter(canvas(), paint + row * row_bytes, width, pieces)
                     .write();
      }
    }
    const auto bytes = static_cast<uint32_t>(
        reinterpret_cast<uint8_t*>(pieces) - (cache_.data_ + begin));
    picture.words = static_cast<uint16_t>((bytes + 3) / 4);
    cache_.used_ += 4u * picture.words;
    return &picture;
  }

  // Draws all layers into rows of pixels.
  void draw_rows(uint8_t* paint,
                 const Rect& band,
                 const LayerTable& table,
                 const LayerTable::Range& range) const noexcept {
    const int32_t width = band.x1 - band.x0;
    __builtin_memset(
        paint, 0,
        static_cast<size_t>(kPaintBytes * width * (band.y1 - band.y0)));
    PaintRows rows = {paint, width, band};
    Sink to;
    to.window = band;
    to.context = &rows;
    to.coverage = PaintRows::coverage;
    to.solid = PaintRows::solid;
    const Painter painter(to, call_.run.painter.ram());
    const Point origin = {Q26_6::from_raw((call_.at.x_q10 & 1023) >> 4),
                          Q26_6::from_raw((call_.at.y_q10 & 1023) >> 4)};
    for (uint32_t i = range.first; i != range.end; ++i) {
      const Layer layer = table.layer(i);
      rows.set_colour(call_.glyphs.colour_of(table, layer.colour));
      painter.glyph(*call_.run.font, *call_.run.style, origin, layer.glyph);
    }
  }

  const LayerCall& call_;
  ColourCache& cache_;
};

}  // namespace detail

ColourGlyphs& ColourGlyphs::set_cache(ColourCache& cache) noexcept {
  pictures_ = &cache;
  draw_picture_ = detail::ColourPictures::draw;
  if (phase_shift == 0) {
    phase_shift = detail::kPicturePhase;
  }
  return *this;
}

Status ColourCache::make(Span<uint8_t> ram, ColourCache& out) noexcept {
  if (reinterpret_cast<uintptr_t>(ram.data) % 4 != 0) {
    return Status::misaligned;
  }
  if (ram.size < kMinBytes) {
    return Status::buffer_small;
  }
  constexpr size_t kMostBytes = 65532;
  ColourCache made;
  made.data_ = ram.data;
  made.size_ =
      static_cast<uint32_t>(ram.size < kMostBytes ? ram.size : kMostBytes) &
      ~3u;
  out = made;
  return Status::ok;
}

ColourCacheStats ColourCache::stats() const noexcept {
  ColourCacheStats stats = {hits_, misses_, bypasses_, 0, used_};
  for (uint32_t at = 0; at != used_; ++stats.glyphs) {
    at += 4u * reinterpret_cast<const detail::KeptPicture*>(data_ + at)->words;
  }
  return stats;
}

}  // namespace inkcell
