// Lookups that move glyphs.
#include "shaper.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

namespace {

// Modulo 2^16, as in font units of the format.
void add_to(int16_t& value, int32_t by) noexcept {
  value = static_cast<int16_t>(value + by);
}

}  // namespace

int32_t Shaper::adjust(const ShapeLookup& lookup, int32_t i) noexcept {
  constexpr uint32_t kColumns = 3;
  const uint32_t width = glyph_bits();
  int32_t least[kColumns];
  uint32_t bits[kColumns];
  uint32_t row_bits = width;
  uint32_t bit = lookup.at;
  for (uint32_t k = 0; k < kColumns; ++k) {
    least[k] = take_signed(bit);
    bits[k] = take(bit, 5);
    row_bits += bits[k];
  }
  uint32_t row = 0;
  if (!find_row(bit, row_bits, lookup.count, g_[i].glyph, row)) {
    return kNo;
  }
  row += width;
  int16_t* const values[kColumns] = {&g_[i].x, &g_[i].y, &g_[i].advance};
  for (uint32_t k = 0; k < kColumns; ++k) {
    add_to(*values[k], least[k] + static_cast<int32_t>(take(row, bits[k])));
  }
  return i + 1;
}

int32_t Shaper::kern(const ShapeLookup& lookup, int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  uint32_t bit = lookup.at;
  const int32_t least = take_signed(bit);
  const uint32_t value_bits = take(bit, 5);
  const bool moves_both = take(bit, 1) != 0;
  const uint32_t left_bits = take(bit, 5);
  const uint32_t right_bits = take(bit, 5);
  const uint32_t start_bits = take(bit, 5);
  const uint32_t left_count = take(bit, 16);
  const uint32_t row_bits = width + left_bits + right_bits;
  uint32_t row = 0;
  if (!find_row(bit, row_bits, lookup.count, g_[i].glyph, row)) {
    return kNo;
  }
  const uint32_t left = get(row + width, left_bits);
  const int32_t j =
      left != 0 ? find_next(lookup, i, 1, Want::any, 0, false) : kNo;
  if (j < 0 || !find_row(bit, row_bits, lookup.count, g_[j].glyph, row)) {
    return kNo;
  }
  const uint32_t right = get(row + width + left_bits, right_bits);
  const uint32_t starts = bit + row_bits * lookup.count;
  const uint32_t begin = get(starts + (left - 1) * start_bits, start_bits);
  const uint32_t end = get(starts + left * start_bits, start_bits);
  const BitTable pairs = {&t_.bytes, starts + (left_count + 1) * start_bits,
                          right_bits + value_bits};
  const uint32_t pair = right != 0 ? pairs.find(begin, end, right_bits, right)
                                   : BitTable::kAbsent;
  if (pair == BitTable::kAbsent) {
    return kNo;
  }
  const int32_t value =
      least + static_cast<int32_t>(pairs.get(pair, right_bits, value_bits));
  add_to(g_[i].advance, value);
  if (moves_both) {
    add_to(g_[i].x, value);
  }
  return j;
}

void Shaper::set_link(RunGlyph& glyph, int32_t link, bool is_cursive) noexcept {
  const bool fits = link >= -127 && link <= 127;
  glyph.link = static_cast<int8_t>(fits ? link : 0);
  glyph.flags = static_cast<uint8_t>((glyph.flags & ~kCursiveLink) |
                                     (is_cursive ? kCursiveLink : 0));
}

int32_t Shaper::link_cursive(const ShapeLookup& lookup, int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  uint32_t bit = lookup.at;
  const int32_t least_x = take_signed(bit);
  const int32_t least_y = take_signed(bit);
  const uint32_t x_bits = take(bit, 5);
  const uint32_t y_bits = take(bit, 5);
  const bool from_end = take(bit, 1) != 0;
  const uint32_t row_bits = width + 2 + 2 * (x_bits + y_bits);
  uint32_t entry = 0;
  uint32_t exit = 0;
  if (!find_row(bit, row_bits, lookup.count, g_[i].glyph, entry) ||
      get(entry + width, 1) == 0) {
    return kNo;
  }
  const int32_t j = find_next(lookup, i, -1, Want::any, 0, false);
  if (j < 0 || !find_row(bit, row_bits, lookup.count, g_[j].glyph, exit) ||
      get(exit + width + 1, 1) == 0) {
    return kNo;
  }
  entry += width + 2;
  exit += width + 2 + x_bits + y_bits;
  const auto take_place = [this](uint32_t& place, int32_t least,
                                 uint32_t bits) {
    return least + static_cast<int32_t>(take(place, bits));
  };
  const int32_t entry_x = take_place(entry, least_x, x_bits);
  const int32_t entry_y = take_place(entry, least_y, y_bits);
  const int32_t exit_x = take_place(exit, least_x, x_bits);
  const int32_t exit_y = take_place(exit, least_y, y_bits);
  RunGlyph& before = g_[j];
  RunGlyph& glyph = g_[i];
  if (program_.has(shap::kRightToLeft)) {
    const int32_t change = exit_x + before.x;
    add_to(before.advance, -change);
    add_to(before.x, -change);
    glyph.advance = static_cast<int16_t>(entry_x + glyph.x);
  } else {
    before.advance = static_cast<int16_t>(exit_x + before.x);
    const int32_t change = entry_x + glyph.x;
    add_to(glyph.advance, -change);
    add_to(glyph.x, -change);
  }
  const int32_t child = from_end ? j : i;
  const int32_t parent = from_end ? i : j;
  turn_cursive(child, parent);
  g_[child].y =
      static_cast<int16_t>(from_end ? entry_y - exit_y : exit_y - entry_y);
  set_link(g_[child], parent - child, true);
  if (g_[parent].link == child - parent) {
    g_[parent].link = 0;
  }
  return i + 1;
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

// The glyph that a mark is attached to; kNo: there is none.
int32_t Shaper::find_base(const ShapeLookup& lookup, int32_t i) noexcept {
  if (lookup.type == shap::kMarkToMark) {
    // Filtered, but nothing is left out by its class.
    ShapeLookup marks = lookup;
    marks.skip = 0;
    const int32_t j = find_next(marks, i, -1, Want::any, 0, false);
    if (j < 0 || !is_mark(g_[j])) {
      return kNo;
    }
    const RunGlyph& mark = g_[i];
    const RunGlyph& other = g_[j];
    const uint32_t component = component_of(mark);
    const uint32_t other_component = component_of(other);
    const bool is_same =
        mark.ligature == other.ligature
            ? mark.ligature == 0 || component == other_component
            : (mark.ligature != 0 && component == 0) ||
                  (other.ligature != 0 && other_component == 0);
    return is_same ? j : kNo;
  }
  for (int32_t j = i; j-- > 0 && spend();) {
    const RunGlyph& glyph = g_[j];
    if (is_mark(glyph) || (glyph.flags & kIgnorable) != 0) {
      continue;
    }
    // Of what was one glyph the first takes the mark, or one behind a mark.
    const bool goes_on =
        lookup.type == shap::kMarkToBase && (glyph.flags & kMultiplied) != 0 &&
        glyph.component != 0 && j != 0 && !is_mark(g_[j - 1]) &&
        (g_[j - 1].flags & kMultiplied) != 0 &&
        g_[j - 1].component == glyph.component - 1;
    if (!goes_on) {
      return j;
    }
  }
  return kNo;
}

int32_t Shaper::attach(const ShapeLookup& lookup, int32_t i) noexcept {
  const int32_t base = find_base(lookup, i);
  if (base < 0) {
    return kNo;
  }
  uint32_t component = 0;
  if (lookup.type == shap::kMarkToLigature) {
    const RunGlyph& mark = g_[i];
    const bool is_of_it = g_[base].ligature != 0 &&
                          g_[base].ligature == mark.ligature &&
                          component_of(mark) != 0;
    component = is_of_it ? component_of(mark) - 1 : 255;
  }
  return anchor(lookup, i, base, component) ? i + 1 : kNo;
}

bool Shaper::anchor(const ShapeLookup& lookup,
                    int32_t i,
                    int32_t base,
                    uint32_t component) noexcept {
  const uint32_t width = glyph_bits();
  uint32_t bit = lookup.at + 32;  // behind what x and y begin with
  const uint32_t x_bits = take(bit, 5);
  const uint32_t y_bits = take(bit, 5);
  const uint32_t class_bits = take(bit, 5);
  const uint32_t pool_bits = take(bit, 5);
  const uint32_t count_bits = take(bit, 5);
  const uint32_t bases = take(bit, 16);
  const uint32_t anchor_bits = class_bits + x_bits + y_bits;
  const uint32_t mark_row = width + anchor_bits;
  const uint32_t base_row = width + pool_bits + count_bits;
  const uint32_t base_table = bit + mark_row * lookup.count;
  const uint32_t pool = base_table + base_row * bases;
  const BitTable table = {&t_.bytes, base_table, base_row};
  uint32_t mark = 0;
  uint32_t row = table.find(0, bases, width, g_[base].glyph);
  if (row == BitTable::kAbsent ||
      !find_row(bit, mark_row, lookup.count, g_[i].glyph, mark)) {
    return false;
  }
  // The rows of a ligature follow each other, one for each letter.
  while (row != 0 && table.get(row - 1, 0, width) == g_[base].glyph &&
         spend()) {
    --row;
  }
  for (; component != 0 && row + 1 < bases &&
         table.get(row + 1, 0, width) == g_[base].glyph && spend();
       --component) {
    ++row;
  }
  const uint32_t first = table.get(row, width, pool_bits);
  const uint32_t count = table.get(row, width + pool_bits, count_bits);
  // So do those of a mark, one for each class.
  while (mark != bit && get(mark - mark_row, width) == g_[i].glyph && spend()) {
    mark -= mark_row;
  }
  for (; mark < base_table && get(mark, width) == g_[i].glyph;
       mark += mark_row) {
    uint32_t from = mark + width;
    const uint32_t kind = take(from, class_bits);
    for (uint32_t k = 0; k < count && spend(); ++k) {
      uint32_t to = pool + (first + k) * anchor_bits;
      if (take(to, class_bits) != kind) {
        continue;
      }
      RunGlyph& glyph = g_[i];
      const auto between = [&](uint32_t bits) {
        return static_cast<int16_t>(take(to, bits) - take(from, bits));
      };
      glyph.x = between(x_bits);
      glyph.y = between(y_bits);
      set_link(glyph, base - i, false);
      return true;
    }
    if (status_ != Status::ok) {
      return false;
    }
  }
  return false;
}

}  // namespace inkcell::detail
