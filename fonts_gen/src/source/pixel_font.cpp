#include "source/pixel_font.hpp"

#include FT_GZIP_H
#include FT_SYSTEM_H

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <utility>

#include "source/faces.hpp"

namespace inkcell::gen {
namespace {

using FileBytes = std::vector<uint8_t>;

// Everything in a file. The first glyph is .notdef.
struct PixelFont {
  std::string file_name;
  std::string name;
  int px = 0;
  int bits = 1;
  int ascent = 0;  // [px]
  int descent = 0;
  struct Glyph {
    Picture picture;
    int advance = 0;  // [px]
  };
  std::vector<Glyph> glyphs = std::vector<Glyph>(1);
  std::map<char32_t, size_t> glyph_of;
  std::map<std::pair<size_t, size_t>, int> kerning;  // [px]

  [[noreturn]] void refuse(const std::string& text) const {
    throw Error(file_name + ": " + text);
  }
};

// The bytes of a file, unpacked.
FileBytes read_bytes(const std::filesystem::path& file) {
  FileBytes packed = read_font_file(file);
  const size_t size = packed.size();
  if (size < 18 || packed[0] != 0x1f || packed[1] != 0x8b) {
    return packed;
  }
  constexpr size_t kMostBytes = 1 << 28;
  size_t bytes = 0;
  for (size_t i = 1; i <= 4; ++i) {
    bytes = bytes << 8 | packed[size - i];
  }
  FT_MemoryRec_ memory = {nullptr,
                          [](FT_Memory, long count) {
                            return std::calloc(1, static_cast<size_t>(count));
                          },
                          [](FT_Memory, void* block) { std::free(block); },
                          [](FT_Memory, long, long count, void* block) {
                            return std::realloc(block,
                                                static_cast<size_t>(count));
                          }};
  FileBytes out(std::min(bytes, kMostBytes));
  FT_ULong written = out.size();
  const FT_Error error =
      FT_Gzip_Uncompress(&memory, out.data(), &written, packed.data(), size);
  if (error != 0 || written != bytes) {
    throw Error(file.string() +
                ": is damaged: gzip cannot unpack it; get it anew");
  }
  return out;
}

enum class Kind { none, freetype, hex, lvgl };

// A hexadecimal digit, or -1.
int digit(uint8_t c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                : -1;
}

Kind kind_of(const FileBytes& bytes) {
  const auto has = [&bytes](size_t at, const char* text) {
    const size_t size = std::strlen(text);
    return bytes.size() >= at + size &&
           std::memcmp(bytes.data() + at, text, size) == 0;
  };
  size_t digits = 0;
  while (digits < bytes.size() && digit(bytes[digits]) >= 0) {
    ++digits;
  }
  return has(0, "STARTFONT") || has(0, "\001fcp")         ? Kind::freetype
         : has(4, "head")                                 ? Kind::lvgl
         : digits >= 4 && digits <= 6 && has(digits, ":") ? Kind::hex
                                                          : Kind::none;
}

// A value of FreeType's pixels, at any depth.
int value_at(const FT_Bitmap& bitmap, int bits, int x, int y) {
  const uint8_t* const row = bitmap.buffer + y * bitmap.pitch;
  const int per_byte = 8 / bits;
  const int shift = 8 - bits - x % per_byte * bits;
  return row[x / per_byte] >> shift & ((1 << bits) - 1);
}

void read_freetype(const FileBytes& bytes, int face_number, PixelFont& font) {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  struct Done {
    FT_Library& library;
    ~Done() { FT_Done_FreeType(library); }  // and its faces
  };
  if (FT_Init_FreeType(&library) != 0) {
    font.refuse("FreeType does not start; is there memory left?");
  }
  const Done done = {library};
  if (FT_New_Memory_Face(library, bytes.data(),
                         static_cast<FT_Long>(bytes.size()), face_number,
                         &face) != 0 ||
      face->num_fixed_sizes < 1 || FT_Select_Size(face, 0) != 0) {
    font.refuse("FreeType cannot read it; it may be damaged: get it anew");
  }
  if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) != 0) {
    font.refuse(
        "has no Unicode characters; use a font whose encoding is ISO10646-1");
  }
  font.name = face->family_name == nullptr ? font.name : face->family_name;
  font.px = static_cast<int>((face->available_sizes[0].y_ppem + 32) / 64);
  font.ascent = static_cast<int>(face->size->metrics.ascender / 64);
  font.descent = static_cast<int>(-face->size->metrics.descender / 64);
  std::map<FT_UInt, size_t> known = {{0, 0}};
  const auto read = [&](FT_UInt id, PixelFont::Glyph& glyph) {
    const FT_GlyphSlot slot = face->glyph;
    if (FT_Load_Glyph(face, id, FT_LOAD_DEFAULT) != 0) {
      font.refuse("glyph " + std::to_string(id) +
                  " cannot be read; it may be damaged: get it anew");
    }
    const FT_Bitmap& bitmap = slot->bitmap;
    const int bits = bitmap.pixel_mode == FT_PIXEL_MODE_MONO    ? 1
                     : bitmap.pixel_mode == FT_PIXEL_MODE_GRAY2 ? 2
                     : bitmap.pixel_mode == FT_PIXEL_MODE_GRAY4 ? 4
                                                                : 0;
    if (bits == 0) {
      font.refuse("has more than 4 bits a pixel; use one of 1, 2 or 4 bits");
    }
    font.bits = bits;
    const int x0 = slot->bitmap_left;
    const int y0 = -slot->bitmap_top;
    glyph.picture = cropped(
        Rect{x0, y0, x0 + static_cast<int>(bitmap.width),
             y0 + static_cast<int>(bitmap.rows)},
        [&](int x, int y) { return value_at(bitmap, bits, x - x0, y - y0); });
    glyph.advance = static_cast<int>(slot->advance.x / 64);
  };
  read(0, font.glyphs[0]);
  FT_UInt id = 0;
  for (FT_ULong c = FT_Get_First_Char(face, &id); id != 0;
       c = FT_Get_Next_Char(face, c, &id)) {
    const auto [found, is_new] = known.emplace(id, font.glyphs.size());
    if (is_new) {
      font.glyphs.emplace_back();
      read(id, font.glyphs.back());
    }
    font.glyph_of[static_cast<char32_t>(c)] = found->second;
  }
}

// Lines such as 0041:0000000018242442427E424242420000: 16 rows of a character.
void read_hex(const FileBytes& bytes, PixelFont& font) {
  constexpr int kRows = 16;
  font.px = kRows;
  font.descent = 2;
  font.ascent = kRows - font.descent;
  int number = 0;
  for (size_t at = 0; at < bytes.size(); ++number) {
    const size_t begin = at;
    char32_t code = 0;
    for (; at < bytes.size() && digit(bytes[at]) >= 0; ++at) {
      code = code << 4 | static_cast<char32_t>(digit(bytes[at]));
    }
    const size_t digits = at - begin;
    const size_t rows = ++at;
    while (at < bytes.size() && digit(bytes[at]) >= 0) {
      ++at;
    }
    const size_t columns = at - std::min(at, rows);
    const size_t end = at;
    while (at < bytes.size() && bytes[at] <= ' ') {
      ++at;
    }
    if (digits < 4 || digits > 6 || bytes[rows - 1] != ':' || columns == 0 ||
        columns % (2 * kRows) != 0 || columns > 8 * kRows || end == at) {
      font.refuse("line " + std::to_string(number + 1) +
                  " is not CODE:ROWS, 16 rows of 8 to 32 pixels; repair it");
    }
    const int width = static_cast<int>(columns) * 4 / kRows;
    PixelFont::Glyph glyph;
    glyph.advance = width;
    glyph.picture =
        cropped(Rect{0, -font.ascent, width, font.descent}, [&](int x, int y) {
          const int bit = (y + font.ascent) * width + x;
          const size_t of = rows + static_cast<size_t>(bit / 4);
          return digit(bytes[of]) >> (3 - bit % 4) & 1;
        });
    font.glyph_of[code] = font.glyphs.size();
    font.glyphs.push_back(std::move(glyph));
  }
}

// LVGL's fonts, as its documents specify them: tables of a length, four letters
// and content, little end first, glyphs in bits from the highest on.
class LvglReader {
 public:
  LvglReader(const FileBytes& bytes, PixelFont& font)
      : bytes_(bytes), font_(font) {}

  void read() {
    head_ = table("head");
    const size_t cmap = table("cmap");
    const size_t loca = table("loca");
    const size_t glyf = table("glyf");
    font_.px = static_cast<int>(number(head_ + 14, 2));
    font_.ascent = sign(number(head_ + 16, 2), 16);
    font_.descent = -sign(number(head_ + 18, 2), 16);
    font_.bits = static_cast<int>(number(head_ + 37, 1));
    if (font_.bits != 1 && font_.bits != 2 && font_.bits != 4) {
      font_.refuse("has " + std::to_string(font_.bits) +
                   " bits a pixel; make it with --bpp 1, 2 or 4");
    }
    if (number(head_ + 42, 1) != 0) {
      font_.refuse("has sub-pixels; make it without --lcd");
    }
    const size_t glyphs = number(loca + 8, 4);
    const size_t width = number(head_ + 34, 1) == 0 ? 2 : 4;
    if (glyphs < 1 || glyphs > kMostGlyphs) {
      damaged();
    }
    font_.glyphs.resize(glyphs);
    for (size_t i = 0; i < glyphs; ++i) {
      read_glyph(glyf + number(loca + 12 + width * i, width), font_.glyphs[i]);
    }
    read_characters(cmap);
    const size_t next = glyf + number(glyf, 4);
    if (next != bytes_.size()) {
      read_kerning(table("kern"));
    }
  }

 private:
  [[noreturn]] void damaged() const {
    font_.refuse("is damaged or truncated; make it again");
  }
  uint32_t number(size_t at, size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at) {
      damaged();
    }
    uint32_t value = 0;
    for (size_t i = 0; i < count; ++i) {
      value |= uint32_t{bytes_[at + i]} << 8 * i;
    }
    return value;
  }
  static int sign(uint32_t value, uint32_t bits) {
    const uint32_t half = uint32_t{1} << (bits - 1);
    return static_cast<int>(value ^ half) - static_cast<int>(half);
  }
  static uint32_t letters(const char* name) {
    uint32_t value = 0;
    for (uint32_t i = 0; i < 4; ++i) {
      value |= uint32_t{static_cast<uint8_t>(name[i])} << 8 * i;
    }
    return value;
  }
  size_t table(const char* name) const {
    size_t at = 0;
    for (; number(at + 4, 4) != letters(name); at += number(at, 4)) {
      if (number(at, 4) < 8) {
        damaged();
      }
    }
    return at;
  }
  uint32_t bits(uint32_t count) {
    uint32_t value = 0;
    for (uint32_t i = 0; i < count; ++i, ++bit_) {
      value = value << 1 | (number(bit_ / 8, 1) >> (7 - bit_ % 8) & 1);
    }
    return value;
  }

  void read_glyph(size_t at, PixelFont::Glyph& glyph) {
    bit_ = 8 * at;
    const uint32_t has_advance = number(head_ + 40, 1);
    const uint32_t place = number(head_ + 38, 1);
    const uint32_t size = number(head_ + 39, 1);
    if (has_advance > 16 || place < 1 || place > 16 || size > 8) {
      damaged();
    }
    const uint32_t advance =
        has_advance != 0 ? bits(has_advance) : number(head_ + 30, 2);
    // In LVGL text stands on whole pixels.
    advances_q4_.push_back(number(head_ + 36, 1) == 0 ? advance * 16 : advance);
    glyph.advance = static_cast<int>(advances_q4_.back() + 8) >> 4;
    const int left = sign(bits(place), place);
    const int bottom = sign(bits(place), place);
    const int width = static_cast<int>(bits(size));
    const int height = static_cast<int>(bits(size));
    const std::vector<uint32_t> values =
        read_values(static_cast<size_t>(width), static_cast<size_t>(height));
    glyph.picture = cropped(
        Rect{left, -bottom - height, left + width, -bottom}, [&](int x, int y) {
          return static_cast<int>(values[static_cast<size_t>(
              (y + bottom + height) * width + x - left)]);
        });
  }

  // As they are, or in runs: a value that follows itself is followed by a bit
  // for each further one, 1, and after eleven of them by six bits with how many
  // more there are. Compression 1 keeps what differs from the row above.
  std::vector<uint32_t> read_values(size_t width, size_t height) {
    const uint32_t compression = number(head_ + 41, 1);
    const auto depth = static_cast<uint32_t>(font_.bits);
    std::vector<uint32_t> values;
    uint32_t ones = 0;
    uint32_t repeats = 0;
    bool is_run = false;
    while (values.size() < width * height) {
      const bool is_first = values.empty();
      uint32_t value = is_first ? 0 : values.back();
      if (repeats != 0) {
        is_run = --repeats != 0;
        value = is_run ? value : bits(depth);
      } else if (is_run && bits(1) != 0) {
        if (++ones == 11) {
          repeats = bits(6);
          is_run = repeats != 0;
          value = is_run ? value : bits(depth);
        }
      } else {
        const uint32_t next = bits(depth);
        is_run = compression != 0 && !is_run && !is_first && next == value;
        ones = 0;
        value = next;
      }
      values.push_back(value);
    }
    for (size_t i = width; compression == 1 && i < values.size(); ++i) {
      values[i] ^= values[i - width];
    }
    return values;
  }

  void read_characters(size_t cmap) {
    const size_t count = number(cmap + 8, 4);
    for (size_t i = 0; i < count; ++i) {
      const size_t entry = cmap + 12 + 16 * i;
      const size_t data = cmap + number(entry, 4);
      const uint32_t first = number(entry + 4, 4);
      const uint32_t first_glyph = number(entry + 10, 2);
      const uint32_t form = number(entry + 14, 1);
      const bool is_sparse = (form & 1) != 0;
      const uint32_t entries =
          is_sparse ? number(entry + 12, 2) : number(entry + 8, 2);
      for (uint32_t k = 0; k < entries; ++k) {
        const uint32_t code = first + (is_sparse ? number(data + 2 * k, 2) : k);
        const uint32_t glyph =
            first_glyph + (form == 0   ? number(data + k, 1)
                           : form == 1 ? number(data + 2 * (entries + k), 2)
                                       : k);
        // Format 0 has 0 where there is no character.
        const bool is_hole = form == 0 && k != 0 && glyph == first_glyph;
        if (glyph < font_.glyphs.size() && glyph != 0 && !is_hole) {
          font_.glyph_of[code] = glyph;
        }
      }
    }
  }

  // Pairs, or a matrix of classes.
  void read_kerning(size_t kern) {
    const uint32_t scale = number(head_ + 32, 2);
    const auto put = [&](size_t left, size_t right, size_t at) {
      const int kerning = sign(number(at, 1), 8) * static_cast<int>(scale) >> 4;
      if (left < font_.glyphs.size() && right < font_.glyphs.size()) {
        const int q4 = static_cast<int>(advances_q4_[left]) + kerning + 8;
        font_.kerning[{left, right}] = (q4 >> 4) - font_.glyphs[left].advance;
      }
    };
    const size_t count = number(kern + 12, 4);
    if (number(kern + 8, 1) == 0) {
      const size_t id = number(head_ + 35, 1) == 0 ? 1 : 2;
      for (size_t i = 0; i < count; ++i) {
        const size_t at = kern + 16 + 2 * id * i;
        put(number(at, id), number(at + id, id),
            kern + 16 + 2 * id * count + i);
      }
      return;
    }
    const size_t glyphs = count & 0xffff;
    const size_t rights = number(kern + 15, 1);
    for (size_t left = 0; left < glyphs; ++left) {
      const size_t row = number(kern + 16 + left, 1);
      for (size_t right = 0; row != 0 && right < glyphs; ++right) {
        const size_t column = number(kern + 16 + glyphs + right, 1);
        if (column != 0) {
          put(left, right,
              kern + 16 + 2 * glyphs + (row - 1) * rights + column - 1);
        }
      }
    }
  }

  const FileBytes& bytes_;
  PixelFont& font_;
  size_t head_ = 0;
  size_t bit_ = 0;  // the next one of a glyph
  std::vector<uint32_t> advances_q4_;
};

PixelFont read_pixel_font(const FontRequest& request) {
  const FileBytes bytes = read_bytes(request.file);
  PixelFont font;
  font.file_name = request.file.filename().string();
  font.name = request.file.stem().string();
  const Kind kind = kind_of(bytes);
  if (kind == Kind::lvgl) {
    LvglReader(bytes, font).read();
  } else if (kind == Kind::hex) {
    read_hex(bytes, font);
  } else {
    read_freetype(bytes, request.face.value_or(0), font);
  }
  if (font.px < 4 || font.px > 255) {
    font.refuse("has " + std::to_string(font.px) +
                " px/em, 4 to 255 are possible; use another size");
  }
  return font;
}

// The pairs of the chosen glyphs. [px]
KerningMatrix kerning_of(const PixelFont& font,
                         const std::map<size_t, size_t>& place_of,
                         int units) {
  std::map<size_t, std::vector<int16_t>> rows;
  for (const auto& [pair, px] : font.kerning) {
    const auto left = place_of.find(pair.first);
    const auto right = place_of.find(pair.second);
    if (px != 0 && left != place_of.end() && right != place_of.end()) {
      auto& row = rows[left->second];
      row.resize(place_of.size());
      row[right->second] = static_cast<int16_t>(px * units);
    }
  }
  std::vector<size_t> lefts;
  std::vector<std::vector<int16_t>> values;
  for (auto& [left, row] : rows) {
    lefts.push_back(left);
    values.push_back(std::move(row));
  }
  return join_classes(place_of.size(), lefts, values);
}

}  // namespace

bool is_bitmap_font(const std::filesystem::path& file) {
  return kind_of(read_bytes(file)) != Kind::none;
}

SourceFont load_pixel_font(const FontRequest& request, Warnings& warnings) {
  const PixelFont pixels = read_pixel_font(request);
  SourceFont font;
  font.file_name = pixels.file_name;
  font.name = pixels.name;
  font.pixel_px = pixels.px;
  font.pixel_bits = pixels.bits;
  font.faces = {{font.file_name, {}}};
  // So fine that outlines may join it.
  const int units = 2048 / pixels.px;
  const auto top = [&](char32_t c) {
    const auto found = pixels.glyph_of.find(c);
    return found == pixels.glyph_of.end()
               ? 0
               : -pixels.glyphs[found->second].picture.top * units;
  };
  font.metrics = {units * pixels.px,
                  units * pixels.ascent,
                  -units * pixels.descent,
                  0,
                  top('x'),
                  top('H')};
  const auto has = [&](char32_t c) { return pixels.glyph_of.count(c) != 0; };
  font.added = additions_to(request.characters, request.additions, has);
  CharSet characters = request.characters;
  characters.insert(font.added.begin(), font.added.end());
  std::map<size_t, size_t> place_of;
  const auto add = [&](size_t glyph) -> SourceGlyph& {
    const auto [found, is_new] = place_of.emplace(glyph, font.glyphs.size());
    if (is_new) {
      font.glyphs.emplace_back();
      SourceGlyph& added = font.glyphs.back();
      added.file_name = font.file_name;
      added.source = static_cast<uint32_t>(glyph);
      added.picture = pixels.glyphs[glyph].picture;
      added.advance = pixels.glyphs[glyph].advance * units;
      if (!added.picture->is_in_format() || added.advance < 0) {
        pixels.refuse("glyph " + std::to_string(glyph) +
                      " is larger than 255 px, or begins further than 128 px "
                      "from its origin; use a smaller size");
      }
    }
    return font.glyphs[found->second];
  };
  add(0);
  for (const char32_t c : characters) {
    if (has(c)) {
      SourceGlyph& glyph = add(pixels.glyph_of.at(c));
      glyph.code_points.push_back(c);
    } else if (is_missed(c)) {
      font.missing.push_back(c);
    }
  }
  if (font.glyphs.size() > kMostGlyphs) {
    pixels.refuse(std::to_string(font.glyphs.size()) +
                  " glyphs asked for, a font holds at most 65535; ask for less "
                  "with --chars");
  }
  font.components.resize(font.glyphs.size());
  font.kerning = kerning_of(pixels, place_of, units);
  renew_missing_warning(font, warnings);
  return font;
}

}  // namespace inkcell::gen
