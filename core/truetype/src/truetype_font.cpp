#include "inkcell/truetype/truetype_font.hpp"

#include "inkcell/style.hpp"
#include "pair_kerning.hpp"
#include "tables.hpp"

namespace inkcell {
namespace detail {
namespace {

namespace header = format::header;

constexpr uint32_t tag_of(char a, char b, char c, char d) noexcept {
  return __builtin_bswap32(format::tag(a, b, c, d));
}

// Tables that are looked for, in the order of `Tables`.
constexpr uint32_t kTableTags[] = {
    tag_of('h', 'e', 'a', 'd'), tag_of('m', 'a', 'x', 'p'),
    tag_of('h', 'h', 'e', 'a'), tag_of('c', 'm', 'a', 'p'),
    tag_of('O', 'S', '/', '2'), tag_of('h', 'm', 't', 'x'),
    tag_of('l', 'o', 'c', 'a'), tag_of('g', 'l', 'y', 'f'),
    tag_of('k', 'e', 'r', 'n'), tag_of('G', 'P', 'O', 'S')};
constexpr uint32_t kTableCount = sizeof kTableTags / sizeof kTableTags[0];
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

// More tables than any font has.
constexpr uint32_t kMaxTables = 256;

void find_tables(const Table& file,
                 uint32_t begin,
                 Table (&tables)[kTableCount]) noexcept {
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

// How well a subtable of cmap serves; 0: not at all.
uint32_t rank_of(uint32_t platform,
                 uint32_t encoding,
                 uint32_t format) noexcept {
  const bool is_unicode =
      platform == 0 || (platform == 3 && (encoding <= 1 || encoding == 10));
  if (format == 12) {
    return is_unicode ? 4 : 0;
  }
  if (format == 4) {
    return is_unicode ? 3 : 0;
  }
  // Of other encodings ASCII is the same.
  return format == 0 || format == 6 ? (is_unicode ? 2 : 1) : 0;
}

void choose_cmap(const Table& cmap, TrueTypeFace& face) noexcept {
  uint32_t best = 0;
  const uint32_t count = u16_at(cmap, 2);
  for (uint32_t at = 4; at < 4 + 8 * count && at < cmap.size; at += 8) {
    const Table found = part_of(cmap, u32_at(cmap, at + 4));
    const uint32_t format = u16_at(found, 0);
    const uint32_t rank =
        rank_of(u16_at(cmap, at), u16_at(cmap, at + 2), format);
    if (rank > best) {
      best = rank;
      face.cmap = found;
      face.cmap_format = static_cast<uint8_t>(format);
    }
  }
}

// Formats 0 and 6: an array of glyphs.
uint32_t glyph_in_array(const Table& cmap,
                        uint32_t format,
                        uint32_t code) noexcept {
  if (format == 0) {
    return code < 256 && code + 6 < cmap.size ? cmap.data[code + 6] : 0;
  }
  const uint32_t at = code - u16_at(cmap, 6);
  return at < u16_at(cmap, 8) ? u16_at(cmap, 10 + 2 * at) : 0;
}

// Format 4: segments of 16 bits, in four arrays.
uint32_t glyph_in_segment(const Table& cmap, uint32_t code) noexcept {
  const uint32_t bytes = u16_at(cmap, 6) & ~1u;  // of an array
  uint32_t low = 0;
  uint32_t high = bytes >> 1;
  while (low < high) {
    const uint32_t middle = (low + high) >> 1;
    if (code > u16_at(cmap, 14 + 2 * middle)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const uint32_t at = 16 + bytes + 2 * low;
  const uint32_t first = u16_at(cmap, at);
  if (2 * low >= bytes || code < first) {
    return 0;
  }
  const uint32_t offset = u16_at(cmap, at + 2 * bytes);
  if (offset != 0) {
    code = u16_at(cmap, at + 2 * bytes + offset + 2 * (code - first));
    if (code == 0) {
      return 0;
    }
  }
  return (code + u16_at(cmap, at + bytes)) & 0xffff;
}

// Format 12: groups of 32 bits.
uint32_t glyph_in_group(const Table& cmap, uint32_t code) noexcept {
  uint32_t low = 0;
  uint32_t high = u32_at(cmap, 12);
  const auto most = static_cast<uint32_t>(cmap.size / 12);
  high = high < most ? high : most;
  while (low < high) {
    const uint32_t middle = (low + high) >> 1;
    const uint32_t at = 16 + 12 * middle;
    const uint32_t first = u32_at(cmap, at);
    if (code > u32_at(cmap, at + 4)) {
      low = middle + 1;
    } else if (code < first) {
      high = middle;
    } else {
      return u32_at(cmap, at + 8) + (code - first);
    }
  }
  return 0;
}

const TrueTypeFace& face_of(const FontPages& pages) noexcept {
  return static_cast<const TrueTypeFace&>(pages);
}

Status glyph_of_code(const FontPages& pages,
                     uint32_t code,
                     uint16_t& glyph) noexcept {
  const TrueTypeFace& face = face_of(pages);
  const uint32_t format = face.cmap_format;
  uint32_t id = 0;
  if (format == 12) {
    id = glyph_in_group(face.cmap, code);
  } else if (code < 0x10000) {
    id = format == 4 ? glyph_in_segment(face.cmap, code)
                     : glyph_in_array(face.cmap, format, code);
  }
  if (id == 0 || id >= face.glyphs) {
    glyph = 0;
    return Status::no_glyph;
  }
  glyph = static_cast<uint16_t>(id);
  return Status::ok;
}

const Font* no_page(const FontPages&, uint32_t&) noexcept {
  return nullptr;
}

int32_t measure_glyph(const FontPages& pages,
                      uint16_t glyph,
                      GlyphMetrics* out) noexcept {
  const TrueTypeFace& face = face_of(pages);
  if (glyph >= face.glyphs) {
    return out == nullptr ? 0 : -1;
  }
  const uint32_t last = face.advances - 1u;
  const auto advance = static_cast<int32_t>(
      u16_at(face.hmtx, 4 * (glyph < last ? glyph : last)));
  if (out == nullptr) {
    return advance;
  }
  const Table record = record_of(face, glyph);
  const auto side = [&record](uint32_t i) noexcept {
    return i16_at(record, kRecordBox + 2 * i);
  };
  const int32_t moved =
      record.size == 0 ? 0 : left_bearing_of(face, glyph) - side(0);
  out->advance = advance;
  out->x_min = static_cast<int16_t>(side(0) + moved);
  out->y_min = static_cast<int16_t>(side(1));
  out->x_max = static_cast<int16_t>(side(2) + moved);
  out->y_max = static_cast<int16_t>(side(3));
  return advance;
}

int32_t kerning_of(const FontPages& pages,
                   uint16_t left,
                   uint16_t right) noexcept {
  return pair_kerning(face_of(pages), left, right);
}

// Not inline: the stack has neither twice while tables are read.
__attribute__((noinline)) void forget(TrueTypeFace& face, Font& font) noexcept {
  face = TrueTypeFace();
  font = Font();
}

void put_u16(TrueTypeFace& face, uint32_t at, uint32_t value) noexcept {
  face.header[at] = static_cast<uint8_t>(value);
  face.header[at + 1] = static_cast<uint8_t>(value >> 8);
}

// The top of a letter, for a font that does not tell its height.
uint32_t top_of_letter(const TrueTypeFace& face, uint32_t letter) noexcept {
  uint16_t glyph = 0;
  GlyphMetrics metrics;
  return glyph_of_code(face, letter, glyph) == Status::ok &&
                 measure_glyph(face, glyph, &metrics) >= 0
             ? static_cast<uint16_t>(metrics.y_max)
             : 0;
}

void put_metrics(const Table (&tables)[kTableCount],
                 TrueTypeFace& face) noexcept {
  constexpr uint32_t kUseTypo = 1 << 7;  // of fsSelection
  const Table& os2 = tables[kTableOs2];
  const Table* lines = &tables[kTableHhea];
  uint32_t at = 4;
  if ((u16_at(os2, 62) & kUseTypo) != 0 ||
      (u32_at(*lines, at) == 0 && os2.size != 0)) {
    lines = &os2;
    at = 68;
  }
  put_u16(face, header::kAscender, u16_at(*lines, at));
  put_u16(face, header::kDescender, u16_at(*lines, at + 2));
  put_u16(face, header::kLineGap, u16_at(*lines, at + 4));
  const bool has_heights = u16_at(os2, 0) >= 2;
  const uint32_t x_height = has_heights ? u16_at(os2, 86) : 0;
  const uint32_t cap_height = has_heights ? u16_at(os2, 88) : 0;
  put_u16(face, header::kXHeight,
          x_height != 0 ? x_height : top_of_letter(face, 'x'));
  put_u16(face, header::kCapHeight,
          cap_height != 0 ? cap_height : top_of_letter(face, 'H'));
  face.header[header::kCoding] = static_cast<uint8_t>(format::Coding::outline);
  put_u16(face, header::kMinPx, static_cast<uint32_t>(kMinSize.raw >> 6));
  put_u16(face, header::kMaxPx, static_cast<uint32_t>(kMaxSize.raw >> 6));
  for (uint32_t i = 0; i != 4; ++i) {
    put_u16(face, header::kXMin + 2 * i,
            u16_at(tables[kTableHead], 36 + 2 * i));
  }
}

}  // namespace

Table record_of(const TrueTypeFace& face, uint32_t glyph) noexcept {
  if (glyph >= face.glyphs) {
    return {};
  }
  uint32_t from;
  uint32_t to;
  if (face.is_long) {
    from = u32_at(face.loca, 4 * glyph);
    to = u32_at(face.loca, 4 * glyph + 4);
  } else {
    from = 2 * u16_at(face.loca, 2 * glyph);
    to = 2 * u16_at(face.loca, 2 * glyph + 2);
  }
  const Table found = from < to ? part_of(face.glyf, from, to - from) : Table();
  return found.size > kRecordBytes ? found : Table();
}

int32_t left_bearing_of(const TrueTypeFace& face, uint32_t glyph) noexcept {
  return i16_at(face.hmtx, glyph < face.advances
                               ? 4 * glyph + 2
                               : 2u * face.advances + 2 * glyph);
}

}  // namespace detail

const detail::TrueTypeFace& TrueTypeFont::face_of(const Font& font) noexcept {
  return static_cast<const detail::TrueTypeFace&>(*font.pages_);
}

Status TrueTypeFont::open(Span<const uint8_t> file,
                          const Coding& coding,
                          uint32_t face) noexcept {
  using namespace detail;
  uint32_t begin = 0;
  if (u32_at(file, 0) == tag_of('t', 't', 'c', 'f')) {
    if (face >= u32_at(file, 8) || face >= file.size / 4) {
      return Status::no_glyph;
    }
    begin = u32_at(file, 12 + 4 * face);
  } else if (face != 0) {
    return Status::no_glyph;
  }
  const uint32_t kind = u32_at(file, begin);
  if (kind == tag_of('O', 'T', 'T', 'O')) {
    return Status::unsupported;
  }
  if (kind != 0x10000 && kind != tag_of('t', 'r', 'u', 'e')) {
    return Status::bad_magic;
  }
  Table tables[kTableCount];
  find_tables(file, begin, tables);
  const uint32_t em = u16_at(tables[kTableHead], 18);
  const bool is_long = u16_at(tables[kTableHead], 50) != 0;
  const uint32_t glyphs = u16_at(tables[kTableMaxp], 4);
  const uint32_t advances = u16_at(tables[kTableHhea], 34);
  if (em < 16 || em > 16384 || glyphs == 0 || advances == 0 ||
      tables[kTableHmtx].size == 0 || tables[kTableGlyf].size == 0 ||
      tables[kTableLoca].size < (glyphs + 1) << (is_long ? 2 : 1)) {
    return Status::corrupt;
  }
  TrueTypeFace& made = face_;
  forget(made, font_);
  static_cast<FontPages&>(made) = {glyph_of_code, no_page, kerning_of,
                                   measure_glyph};
  made.file = file;
  made.glyf = tables[kTableGlyf];
  made.loca = tables[kTableLoca];
  made.hmtx = tables[kTableHmtx];
  made.glyphs = static_cast<uint16_t>(glyphs);
  made.advances = static_cast<uint16_t>(advances);
  made.is_long = is_long;
  choose_cmap(tables[kTableCmap], made);
  choose_kerning(tables[kTableKern], tables[kTableGpos], made);
  put_metrics(tables, made);
  font_.rom_ = {made.header, header::kBytes};
  font_.source_ = coding.source;
  font_.pages_ = &made;
  font_.units_per_em_ = static_cast<uint16_t>(em);
  font_.coding_.code_bits = 1;  // has_outlines(); no record is read by it
  return Status::ok;
}

}  // namespace inkcell
