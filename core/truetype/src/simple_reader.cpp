#include "simple_reader.hpp"

#include "base/math.hpp"

namespace inkcell::detail {
namespace {

// Of a point.
enum PointFlag : uint32_t {
  kPointOn = 1,
  kPointShortX = 2,
  kPointShortY = 4,
  kPointRepeat = 8,
  kPointSameX = 16,  // of a short one: positive
  kPointSameY = 32,
};

// The bytes that the flag of a point says x takes, or shifted by one y.
uint32_t step_bytes_of(uint32_t flag) noexcept {
  return (flag & kPointShortX) != 0 ? 1 : ~flag >> 3 & 2;
}

// The next byte of a stream: where there is one at least, or 0 at the end.
struct AnyByte {
  uint32_t operator()(const uint8_t*& at) const noexcept { return *at++; }
};
struct CheckedByte {
  const uint8_t* end;
  uint32_t operator()(const uint8_t*& at) const noexcept {
    return at != end ? *at++ : 0;
  }
};

// A step along x, or with a flag that is shifted by one along y.
template <typename NextByte>
inline int32_t step_of(uint32_t flag,
                       const NextByte& next,
                       const uint8_t*& at) noexcept {
  const auto first = static_cast<int32_t>(next(at));
  if ((flag & kPointShortX) != 0) {
    return (flag & kPointSameX) != 0 ? first : -first;
  }
  return static_cast<int16_t>(static_cast<uint32_t>(first) << 8 | next(at));
}

}  // namespace

bool SimpleReader::begin(const Table& file,
                         const Table& record,
                         int16_t& budget) noexcept {
  contours_ = 0;
  is_open_ = false;
  const uint32_t contours = u16_at(record, kRecordContours);
  const uint32_t hints = kRecordBytes + 2 * contours;
  const uint32_t points = u16_at(record, hints - 2) + 1;
  const uint32_t flags = hints + 2 + u16_at(record, hints);
  const auto cost = static_cast<int32_t>(points + 2 * contours);
  if (contours == 0 || flags >= record.size || cost > budget) {
    return false;
  }
  const uint8_t* at = record.data + flags;
  const uint8_t* const end = record.data + record.size;
  uint32_t x_bytes = 0;
  uint32_t y_bytes = 0;
  for (uint32_t left = points; left != 0;) {
    if (at == end) {
      return false;
    }
    const uint32_t flag = *at++;
    uint32_t count = 1;
    if ((flag & kPointRepeat) != 0) {
      if (at == end) {
        return false;
      }
      count += *at++;
    }
    if (count > left) {
      return false;
    }
    left -= count;
    x_bytes += step_bytes_of(flag) * count;
    y_bytes += step_bytes_of(flag >> 1) * count;
  }
  if (static_cast<uint32_t>(end - at) < x_bytes + y_bytes) {
    return false;
  }
  budget = static_cast<int16_t>(budget - cost);
  end_ = file.data + file.size;
  ends_ = record.data + kRecordBytes;
  flags_ = record.data + flags;
  xs_ = at;
  ys_ = at + x_bytes;
  contours_ = static_cast<uint16_t>(contours);
  points_ = static_cast<uint16_t>(points);
  next_ = 0;
  repeats_ = 0;
  return true;
}

// Writes `count` points.
template <typename NextByte>
inline void SimpleReader::take_by(const NextByte& next,
                                  const OutlineMap& map,
                                  ScreenPoint* out,
                                  int32_t count) noexcept {
  const OutlineMap::Axis& right = map.axes[0];
  const OutlineMap::Axis& down = map.axes[1];
  const uint8_t* flags = flags_;
  const uint8_t* xs = xs_;
  const uint8_t* ys = ys_;
  uint32_t flag = flag_;
  uint32_t repeats = repeats_;
  uint32_t x_q18 = x_q18_;
  uint32_t y_q18 = y_q18_;
  for (ScreenPoint* const stop = out + count; out != stop; ++out) {
    if (repeats != 0) {
      --repeats;
    } else {
      flag = next(flags);
      if ((flag & kPointRepeat) != 0) {
        repeats = next(flags);
      }
    }
    if ((flag & (kPointShortX | kPointSameX)) != kPointSameX) {
      const auto dx = static_cast<uint32_t>(step_of(flag, next, xs));
      x_q18 += dx * static_cast<uint32_t>(right.per_x);
      y_q18 += dx * static_cast<uint32_t>(down.per_x);
    }
    if ((flag & (kPointShortY | kPointSameY)) != kPointSameY) {
      const auto dy = static_cast<uint32_t>(step_of(flag >> 1, next, ys));
      x_q18 += dy * static_cast<uint32_t>(right.per_y);
      y_q18 += dy * static_cast<uint32_t>(down.per_y);
    }
    *out = ScreenPoint::at(static_cast<int32_t>(x_q18) >> 10,
                           static_cast<int32_t>(y_q18) >> 10,
                           (flag & kPointOn) != 0 ? kCorner : kOffCurve);
  }
  flags_ = flags;
  xs_ = xs;
  ys_ = ys;
  flag_ = static_cast<uint8_t>(flag);
  repeats_ = static_cast<uint8_t>(repeats);
  x_q18_ = x_q18;
  y_q18_ = y_q18;
}

// The same: most points are far from the end of the file.
inline void SimpleReader::take(const OutlineMap& map,
                               ScreenPoint* out,
                               int32_t count) noexcept {
  while (!kIsSmall && count != 0) {
    const uint8_t* const last = flags_ > xs_ ? flags_ : xs_;
    const auto sure =
        static_cast<int32_t>((end_ - (last > ys_ ? last : ys_)) / 2);
    if (sure <= 0) {
      break;
    }
    const int32_t now = min(sure, count);
    take_by(AnyByte(), map, out, now);
    out += now;
    count -= now;
  }
  if (kIsSmall || __builtin_expect(count != 0, 0)) {
    take_by(CheckedByte{end_}, map, out, count);
  }
}

// Sets left_; 0: the contour does not fit, and no more come.
inline void SimpleReader::open_contour() noexcept {
  const int32_t end = ends_[0] << 8 | ends_[1];
  const int32_t count = end + 1 - next_;
  ends_ += 2;
  --contours_;
  is_open_ = true;
  has_tail_ = false;
  if (count <= 0 || count > points_) {
    contours_ = 0;
    is_open_ = false;
    left_ = 0;
    return;
  }
  left_ = static_cast<uint16_t>(count);
  points_ = static_cast<uint16_t>(points_ - count);
  next_ = static_cast<uint16_t>(end + 1);
}

ScreenPoint* SimpleReader::read(const OutlineMap& map,
                                ScreenPoint* out,
                                int32_t room) noexcept {
  ScreenPoint* const last = out + room;
  while (last - out >= kLeastRoom && !has_ended()) {
    const bool is_first = !is_open_;
    if (is_first) {
      open_contour();
    }
    const int32_t count = min(left_, static_cast<int32_t>(last - out));
    take(map, out, count);
    left_ = static_cast<uint16_t>(left_ - count);
    if (is_first && count != 0) {
      // A contour that begins with a control point begins at the next point, or
      // in the middle of two; that control point comes last.
      if (out->kind() == kOffCurve && count != 1) {
        has_tail_ = true;
        tail_ = out[0];
        out[0] =
            out[1].kind() != kOffCurve
                ? out[1]
                : ScreenPoint::at((tail_.x_q8 + out[1].x_q8) >> 1,
                                  (tail_.y_q8() + out[1].y_q8()) >> 1, kCorner);
      }
      start_ = {out->x_q8, (out->y_q8_kind & ~3) | int32_t{kCorner}};
      out->y_q8_kind |= int32_t{kStart};
    }
    out += count;
    if (is_open_ && left_ == 0 && last - out >= kLeastRoom) {
      if (has_tail_) {
        *out++ = tail_;
      }
      *out++ = start_;
      is_open_ = false;
    }
  }
  return out;
}

}  // namespace inkcell::detail
