// What the generator takes from a font file: outlines, metrics, kerning.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "shape/outline.hpp"
#include "source/char_set.hpp"
#include "source/components.hpp"
#include "source/font_file.hpp"
#include "source/icon_files.hpp"
#include "source/kerning.hpp"
#include "source/line_shaper.hpp"

namespace inkcell::gen {

/// The glyph count of the format is 16 bits wide.
inline constexpr size_t kMostGlyphs = 65535;

/// What shaped lines show of one face.
struct LineShare {
  std::set<uint32_t> glyphs;  // ids in the file, without .notdef
  /// Characters whose own glyphs are among them.
  CharSet characters;
};

/// Characters that nobody asks for, but that layout puts into text.
enum class Additions : uint8_t {
  none,
  space,  // the space, which costs an advance and no outline
  signs,  // also those of an ellipsis and a hyphen, for text
};

/// Which face of which file, and which of its characters.
struct FontRequest {
  std::filesystem::path file;
  std::optional<int> face;  // none: the first; a warning names it if need be
  std::string instance;     // by its name; may be empty
  std::vector<AxisSetting> axes;
  CharSet characters;
  /// May be empty, as `characters` may then.
  LineShare lines;
  /// For load_faces().
  Additions additions = Additions::none;
  /// Also the glyphs that others are made of, such as accents: at the end of
  /// the list, without code points.
  bool with_components = false;
};

/// Measures of the face, in font units, y up.
struct SourceMetrics {
  int units_per_em = 0;
  int ascender = 0;
  int descender = 0;
  int line_gap = 0;
  int x_height = 0;
  int cap_height = 0;
};

/// One glyph of the font to be.
struct SourceGlyph {
  std::string file_name;              // the font or drawing it comes from
  uint32_t source = 0;                // id in the font file
  std::vector<char32_t> code_points;  // none: .notdef, or as stated below
  bool is_of_line = false;            // a shaped line has it; else a component
  size_t face = 0;                    // number of its file
  Outline outline;                    // [u]
  int advance = 0;                    // [font units]

  /// How messages and reports name the glyph.
  std::string name() const;
  /// What to do if the glyph cannot be used: `repair`, or leave the character
  /// out, which .notdef cannot be.
  std::string remedy(const std::string& repair) const;
};

/// A face that gives glyphs.
struct SourceFace {
  std::string file_name;
  Variation variation;
  double scale = 1;     // its em, in em of the font
  double shift_em = 0;  // how far above its own baseline it stands
};

/// Everything about a font that is not yet a field.
struct SourceFont {
  std::string file_name;
  std::string name;  // family and style
  SourceMetrics metrics;
  /// .notdef, then in the order of their smallest code points; then those of
  /// lines alone in the same order, the ones without code points last. With
  /// other faces or icons all code points are in one order. Code points that
  /// share a glyph in the file share it here.
  std::vector<SourceGlyph> glyphs;
  /// What each glyph is made of; with components only.
  std::vector<OutlineReferences> components;
  /// Between the glyphs of characters: lines are kerned already.
  KerningMatrix kerning;
  /// Lines in glyphs of all faces.
  std::vector<ShapedLine> lines;
  /// Characters that the font does not have, in ascending order.
  std::vector<char32_t> missing;
  /// What FontRequest::additions brought.
  CharSet added;
  std::vector<IconFile> icons;
  std::vector<SourceFace> faces;  // in order of priority

  /// Whether a text may show a glyph, which is no mere component then.
  bool is_shown(size_t glyph) const {
    return glyph == 0 || !glyphs[glyph].code_points.empty() ||
           glyphs[glyph].is_of_line;
  }
};

/// Reads all that `request` asks for. Kerning is looked up on `jobs` threads
/// (0: all cores). Throws Error.
SourceFont load_font(const FontRequest& request, int jobs, Warnings& warnings);

/// The same of a file that is open, which is that of `request`.
SourceFont load_font(const FontFile& file,
                     const FontRequest& request,
                     int jobs,
                     Warnings& warnings);

/// Throws the Error of a file that has none of the characters asked for.
[[noreturn]] void refuse_all(const FontFile& file, size_t characters);

/// The characters that the font's lines show as .notdef.
CharSet missing_in_lines(const SourceFont& font);

/// Takes the warnings of missing characters away; adds one that lists those of
/// `font`, if there are any.
void renew_missing_warning(const SourceFont& font, Warnings& warnings);

}  // namespace inkcell::gen
