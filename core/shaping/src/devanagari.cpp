// Over 400 lines: one script, whose steps share what is said of a syllable.
//
// Syllables of Devanagari, and the order of their letters: the steps of
// OpenType's specification of Indic scripts, as HarfBuzz takes them.
#include "inkcell/shaping/devanagari.hpp"

#include "shaper.hpp"

namespace inkcell {
namespace detail {
namespace devanagari {
namespace {

namespace shap = format::shaping;

// What a character is in a syllable: the low half of TextGlyph::x.
enum Category : uint8_t {
  kOther,
  kConsonant,
  kRa,
  kVowel,
  kPlaceholder,  // a digit, a dash: marks may stand on it
  kNukta,
  kHalant,
  kMatra,
  kLeftMatra,
  kModifier,
  kAccent,
  kJoiner,
  kNonJoiner,
  kSymbol,
  kLigature = 15,  // of what was something: no step looks at it
};

// Where it stands in a syllable: the high half.
enum Place : uint8_t {
  kStart,
  kReph,
  kBeforeAll,
  kBeforeBase,
  kBase,
  kBelow,
  kBehind,
  kModifiers,
  kEnd,
};

constexpr uint32_t set_of(Category a) noexcept {
  return 1u << a;
}
template <typename... Rest>
constexpr uint32_t set_of(Category a, Rest... rest) noexcept {
  return set_of(a) | set_of(rest...);
}

constexpr uint32_t kLetters = set_of(kConsonant, kRa);
constexpr uint32_t kBases = set_of(kConsonant, kRa, kVowel, kPlaceholder);
constexpr uint32_t kJoiners = set_of(kJoiner, kNonJoiner);
constexpr uint32_t kMatras = set_of(kMatra, kLeftMatra);
constexpr uint32_t kFollowers = set_of(kJoiner, kNonJoiner, kNukta, kHalant);

Category category_of(uint32_t c) noexcept {
  struct Range {
    uint8_t last;  // of the block
    uint8_t category;
  };
  static constexpr Range kRanges[] = {
      {0x03, kModifier},  {0x14, kVowel},       {0x2f, kConsonant},
      {0x30, kRa},        {0x39, kConsonant},   {0x3b, kMatra},
      {0x3c, kNukta},     {0x3d, kSymbol},      {0x3e, kMatra},
      {0x3f, kLeftMatra}, {0x4c, kMatra},       {0x4d, kHalant},
      {0x4e, kLeftMatra}, {0x4f, kMatra},       {0x50, kOther},
      {0x52, kAccent},    {0x54, kModifier},    {0x57, kMatra},
      {0x5f, kConsonant}, {0x61, kVowel},       {0x63, kMatra},
      {0x65, kOther},     {0x6f, kPlaceholder}, {0x71, kOther},
      {0x77, kVowel},     {0x7f, kConsonant}};
  if (c - '0' <= 9 || c == '-' || c == 0xa0 || c == 0x25cc) {
    return kPlaceholder;
  }
  if (c == 0x200c || c == 0x200d) {
    return c == 0x200c ? kNonJoiner : kJoiner;
  }
  if (c - 0x900 > 0x7f) {
    return kOther;
  }
  const Range* range = kRanges;
  while (range->last < c - 0x900) {
    ++range;
  }
  return static_cast<Category>(range->category);
}

}  // namespace

class Order {
 public:
  static void run(Shaper& shaper, SyllableStep step) noexcept;

 private:
  explicit Order(Shaper& shaper) noexcept : s_(shaper), g_(shaper.g_) {}

  Category category(int32_t i) const noexcept {
    return i < s_.n_ ? static_cast<Category>(g_[i].x & 15) : kOther;
  }
  bool is(int32_t i, uint32_t set) const noexcept {
    return (set >> category(i) & 1) != 0;
  }
  uint32_t place(int32_t i) const noexcept {
    return static_cast<uint32_t>(g_[i].x) >> 4;
  }
  void set_place(int32_t i, uint32_t place) noexcept {
    g_[i].x = static_cast<int16_t>((g_[i].x & 15) | place << 4);
  }
  void add_forms(int32_t i, uint32_t forms) noexcept {
    g_[i].kind = static_cast<uint8_t>(g_[i].kind | forms << 2);
  }

  void split() noexcept;
  void part() noexcept;
  int32_t end_of_syllable(int32_t i, bool& has_order) const noexcept;
  int32_t skip_letters(int32_t i) const noexcept;
  int32_t skip_vowels(int32_t i) const noexcept;
  int32_t skip_tail(int32_t i) const noexcept;
  int32_t skip_one(int32_t i, uint32_t set) const noexcept {
    return is(i, set) ? i + 1 : i;
  }

  void order(bool is_last) noexcept;
  int32_t find_base(int32_t begin, int32_t end, bool& has_reph) const noexcept;
  void place_all(int32_t begin, int32_t end, int32_t base) noexcept;
  void sort(int32_t begin, int32_t end) noexcept;
  void turn_matras(int32_t begin, int32_t end) noexcept;
  void reverse(int32_t begin, int32_t end) noexcept;
  void merge_moved(int32_t begin, int32_t end, int32_t base) noexcept;
  void order_first(int32_t begin, int32_t end) noexcept;
  void order_last(int32_t begin, int32_t end) noexcept;
  int32_t place_of_matra(int32_t begin,
                         int32_t end,
                         int32_t base) const noexcept;
  int32_t place_of_reph(int32_t begin,
                        int32_t end,
                        int32_t base) const noexcept;

  Shaper& s_;
  TextGlyph* g_;
};

// Letters with a nukta are always taken apart.
void Order::split() noexcept {
  static constexpr uint8_t kLetter[] = {0x15, 0x16, 0x17, 0x1c,
                                        0x21, 0x22, 0x2b, 0x2f};
  for (int32_t i = 0; i < s_.n_; ++i) {
    const uint32_t number = s_.code_of(g_[i]) - 0x958;
    if (number < sizeof kLetter && s_.insert(i + 1, 1)) {
      s_.set_traits(g_[i], 0x900u + kLetter[number]);
      ++i;
      g_[i] = g_[i - 1];
      s_.set_traits(g_[i], 0x93c);
    }
  }
}

// Halants, each with the letter behind it.
int32_t Order::skip_letters(int32_t i) const noexcept {
  for (int32_t k = 0; k < 4; ++k) {
    int32_t j = skip_one(i, kJoiners);
    if (category(j) != kHalant) {
      break;
    }
    ++j;
    if (category(j) == kJoiner) {
      j = skip_one(j + 1, set_of(kNukta));
    }
    if (!is(j, kLetters)) {
      break;
    }
    i = skip_one(j + 1, set_of(kJoiner));
    i = skip_one(skip_one(i, set_of(kNukta)), set_of(kNukta));
  }
  return i;
}

// Vowel signs, or a halant.
int32_t Order::skip_vowels(int32_t i) const noexcept {
  const int32_t begin = i;
  for (int32_t k = 0; k < 4; ++k) {
    int32_t j = i;
    for (int32_t n = 0; n < 3; ++n) {
      j = skip_one(j, kJoiners);
    }
    if (!is(j, kMatras)) {
      break;
    }
    i = skip_one(skip_one(j + 1, set_of(kNukta)), set_of(kHalant));
  }
  if (i != begin) {
    return i;
  }
  const int32_t j = skip_one(i, kJoiners);
  if (category(j) != kHalant) {
    return i;
  }
  if (j == i && category(j + 1) == kNonJoiner) {
    return j + 2;
  }
  return category(j + 1) == kJoiner ? skip_one(j + 2, set_of(kNukta)) : j + 1;
}

int32_t Order::skip_tail(int32_t i) const noexcept {
  const int32_t j = skip_one(i, kJoiners);
  if (category(j) == kModifier) {
    i = skip_one(skip_one(j + 1, set_of(kModifier)), set_of(kNonJoiner));
  }
  while (category(i) == kAccent) {
    ++i;
  }
  return i;
}

int32_t Order::end_of_syllable(int32_t i, bool& has_order) const noexcept {
  const int32_t begin = i;
  const bool has_reph =
      category(i) == kRa && category(i + 1) == kHalant &&
      (is(i + 2, set_of(kVowel, kNukta)) ||
       is(skip_one(i + 2, kJoiners), kMatras | set_of(kHalant)));
  i += has_reph ? 2 : 0;
  has_order = true;
  const bool is_vowel = category(i) == kVowel;
  if (category(i) == kSymbol) {
    has_order = false;
    return skip_tail(skip_one(i + 1, set_of(kNukta)));
  }
  if (is_vowel || category(i) == kPlaceholder) {
    ++i;
  } else if (!has_reph && is(i, kLetters)) {
    i = skip_one(i + 1, set_of(kJoiner));
  }
  i = skip_one(skip_one(i, set_of(kNukta)), set_of(kNukta));
  const int32_t end = skip_tail(skip_vowels(skip_letters(i)));
  if (is_vowel && end == i && category(end) == kJoiner) {
    return end + 1;
  }
  has_order = end != begin;
  return has_order ? end : end + 1;
}

// Categories, and the numbers of syllables: TextGlyph::y, odd where the order
// matters.
void Order::part() noexcept {
  static constexpr uint8_t kPlaces[] = {
      kEnd,    kBase,      kBase,      kBase,      kBase, kEnd, kEnd,
      kBehind, kBeforeAll, kModifiers, kModifiers, kEnd,  kEnd, kEnd};
  for (int32_t i = 0; i < s_.n_; ++i) {
    TextGlyph& glyph = g_[i];
    const Category category = category_of(s_.code_of(glyph));
    uint32_t place = kPlaces[category];
    if (place == kBase && glyph.ligature == shap::kBelowForm) {
      place = kBelow;
    }
    glyph.x = static_cast<int16_t>(category | place << 4);
  }
  int32_t number = 0;
  for (int32_t i = 0; i < s_.n_;) {
    bool has_order = false;
    const int32_t end = end_of_syllable(i, has_order);
    number = (number + 2) & 0x7ffe;
    for (; i < end; ++i) {
      g_[i].y = static_cast<int16_t>(number | (has_order ? 1 : 0));
    }
  }
}

// The last consonant that has no form below.
int32_t Order::find_base(int32_t begin,
                         int32_t end,
                         bool& has_reph) const noexcept {
  int32_t base = end;
  int32_t limit = begin;
  has_reph = s_.program_.has(shap::kHasReph) && begin + 3 <= end &&
             category(begin) == kRa && category(begin + 1) == kHalant &&
             !is(begin + 2, kJoiners);
  if (has_reph) {
    limit += 2;
    base = begin;
  }
  for (int32_t i = end; --i >= limit;) {
    if (is(i, kBases)) {
      base = i;
      if (place(i) != kBelow) {
        break;
      }
    } else if (i > begin && category(i) == kJoiner &&
               category(i - 1) == kHalant) {
      break;
    }
  }
  has_reph = has_reph && base != begin;
  return base;
}

void Order::place_all(int32_t begin, int32_t end, int32_t base) noexcept {
  uint32_t last = kStart;
  for (int32_t i = begin; i < end; ++i) {
    if (is(i, kFollowers)) {
      uint32_t own = last;
      for (int32_t j = i;
           category(i) == kHalant && own == kBeforeAll && j > begin; --j) {
        own = place(j - 1);
      }
      set_place(i, own);
    } else if (place(i) != kModifiers) {
      last = place(i);
    }
  }
  // What is before a letter behind the base goes with it.
  last = static_cast<uint32_t>(base);
  for (int32_t i = base + 1; i < end; ++i) {
    if (is(i, kBases)) {
      for (int32_t j = static_cast<int32_t>(last) + 1; j < i; ++j) {
        if (place(j) < kModifiers) {
          set_place(j, place(i));
        }
      }
      last = static_cast<uint32_t>(i);
    } else if (is(i, kMatras)) {
      last = static_cast<uint32_t>(i);
    }
  }
}

// By place; TextGlyph::link is where each was.
void Order::sort(int32_t begin, int32_t end) noexcept {
  for (int32_t i = begin; i < end; ++i) {
    g_[i].link = static_cast<int8_t>(i - begin);
    int32_t to = i;
    while (to > begin && place(to - 1) > place(i)) {
      --to;
    }
    s_.move(i, to);
  }
}

void Order::reverse(int32_t begin, int32_t end) noexcept {
  for (; begin < --end; ++begin) {
    s_.move(begin, end);
    s_.move(end - 1, begin);
  }
}

// Of several left vowel signs, each with its nukta, the last comes first.
void Order::turn_matras(int32_t begin, int32_t end) noexcept {
  while (begin < end && place(begin) < kBeforeAll) {
    ++begin;
  }
  while (end > begin && place(end - 1) != kBeforeAll) {
    --end;
  }
  reverse(begin, end);
  for (int32_t i = begin; i < end; ++i) {
    if (is(i, kMatras)) {
      reverse(begin, i + 1);
      begin = i + 1;
    }
  }
}

// Makes one cluster of what changed places, from the base on.
void Order::merge_moved(int32_t begin, int32_t end, int32_t base) noexcept {
  if (end - begin > 127) {
    s_.merge(base, end);
    return;
  }
  for (int32_t i = base; i < end; ++i) {
    if (g_[i].link < 0) {
      continue;
    }
    int32_t least = i;
    int32_t most = i;
    for (int32_t j = begin + g_[i].link; j != i && g_[j].link >= 0;) {
      least = j < least ? j : least;
      most = j > most ? j : most;
      const int32_t next = begin + g_[j].link;
      g_[j].link = -1;
      j = next;
    }
    least = least > base ? least : base;
    if (most > least) {
      s_.merge(least, most + 1);
    }
  }
}

void Order::order_first(int32_t begin, int32_t end) noexcept {
  bool has_reph = false;
  int32_t base = find_base(begin, end, has_reph);
  for (int32_t i = begin; i < base; ++i) {
    if (place(i) > kBeforeBase) {
      set_place(i, kBeforeBase);
    }
  }
  if (base < end) {
    set_place(base, kBase);
  }
  if (has_reph) {
    set_place(begin, kReph);
  }
  place_all(begin, end, base);
  sort(begin, end);
  base = begin;
  while (base < end && place(base) != kBase) {
    ++base;
  }
  turn_matras(begin, base);
  merge_moved(begin, end, base);
  for (int32_t i = begin; i < end; ++i) {
    g_[i].link = 0;
    if (place(i) == kReph) {
      add_forms(i, shap::kReph);
    }
    if (i != base) {
      add_forms(
          i, shap::kBelowBase | (i < base ? shap::kHalf : shap::kBehindBase));
    }
  }
  for (int32_t i = begin + 1; i < end; ++i) {
    if (category(i) == kNonJoiner) {
      int32_t j = i;
      do {
        --j;
        g_[j].kind &= static_cast<uint8_t>(~(shap::kHalf << 2));
      } while (j > begin && !is(j, kBases));
    }
  }
}

// Behind the last halant before the base; `begin`: it stays.
int32_t Order::place_of_matra(int32_t begin,
                              int32_t end,
                              int32_t base) const noexcept {
  int32_t to = base == end ? base - 2 : base - 1;
  for (;; --to) {
    while (to > begin && !is(to, kMatras | set_of(kHalant))) {
      --to;
    }
    if (category(to) != kHalant || place(to) == kBeforeAll) {
      return begin;
    }
    if (to + 1 >= end) {
      return to;
    }
    if (category(to + 1) != kJoiner || to <= begin) {
      return category(to + 1) == kNonJoiner ? to + 1 : to;
    }
  }
}

int32_t Order::place_of_reph(int32_t begin,
                             int32_t end,
                             int32_t base) const noexcept {
  int32_t to = begin + 1;
  while (to < base && category(to) != kHalant) {
    ++to;
  }
  if (to < base) {
    return to + 1 < base && is(to + 1, kJoiners) ? to + 1 : to;
  }
  to = end - 1;
  while (to > begin && place(to) == kModifiers) {
    --to;
  }
  if (category(to) == kHalant) {
    for (int32_t i = base + 1, last = to; i < last; ++i) {
      to -= is(i, kMatras) ? 1 : 0;
    }
  }
  return to;
}

// Left vowel signs and the reph go to their places, which depend on what became
// ligatures.
void Order::order_last(int32_t begin, int32_t end) noexcept {
  int32_t base = begin;
  while (base < end && place(base) < kBase) {
    ++base;
  }
  if (base < end && base > begin && place(base) > kBase) {
    --base;
  }
  if (base == end && begin < base && category(base - 1) == kJoiner) {
    --base;
  }
  while (base < end && base > begin && is(base, set_of(kNukta, kHalant))) {
    --base;
  }
  if (begin + 1 < end && begin < base) {
    int32_t to = place_of_matra(begin, end, base);
    const auto merge_to = [&](int32_t from) {
      s_.merge(from, base + 1 < end ? base + 1 : end);
    };
    if (begin < to && place(to) != kBeforeAll) {
      for (int32_t i = to; i > begin; --i) {
        if (place(i - 1) == kBeforeAll) {
          base -= i - 1 < base && base <= to ? 1 : 0;
          s_.move(i - 1, to);
          merge_to(to);
          --to;
        }
      }
    } else {
      for (int32_t i = begin; i < base; ++i) {
        if (place(i) == kBeforeAll) {
          merge_to(i);
          break;
        }
      }
    }
  }
  if (begin + 1 < end && place(begin) == kReph &&
      category(begin) == kLigature) {
    const int32_t to = place_of_reph(begin, end, base);
    s_.merge(begin, to + 1);
    s_.move(begin, to);
  }
}

void Order::order(bool is_last) noexcept {
  for (int32_t i = 0; i < s_.n_ && s_.spend();) {
    const int32_t begin = i;
    while (i < s_.n_ && g_[i].y == g_[begin].y) {
      ++i;
    }
    if ((g_[begin].y & 1) == 0) {
      continue;
    }
    if (is_last) {
      order_last(begin, i);
    } else {
      order_first(begin, i);
    }
  }
}

void Order::run(Shaper& shaper, SyllableStep step) noexcept {
  Order self(shaper);
  switch (step) {
    case SyllableStep::split:
      return self.split();
    case SyllableStep::part:
      return self.part();
    default:
      return self.order(step == SyllableStep::order_last);
  }
}

}  // namespace devanagari
}  // namespace detail

const detail::SyllableCode kDevanagari = {&detail::devanagari::Order::run};

}  // namespace inkcell
