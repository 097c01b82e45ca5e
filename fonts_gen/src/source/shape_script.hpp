// What the device shapes: scripts, and which lookups of a face do it.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "source/char_set.hpp"
#include "source/font_file.hpp"

namespace inkcell::gen {

/// A script of --shape.
struct ShapeScript {
  std::string tag;                     // as in OpenType: "arab"
  std::vector<std::string> languages;  // of OpenType, such as "FAS"
  std::vector<std::string> features;   // beside those that are on by default
};

/// Reads "arab:FAS,URD,hebr,latn+smcp": scripts; languages are in capitals.
/// Throws Error.
std::vector<ShapeScript> parse_shape_scripts(const std::string& list);

/// Its script in Unicode.
hb_script_t script_of(const ShapeScript& script);

/// A lookup of a program.
struct ShapeEntry {
  unsigned lookup = 0;      // in the file
  unsigned mask = 0;        // of forms; 0: `lookup` orders syllables
  bool manual_zwj = false;  // ZWJ is not looked over
};

/// The lookups of a script in one language, in their order.
struct ShapePlan {
  std::string script;    // tags of OpenType
  std::string language;  // empty: that of the script
  std::vector<std::string> features;
  hb_script_t hb_script = HB_SCRIPT_COMMON;
  bool is_right_to_left = false;
  unsigned flags = 0;  // format::shaping
  CharSet below;       // letters of syllables that have a form below
  std::vector<ShapeEntry> substitutions;
  std::vector<ShapeEntry> positions;
};

/// The plans of all scripts and languages that a face has; those of a script
/// follow each other, the default first. Throws Error for a script that the
/// face cannot shape.
std::vector<ShapePlan> shape_plans(const FontFile& file,
                                   const std::vector<ShapeScript>& scripts);

/// Whether a character is an emoji, or a part of emoji alone.
bool is_emoji(char32_t c);

/// The script of a character for choosing a plan: HB_SCRIPT_COMMON for what
/// belongs to any.
hb_script_t shaped_script(char32_t c);

/// Characters that shaping makes of others.
CharSet shape_additions(const std::vector<ShapePlan>& plans,
                        const CharSet& characters);

/// The glyphs of the file that text of these characters may have.
std::set<uint32_t> shape_closure(const FontFile& file,
                                 const std::vector<ShapePlan>& plans,
                                 const CharSet& characters);

/// The same by all lookups of GSUB, whatever they are for.
std::set<uint32_t> layout_closure(const FontFile& file,
                                  const CharSet& characters);

/// What HarfBuzz takes characters apart into.
CharSet decompositions(const CharSet& characters);

}  // namespace inkcell::gen
