#include "source/font_file.hpp"

#include FT_MULTIPLE_MASTERS_H
#include FT_TRUETYPE_TABLES_H

#include <cmath>
#include <fstream>
#include <iterator>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

constexpr int kLeastUnitsPerEm = 16;
constexpr int kMostUnitsPerEm = 16384;

uint32_t big_endian_32(const uint8_t* at) {
  return uint32_t{at[0]} << 24 | uint32_t{at[1]} << 16 | uint32_t{at[2]} << 8 |
         at[3];
}

constexpr uint32_t tag(const char (&text)[5]) {
  return static_cast<uint32_t>(static_cast<uint8_t>(text[0])) << 24 |
         static_cast<uint32_t>(static_cast<uint8_t>(text[1])) << 16 |
         static_cast<uint32_t>(static_cast<uint8_t>(text[2])) << 8 |
         static_cast<uint32_t>(static_cast<uint8_t>(text[3]));
}

std::string tag_text(uint32_t value) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) {
    text += static_cast<char>(value >> shift & 0xff);
  }
  return text;
}

FT_Fixed to_16_16(double value) {
  return static_cast<FT_Fixed>(std::lround(value * 65536));
}

}  // namespace

int UnitScale::operator()(int units) const {
  return static_cast<int>(std::lround(units * to_ / from_));
}

FontFile::FontFile(const std::filesystem::path& file,
                   int face,
                   const std::vector<AxisSetting>& axes,
                   const std::string& instance)
    : file_name_(file.filename().string()), bytes_(read_font_file(file)) {
  if (is_web_font()) {
    unpack(face);
    face = 0;
  }
  check_tables(face);
  open_face(face);
  check_face();
  select_character_map();
  open_harfbuzz(face);
  vary(instance, axes);
}

void FontFile::refuse(const std::string& text) const {
  throw Error(file_name_ + ": " + text);
}

std::vector<uint8_t> read_font_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw Error(file.string() + ": is a folder; name a file in it");
  }
  if (!std::filesystem::is_regular_file(file, error)) {
    throw Error(file.string() + ": there is no such file; check its name");
  }
  std::ifstream in(file, std::ios::binary);
  std::vector<uint8_t> bytes(std::istreambuf_iterator<char>(in), {});
  if (!in.is_open() || in.bad()) {
    throw Error(file.string() + ": cannot be read; check its permissions");
  }
  return bytes;
}

bool FontFile::is_web_font() const {
  const uint32_t magic = bytes_.size() < 4 ? 0 : big_endian_32(bytes_.data());
  return magic == tag("wOFF") || magic == tag("wOF2");
}

// Replaces a WOFF or WOFF2 file by the font in it, which FreeType keeps in
// memory: for HarfBuzz, and for the checks of all fonts.
void FontFile::unpack(int face) {
  open_face(face);
  FT_ULong size = 0;
  std::vector<uint8_t> font;
  FT_Error error = FT_Load_Sfnt_Table(ft(), 0, 0, nullptr, &size);
  if (error == 0) {
    font.resize(size);
    error = FT_Load_Sfnt_Table(ft(), 0, 0, font.data(), &size);
  }
  if (error != 0) {
    refuse_damaged(error);
  }
  face_.reset();
  bytes_ = std::move(font);
}

// The offset of the face's table directory. open_face reports a face that is
// not in the collection.
size_t FontFile::find_directory(int face) const {
  if (bytes_.size() < 12) {
    refuse("is not a font: only " + std::to_string(bytes_.size()) + " bytes");
  }
  const uint32_t magic = big_endian_32(bytes_.data());
  if (magic == tag("ttcf")) {
    const uint32_t faces = big_endian_32(bytes_.data() + 8);
    const size_t index = face >= 0 && static_cast<uint32_t>(face) < faces
                             ? static_cast<size_t>(face)
                             : 0;
    if (bytes_.size() < 16 + 4 * index) {
      refuse("is truncated in its list of faces; get the whole font file");
    }
    return big_endian_32(bytes_.data() + 12 + 4 * index);
  }
  if (magic != 0x00010000 && magic != tag("OTTO") && magic != tag("true")) {
    refuse(
        "is not a font; TTF, OTF, TTC, OTC, WOFF, WOFF2, BDF, PCF, .hex of "
        "Unifont and .bin of LVGL can be read");
  }
  return 0;
}

// FreeType drops tables that go beyond the end of the file: without this check
// a font could lose its kerning silently.
void FontFile::check_tables(int face) const {
  const size_t directory = find_directory(face);
  if (directory > bytes_.size() - 12) {
    refuse("is truncated; get the whole font file");
  }
  const uint8_t* at = bytes_.data() + directory;
  const size_t tables = size_t{at[4]} << 8 | at[5];
  if (tables * 16 > bytes_.size() - 12 - directory) {
    refuse("is truncated in its table directory; get the whole font file");
  }
  bool outlines = false;
  for (size_t i = 0; i < tables; ++i) {
    const uint8_t* entry = at + 12 + 16 * i;
    check_table(entry);
    const uint32_t name = big_endian_32(entry);
    outlines |=
        name == tag("glyf") || name == tag("CFF ") || name == tag("CFF2");
  }
  if (!outlines) {
    refuse("has no outlines, only bitmaps or nothing; use an outline font");
  }
}

void FontFile::check_table(const uint8_t* entry) const {
  const uint32_t name = big_endian_32(entry);
  const uint64_t begin = big_endian_32(entry + 8);
  const uint64_t end = begin + big_endian_32(entry + 12);
  if (end > bytes_.size()) {
    refuse("is truncated: table '" + tag_text(name) + "' ends at byte " +
           std::to_string(end) + ", the file at " +
           std::to_string(bytes_.size()) + "; get the whole font file");
  }
  if (name == tag("maxp") && end >= begin + 6 &&
      (bytes_[begin + 4] | bytes_[begin + 5]) == 0) {
    refuse("holds no glyphs; use another font");
  }
  if (name == tag("head") && end >= begin + 20) {
    const int units = bytes_[begin + 18] << 8 | bytes_[begin + 19];
    if (units < kLeastUnitsPerEm || units > kMostUnitsPerEm) {
      refuse("has " + std::to_string(units) +
             " units per em, OpenType allows 16 to 16384; repair the font");
    }
  }
}

void FontFile::open_face(int face) {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) {
    refuse("FreeType does not start; is there memory left?");
  }
  library_.reset(library);
  const auto open = [&](FT_Long index, FT_Face* out) {
    return FT_New_Memory_Face(library, bytes_.data(),
                              static_cast<FT_Long>(bytes_.size()), index, out);
  };
  FT_Face found = nullptr;
  const FT_Error error = open(face, &found);
  if (error == 0 && face >= 0) {
    face_.reset(found);
    return;
  }
  FT_Face count_only = nullptr;
  if (open(-1, &count_only) == 0) {
    const FT_Long faces = count_only->num_faces;
    FT_Done_Face(count_only);
    if (face < 0 || face >= faces) {
      refuse("has no face " + std::to_string(face) + "; choose 0" +
             (faces > 1 ? " to " + std::to_string(faces - 1) : ""));
    }
  }
  refuse_damaged(error);
}

void FontFile::refuse_damaged(int error) const {
  const std::string number = "(FreeType error " + std::to_string(error) + ")";
  if (!is_web_font()) {
    refuse("is not a usable font " + number +
           "; it may be damaged: get it anew");
  }
  const bool is_first = bytes_[3] == 'F';
  refuse("FreeType cannot unpack this " +
         std::string(is_first ? "WOFF" : "WOFF2") + " file " + number +
         ": it is damaged, truncated or without outlines, or FreeType was "
         "built without " +
         (is_first ? "zlib" : "Brotli") + "; get it anew, or unpack it with " +
         (is_first ? "woff2sfnt (Debian package woff-tools)"
                   : "woff2_decompress (Debian package woff2)"));
}

void FontFile::check_face() const {
  if (!FT_IS_SFNT(ft())) {
    refuse("is not a TrueType or OpenType font; convert it first");
  }
  if (ft()->num_glyphs < 1) {
    refuse("holds no glyphs; use another font");
  }
  if (!FT_IS_SCALABLE(ft())) {
    refuse("has no outlines; use an outline font");
  }
  const int units = units_per_em();
  if (units < kLeastUnitsPerEm || units > kMostUnitsPerEm) {
    refuse("has " + std::to_string(units) +
           " units per em, OpenType allows 16 to 16384; repair the font");
  }
}

void FontFile::select_character_map() {
  if (FT_Select_Charmap(ft(), FT_ENCODING_UNICODE) != 0 &&
      FT_Select_Charmap(ft(), FT_ENCODING_MS_SYMBOL) != 0) {
    refuse(
        "has no Unicode character map, so that no character can be found in "
        "it; use a font that has one");
  }
}

std::vector<uint8_t> FontFile::table(hb_tag_t tag) const {
  hb_blob_t* blob = hb_face_reference_table(hb_face(), tag);
  unsigned size = 0;
  const char* data = hb_blob_get_data(blob, &size);
  std::vector<uint8_t> bytes(data, data + size);
  hb_blob_destroy(blob);
  return bytes;
}

uint32_t FontFile::glyph_of(char32_t code_point) const {
  const uint32_t glyph = FT_Get_Char_Index(ft(), code_point);
  // Symbol fonts keep ASCII at U+F000.
  if (glyph == 0 && code_point < 0x100 &&
      ft()->charmap->encoding == FT_ENCODING_MS_SYMBOL) {
    return FT_Get_Char_Index(ft(), 0xf000 + code_point);
  }
  return glyph;
}

std::string FontFile::family_of(FT_Face face) const {
  return face->family_name == nullptr ? file_name_ : face->family_name;
}

std::string FontFile::name_of(FT_Face face) const {
  const char* style = face->style_name;
  return family_of(face) + (style == nullptr ? "" : std::string(" ") + style);
}

std::string FontFile::full_name() const {
  if (variation_.is_default()) {
    return name_of(ft());
  }
  const std::string instance = variation_.instance();
  return family_of(ft()) + ", " +
         (instance.empty() ? variation_.values() : instance);
}

std::vector<std::string> FontFile::face_names() const {
  std::vector<std::string> names;
  for (FT_Long i = 0; i < ft()->num_faces; ++i) {
    FT_Face face = nullptr;
    if (FT_New_Memory_Face(library_.get(), bytes_.data(),
                           static_cast<FT_Long>(bytes_.size()), i,
                           &face) != 0) {
      names.emplace_back("damaged");
      continue;
    }
    names.push_back(name_of(face));
    FT_Done_Face(face);
  }
  return names;
}

void FontFile::open_harfbuzz(int face) {
  hb_blob_t* blob = hb_blob_create(reinterpret_cast<const char*>(bytes_.data()),
                                   static_cast<unsigned>(bytes_.size()),
                                   HB_MEMORY_MODE_READONLY, nullptr, nullptr);
  hb_face_.reset(hb_face_create(blob, static_cast<unsigned>(face)));
  hb_blob_destroy(blob);
  hb_font_.reset(hb_font_create(hb_face_.get()));
  hb_font_set_scale(hb_font_.get(), units_per_em(), units_per_em());
}

void FontFile::vary(const std::string& instance,
                    const std::vector<AxisSetting>& settings) {
  variation_ = read_variation(hb_face());
  try {
    set_variation(instance, settings, variation_);
  } catch (const Error& error) {
    refuse(error.what());
  }
  if (variation_.is_default()) {
    return;
  }
  std::vector<FT_Fixed> coordinates;
  std::vector<hb_variation_t> variations;
  for (const FontAxis& axis : variation_.axes) {
    coordinates.push_back(to_16_16(axis.value));
    variations.push_back({hb_tag_from_string(axis.tag.data(), 4),
                          static_cast<float>(axis.value)});
  }
  if (FT_Set_Var_Design_Coordinates(ft(),
                                    static_cast<FT_UInt>(coordinates.size()),
                                    coordinates.data()) != 0) {
    refuse("does not take these values of its axes; they are " +
           variation_.ranges());
  }
  hb_font_set_variations(hb_font_.get(), variations.data(),
                         static_cast<unsigned>(variations.size()));
}

}  // namespace inkcell::gen
