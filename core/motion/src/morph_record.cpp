// Two tracks, one along each outline, go from piece to piece. A piece is a line
// or a quadratic curve on both; what is painted lies between them.
#include "morph_record.hpp"

#include "base/math.hpp"
#include "inkcell/format/rom.hpp"
#include "limits.hpp"
#include "outlines/record_bits.hpp"

namespace inkcell::motion {
namespace {

using detail::kCorner;
using detail::kOffCurve;
using detail::kStart;
using detail::product;
using detail::ScreenPoint;
using detail::sum;

namespace morphs = format::morphs;

struct Vertex {
  int32_t x_q8;
  int32_t y_q8;
};

Vertex vertex_of(const ScreenPoint& point) noexcept {
  return {point.x_q8, point.y_q8()};
}

Vertex middle(const Vertex& a, const Vertex& b) noexcept {
  return {sum(a.x_q8, b.x_q8) >> 1, sum(a.y_q8, b.y_q8) >> 1};
}

int32_t difference(int32_t a, int32_t b) noexcept {
  return detail::wrapped(static_cast<uint32_t>(a) - static_cast<uint32_t>(b));
}

// a + (b - a) part / 2^shift
Vertex between(const Vertex& a,
               const Vertex& b,
               int32_t part,
               int32_t shift) noexcept {
  return {sum(a.x_q8, product(difference(b.x_q8, a.x_q8), part) >> shift),
          sum(a.y_q8, product(difference(b.y_q8, a.y_q8), part) >> shift)};
}

class Bits {
 public:
  explicit Bits(const Span<const uint8_t>& bytes) noexcept : bytes_(bytes) {}

  // At most 16; 0 beyond the end.
  uint32_t take(uint32_t count) noexcept {
    if (count == 0 || bit_ >= 8 * bytes_.size) {
      return 0;
    }
    const uint32_t value = detail::bits_at(bytes_, bit_, count);
    bit_ += count;
    return value;
  }

 private:
  const Span<const uint8_t>& bytes_;
  uint32_t bit_ = 0;
};

// A line or a quadratic curve.
struct Curve {
  Vertex from;
  Vertex control;  // of a line: anywhere
  Vertex to;
  bool is_line;
};

// Along one outline, or at a point of the other's ink.
class Track {
 public:
  Vertex control;  // of the piece at hand
  Vertex at;       // its end
  bool is_line;
  bool is_cut;  // it jumps

  void begin(const MorphOutline& outline, Bits& bits, uint32_t width) noexcept {
    outline_ = &outline;
    is_point_ = false;
    jump(bits, width);
  }

  // The middle of a chord, where all pieces are.
  void begin_point(const MorphOutline& outline,
                   Bits& bits,
                   uint32_t width) noexcept {
    begin(outline, bits, width);
    const Vertex first = at;
    jump(bits, width);
    at = middle(first, at);
    is_point_ = true;
  }

  // The next piece.
  void move(Bits& bits, uint32_t width) noexcept {
    const Vertex from = at;
    is_line = true;
    is_cut = false;
    if (is_point_) {
      // There it stays.
    } else if (bits.take(1) == 0) {
      cut(8);
      step();
      return;
    } else if (bits.take(1) == 0) {
      // It stays.
    } else if (bits.take(1) == 0) {
      cut(static_cast<int32_t>(bits.take(morphs::kEighthBits)));
      return;
    } else {
      is_cut = true;
      jump(bits, width);
    }
    control = middle(from, at);
  }

 private:
  const ScreenPoint& point(int32_t i) const noexcept {
    return outline_->points[clamp(i, 0, outline_->count - 1)];
  }

  // The curve whose first point after its beginning has this number.
  Curve curve() const noexcept {
    const ScreenPoint& first = point(segment_);
    const ScreenPoint& before = point(segment_ - 1);
    Curve out;
    out.is_line = first.kind() != kOffCurve;
    out.from = vertex_of(before);
    out.control = vertex_of(first);
    out.to = out.control;
    if (!out.is_line) {
      if (before.kind() == kOffCurve) {
        out.from = middle(out.from, out.control);
      }
      const ScreenPoint& next = point(segment_ + 1);
      out.to = next.kind() == kOffCurve ? middle(out.control, vertex_of(next))
                                        : vertex_of(next);
    }
    return out;
  }

  // The point of a curve's parameters, in eighths, by its blossom.
  static Vertex on(const Curve& curve, int32_t s, int32_t t) noexcept {
    if (curve.is_line) {
      return between(curve.from, curve.to, t, 3);
    }
    return between(between(curve.from, curve.control, s, 3),
                   between(curve.control, curve.to, s, 3), t, 3);
  }

  // The piece from where the track is to an eighth of its segment.
  void cut(int32_t eighth) noexcept {
    const Curve all = curve();
    is_line = all.is_line;
    const int32_t from = eighth_;
    eighth_ = eighth;
    if (from == 0 && eighth == 8) {
      control = is_line ? middle(all.from, all.to) : all.control;
      at = all.to;
      return;
    }
    at = on(all, eighth, eighth);
    control = is_line ? middle(on(all, from, from), at) : on(all, from, eighth);
  }

  // To the next segment of the contour.
  void step() noexcept {
    const bool is_short = point(segment_).kind() != kOffCurve ||
                          point(segment_ + 1).kind() == kOffCurve;
    segment_ += is_short ? 1 : 2;
    eighth_ = 0;
    if (segment_ >= outline_->count || point(segment_).kind() == kStart) {
      do {
        --segment_;
      } while (segment_ > 0 && point(segment_).kind() != kStart);
      ++segment_;
    }
  }

  void jump(Bits& bits, uint32_t width) noexcept {
    segment_ = static_cast<int32_t>(bits.take(width));
    eighth_ = static_cast<int32_t>(bits.take(morphs::kEighthBits));
    at = on(curve(), eighth_, eighth_);
  }

  const MorphOutline* outline_;
  int32_t segment_;
  int32_t eighth_;
  bool is_point_;
};

// Of a contour that one glyph lacks: how large it is beside one that travels
// evenly. It appears within a 16th of the time.
constexpr int32_t kSizeLog2 = 6;
constexpr int32_t kWholeSize = 1 << kSizeLog2;

int32_t read_size(Bits& bits, int32_t since_q10) noexcept {
  const auto birth = static_cast<int32_t>(bits.take(morphs::kBirthBits));
  const auto swell = static_cast<int32_t>(bits.take(morphs::kSwellBits));
  const int32_t born = clamp(since_q10 - 64 * birth, 0, kWholeSize);
  // 64 half-way.
  const int32_t bulge = since_q10 * (1024 - since_q10) >> 12;
  return born * (256 + swell * bulge) >> 8;
}

// Resizes the contour about the middle of the box of its joints.
void resize(ScreenPoint* begin, const ScreenPoint* end, int32_t size) noexcept {
  Vertex low = vertex_of(*begin);
  Vertex high = low;
  for (const ScreenPoint* point = begin; point != end; ++point) {
    if (point->kind() != kOffCurve) {
      const Vertex at = vertex_of(*point);
      low = {min(low.x_q8, at.x_q8), min(low.y_q8, at.y_q8)};
      high = {max(high.x_q8, at.x_q8), max(high.y_q8, at.y_q8)};
    }
  }
  const Vertex centre = middle(low, high);
  for (; begin != end; ++begin) {
    const Vertex at = between(centre, vertex_of(*begin), size, kSizeLog2);
    *begin = ScreenPoint::at(at.x_q8, at.y_q8, begin->kind());
  }
}

// The glyphs in which a piece is a cut, a bit each.
uint32_t cuts_of(const Track& first, const Track& second) noexcept {
  return (first.is_cut ? 1u : 0u) | (second.is_cut ? 2u : 0u);
}

// Ends of a cut wait for an eighth of the time, or arrive an eighth early: what
// opens and closes moves fast.
int32_t cut_progress(int32_t progress_q10, uint32_t cuts) noexcept {
  const int32_t since = progress_q10 - ((cuts & 1) != 0 ? 128 : 0);
  return cuts == 0   ? progress_q10
         : cuts == 3 ? clamp(since * 1366 >> 10, 0, 1024)
                     : clamp(since * 1171 >> 10, 0, 1024);
}

// Whether a piece is a cut that is closed now; a cut of both glyphs always is.
// Its two sides coincide, and no line is drawn along them: painters of
// distances would show it.
bool is_closed(int32_t progress_q10, uint32_t cuts) noexcept {
  return cuts == 3 || (cuts == 1 && progress_q10 <= 128) ||
         (cuts == 2 && progress_q10 >= 896);
}

struct Ends {
  Vertex first;
  Vertex second;

  ScreenPoint at(int32_t progress_q10, uint32_t kind) const noexcept {
    const Vertex at = between(first, second, progress_q10, 10);
    return ScreenPoint::at(at.x_q8, at.y_q8, kind);
  }
};

}  // namespace

ScreenPoint* write_morph(const Span<const uint8_t>& record,
                         const MorphOutline (&outlines)[2],
                         int32_t progress_q10,
                         ScreenPoint* out,
                         int32_t room) noexcept {
  if (outlines[0].count == 0 || outlines[1].count == 0) {
    return out;
  }
  Bits bits(record);
  const uint32_t width = bits.take(morphs::kPointWidthBits);
  Track first;
  Track second;
  for (;;) {
    const uint32_t kind = bits.take(morphs::kKindBits);
    if (kind == morphs::kEnd) {
      return out;
    }
    uint32_t pieces = bits.take(morphs::kPieceCountBits);
    int32_t size = kWholeSize;
    if (kind == morphs::kSecondOnly) {
      first.begin_point(outlines[0], bits, width);
      size = read_size(bits, progress_q10);
    } else {
      first.begin(outlines[0], bits, width);
    }
    if (kind == morphs::kFirstOnly) {
      second.begin_point(outlines[1], bits, width);
      size = read_size(bits, 1024 - progress_q10);
    } else {
      second.begin(outlines[1], bits, width);
    }
    if (pieces == 0) {
      continue;
    }
    room -= 1 + 2 * static_cast<int32_t>(pieces);
    if (room < 0) {
      return nullptr;
    }
    ScreenPoint* const start = out++;
    const Ends start_ends = {first.at, second.at};
    uint32_t start_cuts = 0;
    uint32_t last_cuts = 0;
    for (; pieces != 0; --pieces) {
      // The joint between the last piece and this one is known now.
      ScreenPoint& joint = out[-1];
      const Ends ends = {first.at, second.at};
      first.move(bits, width);
      second.move(bits, width);
      const uint32_t cuts = cuts_of(first, second);
      if (&joint == start) {
        start_cuts = cuts;
      }
      joint = ends.at(cut_progress(progress_q10, last_cuts | cuts),
                      is_closed(progress_q10, last_cuts) ? kStart : kCorner);
      if ((!first.is_line || !second.is_line) &&
          !is_closed(progress_q10, cuts)) {
        *out++ = Ends{first.control, second.control}.at(
            cut_progress(progress_q10, cuts), kOffCurve);
      }
      ++out;
      last_cuts = cuts;
    }
    // Closed, whatever the record says.
    const int32_t part = cut_progress(progress_q10, start_cuts | last_cuts);
    *start = start_ends.at(part, kStart);
    if (is_closed(progress_q10, last_cuts)) {
      --out;
    } else {
      out[-1] = start_ends.at(part, kCorner);
    }
    if (size == 0) {
      out = start;
    } else if (size != kWholeSize) {
      resize(start, out, size);
    }
  }
}

}  // namespace inkcell::motion
