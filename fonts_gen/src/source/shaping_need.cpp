#include "source/shaping_need.hpp"

#include <fribidi.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "source/char_set.hpp"

namespace inkcell::gen {
namespace {

struct ScriptName {
  hb_script_t script;
  const char* name;
};

// Scripts of languages that are written today. Others are told by their tag.
constexpr ScriptName kNames[] = {
    {HB_SCRIPT_ADLAM, "Adlam"},
    {HB_SCRIPT_ARABIC, "Arabic"},
    {HB_SCRIPT_BALINESE, "Balinese"},
    {HB_SCRIPT_BENGALI, "Bengali"},
    {HB_SCRIPT_CYRILLIC, "Cyrillic"},
    {HB_SCRIPT_DEVANAGARI, "Devanagari"},
    {HB_SCRIPT_GREEK, "Greek"},
    {HB_SCRIPT_GUJARATI, "Gujarati"},
    {HB_SCRIPT_GURMUKHI, "Gurmukhi"},
    {HB_SCRIPT_HANGUL, "Hangul"},
    {HB_SCRIPT_HEBREW, "Hebrew"},
    {HB_SCRIPT_HIRAGANA, "Hiragana"},
    {HB_SCRIPT_JAVANESE, "Javanese"},
    {HB_SCRIPT_KANNADA, "Kannada"},
    {HB_SCRIPT_KATAKANA, "Katakana"},
    {HB_SCRIPT_KHMER, "Khmer"},
    {HB_SCRIPT_LAO, "Lao"},
    {HB_SCRIPT_LATIN, "Latin"},
    {HB_SCRIPT_MALAYALAM, "Malayalam"},
    {HB_SCRIPT_MONGOLIAN, "Mongolian"},
    {HB_SCRIPT_MYANMAR, "Myanmar"},
    {HB_SCRIPT_NKO, "N'Ko"},
    {HB_SCRIPT_ORIYA, "Odia"},
    {HB_SCRIPT_SINHALA, "Sinhala"},
    {HB_SCRIPT_SYRIAC, "Syriac"},
    {HB_SCRIPT_TAMIL, "Tamil"},
    {HB_SCRIPT_TELUGU, "Telugu"},
    {HB_SCRIPT_THAANA, "Thaana"},
    {HB_SCRIPT_THAI, "Thai"},
    {HB_SCRIPT_TIBETAN, "Tibetan"},
};

// Where letters with their marks mostly have characters of their own.
constexpr std::string_view kComposed[] = {
    "text", "Latin", "Greek", "Cyrillic", "Hangul", "Hiragana", "Katakana"};

std::string name_of(hb_script_t script) {
  for (const ScriptName& known : kNames) {
    if (known.script == script) {
      return known.name;
    }
  }
  if (script == HB_SCRIPT_COMMON) {
    return "text";
  }
  char tag[4];
  hb_tag_to_string(hb_script_to_iso15924_tag(script), tag);
  return "the script " + std::string(tag, sizeof tag);
}

bool joins(char32_t c) {
  const FriBidiJoiningType type = fribidi_get_joining_type(c);
  return FRIBIDI_IS_JOINING_TYPE_D(type) || FRIBIDI_IS_JOINING_TYPE_R(type) ||
         FRIBIDI_IS_JOINING_TYPE_L(type);
}

// Marks that show nothing: the grapheme joiner, Khmer inherent vowels, and
// selectors of Mongolian and of variants.
bool is_invisible(char32_t c) {
  return c == 0x34f || (c >= 0x17b4 && c <= 0x17b5) ||
         (c >= 0x180b && c <= 0x180f) || (c >= 0xfe00 && c <= 0xfe0f) ||
         (c >= 0xe0100 && c <= 0xe01ef);
}

bool is_mark(char32_t c) {
  switch (hb_unicode_general_category(hb_unicode_funcs_get_default(), c)) {
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
      return !is_invisible(c);
    default:
      return false;
  }
}

bool is_jamo(char32_t c) {
  return (c >= 0x1100 && c <= 0x11ff) || (c >= 0xa960 && c <= 0xa97c) ||
         (c >= 0xd7b0 && c <= 0xd7fb);
}

}  // namespace

bool needs_shaping(char32_t code_point) {
  return joins(code_point) || is_mark(code_point) || is_jamo(code_point);
}

std::vector<UnshapedScript> unshaped_scripts(std::u32string_view text) {
  std::vector<UnshapedScript> found;
  hb_script_t last = HB_SCRIPT_COMMON;
  for (size_t i = 0; i < text.size(); ++i) {
    const hb_script_t script =
        hb_unicode_script(hb_unicode_funcs_get_default(), text[i]);
    if (script != HB_SCRIPT_COMMON && script != HB_SCRIPT_INHERITED) {
      last = script;
    }
    if (!needs_shaping(text[i])) {
      continue;
    }
    if (std::none_of(
            found.begin(), found.end(),
            [&](const UnshapedScript& one) { return one.script == last; })) {
      found.push_back({last, name_of(last), i});
    }
  }
  return found;
}

std::string unshaped_message(const UnshapedScript& script,
                             std::u32string_view text) {
  // On a dotted circle a mark does not stand on the quotation mark.
  const char32_t first = text[script.at];
  const std::string shown =
      (is_mark(first) ? to_utf8(U'\u25cc') : "") + to_utf8(first);
  char code[16];
  std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(first));
  const bool composes = std::find(std::begin(kComposed), std::end(kComposed),
                                  script.name) != std::end(kComposed);
  return script.name + " is drawn unshaped, from " + code + " '" + shown +
         "' on: " +
         (composes ? "marks miss their places; write each with its letter as "
                     "one character (Unicode NFC), or shape "
                   : "letters do not join, or marks miss their places; "
                     "shape ") +
         "text that is known at build time with inkcell-fontgen --strings";
}

}  // namespace inkcell::gen
