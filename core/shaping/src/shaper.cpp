#include "shaper.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

Status Shaper::shape(const Text& text,
                     const ScriptRun& run,
                     uint32_t program) noexcept {
  if (program < u8(shap::kPrograms)) {
    program_ = ShapeReader::program(program);
  }
  read(text, run);
  const uint32_t most = u16(shap::kSteps);
  steps_ = (most < shap::kMaxSteps ? most : shap::kMaxSteps) *
           (static_cast<uint32_t>(n_) + 1);
  if (status_ != Status::ok) {
    return status_;
  }
  order_marks();
  part_letters();
  compose();
  if (program_.has(shap::kJoins)) {
    join(text, run);
  }
  find_glyphs();
  run_entries(program_.first, program_.substitutions);
  advance_all();
  run_entries(program_.first + program_.substitutions, program_.positions);
  finish(run.is_right_to_left);
  return status_;
}

bool Shaper::spend(uint32_t steps) noexcept {
  if (steps > steps_) {
    steps_ = 0;
    if (status_ == Status::ok) {
      status_ = Status::unsupported;
    }
  }
  steps_ -= status_ == Status::ok ? steps : 0;
  return status_ == Status::ok;
}

void Shaper::load(uint32_t number, ShapeLookup& out) const noexcept {
  const uint32_t set_bits = bits_of(shap::kSetBits);
  const uint32_t offset_bits = bits_of(shap::kOffsetBits);
  out = ShapeLookup();
  if (number >= u16(shap::kLookups)) {
    return;
  }
  uint32_t bit = t_.lookups + number * (shap::kTypeBits + shap::kSkipBits +
                                        set_bits + 16 + offset_bits);
  out.type = take(bit, shap::kTypeBits);
  out.skip = take(bit, shap::kSkipBits);
  out.filter = take(bit, set_bits);
  out.count = take(bit, 16);
  out.at = t_.data + take(bit, offset_bits);
}

// Lookups of the program, each over the whole run.
void Shaper::run_entries(uint32_t first, uint32_t count) noexcept {
  const uint32_t lookup_bits = bits_of(shap::kLookupBits);
  const uint32_t top = u16(shap::kTopLookups);
  for (uint32_t k = first; k < first + count && k < u16(shap::kEntries); ++k) {
    uint32_t bit = t_.entries + k * (lookup_bits + shap::kMaskBits + 1);
    const uint32_t number = take(bit, lookup_bits);
    mask_ = take(bit, shap::kMaskBits);
    manual_zwj_ = take(bit, 1) != 0;
    if (number >= top) {
      continue;
    }
    ShapeLookup lookup;
    load(number, lookup);
    if (lookup.type == shap::kReverse) {
      run_backwards(lookup, mask_);
      continue;
    }
    for (int32_t i = 0; i < n_ && status_ == Status::ok;) {
      int32_t next = kNo;
      if ((g_[i].kind >> 2 & mask_) != 0 &&
          get(row_bit(g_[i].row) + shap::kClassBits + number, 1) != 0) {
        next = apply(number, i, 0);
      }
      // Where nothing replaces a glyph, the next takes its place.
      const bool stays = lookup.type == shap::kMultiple && next == i;
      i = next > i || stays ? next : i + 1;
      if (stays && !spend()) {
        return;
      }
    }
  }
}

void Shaper::run_backwards(const ShapeLookup& lookup, uint32_t mask) noexcept {
  for (int32_t i = n_; i-- > 0 && spend();) {
    if ((g_[i].kind >> 2 & mask) != 0 && !skips(lookup, g_[i])) {
      static_cast<void>(replace_backwards(lookup, i));
    }
  }
}

// What follows the glyphs that the lookup took; kNo: it does not apply.
int32_t Shaper::apply(uint32_t number, int32_t i, uint32_t depth) noexcept {
  ShapeLookup lookup;
  load(number, lookup);
  if (!spend() || skips(lookup, g_[i])) {
    return kNo;
  }
  switch (lookup.type) {
    case shap::kSingle:
      return replace_one(lookup, i);
    case shap::kMultiple:
      return replace_by_many(lookup, i);
    case shap::kLigatures:
      return ligate(lookup, i);
    case shap::kReverse:
      return replace_backwards(lookup, i) ? i + 1 : kNo;
    case shap::kAdjust:
      return adjust(lookup, i);
    case shap::kPairs:
      return kern(lookup, i);
    case shap::kCursive:
      return link_cursive(lookup, i);
    case shap::kMarkToBase:
    case shap::kMarkToLigature:
    case shap::kMarkToMark:
      return attach(lookup, i);
    case shap::kContext:
    case shap::kPositionContext:
      if (depth < shap::kMaxDepth) {
        return apply_context(lookup, i, depth);
      }
      status_ = Status::unsupported;
      return kNo;
    default:
      return kNo;
  }
}

bool Shaper::skips(const ShapeLookup& lookup,
                   const RunGlyph& glyph) const noexcept {
  const uint32_t kind = class_of(glyph);
  if (kind != 0 && (lookup.skip >> (kind - 1) & 1) != 0) {
    return true;
  }
  return kind == 3 && lookup.filter != 0 &&
         !in_set(lookup.filter - 1, glyph.glyph);
}

// Whether a glyph that shows nothing may be looked over.
bool Shaper::may_skip(const ShapeLookup& lookup,
                      const RunGlyph& glyph,
                      bool is_context) const noexcept {
  if ((glyph.flags & kIgnorable) == 0) {
    return false;
  }
  return lookup.type >= shap::kAdjust ||
         ((is_context || (glyph.flags & kZwnj) == 0) &&
          (is_context || !manual_zwj_ || (glyph.flags & kZwj) == 0));
}

// The next glyph of a set, or any, that the lookup sees; kNo: another comes
// first. Those of its input have its form.
int32_t Shaper::find_next(const ShapeLookup& lookup,
                          int32_t from,
                          int32_t step,
                          Want want,
                          uint32_t set,
                          bool is_context) noexcept {
  for (int32_t i = from + step; i >= 0 && i < n_ && spend(); i += step) {
    const RunGlyph& glyph = g_[i];
    if (skips(lookup, glyph)) {
      continue;
    }
    const bool may = may_skip(lookup, glyph, is_context);
    const bool has_form = is_context || (glyph.kind >> 2 & mask_) != 0;
    if (has_form && (want == Want::any ? !may : in_set(set, glyph.glyph))) {
      return i;
    }
    if (!may) {
      return kNo;
    }
  }
  return kNo;
}

// Finds a row that begins with a glyph in a sorted table.
bool Shaper::find_row(uint32_t begin,
                      uint32_t row_bits,
                      uint32_t count,
                      uint32_t glyph,
                      uint32_t& at) const noexcept {
  const BitTable table = {&t_.bytes, begin, row_bits};
  const uint32_t row = table.find(0, count, glyph_bits(), glyph);
  at = begin + row * row_bits;
  return row != BitTable::kAbsent;
}

void Shaper::set_glyph(RunGlyph& glyph, uint32_t id) noexcept {
  glyph.glyph = static_cast<uint16_t>(id);
  glyph.flags &= static_cast<uint8_t>(~kIgnorable);
  glyph.row = static_cast<uint8_t>(row_of(id));
  glyph.kind = static_cast<uint8_t>((glyph.kind & ~3u) |
                                    get(row_bit(glyph.row), shap::kClassBits));
}

bool Shaper::insert(int32_t place, int32_t count) noexcept {
  if (n_ + count > room_) {
    status_ = Status::buffer_small;
    return false;
  }
  for (int32_t i = n_; i-- > place;) {
    g_[i + count] = g_[i];
  }
  n_ += count;
  return true;
}

void Shaper::erase(int32_t place) noexcept {
  --n_;
  for (int32_t i = place; i < n_; ++i) {
    g_[i] = g_[i + 1];
  }
}

// Makes one cluster of glyphs, and of those that belong to their clusters.
void Shaper::merge(int32_t begin, int32_t end) noexcept {
  uint16_t least = g_[begin].cluster;
  bool is_one = true;
  for (int32_t i = begin + 1; i < end; ++i) {
    is_one = is_one && g_[i].cluster == least;
    least = g_[i].cluster < least ? g_[i].cluster : least;
  }
  if (is_one) {
    return;
  }
  while (end < n_ && g_[end].cluster == g_[end - 1].cluster) {
    ++end;
  }
  while (begin > 0 && g_[begin - 1].cluster == g_[begin].cluster) {
    --begin;
  }
  for (int32_t i = begin; i < end; ++i) {
    g_[i].cluster = least;
  }
}

// Marks get no room, and all stand where they are attached; then the order in
// which they are drawn.
void Shaper::finish(bool is_right_to_left) noexcept {
  for (int32_t i = 0; i < n_; ++i) {
    RunGlyph& glyph = g_[i];
    if (is_mark(glyph)) {
      glyph.advance = 0;
    }
    if ((glyph.flags & kIgnorable) != 0) {
      glyph.advance = 0;
      glyph.x = 0;
      glyph.y = 0;
    }
  }
  // First what hangs on glyphs behind it, from the last one on, then marks.
  for (int32_t i = n_; i-- > 0;) {
    if (g_[i].link > 0) {
      settle(i, is_right_to_left);
    }
  }
  for (int32_t i = 0; i < n_; ++i) {
    settle(i, is_right_to_left);
  }
  hide_ignorables();
  for (int32_t i = 0; is_right_to_left && i < n_ / 2; ++i) {
    const RunGlyph glyph = g_[i];
    g_[i] = g_[n_ - 1 - i];
    g_[n_ - 1 - i] = glyph;
  }
}

// Adds the places of all that a glyph hangs on, which do not hang then.
void Shaper::settle(int32_t i, bool is_right_to_left) noexcept {
  int32_t x = g_[i].x;
  int32_t y = g_[i].y;
  bool moves_x = true;
  int32_t from = i;
  for (int32_t most = n_; g_[from].link != 0 && most > 0 && spend(); --most) {
    const int32_t to = from + g_[from].link;
    if (to < 0 || to >= n_) {
      break;
    }
    moves_x = moves_x && (g_[from].flags & kCursiveLink) == 0;
    y += g_[to].y;
    if (moves_x) {
      x += g_[to].x;
      // A link of a mark goes back.
      for (int32_t k = to; k < from; ++k) {
        x += is_right_to_left ? g_[k + 1].advance : -g_[k].advance;
      }
    }
    from = to;
  }
  g_[i].x = static_cast<int16_t>(x);
  g_[i].y = static_cast<int16_t>(y);
  g_[i].link = 0;
}

// What shows nothing becomes a space without width, or goes.
void Shaper::hide_ignorables() noexcept {
  uint16_t space = 0;
  const bool has_space = font_.glyph_of(' ', space) == Status::ok;
  int32_t out = 0;
  for (int32_t i = 0; i < n_; ++i) {
    if ((g_[i].flags & kIgnorable) != 0) {
      if (!has_space) {
        continue;
      }
      g_[i].glyph = space;
    }
    g_[out++] = g_[i];
  }
  n_ = out;
}

}  // namespace inkcell::detail
