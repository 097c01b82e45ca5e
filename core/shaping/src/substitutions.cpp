// Lookups that replace glyphs.
#include "shaper.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

namespace {
constexpr int32_t kMostInput = shap::kMaxInput;
}  // namespace

int32_t Shaper::replace_one(const ShapeLookup& lookup, int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  uint32_t row = 0;
  if (!find_row(lookup.at, 2 * width, lookup.count, g_[i].glyph, row)) {
    return kNo;
  }
  set_glyph(g_[i], get(row + width, width));
  return i + 1;
}

int32_t Shaper::replace_by_many(const ShapeLookup& lookup, int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  uint32_t bit = lookup.at;
  const uint32_t start_bits = take(bit, 5);
  const uint32_t row_bits = width + start_bits;
  uint32_t row = 0;
  if (!find_row(bit, row_bits, lookup.count, g_[i].glyph, row)) {
    return kNo;
  }
  const uint32_t first = get(row + width, start_bits);
  const uint32_t count = get(row + row_bits + width, start_bits) - first;
  uint32_t out = bit + row_bits * (lookup.count + 1) + first * width;
  if (count == 0) {
    // The cluster goes on in a neighbour.
    if (i > 0) {
      merge(i - 1, i + 1);
    } else if (n_ > 1) {
      merge(i, i + 2);
    }
    erase(i);
    return i;
  }
  if (count == 1) {
    set_glyph(g_[i], get(out, width));
    return i + 1;
  }
  if (count > shap::kMaxInput || !insert(i, static_cast<int32_t>(count) - 1)) {
    return kNo;
  }
  const RunGlyph from = g_[i + static_cast<int32_t>(count) - 1];
  for (uint32_t k = 0; k < count; ++k, out += width) {
    RunGlyph& glyph = g_[i + static_cast<int32_t>(k)];
    glyph = from;
    set_glyph(glyph, get(out, width));
    glyph.flags = kMultiplied;
    glyph.ligature = 0;
    glyph.component = static_cast<uint8_t>(k);
  }
  return i + static_cast<int32_t>(count);
}

// The longest ligature, found along a tree whose nodes lie in rows by depth.
int32_t Shaper::ligate(const ShapeLookup& lookup, int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  uint32_t bit = lookup.at;
  const uint32_t child_bits = take(bit, 5);
  const uint32_t row_bits = 2 * width + child_bits;
  uint32_t node = 0;
  if (!find_row(bit, row_bits, lookup.count, g_[i].glyph, node)) {
    return kNo;
  }
  uint16_t places[kMostInput + 1];
  places[0] = static_cast<uint16_t>(i);
  int32_t count = 1;
  int32_t best = 0;
  uint32_t ligature = 0;
  const RunGlyph& first = g_[i];
  for (int32_t j = i; count <= kMostInput;) {
    const uint32_t begin = get(node + 2 * width, child_bits);
    const uint32_t end = get(node + row_bits + 2 * width, child_bits);
    if (begin >= end) {
      break;
    }
    bool is_hit = false;
    for (++j; j < n_ && spend(); ++j) {
      const RunGlyph& glyph = g_[j];
      if (skips(lookup, glyph)) {
        continue;
      }
      is_hit = (glyph.kind >> 2 & mask_) != 0 &&
               find_row(bit + begin * row_bits, row_bits, end - begin,
                        glyph.glyph, node);
      if (is_hit || !may_skip(lookup, glyph, false)) {
        break;
      }
    }
    if (!is_hit) {
      break;
    }
    // Marks of different letters of a ligature do not join.
    const RunGlyph& glyph = g_[j];
    const uint32_t component = component_of(glyph);
    const bool is_apart = first.ligature != 0 && component_of(first) != 0
                              ? first.ligature != glyph.ligature ||
                                    component_of(first) != component
                              : glyph.ligature != 0 && component != 0 &&
                                    glyph.ligature != first.ligature;
    if (is_apart) {
      break;
    }
    places[count++] = static_cast<uint16_t>(j);
    const uint32_t found = get(node + width, width);
    if (found != 0) {
      best = count;
      ligature = found;
    }
  }
  if (best == 0) {
    return kNo;
  }
  join_components(places, best, ligature);
  return i + 1;
}

// Puts a ligature in the place of its first letter. Marks in between keep
// which letter they belong to.
void Shaper::join_components(const uint16_t* places,
                             int32_t count,
                             uint32_t ligature) noexcept {
  bool are_marks = true;
  bool are_rest_marks = true;
  uint32_t total = 0;
  for (int32_t k = 0; k < count; ++k) {
    const RunGlyph& glyph = g_[places[k]];
    are_marks = are_marks && is_mark(glyph);
    are_rest_marks = are_rest_marks && (k == 0 || is_mark(glyph));
    total += components_of(glyph);
  }
  merge(places[0], places[count - 1] + 1);
  RunGlyph& first = g_[places[0]];
  const bool is_ligature =
      !are_marks && !(class_of(first) == 1 && are_rest_marks);
  if (is_ligature) {
    ligatures_ = static_cast<uint8_t>(ligatures_ == 255 ? 1 : ligatures_ + 1);
  }
  uint32_t last = first.ligature;
  uint32_t last_count = components_of(first);
  uint32_t so_far = last_count;
  const auto belong = [&](RunGlyph& glyph, uint32_t component) {
    component = component < last_count ? component : last_count;
    glyph.component = static_cast<uint8_t>(so_far - last_count + component);
    glyph.ligature = is_ligature ? ligatures_ : uint8_t{0};
    glyph.flags &= static_cast<uint8_t>(~kLigated);
  };
  for (int32_t k = 1; k < count; ++k) {
    for (int32_t i = places[k - 1] + 1; is_ligature && i < places[k]; ++i) {
      const uint32_t component = component_of(g_[i]);
      belong(g_[i], component != 0 ? component : last_count);
    }
    last = g_[places[k]].ligature;
    last_count = components_of(g_[places[k]]);
    so_far += last_count;
  }
  if (!are_marks && last != 0) {
    for (int32_t i = places[count - 1] + 1; i < n_; ++i) {
      const uint32_t component = component_of(g_[i]);
      if (g_[i].ligature != last || component == 0 || !spend()) {
        break;
      }
      belong(g_[i], component);
    }
  }
  set_glyph(first, ligature);
  if (is_ligature) {
    first.ligature = ligatures_;
    first.component = static_cast<uint8_t>(total);
    first.flags |= kLigated;
  }
  for (int32_t k = count; --k > 0;) {
    erase(places[k]);
  }
}

// The glyphs behind the first that are in the sets; how many they are then, 0:
// they do not match.
int32_t Shaper::match_input(const ShapeLookup& lookup,
                            uint32_t sets,
                            int32_t count,
                            uint16_t* places) noexcept {
  const uint32_t set_bits = bits_of(shap::kSetBits);
  int32_t at_glyph = places[0];
  for (int32_t k = 1; k <= count; ++k, sets += set_bits) {
    at_glyph =
        find_next(lookup, at_glyph, 1, Want::set, get(sets, set_bits), false);
    if (at_glyph < 0) {
      return 0;
    }
    places[k] = static_cast<uint16_t>(at_glyph);
  }
  return count + 1;
}

bool Shaper::match_around(const ShapeLookup& lookup,
                          uint32_t sets,
                          int32_t count,
                          int32_t from,
                          int32_t step) noexcept {
  const uint32_t set_bits = bits_of(shap::kSetBits);
  for (; count != 0; --count, sets += set_bits) {
    from = find_next(lookup, from, step, Want::set, get(sets, set_bits), true);
    if (from < 0) {
      return false;
    }
  }
  return true;
}

// The first rule that matches.
int32_t Shaper::apply_context(const ShapeLookup& lookup,
                              int32_t i,
                              uint32_t depth) noexcept {
  const uint32_t set_bits = bits_of(shap::kSetBits);
  const uint32_t lookup_bits = bits_of(shap::kLookupBits);
  uint16_t places[kMostInput + 1];
  uint32_t bit = lookup.at;
  for (uint32_t rule = 0; rule < lookup.count && spend(); ++rule) {
    const uint32_t before = take(bit, shap::kRuleBits);
    const uint32_t input = take(bit, shap::kRuleBits);
    const uint32_t behind = take(bit, shap::kRuleBits);
    const uint32_t actions = take(bit, shap::kRuleBits);
    const uint32_t sets = bit + set_bits;
    const uint32_t first = get(bit, set_bits);
    const uint32_t end = sets + set_bits * (before + input + behind);
    bit = end + actions * (shap::kRuleBits + lookup_bits);
    if (!in_set(first, g_[i].glyph)) {
      continue;
    }
    places[0] = static_cast<uint16_t>(i);
    const int32_t inputs = match_input(lookup, sets + set_bits * before,
                                       static_cast<int32_t>(input), places);
    if (inputs != 0 &&
        match_around(lookup, sets, static_cast<int32_t>(before), i, -1) &&
        match_around(lookup, sets + set_bits * (before + input),
                     static_cast<int32_t>(behind), places[inputs - 1], 1)) {
      return apply_rule(end, static_cast<int32_t>(actions), places, inputs,
                        depth);
    }
  }
  return kNo;
}

// Applies lookups at places of the input, which move as glyphs come and go.
int32_t Shaper::apply_rule(uint32_t actions,
                           int32_t count,
                           uint16_t* places,
                           int32_t inputs,
                           uint32_t depth) noexcept {
  const uint32_t lookup_bits = bits_of(shap::kLookupBits);
  int32_t end = places[inputs - 1] + 1;
  for (; count != 0 && status_ == Status::ok; --count) {
    const auto number = static_cast<int32_t>(take(actions, shap::kRuleBits));
    const uint32_t lookup = take(actions, lookup_bits);
    if (number >= inputs || places[number] >= n_) {
      continue;
    }
    const int32_t place = places[number];
    const int32_t length = n_;
    if (apply(lookup, place, depth + 1) < 0) {
      continue;
    }
    int32_t change = n_ - length;
    if (change == 0) {
      continue;
    }
    end += change;
    if (end < place) {
      // As far as the input was taken by a lookup that looks farther.
      change += place - end;
      end = place;
    }
    int32_t next = number + 1;
    if (change > 0) {
      if (inputs + change > kMostInput + 1) {
        break;
      }
      for (int32_t k = inputs; k-- > next;) {
        places[k + change] = places[k];
      }
      for (int32_t k = 0; k < change; ++k) {
        places[next + k] = static_cast<uint16_t>(place + 1 + k);
      }
      next += change;
    } else {
      change = change < next - inputs ? next - inputs : change;
      for (int32_t k = next; k < inputs + change; ++k) {
        places[k] = places[k - change];
      }
    }
    inputs += change;
    for (int32_t k = next; k < inputs; ++k) {
      places[k] = static_cast<uint16_t>(places[k] + change);
    }
  }
  return end;
}

// Rules of sets on both sides and pairs of glyphs, from the end of a run on.
bool Shaper::replace_backwards(const ShapeLookup& lookup, int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  const uint32_t set_bits = bits_of(shap::kSetBits);
  uint32_t bit = lookup.at;
  for (uint32_t rule = 0; rule < lookup.count && spend(); ++rule) {
    const uint32_t before = take(bit, shap::kRuleBits);
    const uint32_t behind = take(bit, shap::kRuleBits);
    const uint32_t pairs = take(bit, 16);
    const uint32_t sets = bit;
    const uint32_t rows = bit + set_bits * (before + behind);
    bit = rows + pairs * 2 * width;
    uint32_t row = 0;
    if (find_row(rows, 2 * width, pairs, g_[i].glyph, row) &&
        match_around(lookup, sets, static_cast<int32_t>(before), i, -1) &&
        match_around(lookup, sets + set_bits * before,
                     static_cast<int32_t>(behind), i, 1)) {
      set_glyph(g_[i], get(row + width, width));
      return true;
    }
  }
  return false;
}

}  // namespace inkcell::detail
