// Reads outlines, metrics and kerning of a font file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "shape/outline.hpp"
#include "shape/paint.hpp"
#include "shape/shape.hpp"
#include "source/char_set.hpp"
#include "source/components.hpp"
#include "source/font_file.hpp"
#include "source/icon_files.hpp"
#include "source/kerning.hpp"
#include "source/line_shaper.hpp"
#include "source/picture.hpp"
#include "source/shape_script.hpp"

namespace inkcell::gen {

/// The glyph count of the format is 16 bits wide.
inline constexpr size_t kMostGlyphs = 65535;

/// The part of shaped lines that comes from one face.
struct LineShare {
  std::set<uint32_t> glyphs;  // ids in the file, without .notdef
  /// Characters whose plain glyphs are among them.
  CharSet characters;
};

/// Characters that layout inserts into text without being asked for.
enum class Additions : uint8_t {
  none,
  space,  // the space: an advance without an outline
  signs,  // also those of an ellipsis and a hyphen, for text
};

/// The file, the face, and its characters.
struct FontRequest {
  std::filesystem::path file;
  std::optional<int> face;  // none: the first; a warning names it if need be
  std::string instance;     // by its name; may be empty
  AxisSettings axes;
  CharSet characters;
  /// May be empty, as `characters` may then.
  LineShare lines;
  /// For load_faces().
  Additions additions = Additions::none;
  /// Also add components of other glyphs, such as accents: at the end of the
  /// list, without code points.
  bool with_components = false;
  /// Whether glyphs of several colours keep their layers.
  bool has_colours = false;
  /// Scripts that the device shapes with the glyphs of this face.
  std::vector<ShapeScript> shapes;
  bool keep_layout = false;  // HarfBuzz shapes with this face
};

/// Metrics of the face, in font units, y up.
struct SourceMetrics {
  int units_per_em = 0;
  int ascender = 0;
  int descender = 0;
  int line_gap = 0;
  int x_height = 0;
  int cap_height = 0;
};

/// A glyph in a colour.
struct LayerReference {
  size_t layer = 0;   // among the glyphs that are layers
  size_t colour = 0;  // in SourceFont::colours; see format::layers
};

/// A glyph of the font to be made.
struct SourceGlyph {
  std::string file_name;              // the font or drawing it comes from
  uint32_t source = 0;                // id in the font file
  std::vector<char32_t> code_points;  // none: .notdef, or as stated below
  bool is_of_line = false;            // a shaped line has it; else a component
  std::u32string sequence;            // of characters that it draws, if several
  /// Of a second master: "U+0041 'A' at wght 800". It has no code points, and
  /// the source and the face of the plain glyph.
  std::string master;
  size_t face = 0;                 // number of its file
  Outline outline;                 // [u]
  std::optional<Picture> picture;  // of a bitmap font, instead
  /// Of a glyph of several colours, from below.
  std::vector<PaintedOutline> painted;
  std::vector<LayerReference> layers;  // the same as glyphs
  Box layers_box;                      // [u] of their ink
  /// Of such a layer, which has no code points: "U+2600".
  std::string layer_of;
  int advance = 0;  // [font units]

  /// How messages and reports name the glyph.
  std::string name() const;
  /// The remedy if the glyph cannot be used: `repair`, or leave the character
  /// out, which is impossible for .notdef.
  std::string remedy(const std::string& repair) const;
};

/// A face that has glyphs in the font.
struct SourceFace {
  std::string file_name;
  Variation variation;
  double scale = 1;     // its em, in em of the font
  double shift_em = 0;  // of its baseline, upwards
};

/// A font before its glyphs are encoded.
struct SourceFont {
  std::string file_name;
  std::string name;  // family and style
  SourceMetrics metrics;
  /// .notdef, then glyphs in the order of their smallest code points; then
  /// those of lines alone in the same order, those without code points last.
  /// With other faces or icons all code points are in one order. Code points
  /// that share a glyph in the file share it here. Second masters are the last.
  std::vector<SourceGlyph> glyphs;
  /// The components of each glyph; only if asked for.
  std::vector<OutlineReferences> components;
  /// Between glyphs of characters; lines are already kerned.
  KerningMatrix kerning;
  /// Lines in glyphs of all faces.
  std::vector<ShapedLine> lines;
  /// Characters that the font lacks, in ascending order.
  std::vector<char32_t> missing;
  /// Characters added by FontRequest::additions.
  CharSet added;
  std::vector<IconFile> icons;
  std::vector<SourceFace> faces;  // in order of priority
  /// Of layers, in each palette of the file.
  std::vector<std::vector<Paint>> palettes;
  size_t layer_count = 0;  // glyphs at the end that are layers
  /// Of bitmap fonts: their size and bits of a pixel. 0: there are none.
  int pixel_px = 0;
  int pixel_bits = 0;

  /// Whether text may show a glyph; false for mere components.
  bool is_shown(size_t glyph) const {
    return glyph == 0 || !glyphs[glyph].code_points.empty() ||
           glyphs[glyph].is_of_line || !glyphs[glyph].master.empty() ||
           !glyphs[glyph].layer_of.empty();
  }
};

/// Reads all that `request` asks for. Kerning is looked up on `jobs` threads
/// (0: all cores). Throws Error.
SourceFont load_font(const FontRequest& request, int jobs, Warnings& warnings);

/// The same for a file that is already open.
SourceFont load_font(const FontFile& file,
                     const FontRequest& request,
                     int jobs,
                     Warnings& warnings);

/// Throws the Error for a file that has none of the characters asked for.
[[noreturn]] void refuse_all(const FontFile& file, size_t characters);

/// The characters that the font's lines show as .notdef.
CharSet missing_in_lines(const SourceFont& font);

/// Replaces the warnings of missing characters by one for `font`, if any are
/// missing.
void renew_missing_warning(const SourceFont& font, Warnings& warnings);

}  // namespace inkcell::gen
