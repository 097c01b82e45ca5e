// Characters in the order and the forms in which they are drawn.
#include "shaper.hpp"

namespace inkcell::detail {

namespace shap = format::shaping;

namespace {

// Code points that show nothing where no lookup replaces them.
bool is_default_ignorable(uint32_t c) noexcept {
  struct Range {
    uint32_t first;
    uint32_t extra;
  };
  static constexpr Range kRanges[] = {
      {0xad, 0},    {0x34f, 0},  {0x61c, 0},   {0x115f, 1},
      {0x17b4, 1},  {0x180b, 4}, {0x200b, 4},  {0x202a, 4},
      {0x2060, 15}, {0x3164, 0}, {0xfe00, 15}, {0xfeff, 0},
      {0xffa0, 0},  {0xfff0, 8}, {0x1d173, 7}, {0xe0000, 0xfff}};
  if (c < 0xad) {
    return false;
  }
  for (const Range& range : kRanges) {
    if (c - range.first <= range.extra) {
      return true;
    }
  }
  return false;
}

// Of Thai, and of Lao, which is the same 128 code points higher.
bool is_above_base(uint32_t c) noexcept {
  c &= ~uint32_t{0x80};
  return c == 0xe31 || c - 0xe34 <= 3 || c - 0xe47 <= 7;
}

// Whether ranks are in the order of Unicode there.
bool is_letter_mark(const RunGlyph& glyph) noexcept {
  return glyph.row != 0;
}

uint8_t number_of_mark(const RunGlyph& glyph) noexcept {
  return static_cast<uint8_t>(glyph.link);
}

// Where the character before the byte `at` begins; bytes of no character are
// one each.
size_t before(const Text& text, size_t at) noexcept {
  const size_t most = at > 4 ? at - 4 : 0;
  size_t begin = at - 1;
  while (begin > most &&
         (static_cast<uint8_t>(text.data[begin]) & 0xc0) == 0x80) {
    --begin;
  }
  return begin;
}

}  // namespace

void Shaper::set_traits(RunGlyph& glyph, uint32_t code) noexcept {
  const CharacterTraits found = traits(code);
  set_code(glyph, code);
  glyph.ligature = found.joining;
  glyph.row = found.rank;
  glyph.link = static_cast<int8_t>(found.mark);
}

void Shaper::add_character(uint32_t code, uint32_t cluster) noexcept {
  if (n_ >= room_) {
    status_ = Status::buffer_small;
    return;
  }
  RunGlyph& glyph = g_[n_++];
  glyph = RunGlyph();
  set_traits(glyph, code);
  glyph.cluster = static_cast<uint16_t>(cluster);
  glyph.kind = shap::kAnyForm << 2;
  // Marks and joiners belong to the letter before them.
  if ((glyph.ligature >= shap::kLowMark || code == 0x200d) && n_ > 1) {
    glyph.cluster = g_[n_ - 2].cluster;
  }
  if (code == 0x200c || code == 0x200d) {
    glyph.flags = kIgnorable | (code == 0x200c ? kZwnj : kZwj);
  } else if (is_default_ignorable(code)) {
    glyph.flags = kIgnorable;
  } else if (program_.has(shap::kThai) && is_above_base(code)) {
    glyph.flags = kAboveBase;
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
  const RunGlyph glyph = g_[end];
  int32_t ring = end;
  for (; ring > 0 && (g_[ring - 1].flags & kAboveBase) != 0; --ring) {
    g_[ring] = g_[ring - 1];
  }
  g_[ring] = glyph;
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
        const RunGlyph glyph = g_[i];
        int32_t to = i;
        for (; to > begin && g_[to - 1].row > glyph.row; --to) {
          g_[to] = g_[to - 1];
        }
        g_[to] = glyph;
        if (to != i) {
          merge(to, i + 1);
        }
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
      const RunGlyph glyph = g_[i];
      g_[i] = g_[i - 1];
      g_[i - 1] = glyph;
      return;
    }
  }
}

// Takes composed letters apart where a mark behind them comes before their own.
void Shaper::part_letters() noexcept {
  for (int32_t i = 0; i + 1 < n_; ++i) {
    for (uint32_t depth = 0; depth < 4; ++depth) {
      const RunGlyph& next = g_[i + 1];
      uint32_t letter = 0;
      uint32_t number = 0;
      const uint32_t code = code_of(g_[i]);
      if (!is_letter_mark(next) || is_letter_mark(g_[i]) ||
          composed(code, number_of_mark(next)) != 0 ||
          !decompose(code, letter, number) || number == 0) {
        break;
      }
      RunGlyph mark = g_[i];
      set_traits(mark, get(t_.marks + 16 * (number - 1), 16));
      if (mark.row <= next.row || !insert(i + 1, 1)) {
        break;
      }
      set_traits(g_[i], letter);
      int32_t to = i + 1;
      for (; to + 1 < n_ && is_letter_mark(g_[to + 1]) &&
             g_[to + 1].row < mark.row;
           ++to) {
        g_[to] = g_[to + 1];
      }
      g_[to] = mark;
    }
  }
}

void Shaper::compose() noexcept {
  int32_t starter = 0;
  int32_t out = 1;
  for (int32_t i = 1; i < n_; ++i) {
    const RunGlyph glyph = g_[i];
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

// Forms of letters by what stands beside them.
void Shaper::join(const Text& text, const ScriptRun& run) noexcept {
  const auto set_form = [this](int32_t i, uint32_t form) {
    if (i >= 0) {
      g_[i].kind =
          static_cast<uint8_t>(class_of(g_[i]) | (shap::kAnyForm | form) << 2);
    }
  };
  bool is_open = false;  // whether the letter before joins
  bool is_final = false;
  int32_t last = kNo;
  const auto step = [&](uint32_t type, int32_t i) {
    if (type >= shap::kLowMark) {
      return;
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
  };
  constexpr uint32_t kContextCharacters = 5;
  size_t begin = run.begin;
  for (uint32_t i = 0; i < kContextCharacters && begin != 0; ++i) {
    begin = before(text, begin);
    Text one(text.data + begin, run.begin - begin);
    const uint32_t type = traits(next_code_point(one)).joining;
    if (type < shap::kLowMark) {
      step(type, kNo);
      break;
    }
  }
  for (int32_t i = 0; i < n_; ++i) {
    step(g_[i].ligature, i);
  }
  Text rest(text.data + run.end, text.size - run.end);
  for (uint32_t i = 0; i < kContextCharacters && rest.size != 0; ++i) {
    const uint32_t type = traits(next_code_point(rest)).joining;
    if (type < shap::kLowMark) {
      step(type, kNo);
      break;
    }
  }
}

void Shaper::find_glyphs() noexcept {
  for (int32_t i = 0; i < n_; ++i) {
    RunGlyph& glyph = g_[i];
    const uint32_t id = font_.glyph_or_notdef(code_of(glyph));
    glyph.link = 0;
    glyph.ligature = 0;
    glyph.component = 0;
    const uint8_t flags = glyph.flags & (kIgnorable | kZwj | kZwnj);
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
