// A font file opened by FreeType (outlines) and HarfBuzz (metrics, kerning).
#pragma once

#include <ft2build.h>
#include FT_FREETYPE_H
#include <hb.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "source/variation.hpp"

namespace inkcell::gen {

/// Converts font units of one face to those of another, rounded to nearest.
class UnitScale {
 public:
  /// An em of the first face is `scale` em of the second.
  UnitScale(int from_units_per_em, int to_units_per_em, double scale)
      : from_(from_units_per_em), to_(scale * to_units_per_em) {}

  int operator()(int units) const;
  bool is_one() const { return from_ == to_; }

 private:
  double from_;
  double to_;
};

/// The bytes of a file. Throws Error.
std::vector<uint8_t> read_font_file(const std::filesystem::path& file);

/// One face of a TTF, OTF, TTC, OTC, WOFF or WOFF2 file at one instance.
/// FreeType and HarfBuzz return all lengths of it in font units.
class FontFile {
 public:
  /// Opens face number `face` at the named instance, if the name is not empty,
  /// and with the given axes; other axes keep their defaults. Throws Error if
  /// there are no outlines: not a font, truncated, bitmaps only, unitsPerEm
  /// outside 16..16384, no glyphs, unknown face, instance or axis.
  FontFile(const std::filesystem::path& file,
           int face,
           const std::vector<AxisSetting>& axes,
           const std::string& instance = {});

  FT_Face ft() const { return face_.get(); }
  hb_face_t* hb_face() const { return hb_face_.get(); }
  hb_font_t* hb() const { return hb_font_.get(); }

  int units_per_em() const { return face_->units_per_EM; }

  /// The glyph of a code point in the Unicode (or symbol) character map; 0 if
  /// there is none.
  uint32_t glyph_of(char32_t code_point) const;

  /// The bytes of a table of the face; empty if there is none.
  std::vector<uint8_t> table(hb_tag_t tag) const;

  /// The file name without folders, for messages and reports.
  const std::string& file_name() const { return file_name_; }
  /// The axes and their values.
  const Variation& variation() const { return variation_; }
  /// Family and style, such as "DejaVu Sans Book"; instances of variable fonts
  /// are "Roboto Flex, Bold" or "Roboto Flex, wght 650".
  std::string full_name() const;
  /// The same of each face in the file.
  std::vector<std::string> face_names() const;

  /// Throws Error "<file>: <text>".
  [[noreturn]] void refuse(const std::string& text) const;

 private:
  struct Release {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
    void operator()(hb_font_t* font) const { hb_font_destroy(font); }
  };
  template <typename Handle>
  using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

  std::string family_of(FT_Face face) const;
  std::string name_of(FT_Face face) const;
  bool is_web_font() const;
  void unpack(int face);
  /// Throws the Error for a file that FreeType cannot open.
  [[noreturn]] void refuse_damaged(int error) const;
  size_t find_directory(int face) const;
  void check_tables(int face) const;
  /// One entry of the table directory.
  void check_table(const uint8_t* entry) const;
  void open_face(int face);
  void check_face() const;
  void select_character_map();
  void open_harfbuzz(int face);
  void vary(const std::string& instance,
            const std::vector<AxisSetting>& settings);

  std::string file_name_;
  Variation variation_;
  std::vector<uint8_t> bytes_;  // outlives the handles below
  Owner<FT_Library> library_;
  Owner<FT_Face> face_;
  Owner<hb_face_t*> hb_face_;
  Owner<hb_font_t*> hb_font_;
};

}  // namespace inkcell::gen
