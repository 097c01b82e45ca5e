// What SHAP says of characters: compositions, order of marks, joining, scripts.
#include <fribidi.h>

#include <algorithm>

#include "shaping/section_writer.hpp"

namespace inkcell::gen {
namespace {

hb_unicode_funcs_t* unicode() {
  return hb_unicode_funcs_get_default();
}

bool is_any_mark(char32_t c) {
  const auto category = hb_unicode_general_category(unicode(), c);
  return category == HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK ||
         category == HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK ||
         category == HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK;
}

// Arabic marks that belong to the letter, before all others (UTR #53).
bool is_modifier(char32_t c) {
  static const CharSet kModifiers = {0x654, 0x655, 0x658, 0x6dc, 0x6e3,
                                     0x6e7, 0x6e8, 0x8ca, 0x8cb, 0x8cd,
                                     0x8ce, 0x8cf, 0x8d3, 0x8f3};
  return kModifiers.count(c) != 0;
}

// The order of marks: classes of Unicode, changed as HarfBuzz does where those
// do not order what is drawn.
unsigned order_of(char32_t c) {
  const unsigned kind =
      static_cast<unsigned>(hb_unicode_combining_class(unicode(), c));
  static const std::map<unsigned, unsigned> kChanged = {
      {10, 22}, {11, 15}, {12, 16},   {13, 17},   {14, 23},  {15, 18},
      {16, 19}, {17, 20}, {18, 21},   {19, 14},   {20, 24},  {21, 12},
      {22, 25}, {23, 13}, {24, 10},   {25, 11},   {27, 28},  {28, 29},
      {29, 30}, {30, 31}, {31, 32},   {32, 33},   {33, 27},  {84, 0},
      {91, 0},  {103, 3}, {129, 129}, {130, 132}, {132, 131}};
  if (is_modifier(c)) {
    return kind == 220 ? 1 : 2;
  }
  const auto found = kChanged.find(kind);
  return found == kChanged.end() ? kind : found->second;
}

unsigned hebrew_mark(char32_t c) {
  switch (hb_unicode_combining_class(unicode(), c)) {
    case HB_UNICODE_COMBINING_CLASS_CCC17:
    case HB_UNICODE_COMBINING_CLASS_CCC18:
      return shaping::kWideMark;
    case HB_UNICODE_COMBINING_CLASS_CCC10:
    case HB_UNICODE_COMBINING_CLASS_CCC14:
      return shaping::kNarrowMark;
    case HB_UNICODE_COMBINING_CLASS_CCC22:
    case HB_UNICODE_COMBINING_CLASS_BELOW:
      return shaping::kLowMark;
    default:
      return shaping::kMark;
  }
}

unsigned joining_of(char32_t c) {
  // Signs that enclose digits are controls, and do join nothing.
  if (c == 0x200c || (c >= 0x600 && c <= 0x605) || c == 0x6dd || c == 0x8e2) {
    return shaping::kJoinsNone;
  }
  if (c == 0x200d) {
    return shaping::kJoinsDual;
  }
  const FriBidiJoiningType type = fribidi_get_joining_type(c);
  if (FRIBIDI_IS_JOINING_TYPE_R(type)) {
    return shaping::kJoinsRight;
  }
  if (FRIBIDI_IS_JOINING_TYPE_D(type) || FRIBIDI_IS_JOINING_TYPE_C(type)) {
    return shaping::kJoinsDual;
  }
  if (FRIBIDI_IS_JOINING_TYPE_L(type)) {
    return shaping::kJoinsLeft;
  }
  const auto category = hb_unicode_general_category(unicode(), c);
  return is_any_mark(c) || category == HB_UNICODE_GENERAL_CATEGORY_FORMAT
             ? shaping::kMark
             : shaping::kJoinsNone;
}

}  // namespace

void SectionWriter::find_compositions() {
  std::map<char32_t, unsigned> numbers;
  for (const auto& [composed, glyph] : source_.characters) {
    hb_codepoint_t letter = 0;
    hb_codepoint_t mark = 0;
    hb_codepoint_t again = 0;
    if (composed > 0xffff ||
        hb_unicode_decompose(unicode(), composed, &letter, &mark) == 0 ||
        mark == 0 || hb_unicode_compose(unicode(), letter, mark, &again) == 0 ||
        again != composed || source_.characters.count(letter) == 0 ||
        order_of(mark) == 0) {
      continue;
    }
    const auto [found, is_new] =
        numbers.emplace(mark, static_cast<unsigned>(marks_.size() + 1));
    if (is_new) {
      marks_.push_back(mark);
    }
    compositions_.push_back({found->second, letter, composed});
  }
  std::sort(compositions_.begin(), compositions_.end(),
            [](const Composition& a, const Composition& b) {
              return std::tie(a.letter, a.mark) < std::tie(b.letter, b.mark);
            });
  char32_t most = 0;
  for (const Composition& one : compositions_) {
    most = std::max({most, one.letter, one.composed});
  }
  letter_bits_ = width_of(most);
  mark_bits_ = width_of(static_cast<uint32_t>(marks_.size()));
  check(marks_.size(), 127, "marks that compose");
  // Both are looked for as one number.
  check(letter_bits_ + mark_bits_, format::bit_table::kMaxBits,
        "bits of a composition");
}

ShapeTraits SectionWriter::traits_of(char32_t c) const {
  ShapeTraits traits;
  if ((c >= 0x1f3fb && c <= 0x1f3ff) || (c >= 0xe0020 && c <= 0xe007f)) {
    traits.joining = shaping::kMark;  // skin tones, and tags of flags
    return traits;
  }
  if (c >= 0x1f1e6 && c <= 0x1f1ff) {
    traits.joining = shaping::kJoinsRight;  // letters of flags
    return traits;
  }
  const bool joins = std::any_of(
      programs_.begin(), programs_.end(), [](const Program& program) {
        return (program.plan->flags & shaping::kJoins) != 0;
      });
  if (is_any_mark(c)) {
    traits.joining =
        shaped_script(c) == HB_SCRIPT_HEBREW ? hebrew_mark(c) : shaping::kMark;
    const auto rank = ranks_.find(order_of(c));
    traits.rank = rank == ranks_.end() ? 0 : rank->second;
    const auto mark = std::find(marks_.begin(), marks_.end(), c);
    traits.mark = mark == marks_.end()
                      ? 0
                      : static_cast<unsigned>(mark - marks_.begin() + 1);
  } else if (joins) {
    traits.joining = joining_of(c);
  }
  if (std::any_of(programs_.begin(), programs_.end(),
                  [c](const Program& program) {
                    return program.plan->below.count(c) != 0;
                  })) {
    traits.joining = shaping::kBelowForm;
  }
  return traits;
}

// Characters whose traits are not plain: of the font, and all that join or are
// marks in the block of a script, so that letters also join with those that
// the font lacks.
void SectionWriter::find_spans() {
  CharSet all;
  for (const auto* characters : {&source_.characters, &source_.drawings}) {
    for (const auto& [c, glyph] : *characters) {
      all.insert(c);
    }
  }
  all.insert(marks_.begin(), marks_.end());
  for (const Program& program : programs_) {
    if ((program.plan->flags & shaping::kJoins) != 0) {
      for (char32_t c = 0x600; c < 0x700; ++c) {
        all.insert(c);
      }
      all.insert({0x200c, 0x200d});
    }
    if ((program.plan->flags & shaping::kEmoji) != 0) {
      all.insert({0x20e3, 0xfe0e, 0xfe0f});
    }
  }
  std::set<unsigned> orders;
  for (const char32_t c : all) {
    if (is_any_mark(c) && order_of(c) != 0) {
      orders.insert(order_of(c));
    }
  }
  for (const unsigned order : orders) {
    ranks_.emplace(order, static_cast<unsigned>(ranks_.size() + 1));
  }
  rank_bits_ = width_of(static_cast<uint32_t>(ranks_.size()));
  std::map<ShapeTraits, unsigned> numbers = {{ShapeTraits(), 0}};
  properties_.push_back(ShapeTraits());
  constexpr char32_t kGap = 12;  // a span costs more than so many characters
  for (const char32_t c : all) {
    const ShapeTraits traits = traits_of(c);
    if (traits.is_plain()) {
      continue;
    }
    const auto [found, is_new] =
        numbers.emplace(traits, static_cast<unsigned>(properties_.size()));
    if (is_new) {
      properties_.push_back(traits);
    }
    if (spans_.empty() ||
        c - spans_.back().first - spans_.back().properties.size() > kGap) {
      spans_.push_back({c, {}});
    }
    Span& span = spans_.back();
    span.properties.resize(c - span.first, 0);
    span.properties.push_back(found->second);
  }
  check(properties_.size(), 255, "kinds of characters");
  check(spans_.size(), 255, "spans of characters");
}

// Ranges of characters of the font by the first program of their script.
// Marks of all scripts belong to what is before them.
std::vector<SectionWriter::ScriptRange> SectionWriter::find_scripts() const {
  if (source_.plans.front().hb_script == HB_SCRIPT_INHERITED) {
    const auto [low, high] = std::minmax_element(marks_.begin(), marks_.end());
    return {{*low, *high, 0}};
  }
  std::vector<ScriptRange> ranges;
  bool is_open = false;
  std::map<char32_t, uint16_t> all = source_.drawings;
  all.insert(source_.characters.begin(), source_.characters.end());
  for (const auto& [c, glyph] : all) {
    const hb_script_t script = shaped_script(c);
    const bool has_program = script != HB_SCRIPT_COMMON || is_emoji(c);
    if (!has_program && is_any_mark(c)) {
      continue;
    }
    const auto found = std::find_if(
        programs_.begin(), programs_.end(), [&](const Program& one) {
          return has_program && one.plan->hb_script == script;
        });
    if (found == programs_.end()) {
      is_open = false;
      continue;
    }
    const auto program = static_cast<unsigned>(found - programs_.begin());
    if (is_open && ranges.back().program == program) {
      ranges.back().last = c;
    } else {
      ranges.push_back({c, c, program});
      is_open = true;
    }
  }
  check(ranges.size(), 255, "ranges of characters");
  return ranges;
}

std::vector<std::pair<char32_t, char32_t>> SectionWriter::find_mirrors() const {
  std::vector<std::pair<char32_t, char32_t>> mirrors;
  const bool is_any = std::any_of(
      programs_.begin(), programs_.end(),
      [](const Program& program) { return program.plan->is_right_to_left; });
  for (const auto& [c, glyph] : source_.characters) {
    const char32_t other = hb_unicode_mirroring(unicode(), c);
    if (is_any && other != c && source_.characters.count(other) != 0 &&
        std::max(c, other) <= 0xffff) {
      mirrors.emplace_back(c, other);
    }
  }
  check(mirrors.size(), 255, "characters with mirror images");
  return mirrors;
}

}  // namespace inkcell::gen
