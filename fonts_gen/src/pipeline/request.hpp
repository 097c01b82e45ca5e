// What to generate.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "source/char_set.hpp"
#include "source/font_file.hpp"
#include "source/icons.hpp"
#include "target/target.hpp"
#include "texts/string_file.hpp"

namespace inkcell::gen {

class BuiltGlyphs;

/// A part of the glyphs of a font, for processes that share the work.
struct GlyphPart {
  size_t number = 0;
  size_t count = 1;
};

/// What to generate. The defaults are those of the command line.
struct GenerateRequest {
  std::filesystem::path font;  // empty: icons alone
  std::optional<int> face;     // none: the first
  std::string instance;        // of a variable font, by its name
  /// Where one moves to a second value, glyphs get a second master.
  AxisSettings axes;
  /// Characters: the union of all five; printable ASCII if they are empty and
  /// there are no strings.
  std::vector<std::string> chars;  // lists as add_ranges reads them
  std::vector<std::string> sets;   // lists as add_named_sets reads them
  std::vector<std::filesystem::path> text_files;
  std::vector<std::string> strings_from;  // patterns, as shown_texts() reads
  std::string symbols;                    // UTF-8
  /// Whether text gets what layout may add: an ellipsis, a hyphen. The space is
  /// always there if the face has one.
  bool layout_glyphs = true;
  /// Files of strings that are shaped, as add_string_file reads them.
  std::vector<std::filesystem::path> string_files;
  /// Whether generate() throws for characters that the font lacks; otherwise
  /// it warns.
  bool strict = false;
  /// More faces, as parse_merged_face reads them, in order of priority.
  std::vector<std::string> merge;
  /// Whether glyphs of several colours keep them, as layers.
  bool has_colours = false;
  std::vector<std::string> svg_files;  // "wifi.svg=0xE001"
  std::vector<std::filesystem::path> svg_folders;
  IconPlace icon_place;
  /// Sizes are whole numbers within 4..1024 px/em, min <= max; the tolerance is
  /// a whole number within 1..255.
  Target target;
  GenerateRequest() { target.coding = Coding::outline; }
  /// Whether an outline font says what grid fitting needs.
  bool hints = true;
  /// Groups of characters, UTF-8, parted by blanks: all of a group morph into
  /// each other. After "points:", point by point.
  std::vector<std::string> morphs;
  /// Scripts that the device shapes, as parse_shape_scripts() reads them.
  std::string shapes;
  /// Whether the font keeps the face's tables of layout, for HarfBuzz.
  bool keep_layout = false;
  /// Whether a font that shapes no script lets the device compose letters and
  /// marks, where it has the composed letter.
  bool compose = true;
  /// Bytes of a block of a font for storage that is not mapped: 512, 1024, 2048
  /// or 4096; 0: the font is for mapped memory.
  int paged = 0;
  /// Sizes at which pictures of glyphs are in the font beside its outlines; or,
  /// one of them, instead of those.
  std::vector<StrikeTarget> strikes;
  bool strike_only = false;
  /// Whether generate() throws if a glyph misses the tolerance. If not, the
  /// glyph gets its best outline, and a warning names it.
  bool tolerance_is_limit = false;
  /// Threads; 0: all cores. The bytes do not depend on it.
  int threads = 0;
  /// Glyphs of an earlier font, which need not be built again; not owned, null:
  /// none. The bytes do not depend on it.
  BuiltGlyphs* built_glyphs = nullptr;
  /// Called at once, with 0, and now and then on the calling thread with glyphs
  /// done and their number.
  std::function<void(size_t done, size_t count)> progress;
};

/// Throws Error unless the numbers of `request` lie within their limits.
void check_request(const GenerateRequest& request);

/// Whether the device shapes emoji, those of file names as well.
bool shapes_emoji(const GenerateRequest& request);

/// What a request asks its font files for.
struct AskedCharacters {
  CharSet all;     // without those of strings that are shaped
  CharSet common;  // of no language
  std::map<std::string, CharSet> languages;  // of translations
};

/// Throws Error if there are neither characters nor strings that are shaped.
AskedCharacters characters_of(const GenerateRequest& request);

/// The files that strings_from names, each once. Throws Error.
std::vector<std::filesystem::path> sources_of(const GenerateRequest& request);

/// The strings that are shaped. Throws Error.
std::vector<NamedString> strings_of(const GenerateRequest& request);

/// The files that generate() reads. Throws Error.
std::vector<std::filesystem::path> inputs_of(const GenerateRequest& request);

}  // namespace inkcell::gen
