#include "shaper.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

Status Shaper::shape(const Text& text,
                     const ScriptRun& run,
                     uint32_t program) noexcept {
  if (program < header(shap::kPrograms)) {
    program_ = ShapeReader::program(program);
  }
  const bool has_syllables = program_.has(shap::kSyllables);
  if (has_syllables && syllables_ == nullptr) {
    return Status::unsupported;
  }
  read(text, run);
  const uint32_t most = header(shap::kSteps);
  steps_ = (most < shap::kMaxSteps ? most : shap::kMaxSteps) *
           (static_cast<uint32_t>(n_) + 1);
  if (has_syllables) {
    syllables_->run(*this, SyllableStep::split);
  }
  order_marks();
  part_letters();
  compose();
  if (program_.has(shap::kJoins)) {
    join(text, run);
  }
  if (has_syllables) {
    syllables_->run(*this, SyllableStep::part);
  }
  find_glyphs();
  run_entries(program_.first, program_.substitutions);
  advance_all();
  run_entries(program_.first + program_.substitutions, program_.positions);
  // Where the script positions nothing, pairs are those of plain text.
  for (int32_t i = 0;
       program_.positions == 0 && !run.is_right_to_left && i + 1 < n_; ++i) {
    g_[i].advance = static_cast<int16_t>(
        g_[i].advance + font_.kerning(g_[i].glyph, g_[i + 1].glyph));
  }
  finish(run.is_right_to_left);
  return status_;
}

bool Shaper::spend() noexcept {
  if (status_ != Status::ok) {
    return false;
  }
  if (steps_ == 0) {
    status_ = Status::unsupported;
    return false;
  }
  --steps_;
  return true;
}

namespace {

// What the data of a type begin with: bases and numbers of 16 bits, widths of
// 5. Then what is in its rows: glyphs, and the columns of the first widths.
constexpr uint16_t kind_of(uint32_t bases,
                           uint32_t widths,
                           uint32_t numbers,
                           uint32_t glyphs,
                           uint32_t columns) noexcept {
  return static_cast<uint16_t>(bases | widths << 2 | numbers << 5 |
                               glyphs << 7 | columns << 9);
}

// From type 0 on; contexts have none.
constexpr uint16_t kLookupKinds[] = {0,
                                     kind_of(0, 0, 0, 2, 0),
                                     kind_of(0, 1, 0, 1, 1),
                                     0,
                                     kind_of(0, 1, 0, 2, 1),
                                     0,
                                     0,
                                     0,
                                     0,
                                     kind_of(3, 3, 0, 1, 3),
                                     kind_of(1, 5, 1, 1, 2),
                                     kind_of(1, 7, 2, 1, 2),
                                     kind_of(0, 6, 2, 1, 2),
                                     kind_of(0, 6, 2, 1, 2),
                                     kind_of(0, 6, 2, 1, 2),
                                     0};

}  // namespace

void Shaper::load(uint32_t number) noexcept {
  lookup_.number = static_cast<uint16_t>(number);
  seek(kLookupTable, number);
  lookup_.type = static_cast<uint8_t>(take(shap::kTypeBits));
  lookup_.skip = static_cast<uint8_t>(take(shap::kSkipBits));
  lookup_.filter = static_cast<uint16_t>(take(header(shap::kSetBits)));
  lookup_.count = static_cast<uint16_t>(take(16));
  at_ = t_.begins[kDataTable] + take(header(shap::kOffsetBits));
  const uint32_t kind = kLookupKinds[lookup_.type];
  for (uint32_t i = 0; i < (kind & 3); ++i) {
    lookup_.bases[i] = static_cast<int16_t>(take(16));
  }
  uint32_t row_bits = (kind >> 7 & 3) * glyph_bits();
  for (uint32_t i = 0; i < (kind >> 2 & 7); ++i) {
    const uint32_t width = take(5);
    lookup_.widths[i] = static_cast<uint8_t>(width);
    row_bits += i < kind >> 9 ? width : 0;
  }
  for (uint32_t i = 0; i < (kind >> 5 & 3); ++i) {
    lookup_.numbers[i] = static_cast<uint16_t>(take(16));
  }
  lookup_.row_bits = static_cast<uint8_t>(row_bits);
  lookup_.rows = at_;
  lookup_.rest = at_ + row_bits * lookup_.count;
}

// Lookups of the program, each over the whole run.
void Shaper::run_entries(uint32_t first, uint32_t count) noexcept {
  const uint32_t row_bits = t_.row_bits[kRowTable];
  const uint32_t rows = t_.begins[kRowTable] + shap::kClassBits;
  for (const uint32_t end = first + count; first < end; ++first) {
    seek(kEntryTable, first);
    const uint32_t own = take(header(shap::kLookupBits));
    mask_ = take(shap::kMaskBits);
    manual_zwj_ = take(1) != 0;
    if (mask_ == 0 && program_.has(shap::kSyllables)) {
      syllables_->run(*this, own == shap::kOrderFirst
                                 ? SyllableStep::order_first
                                 : SyllableStep::order_last);
    }
    bool is_loaded = false;
    for (int32_t i = 0; i < n_ && status_ == Status::ok;) {
      int32_t next = kNo;
      // Most lookups concern no glyph of a run: they are not read.
      if (has_form(g_[i]) && has_bit(rows + row_bits * g_[i].row + own)) {
        if (!is_loaded) {
          load(own);
          is_loaded = true;
        }
        if (lookup_.type == shap::kReverse) {
          for (int32_t k = n_; k-- > i;) {
            if (has_form(g_[k])) {
              static_cast<void>(apply(k, 0));
            }
          }
          break;
        }
        next = apply(i, 0);
      }
      // Where nothing replaces a glyph, the next takes its place.
      const bool stays =
          is_loaded && lookup_.type == shap::kMultiple && next == i;
      i = next > i || stays ? next : i + 1;
    }
  }
}

// What follows the glyphs that the lookup took; kNo: it does not apply.
int32_t Shaper::apply(int32_t i, uint32_t depth) noexcept {
  if (!spend()) {
    return kNo;
  }
  if (lookup_.row_bits == 0) {
    return apply_context(i, depth);
  }
  if (!find_row(g_[i].glyph)) {
    return kNo;
  }
  switch (lookup_.type) {
    case shap::kSingle:
      return replace_one(i);
    case shap::kMultiple:
      return replace_by_many(i);
    case shap::kLigatures:
      return ligate(i);
    case shap::kAdjust:
      return adjust(i);
    case shap::kPairs:
      return kern(i);
    default:
      return attach(i);
  }
}

// Whether a glyph that shows nothing may be looked over.
bool Shaper::may_skip(const TextGlyph& glyph, bool is_context) const noexcept {
  if ((glyph.flags & kIgnorable) == 0) {
    return false;
  }
  if ((glyph.flags & kZwnj) != 0) {
    return lookup_.type >= shap::kAdjust ||
           (is_context && !(manual_zwj_ && program_.has(shap::kSyllables)));
  }
  return is_context || !manual_zwj_ || (glyph.flags & kZwj) == 0;
}

// The next glyph that is accepted of those that the lookup sees; kNo: another
// comes first. Those of its input have its form.
int32_t Shaper::find_next(int32_t from,
                          int32_t step,
                          uint32_t set,
                          bool is_context) noexcept {
  for (int32_t i = from + step; i >= 0 && i < n_ && spend(); i += step) {
    const TextGlyph& glyph = g_[i];
    const uint32_t kind = class_of(glyph);
    if ((lookup_.skip << 1 >> kind & 1) != 0 ||
        (kind == 3 && lookup_.filter != 0 &&
         !in_set(lookup_.filter - 1u, glyph.glyph))) {
      continue;
    }
    const bool may = may_skip(glyph, is_context);
    // Of its syllable, until positions take the room of its number.
    if ((is_context || has_form(glyph)) &&
        (lookup_.type >= shap::kAdjust || glyph.y == g_[from].y)) {
      bool is_found = !may;
      if (set == kBranch) {
        at_ = branch_;
        is_found = find(lookup_.row_bits, branches_, glyph_bits(), glyph.glyph);
      } else if (set != kAnyGlyph) {
        is_found = in_set(set, glyph.glyph);
      }
      if (is_found) {
        return i;
      }
    }
    if (!may) {
      return kNo;
    }
  }
  return kNo;
}

void Shaper::set_glyph(TextGlyph& glyph, uint32_t id) noexcept {
  glyph.glyph = static_cast<uint16_t>(id);
  glyph.flags &= static_cast<uint8_t>(~kIgnorable);
  uint32_t row = 0;
  if (id < header(shap::kGlyphs)) {
    seek(kGlyphTable, id);
    row = take(header(shap::kRowBits));
  }
  glyph.row = static_cast<uint8_t>(row);
  seek(kRowTable, row);
  glyph.kind =
      static_cast<uint8_t>((glyph.kind & ~3u) | take(shap::kClassBits));
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

// The glyphs in between go one place the other way.
void Shaper::move(int32_t from, int32_t to) noexcept {
  const int32_t step = from < to ? 1 : -1;
  const TextGlyph glyph = g_[from];
  for (; from != to; from += step) {
    g_[from] = g_[from + step];
  }
  g_[to] = glyph;
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
    TextGlyph& glyph = g_[i];
    if ((glyph.flags & kIgnorable) != 0 ||
        (is_mark(glyph) && !program_.has(shap::kSyllables))) {
      glyph.advance = 0;
    }
  }
  // From the last one on, so that chains of what hangs on glyphs behind it are
  // short; those of marks are.
  for (int32_t i = n_; i-- > 0;) {
    settle(i, is_right_to_left);
  }
  hide_ignorables();
  for (int32_t i = 0; is_right_to_left && i < n_ / 2; ++i) {
    const TextGlyph glyph = g_[i];
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
  while (g_[from].link != 0 && spend()) {
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
      g_[i].x = 0;
      g_[i].y = 0;
    }
    g_[out++] = g_[i];
  }
  n_ = out;
}

}  // namespace inkcell::detail
