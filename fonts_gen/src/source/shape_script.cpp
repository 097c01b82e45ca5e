#include "source/shape_script.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <memory>

#include "base/error.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace shaping = format::shaping;

struct KnownScript {
  const char* tag;
  hb_script_t script;
  bool is_right_to_left;
  unsigned flags;
};

constexpr KnownScript kScripts[] = {
    {"arab", HB_SCRIPT_ARABIC, true, shaping::kJoins},
    {"armn", HB_SCRIPT_ARMENIAN, false, 0},
    {"cyrl", HB_SCRIPT_CYRILLIC, false, 0},
    {"deva", HB_SCRIPT_DEVANAGARI, false, shaping::kSyllables},
    {"emoj", HB_SCRIPT_COMMON, false, shaping::kEmoji},
    {"geor", HB_SCRIPT_GEORGIAN, false, 0},
    {"grek", HB_SCRIPT_GREEK, false, 0},
    {"hebr", HB_SCRIPT_HEBREW, true, shaping::kHebrew},
    {"lao ", HB_SCRIPT_LAO, false, shaping::kThai},
    {"latn", HB_SCRIPT_LATIN, false, 0},
    {"thai", HB_SCRIPT_THAI, false, shaping::kThai}};

const KnownScript* find_script(const std::string& tag) {
  const auto* found =
      std::find_if(std::begin(kScripts), std::end(kScripts),
                   [&](const KnownScript& known) { return known.tag == tag; });
  return found == std::end(kScripts) ? nullptr : found;
}

std::string padded_tag(std::string tag) {
  tag.resize(4, ' ');
  return tag;
}

bool is_tag_of(const std::string& text, int (*kind)(int)) {
  return !text.empty() && text.size() <= 4 &&
         std::all_of(text.begin(), text.end(), [&](char c) {
           return kind(static_cast<unsigned char>(c)) != 0 ||
                  std::isdigit(static_cast<unsigned char>(c)) != 0;
         });
}

hb_tag_t hb_tag(const std::string& text) {
  return hb_tag_from_string(text.data(), static_cast<int>(text.size()));
}

[[noreturn]] void refuse_script(const std::string& item) {
  std::string known;
  for (const KnownScript& script : kScripts) {
    known += std::string(known.empty() ? "" : ", ") +
             (script.flags == shaping::kEmoji
                  ? "emoji"
                  : std::string(script.tag, script.tag[3] == ' ' ? 3 : 4));
  }
  throw Error("--shape '" + item + "': write scripts such as arab,hebr; " +
              "languages in capitals: arab:FAS,URD; features: latn+smcp; " +
              "scripts are " + known);
}

// One table of a face for a script and a language.
class FeatureTable {
 public:
  FeatureTable(const FontFile& file,
               hb_tag_t table,
               hb_script_t script,
               const std::string& language)
      : face_(file.hb_face()), table_(table) {
    hb_tag_t tags[3];
    unsigned count = 3;
    unsigned none = 0;
    hb_ot_tags_from_script_and_language(script, HB_LANGUAGE_INVALID, &count,
                                        tags, &none, nullptr);
    is_found_ = hb_ot_layout_table_select_script(face_, table, count, tags,
                                                 &script_, &chosen_) != 0;
    if (!language.empty()) {
      const hb_tag_t tag = hb_tag(language);
      has_language_ = hb_ot_layout_script_select_language(
                          face_, table, script_, 1, &tag, &language_) != 0;
    }
    unsigned coordinates = 0;
    const int* values =
        hb_font_get_var_coords_normalized(file.hb(), &coordinates);
    hb_ot_layout_table_find_feature_variations(face_, table, values,
                                               coordinates, &variation_);
  }

  bool is_found() const { return is_found_; }
  bool has_language() const { return has_language_; }
  hb_tag_t chosen_script() const { return chosen_; }

  std::vector<unsigned> lookups(const std::string& feature) const {
    unsigned index = 0;
    return hb_ot_layout_language_find_feature(face_, table_, script_, language_,
                                              hb_tag(feature), &index) != 0
               ? lookups_of(index)
               : std::vector<unsigned>();
  }
  std::vector<unsigned> required() const {
    unsigned index = 0;
    return hb_ot_layout_language_get_required_feature_index(
               face_, table_, script_, language_, &index) != 0
               ? lookups_of(index)
               : std::vector<unsigned>();
  }

 private:
  std::vector<unsigned> lookups_of(unsigned feature) const {
    unsigned count = 0;
    const unsigned all = hb_ot_layout_feature_with_variations_get_lookups(
        face_, table_, feature, variation_, 0, &count, nullptr);
    std::vector<unsigned> lookups(all);
    count = all;
    hb_ot_layout_feature_with_variations_get_lookups(
        face_, table_, feature, variation_, 0, &count, lookups.data());
    lookups.resize(count);
    return lookups;
  }

  hb_face_t* face_;
  hb_tag_t table_;
  hb_tag_t chosen_ = 0;
  unsigned script_ = 0;
  unsigned language_ = HB_OT_LAYOUT_DEFAULT_LANGUAGE_INDEX;
  unsigned variation_ = HB_OT_LAYOUT_NO_VARIATIONS_INDEX;
  bool is_found_ = false;
  bool has_language_ = false;
};

struct StageFeature {
  const char* tag = "";
  unsigned mask = shaping::kAnyForm;
  bool manual_zwj = false;
};
using Stage = std::vector<StageFeature>;

// Stages that order syllables.
constexpr const char* kOrderTags[] = {"first", "last"};

// On by default in all scripts.
const char* const kCommon[] = {"abvm", "blwm", "ccmp", "locl", "mark",
                               "mkmk", "rlig", "calt", "clig", "curs",
                               "dist", "kern", "liga", "rclt"};

// The features in the order of HarfBuzz, which applies the lookups of a stage
// in the order of the file.
std::vector<Stage> stages_of(const KnownScript& script,
                             const std::vector<std::string>& features) {
  std::vector<Stage> stages = {{{"rvrn"}}};
  Stage last;
  if (script.is_right_to_left) {
    last.push_back({"rtla"});
  } else {
    last.push_back({"ltra"});
    last.push_back({"ltrm"});
  }
  const bool joins = (script.flags & shaping::kJoins) != 0;
  const bool has_syllables = (script.flags & shaping::kSyllables) != 0;
  if (has_syllables) {
    stages.push_back(last);
    stages.push_back({{"ccmp"}, {"locl"}});
    stages.push_back({{kOrderTags[shaping::kOrderFirst], 0}});
    constexpr StageFeature kBasic[] = {{"nukt", 1, true},
                                       {"akhn", 1, true},
                                       {"rphf", shaping::kReph, true},
                                       {"rkrf", 1, true},
                                       {"blwf", shaping::kBelowBase, true},
                                       {"abvf", shaping::kBehindBase, true},
                                       {"half", shaping::kHalf, true},
                                       {"pstf", shaping::kBehindBase, true},
                                       {"vatu", 1, true},
                                       {"cjct", 1, true}};
    for (const StageFeature& feature : kBasic) {
      stages.push_back({feature});
    }
    stages.push_back({{kOrderTags[shaping::kOrderLast], 0}});
    last = {{"pres", 1, true},
            {"abvs", 1, true},
            {"blws", 1, true},
            {"psts", 1, true},
            {"haln", 1, true}};
  }
  if (joins) {
    stages.push_back(last);
    stages.push_back({{"ccmp", 1, true}, {"locl", 1, true}});
    stages.push_back({{"isol", shaping::kIsolated, true}});
    stages.push_back({{"fina", shaping::kFinal, true}});
    stages.push_back({{"medi", shaping::kMedial, true}});
    stages.push_back({{"init", shaping::kInitial, true}});
    stages.push_back({{"rlig", 1, true}});
    stages.push_back({{"calt", 1, true}});
    last = {{"rclt", 1, true},
            {"liga", 1, true},
            {"clig", 1, true},
            {"mset", 1, true}};
  }
  for (const char* tag : kCommon) {
    const bool is_there =
        (joins || has_syllables) &&
        std::any_of(stages.begin(), stages.end(), [tag](const Stage& stage) {
          return std::any_of(
              stage.begin(), stage.end(),
              [tag](const StageFeature& one) { return one.tag == tag; });
        });
    const bool is_last =
        std::any_of(last.begin(), last.end(),
                    [tag](const StageFeature& one) { return one.tag == tag; });
    const bool is_off = has_syllables && std::string(tag) == "liga";
    if (!is_there && !is_last && !is_off) {
      // Marks do not look over ZWJ.
      const bool is_mark =
          std::string(tag) == "mark" || std::string(tag) == "mkmk";
      last.push_back({tag, shaping::kAnyForm, is_mark});
    }
  }
  for (const std::string& tag : features) {
    last.push_back({tag.c_str()});
  }
  stages.push_back(last);
  return stages;
}

void add_entries(const FeatureTable& table,
                 const Stage& stage,
                 bool with_required,
                 std::vector<ShapeEntry>& out) {
  std::map<unsigned, ShapeEntry> entries;
  const auto add = [&](const std::vector<unsigned>& lookups,
                       const StageFeature& feature) {
    for (const unsigned lookup : lookups) {
      ShapeEntry& entry = entries[lookup];
      entry.lookup = lookup;
      entry.mask |= feature.mask;
      entry.manual_zwj = entry.manual_zwj || feature.manual_zwj;
    }
  };
  for (const StageFeature& feature : stage) {
    add(table.lookups(feature.tag), feature);
  }
  if (with_required) {
    add(table.required(), {});
  }
  for (const auto& [lookup, entry] : entries) {
    out.push_back(entry);
  }
}

bool would_replace(const FontFile& file,
                   const FeatureTable& gsub,
                   std::initializer_list<const char*> features,
                   const std::vector<hb_codepoint_t>& glyphs) {
  for (const char* feature : features) {
    for (const unsigned lookup : gsub.lookups(feature)) {
      if (hb_ot_layout_lookup_would_substitute(
              file.hb_face(), lookup, glyphs.data(),
              static_cast<unsigned>(glyphs.size()), 1) != 0) {
        return true;
      }
    }
  }
  return false;
}

// What letters become in syllables of Devanagari, as far as the face says.
void find_forms(const FontFile& file,
                const FeatureTable& gsub,
                ShapePlan& plan) {
  if (gsub.chosen_script() != hb_tag("dev2")) {
    file.refuse("has no table GSUB of the script dev2" +
                std::string("; choose another face for --shape deva"));
  }
  const hb_codepoint_t virama = file.glyph_of(0x94d);
  if (would_replace(file, gsub, {"rphf"}, {file.glyph_of(0x930), virama})) {
    plan.flags |= shaping::kHasReph;
  }
  for (char32_t c = 0x915; c < 0x980; c += c == 0x939 ? 0x3f : 1) {
    const hb_codepoint_t glyph = file.glyph_of(c);
    const bool is_letter =
        hb_unicode_general_category(hb_unicode_funcs_get_default(), c) ==
        HB_UNICODE_GENERAL_CATEGORY_OTHER_LETTER;
    if (glyph != 0 && is_letter &&
        (would_replace(file, gsub, {"blwf", "vatu"}, {virama, glyph}) ||
         would_replace(file, gsub, {"blwf", "vatu"}, {glyph, virama}))) {
      plan.below.insert(c);
    }
  }
}

ShapePlan make_plan(const FontFile& file,
                    const KnownScript& known,
                    const ShapeScript& script,
                    const std::string& language) {
  const FeatureTable gsub(file, HB_OT_TAG_GSUB, known.script, language);
  const FeatureTable gpos(file, HB_OT_TAG_GPOS, known.script, language);
  ShapePlan plan;
  plan.script = known.tag;
  plan.language = language;
  plan.features = script.features;
  plan.hb_script = known.script;
  plan.is_right_to_left = known.is_right_to_left;
  plan.flags =
      known.flags | (known.is_right_to_left ? shaping::kRightToLeft : 0u);
  if (!language.empty() && !gsub.has_language() && !gpos.has_language()) {
    file.refuse("knows no language " + language.substr(0, language.find(' ')) +
                " of " + plan.script +
                "; leave it out of --shape: it is shaped as all others");
  }
  const std::vector<Stage> stages = stages_of(known, script.features);
  Stage all;
  if ((known.flags & shaping::kSyllables) != 0) {
    find_forms(file, gsub, plan);
  }
  for (size_t i = 0; i < stages.size(); ++i) {
    if (stages[i].front().mask == 0) {
      const bool is_last =
          stages[i].front().tag == kOrderTags[shaping::kOrderLast];
      plan.substitutions.push_back({is_last ? 1u : 0u, 0, false});
      continue;
    }
    add_entries(gsub, stages[i], i + 1 == stages.size(), plan.substitutions);
    for (const StageFeature& feature : stages[i]) {
      if (feature.mask == shaping::kAnyForm) {
        all.push_back(feature);
      }
    }
  }
  if ((known.flags & shaping::kJoins) != 0 && gsub.lookups("init").empty()) {
    file.refuse("has no forms of joined letters for " + plan.script +
                "; choose another face for --shape");
  }
  if ((known.flags & shaping::kThai) != 0 && !gsub.is_found()) {
    file.refuse("has no table GSUB for " + plan.script +
                "; choose another face for --shape");
  }
  // HarfBuzz takes positions of Hebrew from its own script alone.
  if (known.script == HB_SCRIPT_HEBREW ? gpos.chosen_script() == hb_tag("hebr")
                                       : known.flags != shaping::kEmoji) {
    add_entries(gpos, all, true, plan.positions);
  }
  return plan;
}

struct DestroyClosure {
  void operator()(hb_set_t* set) const { hb_set_destroy(set); }
};
using ClosureSet = std::unique_ptr<hb_set_t, DestroyClosure>;

}  // namespace

std::vector<ShapeScript> parse_shape_scripts(const std::string& list) {
  std::vector<ShapeScript> scripts;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    std::string item = list.substr(begin, end - begin);
    const std::string whole = item;
    begin = end + 1;
    if (is_tag_of(item, std::isupper) && !scripts.empty() &&
        !scripts.back().languages.empty()) {
      scripts.back().languages.push_back(padded_tag(item));
      continue;
    }
    ShapeScript script;
    const size_t colon = item.find(':');
    if (colon != std::string::npos) {
      const std::string language = item.substr(colon + 1);
      if (!is_tag_of(language, std::isupper)) {
        refuse_script(whole);
      }
      script.languages.push_back(padded_tag(language));
      item.resize(colon);
    }
    for (size_t plus = item.rfind('+'); plus != std::string::npos;
         plus = item.rfind('+')) {
      const std::string feature = item.substr(plus + 1);
      if (!is_tag_of(feature, std::islower) || feature.size() != 4) {
        refuse_script(whole);
      }
      script.features.insert(script.features.begin(), feature);
      item.resize(plus);
    }
    script.tag = padded_tag(item);
    const bool is_twice = std::any_of(
        scripts.begin(), scripts.end(),
        [&](const ShapeScript& one) { return one.tag == script.tag; });
    if (find_script(script.tag) == nullptr || is_twice) {
      refuse_script(whole);
    }
    scripts.push_back(script);
  }
  return scripts;
}

hb_script_t script_of(const ShapeScript& script) {
  return find_script(script.tag)->script;
}

std::vector<ShapePlan> shape_plans(const FontFile& file,
                                   const std::vector<ShapeScript>& scripts) {
  std::vector<ShapePlan> plans;
  for (const ShapeScript& script : scripts) {
    const KnownScript& known = *find_script(script.tag);
    plans.push_back(make_plan(file, known, script, ""));
    for (const std::string& language : script.languages) {
      plans.push_back(make_plan(file, known, script, language));
    }
  }
  return plans;
}

bool is_emoji(char32_t c) {
  constexpr std::pair<char32_t, char32_t> kRanges[] = {
      {0x203c, 0x203c},  {0x2049, 0x2049}, {0x20e3, 0x20e3}, {0x2190, 0x21ff},
      {0x2300, 0x23ff},  {0x25a0, 0x27bf}, {0x2900, 0x297f}, {0x2b00, 0x2bff},
      {0x3030, 0x3030},  {0x303d, 0x303d}, {0x3297, 0x3299}, {0x1f000, 0x1faff},
      {0xe0020, 0xe007f}};
  return std::any_of(
      std::begin(kRanges), std::end(kRanges),
      [c](const auto& range) { return c >= range.first && c <= range.second; });
}

hb_script_t shaped_script(char32_t c) {
  const hb_script_t script =
      hb_unicode_script(hb_unicode_funcs_get_default(), c);
  return script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN
             ? HB_SCRIPT_COMMON
             : script;
}

CharSet shape_additions(const std::vector<ShapePlan>& plans,
                        const CharSet& characters) {
  CharSet added;
  for (const ShapePlan& plan : plans) {
    for (const char32_t am : {U'\u0e33', U'\u0eb3'}) {
      if ((plan.flags & shaping::kThai) != 0 && characters.count(am) != 0) {
        added.insert({am - 1, am + 0x1a});
      }
    }
    if ((plan.flags & shaping::kEmoji) != 0) {
      added.insert({0x200d, 0x20e3});
      for (char32_t tag = 0xe0020; tag < 0xe0080; ++tag) {
        added.insert(tag);
      }
    }
    // Letters with a nukta are taken apart.
    constexpr char32_t kParted[] = {0x915, 0x916, 0x917, 0x91c,
                                    0x921, 0x922, 0x92b, 0x92f};
    for (char32_t i = 0; i < 8; ++i) {
      if ((plan.flags & shaping::kSyllables) != 0 &&
          characters.count(0x958 + i) != 0) {
        added.insert({kParted[i], 0x93c});
      }
    }
  }
  return added;
}

namespace {

// Adds the glyphs that lookups make of glyphs.
void close(const FontFile& file,
           const ClosureSet& lookups,
           const ClosureSet& glyphs,
           std::set<uint32_t>& closure) {
  hb_ot_layout_lookups_substitute_closure(file.hb_face(), lookups.get(),
                                          glyphs.get());
  hb_codepoint_t glyph = HB_SET_VALUE_INVALID;
  while (hb_set_next(glyphs.get(), &glyph)) {
    if (glyph != 0) {
      closure.insert(glyph);
    }
  }
}

}  // namespace

std::set<uint32_t> shape_closure(const FontFile& file,
                                 const std::vector<ShapePlan>& plans,
                                 const CharSet& characters) {
  std::set<uint32_t> closure;
  for (const ShapePlan& plan : plans) {
    const ClosureSet glyphs(hb_set_create());
    for (const char32_t c : characters) {
      const hb_script_t script = shaped_script(c);
      if (script == plan.hb_script || script == HB_SCRIPT_COMMON) {
        hb_set_add(glyphs.get(), file.glyph_of(c));
      }
    }
    const ClosureSet lookups(hb_set_create());
    for (const ShapeEntry& entry : plan.substitutions) {
      if (entry.mask != 0) {
        hb_set_add(lookups.get(), entry.lookup);
      }
    }
    close(file, lookups, glyphs, closure);
  }
  return closure;
}

std::set<uint32_t> layout_closure(const FontFile& file,
                                  const CharSet& characters) {
  const ClosureSet glyphs(hb_set_create());
  for (const char32_t c : characters) {
    hb_set_add(glyphs.get(), file.glyph_of(c));
  }
  const ClosureSet lookups(hb_set_create());
  hb_ot_layout_collect_lookups(file.hb_face(), HB_OT_TAG_GSUB, nullptr, nullptr,
                               nullptr, lookups.get());
  std::set<uint32_t> closure;
  close(file, lookups, glyphs, closure);
  return closure;
}

CharSet decompositions(const CharSet& characters) {
  CharSet parts;
  for (const char32_t c : characters) {
    hb_codepoint_t letter = c;
    hb_codepoint_t mark = 0;
    while (hb_unicode_decompose(hb_unicode_funcs_get_default(), letter, &letter,
                                &mark) != 0) {
      parts.insert({letter, mark});
    }
    constexpr char32_t kKhmerE = 0x17c1;  // vowels of Khmer begin with it
    if (c == 0x17be || c == 0x17bf || c == 0x17c0 || c == 0x17c4 ||
        c == 0x17c5) {
      parts.insert(kKhmerE);
    }
  }
  parts.erase(0);
  return parts;
}

}  // namespace inkcell::gen
