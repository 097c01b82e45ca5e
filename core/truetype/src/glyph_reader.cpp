#include "glyph_reader.hpp"

#include "base/math.hpp"
#include "place/style_parts.hpp"

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

// Of a component.
enum PartFlag : uint32_t {
  kPartWords = 1,
  kPartOffsets = 2,
  kPartScale = 8,
  kPartMore = 32,
  kPartTwoScales = 64,
  kPartMatrix = 128,
};

// The bytes that the flag of a point says x takes, or shifted by one y.
uint32_t step_bytes_of(uint32_t flag) noexcept {
  return (flag & kPointShortX) != 0 ? 1 : ~flag >> 3 & 2;
}

// A step along x, or with a flag that is shifted by one along y.
__attribute__((always_inline)) inline int32_t step_of(
    uint32_t flag, const uint8_t*& at) noexcept {
  if ((flag & kPointShortX) != 0) {
    const int32_t step = *at++;
    return (flag & kPointSameX) != 0 ? step : -step;
  }
  const int32_t step = static_cast<int16_t>(at[0] << 8 | at[1]);
  at += 2;
  return step;
}

int32_t units_moved(const OutlineMap::Axis& axis,
                    int32_t x,
                    int32_t y) noexcept {
  return sum(product(x, axis.per_x), product(y, axis.per_y));
}

// Copies up to two bytes, zeros behind the end.
void copy_two(const uint8_t* from, const uint8_t* end, uint8_t* to) noexcept {
  to[0] = from < end ? from[0] : uint8_t{0};
  to[1] = end - from > 1 ? from[1] : uint8_t{0};
}

}  // namespace

bool SimpleReader::begin(const Table& file,
                         const Table& record,
                         int32_t& budget) noexcept {
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
  budget -= cost;
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
inline void SimpleReader::take(const OutlineMap& map,
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
  while (count != 0) {
    // Near the end of the file points are read from a copy, one at a time.
    uint8_t copy[6];
    const uint8_t* const last = flags > xs ? flags : xs;
    auto safe = static_cast<int32_t>((end_ - (last > ys ? last : ys)) / 2);
    const bool is_copied = safe <= 0;
    if (__builtin_expect(is_copied, 0)) {
      copy_two(flags, end_, copy);
      copy_two(xs, end_, copy + 2);
      copy_two(ys, end_, copy + 4);
      flags_ = flags;
      xs_ = xs;
      ys_ = ys;
      flags = copy;
      xs = copy + 2;
      ys = copy + 4;
      safe = 1;
    }
    safe = min(safe, count);
    count -= safe;
    for (ScreenPoint* const stop = out + safe; out != stop; ++out) {
      if (repeats != 0) {
        --repeats;
      } else {
        flag = *flags++;
        if ((flag & kPointRepeat) != 0) {
          repeats = *flags++;
        }
      }
      if ((flag & (kPointShortX | kPointSameX)) != kPointSameX) {
        const auto dx = static_cast<uint32_t>(step_of(flag, xs));
        x_q18 += dx * static_cast<uint32_t>(right.per_x);
        y_q18 += dx * static_cast<uint32_t>(down.per_x);
      }
      if ((flag & (kPointShortY | kPointSameY)) != kPointSameY) {
        const auto dy = static_cast<uint32_t>(step_of(flag >> 1, ys));
        x_q18 += dy * static_cast<uint32_t>(right.per_y);
        y_q18 += dy * static_cast<uint32_t>(down.per_y);
      }
      *out = ScreenPoint::at(static_cast<int32_t>(x_q18) >> 10,
                             static_cast<int32_t>(y_q18) >> 10,
                             (flag & kPointOn) != 0 ? kCorner : kOffCurve);
    }
    if (__builtin_expect(is_copied, 0)) {
      const auto passed = [this](const uint8_t* from, const uint8_t* at,
                                 const uint8_t* begin) noexcept {
        return end_ - from < at - begin ? end_ : from + (at - begin);
      };
      flags = passed(flags_, flags, copy);
      xs = passed(xs_, xs, copy + 2);
      ys = passed(ys_, ys, copy + 4);
    }
  }
  flags_ = flags;
  xs_ = xs;
  ys_ = ys;
  flag_ = static_cast<uint8_t>(flag);
  repeats_ = static_cast<uint8_t>(repeats);
  x_q18_ = x_q18;
  y_q18_ = y_q18;
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

bool TrueTypeGlyph::find(const Font& font,
                         uint16_t glyph,
                         const Style& style,
                         InkEnds (&ink)[2],
                         bool& is_mirrored) noexcept {
  face_ = &TrueTypeFont::face_of(font);
  record_ = record_of(*face_, glyph);
  if (record_.size == 0) {
    return false;
  }
  const uint32_t em = font.units_per_em();
  const auto size_q18 = static_cast<uint32_t>(style.size().raw) << 12;
  const auto scale = static_cast<int32_t>((size_q18 + em / 2) / em);
  map_ = {{{scale, 0}, {0, -scale}}};
  // Filled areas lie to the right, and y leads down.
  is_mirrored =
      style.is_upright() || !StyleParts::slant(style).map(style, map_);
  const int32_t x_min = i16_at(record_, kRecordBox);
  const int32_t y_min = i16_at(record_, kRecordBox + 2);
  const int32_t width = i16_at(record_, kRecordBox + 4) - x_min;
  const int32_t height = i16_at(record_, kRecordBox + 6) - y_min;
  const int32_t left = left_bearing_of(*face_, glyph);
  shift_ = left - x_min;
  for (int32_t i = 0; i != 2; ++i) {
    const OutlineMap::Axis& axis = map_.axes[i];
    InkEnds& ends = ink[i];
    ends.low = ends.high = units_moved(axis, left, y_min);
    const int32_t sides[] = {product(width, axis.per_x),
                             product(height, axis.per_y)};
    for (const int32_t side : sides) {
      int32_t& end = side < 0 ? ends.low : ends.high;
      end = sum(end, side);
    }
  }
  return true;
}

// True: the reader has a simple glyph.
bool TrueTypeGlyph::begin_record(const Table& record,
                                 const OutlineMap& map,
                                 const int32_t (&origin_q18)[2]) noexcept {
  if (i16_at(record, kRecordContours) < 0) {
    if (depth_ != kDepth) {
      work_.frames[depth_++] = {
          part_of(record, kRecordBytes), map, {origin_q18[0], origin_q18[1]}};
    }
    return false;
  }
  part_map_ = map;
  work_.reader.set_pen(origin_q18);
  return work_.reader.begin(face_->file, record, budget_);
}

// Goes to the next simple component. False: there are no more.
bool TrueTypeGlyph::next_part() noexcept {
  while (depth_ != 0 && parts_ != kMostParts) {
    Frame& frame = work_.frames[depth_ - 1];
    const Table part = frame.rest;
    if (part.size < 6) {
      --depth_;
      continue;
    }
    ++parts_;
    const uint32_t flags = u16_at(part, 0);
    const uint32_t glyph = u16_at(part, 2);
    uint32_t at = 4;
    const auto number = [&part, &at]() noexcept {
      at += 2;
      return i16_at(part, at - 2);
    };
    int32_t dx = number();
    int32_t dy;
    if ((flags & kPartWords) != 0) {
      dy = number();
    } else {
      dy = static_cast<int8_t>(dx);
      dx >>= 8;
    }
    if ((flags & kPartOffsets) == 0) {
      // Parts whose points are to meet stay where they are: no font of 605 has
      // some.
      dx = 0;
      dy = 0;
    }
    constexpr int32_t kOne = 1 << 14;
    int32_t xx = kOne;
    int32_t yx = 0;
    int32_t xy = 0;
    int32_t yy = kOne;
    const bool has_matrix =
        (flags & (kPartScale | kPartTwoScales | kPartMatrix)) != 0;
    if (has_matrix) {
      xx = number();
      if ((flags & kPartMatrix) != 0) {
        yx = number();
        xy = number();
      }
      yy = (flags & kPartScale) != 0 ? xx : number();
    }
    OutlineMap map = frame.map;
    int32_t origin_q18[2];
    for (int32_t i = 0; i != 2; ++i) {
      OutlineMap::Axis& axis = map.axes[i];
      origin_q18[i] = sum(frame.origin_q18[i], units_moved(axis, dx, dy));
      if (has_matrix) {
        axis = {mixed(axis.per_x, xx, axis.per_y, yx),
                mixed(axis.per_x, xy, axis.per_y, yy)};
      }
    }
    if ((flags & kPartMore) != 0) {
      frame.rest = part_of(part, at);
    } else {
      --depth_;
    }
    if (begin_record(record_of(*face_, glyph), map, origin_q18)) {
      return true;
    }
  }
  return false;
}

void TrueTypeGlyph::rewind() noexcept {
  depth_ = 0;
  parts_ = 0;
  budget_ = kMostPoints;
  const int32_t pen_q18[] = {
      sum(origin_q18_[0], product(shift_, map_.axes[0].per_x)),
      sum(origin_q18_[1], product(shift_, map_.axes[1].per_x))};
  is_done_ = !begin_record(record_, map_, pen_q18) && !next_part();
}

ScreenPoint* TrueTypeGlyph::read(ScreenPoint* out, int32_t room) noexcept {
  while (!is_done_) {
    ScreenPoint* const end = work_.reader.read(part_map_, out, room);
    room -= static_cast<int32_t>(end - out);
    out = end;
    if (!work_.reader.has_ended()) {
      break;
    }
    is_done_ = !next_part();
  }
  return out;
}

}  // namespace inkcell::detail
