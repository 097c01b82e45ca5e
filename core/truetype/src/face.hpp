// What the tables of a TrueType file say, for files in memory and in storage.
//
// A `Face` is a TrueTypeFace with tables of the type AnyTable, which tables.hpp
// reads, or what stands for it.
#pragma once

#include <stdint.h>

#include "code_map.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/status.hpp"
#include "inkcell/style.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "pair_kerning.hpp"
#include "tables.hpp"

namespace inkcell::detail {

constexpr uint32_t tag_of_table(char a, char b, char c, char d) noexcept {
  return __builtin_bswap32(format::tag(a, b, c, d));
}

// Tables that are looked for, in the order of `TableAt`.
inline constexpr uint32_t kTableTags[] = {
    tag_of_table('h', 'e', 'a', 'd'), tag_of_table('m', 'a', 'x', 'p'),
    tag_of_table('h', 'h', 'e', 'a'), tag_of_table('c', 'm', 'a', 'p'),
    tag_of_table('O', 'S', '/', '2'), tag_of_table('h', 'm', 't', 'x'),
    tag_of_table('l', 'o', 'c', 'a'), tag_of_table('g', 'l', 'y', 'f'),
    tag_of_table('k', 'e', 'r', 'n'), tag_of_table('G', 'P', 'O', 'S')};
inline constexpr uint32_t kTableCount =
    sizeof kTableTags / sizeof kTableTags[0];
enum TableAt : uint32_t {
  kTableHead,
  kTableMaxp,
  kTableHhea,
  kTableCmap,
  kTableOs2,
  kTableHmtx,
  kTableLoca,
  kTableGlyf,
  kTableKern,
  kTableGpos
};

template <typename AnyTable>
struct Directory {
  AnyTable tables[kTableCount];

  uint32_t units_per_em() const noexcept {
    return u16_at(tables[kTableHead], 18);
  }
  bool is_long() const noexcept { return u16_at(tables[kTableHead], 50) != 0; }
  uint32_t glyphs() const noexcept { return u16_at(tables[kTableMaxp], 4); }
  uint32_t advances() const noexcept { return u16_at(tables[kTableHhea], 34); }

  // As TrueTypeFont::open().
  __attribute__((always_inline)) Status read(const AnyTable& file,
                                             uint32_t face) noexcept {
    uint32_t begin = 0;
    if (u32_at(file, 0) == tag_of_table('t', 't', 'c', 'f')) {
      if (face >= u32_at(file, 8) || face >= file.size / 4) {
        return Status::no_glyph;
      }
      begin = u32_at(file, 12 + 4 * face);
    } else if (face != 0) {
      return Status::no_glyph;
    }
    const uint32_t kind = u32_at(file, begin);
    if (kind == tag_of_table('O', 'T', 'T', 'O')) {
      return Status::unsupported;
    }
    if (kind != 0x10000 && kind != tag_of_table('t', 'r', 'u', 'e')) {
      return Status::bad_magic;
    }
    find(file, begin);
    const uint32_t em = units_per_em();
    return em < 16 || em > 16384 || glyphs() == 0 || advances() == 0 ||
                   tables[kTableHmtx].size == 0 ||
                   tables[kTableGlyf].size == 0 ||
                   tables[kTableLoca].size < (glyphs() + 1)
                                                 << (is_long() ? 2 : 1)
               ? Status::corrupt
               : Status::ok;
  }

 private:
  // More tables than any font has.
  static constexpr uint32_t kMaxTables = 256;

  __attribute__((always_inline)) void find(const AnyTable& file,
                                           uint32_t begin) noexcept {
    const uint32_t said = u16_at(file, begin + 4);
    const uint32_t count = said < kMaxTables ? said : kMaxTables;
    for (uint32_t i = 0; i != count; ++i) {
      const uint32_t at = begin + 12 + 16 * i;
      const uint32_t tag = u32_at(file, at);
      for (uint32_t known = 0; known != kTableCount; ++known) {
        if (kTableTags[known] == tag) {
          tables[known] =
              part_of(file, u32_at(file, at + 8), u32_at(file, at + 12));
        }
      }
    }
  }
};

// The record of a glyph in `glyf`; empty for a space, and where something does
// not fit.
template <typename Face>
static typename Face::AnyTable record_in(const Face& face,
                                         uint32_t glyph) noexcept {
  using AnyTable = typename Face::AnyTable;
  if (glyph >= face.glyphs) {
    return {};
  }
  const auto offset_at = [&face](uint32_t number) noexcept {
    return face.is_long ? u32_at(face.loca, 4 * number)
                        : 2 * u16_at(face.loca, 2 * number);
  };
  const uint32_t from = offset_at(glyph);
  const uint32_t to = offset_at(glyph + 1);
  const AnyTable found =
      from < to ? part_of(face.glyf, from, to - from) : AnyTable();
  return found.size > kRecordBytes ? found : AnyTable();
}

// The distance from the origin to the box of a glyph, as `hmtx` has it.
template <typename Face>
static int32_t left_bearing_in(const Face& face, uint32_t glyph) noexcept {
  return i16_at(face.hmtx, glyph < face.advances
                               ? 4 * glyph + 2
                               : 2u * face.advances + 2 * glyph);
}

// As FontPages::measure.
template <typename Face>
static int32_t measure_in(const Face& face,
                          uint32_t glyph,
                          GlyphMetrics* out) noexcept {
  if (glyph >= face.glyphs) {
    return out == nullptr ? 0 : -1;
  }
  const uint32_t last = face.advances - 1u;
  const auto advance = static_cast<int32_t>(
      u16_at(face.hmtx, 4 * (glyph < last ? glyph : last)));
  if (out == nullptr) {
    return advance;
  }
  const auto record = record_in(face, glyph);
  const auto side = [&record](uint32_t i) noexcept {
    return i16_at(record, kRecordBox + 2 * i);
  };
  const int32_t moved =
      record.size == 0 ? 0 : left_bearing_in(face, glyph) - side(0);
  out->advance = advance;
  out->x_min = static_cast<int16_t>(side(0) + moved);
  out->y_min = static_cast<int16_t>(side(1));
  out->x_max = static_cast<int16_t>(side(2) + moved);
  out->y_max = static_cast<int16_t>(side(3));
  return advance;
}

// As FontPages::glyph_of; `run` is that of the code point.
template <typename Face>
static Status take_glyph(const Face& face,
                         const CodeRun& run,
                         uint32_t code,
                         uint16_t& glyph) noexcept {
  const uint32_t id = glyph_in(face, run, code);
  if (id == 0 || id >= face.glyphs) {
    return Status::no_glyph;
  }
  glyph = static_cast<uint16_t>(id);
  return Status::ok;
}
template <typename Face>
static Status find_glyph(const Face& face,
                         uint32_t code,
                         uint16_t& glyph) noexcept {
  CodeRun run;
  glyph = 0;
  return find_run_of(face, code, run) ? take_glyph(face, run, code, glyph)
                                      : Status::no_glyph;
}

// The top of a letter, for a font that does not tell its height.
template <typename Face>
static uint32_t top_of_letter(const Face& face, uint32_t letter) noexcept {
  uint16_t glyph = 0;
  GlyphMetrics metrics;
  return find_glyph(face, letter, glyph) == Status::ok &&
                 measure_in(face, glyph, &metrics) >= 0
             ? static_cast<uint16_t>(metrics.y_max)
             : 0;
}

template <typename Face>
static void put_metrics(const Directory<typename Face::AnyTable>& directory,
                        Face& face) noexcept {
  namespace header = format::header;
  constexpr uint32_t kUseTypo = 1 << 7;  // of fsSelection
  const auto put = [&face](uint32_t at, uint32_t value) noexcept {
    face.header[at] = static_cast<uint8_t>(value);
    face.header[at + 1] = static_cast<uint8_t>(value >> 8);
  };
  const auto& os2 = directory.tables[kTableOs2];
  const auto* lines = &directory.tables[kTableHhea];
  uint32_t at = 4;
  if ((u16_at(os2, 62) & kUseTypo) != 0 ||
      (u32_at(*lines, at) == 0 && os2.size != 0)) {
    lines = &os2;
    at = 68;
  }
  put(header::kAscender, u16_at(*lines, at));
  put(header::kDescender, u16_at(*lines, at + 2));
  put(header::kLineGap, u16_at(*lines, at + 4));
  const bool has_heights = u16_at(os2, 0) >= 2;
  const uint32_t x_height = has_heights ? u16_at(os2, 86) : 0;
  const uint32_t cap_height = has_heights ? u16_at(os2, 88) : 0;
  put(header::kXHeight, x_height != 0 ? x_height : top_of_letter(face, 'x'));
  put(header::kCapHeight,
      cap_height != 0 ? cap_height : top_of_letter(face, 'H'));
  face.header[header::kCoding] = static_cast<uint8_t>(format::Coding::outline);
  put(header::kMinPx, static_cast<uint32_t>(kMinSize.raw >> 6));
  put(header::kMaxPx, static_cast<uint32_t>(kMaxSize.raw >> 6));
  for (uint32_t i = 0; i != 4; ++i) {
    put(header::kXMin + 2 * i,
        u16_at(directory.tables[kTableHead], 36 + 2 * i));
  }
}

// Takes the tables of a file that was read.
template <typename Face>
static void take_tables(const Directory<typename Face::AnyTable>& directory,
                        Face& face) noexcept {
  face.glyf = directory.tables[kTableGlyf];
  face.loca = directory.tables[kTableLoca];
  face.hmtx = directory.tables[kTableHmtx];
  face.glyphs = static_cast<uint16_t>(directory.glyphs());
  face.advances = static_cast<uint16_t>(directory.advances());
  face.is_long = directory.is_long();
  choose_map(directory.tables[kTableCmap], face);
  choose_kerning(directory.tables[kTableKern], directory.tables[kTableGpos],
                 face);
  put_metrics(directory, face);
}

inline const Font* no_page_of(const FontPages&, uint32_t&) noexcept {
  return nullptr;
}

}  // namespace inkcell::detail
