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
             std::string(script.tag, script.tag[3] == ' ' ? 3 : 4);
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
  std::string tag;
  unsigned mask = shaping::kAnyForm;
  bool manual_zwj = false;
};
using Stage = std::vector<StageFeature>;

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
        joins &&
        std::any_of(stages.begin(), stages.end(), [tag](const Stage& stage) {
          return std::any_of(
              stage.begin(), stage.end(),
              [tag](const StageFeature& one) { return one.tag == tag; });
        });
    const bool is_last =
        std::any_of(last.begin(), last.end(),
                    [tag](const StageFeature& one) { return one.tag == tag; });
    if (!is_there && !is_last) {
      last.push_back({tag});
    }
  }
  for (const std::string& tag : features) {
    last.push_back({tag});
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
    file.refuse("knows no language " + language + " of " + plan.script +
                "; leave it out of --shape: it is shaped as all others");
  }
  const std::vector<Stage> stages = stages_of(known, script.features);
  Stage all;
  for (size_t i = 0; i < stages.size(); ++i) {
    add_entries(gsub, stages[i], i + 1 == stages.size(), plan.substitutions);
    for (const StageFeature& feature : stages[i]) {
      if (feature.mask == shaping::kAnyForm) {
        all.push_back({feature.tag});
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
  if (known.script != HB_SCRIPT_HEBREW ||
      gpos.chosen_script() == hb_tag("hebr")) {
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
  }
  return added;
}

std::set<uint32_t> shape_closure(const FontFile& file,
                                 const std::vector<ShapePlan>& plans,
                                 const CharSet& characters) {
  std::set<uint32_t> closure;
  for (const ShapePlan& plan : plans) {
    const ClosureSet glyphs(hb_set_create());
    for (const char32_t c : characters) {
      const hb_script_t script = shaped_script(c);
      const uint32_t glyph = file.glyph_of(c);
      if (glyph != 0 &&
          (script == plan.hb_script || script == HB_SCRIPT_COMMON)) {
        hb_set_add(glyphs.get(), glyph);
      }
    }
    const ClosureSet lookups(hb_set_create());
    for (const ShapeEntry& entry : plan.substitutions) {
      hb_set_add(lookups.get(), entry.lookup);
    }
    hb_ot_layout_lookups_substitute_closure(file.hb_face(), lookups.get(),
                                            glyphs.get());
    hb_codepoint_t glyph = HB_SET_VALUE_INVALID;
    while (hb_set_next(glyphs.get(), &glyph)) {
      if (glyph != 0) {
        closure.insert(glyph);
      }
    }
  }
  return closure;
}

}  // namespace inkcell::gen
