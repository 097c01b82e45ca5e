#include "glyph_reader.hpp"

#include "base/bytes.hpp"
#include "base/math.hpp"
#include "place/style_parts.hpp"

namespace inkcell::detail {
namespace {

// Of a component.
enum PartFlag : uint32_t {
  kPartWords = 1,
  kPartOffsets = 2,
  kPartScale = 8,
  kPartMore = 32,
  kPartTwoScales = 64,
  kPartMatrix = 128,
};

// The scale at which a height is whole rows: those that are missing less than
// `more_q6` of one are rounded up. Heights below 1.5 rows keep it. [px, Q18]
__attribute__((noinline)) uint32_t scale_to_grid(uint32_t scale,
                                                 uint32_t units,
                                                 uint32_t more_q6,
                                                 int32_t strength_q8) noexcept {
  const uint32_t natural = units * scale >> 12;
  if (natural < 96) {
    return scale;
  }
  const auto more =
      static_cast<int32_t>(((natural + more_q6) & ~63u) - natural);
  return scale * (natural + static_cast<uint32_t>(more * strength_q8 >> 8)) /
         natural;
}

// That of y in a fitted style, of a glyph whose ink ends at `top`: the x-height
// is rounded up, as Fit does, and then the height of capitals to the nearest.
uint32_t fitted_scale(const TrueTypeFace& face,
                      uint32_t scale,
                      uint32_t em,
                      int32_t top,
                      int32_t strength_q8) noexcept {
  const uint32_t x_height = load_u16(face.header + format::header::kXHeight);
  const uint32_t capitals = load_u16(face.header + format::header::kCapHeight);
  if (x_height <= em) {
    scale = scale_to_grid(scale, x_height, 56, strength_q8);
  }
  // Round ones are higher.
  const uint32_t beyond = em >> 6;
  if (capitals <= em &&
      static_cast<uint32_t>(top) - capitals + beyond <= 2 * beyond) {
    scale = scale_to_grid(scale, capitals, 32, strength_q8);
  }
  return scale;
}

int32_t units_moved(const OutlineMap::Axis& axis,
                    int32_t x,
                    int32_t y) noexcept {
  return sum(product(x, axis.per_x), product(y, axis.per_y));
}

}  // namespace

__attribute__((noinline)) int32_t fit_strength_q8(const Style& style) noexcept {
  constexpr int32_t kEnds = 40 << 6;
  return style.is_upright() && style.is_fitted()
             ? min(max(kEnds - style.size().raw, 0) >> 2, 256)
             : 0;
}

bool TrueTypeGlyph::find(const Font& font,
                         uint16_t glyph,
                         const Style& style,
                         InkEnds (&ink)[2],
                         bool& is_mirrored) noexcept {
  face_ = &TrueTypeFont::face_of(font);
  int32_t left = 0;
  record_ = face_->record(*face_, glyph, &left);
  glyph_ = glyph;
  if (record_.size == 0) {
    return false;
  }
  const uint32_t em = font.units_per_em();
  const auto size_q18 = static_cast<uint32_t>(style.size().raw) << 12;
  const uint32_t scale = (size_q18 + em / 2) / em;
  const int32_t strength_q8 = fit_strength_q8(style);
  const int32_t top = i16_at(record_, kRecordBox + 6);
  const auto up = static_cast<int32_t>(
      strength_q8 == 0 ? scale
                       : fitted_scale(*face_, scale, em, top, strength_q8));
  map_ = {{{static_cast<int32_t>(scale), 0}, {0, -up}}};
  // Filled areas lie to the right, and y leads down.
  is_mirrored =
      style.is_upright() || !StyleParts::slant(style).map(style, map_);
  const int32_t x_min = i16_at(record_, kRecordBox);
  const int32_t y_min = i16_at(record_, kRecordBox + 2);
  const int32_t width = i16_at(record_, kRecordBox + 4) - x_min;
  const int32_t height = top - y_min;
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
  return work_.reader.begin(face_->records, record, budget_);
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
    if (begin_record(face_->record(*face_, glyph, nullptr), map, origin_q18)) {
      return true;
    }
  }
  return false;
}

void TrueTypeGlyph::find_again() noexcept {
  int32_t left;
  record_ = face_->record(*face_, glyph_, &left);
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
