// Lookups that replace glyphs.
#include "shaper.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

namespace {
constexpr int32_t kMostInput = shap::kMaxInput;

uint32_t components_of(const TextGlyph& glyph) noexcept {
  return glyph.component < kComponents ? 1u : glyph.component - kComponents;
}
}  // namespace

int32_t Shaper::replace_by_many(int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  const uint32_t first = take(lookup_.widths[0]);
  at_ += width;
  const uint32_t count = take(lookup_.widths[0]) - first;
  at_ = lookup_.rest + lookup_.row_bits + first * width;
  if (count == 0) {
    // The cluster goes on in a neighbour.
    const int32_t begin = i > 0 ? i - 1 : 0;
    merge(begin, begin + 2 < n_ ? begin + 2 : n_);
    erase(i);
    return i;
  }
  if (count == 1) {
    return replace_one(i);
  }
  const auto more = static_cast<int32_t>(count) - 1;
  if (count > shap::kMaxInput || !insert(i + 1, more)) {
    return kNo;
  }
  uint32_t bit = at_ + count * width;
  for (int32_t k = more; k >= 0; --k) {
    TextGlyph& glyph = g_[i + k];
    glyph = g_[i];
    bit -= width;
    set_glyph(glyph, get(bit, width));
    // What belongs to a ligature, or is one, stays so.
    glyph.flags = kMultiplied;
    if (glyph.ligature == 0) {
      glyph.component = static_cast<uint8_t>(k);
    }
  }
  return i + more + 1;
}

// The longest ligature, found along a tree whose nodes lie in rows by depth.
int32_t Shaper::ligate(int32_t i) noexcept {
  const uint32_t width = glyph_bits();
  const uint32_t child_bits = lookup_.widths[0];
  uint16_t places[kMostInput + 1];
  int32_t count = 0;
  int32_t best = 0;
  uint32_t ligature = 0;
  const TextGlyph& first = g_[i];
  for (int32_t j = i;;) {
    places[count++] = static_cast<uint16_t>(j);
    const uint32_t found = take(width);
    if (found != 0) {
      best = count;
      ligature = found;
    }
    branch_ = take(child_bits);
    at_ += 2 * width;
    branches_ = take(child_bits) - branch_;
    branch_ = lookup_.rows + branch_ * lookup_.row_bits;
    if (branches_ == 0 || count > kMostInput) {
      break;
    }
    j = find_next(j, 1, kBranch, false);
    if (j < 0) {
      break;
    }
    // Marks of different letters of a ligature do not join.
    const TextGlyph& glyph = g_[j];
    const uint32_t own = component_of(first);
    const uint32_t component = component_of(glyph);
    const bool is_of_other = first.ligature != glyph.ligature;
    if (first.ligature != 0 && own != 0
            ? is_of_other || own != component
            : glyph.ligature != 0 && component != 0 && is_of_other) {
      break;
    }
  }
  if (best == 0) {
    return kNo;
  }
  join_components(places, best, ligature);
  return i + 1;
}

// Puts a ligature in the place of its first letter. Marks in between, and those
// behind that belong to the last letter, keep which letter they belong to.
void Shaper::join_components(const uint16_t* places,
                             int32_t count,
                             uint32_t ligature) noexcept {
  TextGlyph& first = g_[places[0]];
  bool is_ligature = class_of(first) % 2 == 0;  // not a mark or a base
  for (int32_t k = 1; k < count; ++k) {
    is_ligature = is_ligature || !is_mark(g_[places[k]]);
  }
  merge(places[0], places[count - 1] + 1);
  if (is_ligature) {
    ligatures_ = static_cast<uint8_t>(ligatures_ == 255 ? 1 : ligatures_ + 1);
  }
  uint32_t total = 0;
  for (int32_t k = 0; k < count; ++k) {
    const bool is_last = k + 1 == count;
    const TextGlyph& letter = g_[places[k]];
    const uint32_t most = components_of(letter);
    const int32_t end = is_last ? n_ : places[k + 1];
    // Marks alone are no letters.
    const bool has_marks =
        is_last ? letter.ligature != 0 && (is_ligature || !is_mark(first))
                : is_ligature;
    for (int32_t i = places[k] + 1; has_marks && i < end; ++i) {
      TextGlyph& glyph = g_[i];
      uint32_t component = component_of(glyph);
      if (is_last &&
          (component == 0 || glyph.ligature != letter.ligature || !spend())) {
        break;
      }
      component = component - 1 < most ? component : most;
      glyph.component = static_cast<uint8_t>(total + component);
      glyph.ligature = is_ligature ? ligatures_ : uint8_t{0};
    }
    total += most;
  }
  set_glyph(first, ligature);
  first.x |= 15;  // what it was in a syllable
  if (is_ligature) {
    first.ligature = ligatures_;
    first.component = static_cast<uint8_t>(kComponents | total);
  }
  while (--count > 0) {
    erase(places[count]);
  }
}

// The glyphs of sets, one after the other: the last one, or kNo. `places` are
// of an input, which has its forms; null: of what stands beside it.
int32_t Shaper::match(uint32_t sets,
                      uint32_t count,
                      int32_t from,
                      int32_t step,
                      uint16_t* places) noexcept {
  const uint32_t set_bits = header(shap::kSetBits);
  for (; count != 0 && from >= 0; --count, sets += set_bits) {
    from = find_next(from, step, get(sets, set_bits), places == nullptr);
    if (places != nullptr) {
      *places++ = static_cast<uint16_t>(from);
    }
  }
  return from;
}

// The first rule that matches.
int32_t Shaper::apply_context(int32_t i, uint32_t depth) noexcept {
  const uint32_t set_bits = header(shap::kSetBits);
  if (depth >= shap::kMaxDepth) {
    status_ = Status::unsupported;
  }
  uint16_t places[kMostInput + 1];
  places[0] = static_cast<uint16_t>(i);
  uint32_t bit = lookup_.rows;
  for (uint32_t rule = lookup_.count; rule-- != 0 && spend();) {
    at_ = bit;
    const uint32_t head = take(4 * shap::kRuleBits);
    const uint32_t before = head & shap::kMaxInput;
    const uint32_t input = head >> shap::kRuleBits & shap::kMaxInput;
    const uint32_t behind = head >> 2 * shap::kRuleBits & shap::kMaxInput;
    const uint32_t actions = head >> 3 * shap::kRuleBits;
    const uint32_t first = take(set_bits);
    const uint32_t sets = at_;
    const uint32_t end = sets + set_bits * (before + input + behind);
    bit = end + actions * (shap::kRuleBits + header(shap::kLookupBits));
    if (!in_set(first, g_[i].glyph)) {
      continue;
    }
    const int32_t last =
        match(sets + set_bits * before, input, i, 1, places + 1);
    if (last >= 0 && match(sets, before, i, -1, nullptr) >= 0 &&
        match(end - set_bits * behind, behind, last, 1, nullptr) >= 0) {
      return apply_rule(end, actions, places, static_cast<int32_t>(input) + 1,
                        depth);
    }
  }
  return kNo;
}

// Applies lookups at places of the input, which move as glyphs come and go.
int32_t Shaper::apply_rule(uint32_t actions,
                           uint32_t count,
                           uint16_t* places,
                           int32_t inputs,
                           uint32_t depth) noexcept {
  const uint32_t own = lookup_.number;
  int32_t end = places[inputs - 1] + 1;
  for (; count != 0 && status_ == Status::ok; --count) {
    at_ = actions;
    const auto number = static_cast<int32_t>(take(shap::kRuleBits));
    const uint32_t nested = take(header(shap::kLookupBits));
    actions = at_;
    if (number >= inputs || places[number] >= n_) {
      continue;
    }
    const int32_t place = places[number];
    const int32_t length = n_;
    load(nested);
    const int32_t next_place = apply(place, depth + 1);
    load(own);
    if (next_place < 0) {
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
        places[k + change] = static_cast<uint16_t>(places[k] + change);
      }
      for (int32_t k = 0; k < change; ++k) {
        places[next + k] = static_cast<uint16_t>(place + 1 + k);
      }
    } else {
      change = change < next - inputs ? next - inputs : change;
      for (; next < inputs + change; ++next) {
        places[next] = static_cast<uint16_t>(places[next - change] + change);
      }
    }
    inputs += change;
  }
  return end;
}

}  // namespace inkcell::detail
