// Characters in the order and the forms in which they are drawn.
#include "shaper.hpp"
#include "text/blank.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

namespace {

// Of Thai, and of Lao, which is the same 128 code points higher.
bool is_above_base(uint32_t c) noexcept {
  c &= ~uint32_t{0x80};
  return c == 0xe31 || c - 0xe34 <= 3 || c - 0xe47 <= 7;
}

// Whether ranks are in the order of Unicode there.
bool is_letter_mark(const TextGlyph& glyph) noexcept {
  return glyph.row != 0;
}

uint8_t number_of_mark(const TextGlyph& glyph) noexcept {
  return static_cast<uint8_t>(glyph.link);
}

}  // namespace

void Shaper::set_traits(TextGlyph& glyph, uint32_t code) noexcept {
  const CharacterTraits found = traits(code);
  set_code(glyph, code);
  glyph.ligature = found.joining;
  glyph.row = found.rank;
  glyph.link = static_cast<int8_t>(found.mark);
}

// Whether the last glyph belongs to the letter before it: marks, joiners, what
// joiners join of emoji, and the second letter of a flag.
bool Shaper::continues(const TextGlyph& glyph, uint32_t code) const noexcept {
  const TextGlyph& last = g_[n_ - 2];
  if (glyph.ligature >= shap::kLowMark || code == 0x200d) {
    return true;
  }
  return program_.has(shap::kEmoji) &&
         ((last.flags & kZwj) != 0 ||
          (glyph.ligature == shap::kJoinsRight &&
           last.ligature == shap::kJoinsRight &&
           (n_ < 3 || g_[n_ - 3].cluster != last.cluster)));
}

void Shaper::add_character(uint32_t code, uint32_t cluster) noexcept {
  if (n_ >= room_) {
    status_ = Status::buffer_small;
    return;
  }
  TextGlyph& glyph = g_[n_++];
  glyph = TextGlyph();
  set_traits(glyph, code);
  glyph.cluster = static_cast<uint16_t>(cluster);
  glyph.kind = shap::kAnyForm << 2;
  if (n_ > 1 && continues(glyph, code)) {
    glyph.cluster = g_[n_ - 2].cluster;
  }
  if (code == 0x200c || code == 0x200d) {
    glyph.flags = kIgnorable | (code == 0x200c ? kZwnj : kZwj);
  } else if (shown_as(code) == Shown::nothing) {
    glyph.flags = kIgnorable;
  }
}

// SARA AM is drawn as a ring above the letter, below marks that are there, and
// SARA AA.
void Shaper::split_sara_am(uint32_t code, uint32_t cluster) noexcept {
  const int32_t end = n_;
  add_character(code + 0x1a, end != 0 ? g_[end - 1].cluster : cluster);
  add_character(code - 1, end != 0 ? g_[end - 1].cluster : cluster);
  if (status_ != Status::ok) {
    return;
  }
  int32_t ring = end;
  while (ring > 0 && is_above_base(code_of(g_[ring - 1]))) {
    --ring;
  }
  move(end, ring);
}

void Shaper::read(const Text& text, const ScriptRun& run) noexcept {
  Text rest(text.data + run.begin, run.end - run.begin);
  const bool is_thai = program_.has(shap::kThai);
  for (uint32_t cluster = 0; rest.size != 0 && status_ == Status::ok;
       ++cluster) {
    uint32_t code = next_code_point(rest);
    if (cluster > 65535) {
      status_ = Status::bad_argument;
    } else if (is_thai && (code == 0xe33 || code == 0xeb3)) {
      split_sara_am(code, cluster);
    } else {
      if (run.is_right_to_left) {
        code = mirrored(code);
      }
      add_character(code, cluster);
    }
  }
}

// A mark stands before those of higher ranks: an insertion sort, whose marks
// are few.
void Shaper::order_marks() noexcept {
  for (int32_t begin = 0; begin < n_; ++begin) {
    if (!is_letter_mark(g_[begin])) {
      continue;
    }
    int32_t end = begin + 1;
    while (end < n_ && is_letter_mark(g_[end])) {
      ++end;
    }
    if (end - begin <= static_cast<int32_t>(shap::kMaxMarks)) {
      for (int32_t i = begin + 1; i < end; ++i) {
        int32_t to = i;
        while (to > begin && g_[to - 1].row > g_[i].row) {
          --to;
        }
        move(i, to);
        merge(to, i + 1);
      }
      if (program_.has(shap::kHebrew)) {
        order_hebrew(begin, end);
      }
    }
    begin = end;
  }
}

// A narrow vowel between a wide one and what is below goes to the end.
void Shaper::order_hebrew(int32_t begin, int32_t end) noexcept {
  for (int32_t i = begin + 2; i < end; ++i) {
    if (g_[i - 2].ligature == shap::kWideMark &&
        g_[i - 1].ligature == shap::kNarrowMark &&
        g_[i].ligature == shap::kLowMark) {
      merge(i - 1, i + 1);
      move(i, i - 1);
      return;
    }
  }
}

// Takes letters apart that do not compose with the mark behind them, and puts
// their marks in order: compose() then finds those that do.
void Shaper::part_letters() noexcept {
  for (int32_t i = 0; i + 1 < n_; ++i) {
    uint32_t letter = 0;
    uint32_t number = 0;
    while (is_letter_mark(g_[i + 1]) && !is_letter_mark(g_[i]) &&
           composed(code_of(g_[i]), number_of_mark(g_[i + 1])) == 0 &&
           decompose(code_of(g_[i]), letter, number)) {
      seek(kMarkTable, number - 1);
      const uint32_t mark = take(16);
      if (font_.glyph_or_notdef(mark) == 0 || !spend() || !insert(i + 1, 1)) {
        break;
      }
      g_[i + 1] = g_[i];
      set_traits(g_[i + 1], mark);
      set_traits(g_[i], letter);
      int32_t to = i + 1;
      while (to + 1 < n_ && is_letter_mark(g_[to + 1]) &&
             g_[to + 1].row < g_[i + 1].row) {
        ++to;
      }
      move(i + 1, to);
    }
  }
}

void Shaper::compose() noexcept {
  int32_t starter = 0;
  int32_t out = 1;
  for (int32_t i = 1; i < n_; ++i) {
    const TextGlyph glyph = g_[i];
    if (glyph.link != 0 &&
        (starter == out - 1 || g_[out - 1].row < glyph.row)) {
      const uint32_t code =
          composed(code_of(g_[starter]), number_of_mark(glyph));
      if (code != 0) {
        // As of the letter: joining, order, cluster.
        set_code(g_[starter], code);
        g_[starter].link = 0;
        continue;
      }
    }
    if (!is_letter_mark(glyph)) {
      starter = out;
    }
    g_[out++] = glyph;
  }
  n_ = n_ < out ? n_ : out;
}

// The joining type of the letter that ends at the byte `at`, or that begins
// there: of five characters the first that is no mark.
uint32_t Shaper::type_beside(const Text& text,
                             size_t at,
                             bool is_before) noexcept {
  Text rest(text.data + at, text.size - at);
  for (uint32_t i = 0; i < 5; ++i) {
    if (is_before && at != 0) {
      at = cut(Text(text.data, at), at - 1).size;
      rest = Text(text.data + at, text.size - at);
    } else if (is_before || rest.size == 0) {
      break;
    }
    const uint32_t type = traits(next_code_point(rest)).joining;
    if (type < shap::kLowMark) {
      return type;
    }
  }
  return shap::kJoinsNone;
}

// Forms of letters by what stands beside them.
void Shaper::join(const Text& text, const ScriptRun& run) noexcept {
  const auto set_form = [this](int32_t i, uint32_t form) {
    if (i >= 0 && i < n_) {
      g_[i].kind =
          static_cast<uint8_t>(class_of(g_[i]) | (shap::kAnyForm | form) << 2);
    }
  };
  bool is_open = false;  // whether the letter before joins
  bool is_final = false;
  int32_t last = kNo;
  for (int32_t i = -1; i <= n_; ++i) {
    uint32_t type = 0;
    if (i < 0) {
      type = type_beside(text, run.begin, true);
    } else if (i == n_) {
      type = type_beside(text, run.end, false);
    } else {
      type = g_[i].ligature;
    }
    if (type >= shap::kLowMark) {
      continue;
    }
    const bool takes = type == shap::kJoinsRight || type == shap::kJoinsDual;
    if (is_open && takes) {
      set_form(last, is_final ? shap::kMedial : shap::kInitial);
    }
    is_final = is_open && takes;
    if (type != shap::kJoinsNone) {
      set_form(i, is_final ? shap::kFinal : shap::kIsolated);
    }
    is_open = type == shap::kJoinsDual || type == shap::kJoinsLeft;
    last = i;
  }
}

void Shaper::find_glyphs() noexcept {
  for (int32_t i = 0; i < n_; ++i) {
    TextGlyph& glyph = g_[i];
    const uint32_t id = font_.glyph_or_notdef(code_of(glyph));
    glyph.link = 0;
    glyph.ligature = 0;
    glyph.component = 0;
    const uint8_t flags = glyph.flags;
    set_glyph(glyph, id);
    glyph.flags = flags;
  }
}

void Shaper::advance_all() noexcept {
  for (int32_t i = 0; i < n_; ++i) {
    g_[i].advance = static_cast<int16_t>(font_.advance(g_[i].glyph));
    g_[i].x = 0;
    g_[i].y = 0;
    g_[i].link = 0;
  }
}

}  // namespace inkcell::detail
