#include "pipeline/request.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "base/error.hpp"
#include "pipeline/font_morphs.hpp"
#include "source/faces.hpp"
#include "source/named_sets.hpp"
#include "source/shape_script.hpp"
#include "texts/file_pattern.hpp"
#include "texts/shown_texts.hpp"

namespace inkcell::gen {

namespace {

constexpr double kLeastPx = 4;
constexpr double kMostPx = 1024;

bool is_whole_within(double value, double least, double most) {
  return value >= least && value <= most && value == std::floor(value);
}

// A number as people write it.
std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

bool is_size(double px) {
  return is_whole_within(px, kLeastPx, kMostPx);
}

std::string no_size(const char* option, double px) {
  return std::string(option) + " " + shown(px) +
         ": sizes are whole numbers within 4..1024 px/em";
}

bool is_band(Target target) {
  const double band = band_u(target);
  const bool is_asked = target.band_px > 0;
  target.band_px = 0;
  return is_asked && target.predicate != Predicate::fixed &&
         band >= band_u(target) && band <= kMostBand_u;
}

}  // namespace

bool shapes_emoji(const GenerateRequest& request) {
  if (request.shapes.empty()) {
    return false;
  }
  const auto scripts = parse_shape_scripts(request.shapes);
  return std::any_of(scripts.begin(), scripts.end(),
                     [](const auto& script) { return script.tag == "emoj"; });
}

void check_request(const GenerateRequest& request) {
  const Target& target = request.target;
  const bool has_font = !request.font.empty();
  const bool has_icons =
      !request.svg_files.empty() || !request.svg_folders.empty();
  const bool has_texts = !request.merge.empty() || !request.chars.empty() ||
                         !request.sets.empty() || !request.text_files.empty() ||
                         !request.symbols.empty() ||
                         !request.strings_from.empty() ||
                         !request.string_files.empty();
  const bool has_morphs = !request.morphs.empty();
  const bool has_masters = has_second_master(request.axes);
  const bool is_outline = target.coding == Coding::outline;
  const bool is_paged = request.paged != 0;
  const bool has_strikes = !request.strikes.empty();
  const std::set<int> block_sizes = {0, 512, 1024, 2048, 4096};
  const std::pair<bool, std::string> rules[] = {
      {!has_font && !has_icons,
       "there is no font; give a font file with --font, or icons with --svg or "
       "--svg-dir"},
      {!has_font && has_texts,
       "--merge, characters and strings need a font file; add --font FILE"},
      {!is_size(target.min_px), no_size("--min-px", target.min_px)},
      {!is_size(target.max_px), no_size("--max-px", target.max_px)},
      {target.min_px > target.max_px,
       "--min-px " + shown(target.min_px) + " is above --max-px " +
           shown(target.max_px) + "; give both, the smaller size as --min-px"},
      {!is_whole_within(target.tolerance, 1, 255),
       "--tolerance is a whole number within 1..255, such as 16/255"},
      {target.band_px != 0 && !is_band(target),
       "--band-px is at least 0.75, and at most 3/16 em at --min-px; the fixed "
       "predicate has its own"},
      {target.effort < 0 || target.effort > 9,
       "--effort is a whole number within 0..9"},
      {!is_outline && has_morphs,
       "--morph moves outlines; use --coding outline, or leave it out"},
      {!is_outline && has_masters,
       "--axis with two values makes outlines that morph; use --coding "
       "outline, or give one value"},
      {block_sizes.count(request.paged) == 0,
       "--paged " + std::to_string(request.paged) +
           ": blocks have 512, 1024, 2048 or 4096 bytes"},
      {is_paged && !is_outline,
       "--paged is for outlines; leave --coding field out"},
      {is_paged && has_morphs,
       "--morph needs a font in mapped memory; leave --paged out, or morph "
       "glyphs of another font"},
      {is_paged && has_masters,
       "--axis with two values needs a font in mapped memory; leave --paged "
       "out, or give one value"},
      {is_paged && !request.string_files.empty(),
       "--strings: runs of glyphs are for fonts in mapped memory; leave "
       "--paged out, or shape them with another font"},
      {!is_outline && has_strikes,
       "--strike is of outlines; leave --coding field out"},
      {is_paged && has_strikes && !request.strike_only,
       "--strike beside outlines needs a font in mapped memory; add "
       "--strike-only, or leave --paged out"},
      {request.strike_only && request.strikes.size() != 1,
       "--strike-only makes a font of one size; give one --strike, such as "
       "--strike 12:1"},
      {request.strike_only && (has_morphs || has_masters),
       "--strike-only leaves no outlines that morph; leave --morph and --axis "
       "with two values out, or --strike-only"},
      {request.keep_layout &&
           (is_paged || !is_outline || !has_font || request.strike_only),
       "--keep-layout is for outlines of a font file in mapped memory; leave "
       "--paged, --coding field and --strike-only out"},
      {is_paged && !request.shapes.empty(),
       "--shape needs a font in mapped memory; leave --paged out, or shape "
       "text with another font"},
      {!is_outline && !request.shapes.empty(),
       "--shape is for outlines; leave --coding field out"},
      {!has_font && !request.shapes.empty(),
       "--shape needs a font file; add --font FILE"},
      {request.strike_only && !request.shapes.empty(),
       "--shape is for outlines; leave --strike-only out"},
      {request.has_colours && (!is_outline || request.strike_only),
       "--colour makes layers of outlines; leave --coding field and "
       "--strike-only out"},
      {request.has_colours && has_masters,
       "--colour: layers have no second masters; give --axis one value"},
      {is_outline && target.predicate == Predicate::fixed,
       "--predicate fixed is the paper's, for its cells; use --coding field"}};
  for (const auto& [is_broken, what] : rules) {
    if (is_broken) {
      throw Error(what);
    }
  }
}

std::vector<std::filesystem::path> inputs_of(const GenerateRequest& request) {
  std::vector<std::filesystem::path> files;
  if (!request.font.empty()) {
    files.push_back(request.font);
  }
  files.insert(files.end(), request.text_files.begin(),
               request.text_files.end());
  files.insert(files.end(), request.string_files.begin(),
               request.string_files.end());
  for (const std::filesystem::path& source : sources_of(request)) {
    files.push_back(source);
  }
  for (const std::string& face : request.merge) {
    files.push_back(parse_merged_face(face).file);
  }
  for (const IconFile& icon : find_icons(request.svg_files, request.svg_folders,
                                         shapes_emoji(request))) {
    files.push_back(icon.file);
  }
  for (const std::filesystem::path& list : icon_lists(request.svg_folders)) {
    files.push_back(list);
  }
  return files;
}

AskedCharacters characters_of(const GenerateRequest& request) {
  AskedCharacters asked;
  for (const std::string& list : request.chars) {
    add_ranges(list, asked.common);
  }
  for (const std::string& list : request.sets) {
    add_named_sets(list, asked.common);
  }
  for (const std::filesystem::path& file : request.text_files) {
    add_text_file(file, asked.common);
  }
  for (const std::filesystem::path& file : sources_of(request)) {
    for (const LanguageText& shown : shown_texts(file, "--strings-from")) {
      CharSet& to = shown.language.empty() ? asked.common
                                           : asked.languages[shown.language];
      for (const LocatedCharacter& found : shown.text) {
        to.insert(found.value);
      }
    }
  }
  add_text(request.symbols, "--symbols", asked.common);
  add_morph_characters(request, asked.common);
  const bool has_lists = !request.chars.empty() || !request.sets.empty() ||
                         !request.text_files.empty() ||
                         !request.strings_from.empty() ||
                         !request.symbols.empty() || !request.morphs.empty() ||
                         !request.string_files.empty();
  if (!has_lists) {
    add_ranges(kDefaultChars, asked.common);
  }
  asked.all = asked.common;
  for (const auto& [language, characters] : asked.languages) {
    asked.all.insert(characters.begin(), characters.end());
  }
  if (asked.all.empty() && request.string_files.empty()) {
    throw Error(
        "no characters asked for: the texts hold nothing printable; check "
        "--text-file, --strings-from and --symbols");
  }
  return asked;
}

std::vector<std::filesystem::path> sources_of(const GenerateRequest& request) {
  std::set<std::filesystem::path> sources;
  for (const std::string& pattern : request.strings_from) {
    const auto found = matching_files(pattern, "--strings-from");
    sources.insert(found.begin(), found.end());
  }
  return {sources.begin(), sources.end()};
}

std::vector<NamedString> strings_of(const GenerateRequest& request) {
  std::vector<NamedString> strings;
  for (const std::filesystem::path& file : request.string_files) {
    add_string_file(file, strings);
  }
  if (strings.empty() && !request.string_files.empty()) {
    throw Error(request.string_files.front().string() +
                ": holds no strings; write lines of name = text");
  }
  return strings;
}

}  // namespace inkcell::gen
