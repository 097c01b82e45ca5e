// Lookups that move glyphs.
#include "shaper.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

namespace {

// Modulo 2^16, as in font units of the format.
void add_to(int16_t& value, int32_t by) noexcept {
  value = static_cast<int16_t>(value + by);
}

// Whether a glyph is what follows the one before it of what was one glyph: the
// first of those takes marks, or one behind a mark.
bool is_part(const TextGlyph& before, const TextGlyph& glyph) noexcept {
  return (glyph.flags & kMultiplied) != 0 && component_of(glyph) != 0 &&
         !is_mark(before) && (before.flags & kMultiplied) != 0 &&
         before.ligature == glyph.ligature &&
         component_of(before) == component_of(glyph) - 1;
}

// Whether two marks belong to the same letter.
bool are_of_same(const TextGlyph& mark, const TextGlyph& other) noexcept {
  const uint32_t component = component_of(mark);
  const uint32_t other_component = component_of(other);
  return mark.ligature == other.ligature
             ? mark.ligature == 0 || component == other_component
             : (mark.ligature != 0 && component == 0) ||
                   (other.ligature != 0 && other_component == 0);
}

}  // namespace

// Of a row: a column's number, from its base on.
int32_t Shaper::take_value(uint32_t column) noexcept {
  return lookup_.bases[column] +
         static_cast<int32_t>(take(lookup_.widths[column]));
}

int32_t Shaper::adjust(int32_t i) noexcept {
  add_to(g_[i].x, take_value(0));
  add_to(g_[i].y, take_value(1));
  add_to(g_[i].advance, take_value(2));
  return i + 1;
}

int32_t Shaper::kern(int32_t i) noexcept {
  const uint8_t* widths = lookup_.widths;  // left, right, start, value, both
  const uint32_t left = take(widths[0]);
  const int32_t j = left != 0 ? find_next(i, 1, kAnyGlyph, false) : kNo;
  if (j < 0 || !find_row(g_[j].glyph)) {
    return kNo;
  }
  at_ += widths[0];
  const uint32_t right = take(widths[1]);
  at_ = lookup_.rest + (left - 1) * widths[2];
  const uint32_t begin = take(widths[2]);
  const uint32_t end = take(widths[2]);
  const uint32_t pair_bits = widths[1] + widths[3];
  at_ =
      lookup_.rest + (lookup_.numbers[0] + 1u) * widths[2] + begin * pair_bits;
  if (!find(pair_bits, end - begin, widths[1], right)) {
    return kNo;
  }
  const int32_t value =
      lookup_.bases[0] + static_cast<int32_t>(take(widths[3]));
  add_to(g_[i].advance, value);
  if (widths[4] != 0) {
    add_to(g_[i].x, value);
  }
  return j;
}

void Shaper::set_link(TextGlyph& glyph,
                      int32_t link,
                      bool is_cursive) noexcept {
  const bool fits = link >= -127 && link <= 127;
  glyph.link = static_cast<int8_t>(fits ? link : 0);
  glyph.flags = static_cast<uint8_t>((glyph.flags & ~kCursiveLink) |
                                     (is_cursive ? kCursiveLink : 0));
}

// Where two glyphs meet, in each.
struct Shaper::Anchor {
  int32_t x;
  int32_t y;
  int32_t base_x;
  int32_t base_y;
};

// The end of a glyph is joined to that of the glyph before it.
void Shaper::link_cursive(int32_t i, int32_t j, const Anchor& anchor) noexcept {
  TextGlyph& before = g_[j];
  TextGlyph& glyph = g_[i];
  const int32_t entry = lookup_.bases[0] + anchor.x + glyph.x;
  const int32_t exit = lookup_.bases[0] + anchor.base_x + before.x;
  if (program_.has(shap::kRightToLeft)) {
    add_to(before.advance, -exit);
    add_to(before.x, -exit);
    glyph.advance = static_cast<int16_t>(entry);
  } else {
    before.advance = static_cast<int16_t>(exit);
    add_to(glyph.advance, -entry);
    add_to(glyph.x, -entry);
  }
  int32_t child = i;
  int32_t parent = j;
  int32_t y = anchor.base_y - anchor.y;
  if (lookup_.widths[6] != 0) {
    child = j;
    parent = i;
    y = -y;
  }
  turn_cursive(child, parent);
  g_[child].y = static_cast<int16_t>(y);
  set_link(g_[child], parent - child, true);
  if (g_[parent].link == child - parent) {
    g_[parent].link = 0;
  }
}

// A glyph that hangs on another already: the chain from there on is turned, so
// that it hangs on the glyph.
void Shaper::turn_cursive(int32_t i, int32_t parent) noexcept {
  int32_t link = g_[i].link;
  int32_t y = g_[i].y;
  if ((g_[i].flags & kCursiveLink) == 0) {
    return;
  }
  g_[i].link = 0;
  while (link != 0 && spend()) {
    const int32_t to = i + link;
    if (to < 0 || to >= n_ || to == parent) {
      return;
    }
    const bool goes_on = (g_[to].flags & kCursiveLink) != 0;
    const int32_t next_link = g_[to].link;
    const int32_t next_y = g_[to].y;
    g_[to].y = static_cast<int16_t>(-y);
    set_link(g_[to], -link, true);
    i = to;
    link = goes_on ? next_link : 0;
    y = next_y;
  }
}

// A mark to the letter or mark before it; of a cursive script, a glyph.
int32_t Shaper::attach(int32_t i) noexcept {
  const uint32_t mark_row = at_;
  const TextGlyph& mark = g_[i];
  int32_t j = i;
  do {
    j = find_next(j, -1, kAnyGlyph, false);
    if (j < 0) {
      return kNo;
    }
  } while (lookup_.type == shap::kMarkToBase && j > 0 &&
           is_part(g_[j - 1], g_[j]));
  const TextGlyph& base = g_[j];
  uint32_t component = 0;
  if (lookup_.type == shap::kMarkToLigature) {
    const bool is_of_it = base.ligature != 0 &&
                          base.ligature == mark.ligature &&
                          component_of(mark) != 0;
    component = is_of_it ? component_of(mark) - 1 : 255;
  }
  Anchor anchor;
  if ((lookup_.type == shap::kMarkToMark &&
       !(is_mark(base) && are_of_same(mark, base))) ||
      !find_anchor(mark, mark_row, base.glyph, component, anchor)) {
    return kNo;
  }
  if (lookup_.type == shap::kCursive) {
    link_cursive(i, j, anchor);
  } else {
    g_[i].x = static_cast<int16_t>(anchor.base_x - anchor.x);
    g_[i].y = static_cast<int16_t>(anchor.base_y - anchor.y);
    set_link(g_[i], j - i, false);
  }
  return i + 1;
}

bool Shaper::find_anchor(const TextGlyph& mark,
                         uint32_t mark_row,
                         uint32_t base,
                         uint32_t component,
                         Anchor& out) noexcept {
  const uint32_t width = glyph_bits();
  // Of levels, x, kinds, y, places in the pool, and counts.
  const uint8_t* widths = lookup_.widths;
  const uint32_t level_bits = widths[2] + widths[3];
  const uint32_t base_row = width + widths[4] + widths[5];
  const uint32_t bases = lookup_.numbers[1];
  const uint32_t levels = lookup_.rest + base_row * bases;
  const uint32_t anchor_bits = widths[0] + widths[1];
  const auto take_level = [&] {
    return get(levels + take(widths[0]) * level_bits, level_bits);
  };
  at_ = lookup_.rest;
  if (!find(base_row, bases, width, base)) {
    return false;
  }
  // The rows of a ligature follow each other, one for each letter, as do those
  // of a mark, one for each kind.
  for (; component != 0 && at_ + base_row < levels + width &&
         get(at_ + base_row - width, width) == base && spend();
       --component) {
    at_ += base_row;
  }
  uint32_t first = take(widths[4]);
  const uint32_t count = take(widths[5]);
  first = levels + level_bits * lookup_.numbers[0] + first * anchor_bits;
  do {
    at_ = mark_row;
    const uint32_t level = take_level();
    out.x = static_cast<int32_t>(take(widths[1]));
    out.y = static_cast<int32_t>(level >> widths[2]);
    for (uint32_t k = 0; k < count && spend(); ++k) {
      at_ = first + k * anchor_bits;
      const uint32_t other = take_level();
      if (((level ^ other) & ~(~uint32_t{0} << widths[2])) == 0) {
        out.base_x = static_cast<int32_t>(take(widths[1]));
        out.base_y = static_cast<int32_t>(other >> widths[2]);
        return true;
      }
    }
    mark_row += lookup_.row_bits;
  } while (mark_row < lookup_.rest + width &&
           get(mark_row - width, width) == mark.glyph && spend());
  return false;
}

}  // namespace inkcell::detail
