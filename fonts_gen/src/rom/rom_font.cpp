#include "rom/rom_font.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/bit_table_writer.hpp"
#include "base/byte_writer.hpp"
#include "field/record.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/version.hpp"
#include "rom/character_runs.hpp"
#include "rom/font_sections.hpp"

namespace inkcell::gen {
namespace {

namespace header = format::header;
namespace section = format::section;

constexpr unsigned kAlignmentLog2 = 2;
static_assert(1 << kAlignmentLog2 == format::kAlignment);

using MetricsRow = std::array<int, format::metrics::kColumns>;

MetricsRow metrics_row(const GlyphMetrics& m) {
  return {m.advance, m.x_min, m.y_min, m.x_max, m.y_max};
}

// The pairs that kern, row by row, as KERN wants them.
struct KerningPairs {
  struct Pair {
    uint32_t right_class;
    int16_t value;
  };
  std::vector<uint32_t> row_starts;
  std::vector<Pair> pairs;
  int16_t least = 0;
  int16_t most = 0;
};

KerningPairs kerning_pairs(const KerningMatrix& kerning) {
  KerningPairs found;
  found.row_starts.push_back(0);
  auto value = kerning.values.begin();
  for (int row = 0; row < kerning.left_classes; ++row) {
    for (int column = 1; column <= kerning.right_classes; ++column, ++value) {
      if (*value == 0) {
        continue;
      }
      const bool first = found.pairs.empty();
      found.least = first ? *value : std::min(found.least, *value);
      found.most = first ? *value : std::max(found.most, *value);
      found.pairs.push_back({static_cast<uint32_t>(column), *value});
    }
    found.row_starts.push_back(static_cast<uint32_t>(found.pairs.size()));
  }
  return found;
}

// Glyphs that kern on at least one side.
std::vector<uint32_t> kerning_members(const KerningMatrix& kerning) {
  std::vector<uint32_t> members;
  for (size_t glyph = 0; glyph < kerning.left_class.size(); ++glyph) {
    if (kerning.left_class[glyph] != 0 || kerning.right_class[glyph] != 0) {
      members.push_back(static_cast<uint32_t>(glyph));
    }
  }
  return members;
}

}  // namespace

Bytes kerning_section(const RomContent& content) {
  const KerningMatrix& kerning = content.kerning;
  Bytes out;
  if (kerning.empty()) {
    return out;
  }
  const KerningPairs found = kerning_pairs(kerning);
  if (found.pairs.size() > format::kerning::kMaxPairs) {
    throw Error(content.name +
                ": more than 4 million pairs of classes kern; ask for fewer "
                "characters");
  }
  const auto pair_count = static_cast<uint32_t>(found.pairs.size());
  const std::vector<uint32_t> members = kerning_members(kerning);
  const unsigned glyph_bits = width_of(members.back());
  const unsigned left_bits =
      width_of(static_cast<uint32_t>(kerning.left_classes));
  const unsigned right_bits =
      width_of(static_cast<uint32_t>(kerning.right_classes));
  const unsigned value_bits =
      width_of(static_cast<uint32_t>(found.most - found.least));
  const unsigned start_bits = width_of(pair_count);
  put_u32(out, pair_count);
  put_u16(out, static_cast<unsigned>(members.size()));
  put_u16(out, static_cast<unsigned>(kerning.left_classes));
  put_u16(out, static_cast<unsigned>(kerning.right_classes));
  put_i16(out, found.least);
  for (const unsigned width :
       {glyph_bits, left_bits, right_bits, value_bits, start_bits}) {
    put_u8(out, width);
  }
  BitTableWriter table(out);
  for (const uint32_t glyph : members) {
    table.put(glyph, glyph_bits);
    table.put(kerning.left_class[glyph], left_bits);
    table.put(kerning.right_class[glyph], right_bits);
  }
  for (const uint32_t start : found.row_starts) {
    table.put(start, start_bits);
  }
  for (const KerningPairs::Pair& pair : found.pairs) {
    table.put(pair.right_class, right_bits);
    table.put(static_cast<uint32_t>(pair.value - found.least), value_bits);
  }
  return out;
}

namespace {

// How GLYF counts its offsets.
struct OffsetUnits {
  unsigned unit_log2;
  unsigned width;  // [bits]
  uint64_t begin;  // of the first record [bytes]
  uint64_t total;  // the section [bytes]

  uint64_t round_up(uint64_t bytes) const {
    return (((bytes - 1) >> unit_log2) + 1) << unit_log2;
  }
};

// Records of cells begin at even bytes, those of outlines at any.
constexpr unsigned kCellsUnitLog2 = 1;
static_assert(format::glyphs::kRecordAlignment == 1 << kCellsUnitLog2);

// The smallest unit that keeps every offset within its bits, and with it the
// narrowest table.
OffsetUnits offset_units(const RomContent& content,
                         const std::vector<Bytes>& glyph_records) {
  namespace glyphs = format::glyphs;
  const bool has_cells = content.options.coding != Coding::outline;
  for (unsigned unit_log2 = has_cells ? kCellsUnitLog2 : 0;
       unit_log2 <= glyphs::kMaxUnitLog2; ++unit_log2) {
    OffsetUnits units = {unit_log2, 0, 0, 0};
    uint64_t records = 0;
    for (const Bytes& record : glyph_records) {
      records += record.empty() ? 0 : units.round_up(record.size());
    }
    for (; units.width <= format::bit_table::kMaxBits; ++units.width) {
      const uint64_t offsets = glyph_records.size() + 1;
      units.begin =
          units.round_up(glyphs::kBytes + (offsets * units.width + 7) / 8);
      units.total = units.begin + records;
      // All sections of the font are below 4 GB; the rest of it is far
      // smaller than what this leaves.
      if (units.total >> unit_log2 < uint64_t{1} << units.width &&
          units.total <= 0xf0000000u) {
        return units;
      }
    }
  }
  throw Error(content.name +
              ": the font would pass 4 GB; ask for fewer characters");
}

Bytes morphs_section(const RomContent& content) {
  namespace morphs = format::morphs;
  Bytes out;
  if (content.morphs.empty()) {
    return out;
  }
  uint32_t greatest = 0;
  int points = 0;
  Bytes records;
  std::vector<uint32_t> begins;
  for (const RomMorph& morph : content.morphs) {
    greatest = std::max<uint32_t>(greatest, morph.second);
    points = std::max(points, morph.points);
    begins.push_back(static_cast<uint32_t>(records.size()));
    records.insert(records.end(), morph.record.begin(), morph.record.end());
  }
  const unsigned glyph_bits = width_of(greatest);
  const unsigned offset_bits = width_of(begins.back());
  if (begins.size() > UINT16_MAX || points > UINT16_MAX ||
      offset_bits > format::bit_table::kMaxBits) {
    throw Error(content.name +
                ": more than 65535 pairs of --morph; name fewer characters in "
                "a group");
  }
  put_u16(out, static_cast<unsigned>(begins.size()));
  put_u8(out, glyph_bits);
  put_u8(out, offset_bits);
  put_u16(out, static_cast<unsigned>(points));
  put_u16(out, static_cast<unsigned>(content.first_master));
  BitTableWriter table(out);
  for (size_t i = 0; i < begins.size(); ++i) {
    table.put(content.morphs[i].first, glyph_bits);
    table.put(content.morphs[i].second, glyph_bits);
    table.put(begins[i], offset_bits);
  }
  out.insert(out.end(), records.begin(), records.end());
  return out;
}

Bytes name_section(const RomContent& content) {
  Bytes out;
  for (const char c : content.name) {
    put_u8(out, static_cast<uint8_t>(c));
  }
  return out;
}

// Box of all ink; zero if there is none.
GlyphMetrics font_box(const RomContent& content) {
  GlyphMetrics box;
  bool first = true;
  for (const RomGlyph& glyph : content.glyphs) {
    const GlyphMetrics& m = glyph.metrics;
    if (m.x_min == m.x_max) {
      continue;
    }
    box.x_min = first ? m.x_min : std::min(box.x_min, m.x_min);
    box.y_min = first ? m.y_min : std::min(box.y_min, m.y_min);
    box.x_max = first ? m.x_max : std::max(box.x_max, m.x_max);
    box.y_max = first ? m.y_max : std::max(box.y_max, m.y_max);
    first = false;
  }
  return box;
}

void set_metrics(Bytes& out, const RomContent& content) {
  const SourceMetrics& m = content.metrics;
  const GlyphMetrics box = font_box(content);
  set_u16(out, header::kUnitsPerEm, static_cast<unsigned>(m.units_per_em));
  set_i16(out, header::kAscender, m.ascender);
  set_i16(out, header::kDescender, m.descender);
  set_i16(out, header::kLineGap, m.line_gap);
  set_i16(out, header::kXHeight, m.x_height);
  set_i16(out, header::kCapHeight, m.cap_height);
  set_i16(out, header::kXMin, box.x_min);
  set_i16(out, header::kYMin, box.y_min);
  set_i16(out, header::kXMax, box.x_max);
  set_i16(out, header::kYMax, box.y_max);
}

void set_range(Bytes& out, const RomContent& content) {
  const Target& options = content.options;
  const bool fixed = options.predicate == Predicate::fixed;
  set_u16(out, header::kMinPx, static_cast<unsigned>(options.min_px));
  set_u16(out, header::kMaxPx, static_cast<unsigned>(options.max_px));
  const bool is_strike = options.coding == Coding::strike;
  out[header::kTolerance] =
      fixed || is_strike ? uint8_t{0} : static_cast<uint8_t>(options.tolerance);
  out[header::kCoding] = static_cast<uint8_t>(options.coding);
  out[header::kPredicate] = static_cast<uint8_t>(
      fixed ? format::Predicate::fixed : format::Predicate::size_aware);
  set_u16(out, header::kBand,
          is_strike ? 0 : static_cast<unsigned>(std::floor(band_u(options))));
  // What a reader may want to know before it meets a glyph.
  unsigned cells = 0;
  unsigned nodes = 0;
  unsigned depth = 0;
  for (const RomGlyph& glyph : content.glyphs) {
    const auto& field = glyph.field;
    cells = std::max(cells, static_cast<unsigned>(field.cells.size()));
    nodes = std::max(nodes, static_cast<unsigned>(field.node_count()));
    depth = std::max(depth, static_cast<unsigned>(field.depth));
  }
  set_u16(out, header::kMaxCells, cells);
  set_u16(out, header::kMaxNodes, nodes);
  out[header::kMaxDepth] = static_cast<uint8_t>(depth);
  const OutlineCoding& outlines = content.outlines;
  out[header::kGridShift] = static_cast<uint8_t>(outlines.grid_shift);
  out[header::kCodeBits] = static_cast<uint8_t>(outlines.code_bits);
  set_u16(out, header::kMaxPoints, static_cast<unsigned>(outlines.max_points));
}

std::vector<FontSection> make_sections(const RomContent& content) {
  constexpr uint32_t kNeeded = section::kMustUnderstand;
  const HintCode hints = content.hint_code();
  std::vector<FontSection> sections;
  const auto add = [&](uint32_t tag, uint32_t must_understand, Bytes bytes,
                       size_t PartBytes::*part) {
    if (!bytes.empty()) {
      sections.push_back({tag, must_understand, std::move(bytes), part});
    }
  };
  const CharacterRuns runs(content.glyph_of);
  add(section::kCmap, kNeeded, runs.cmap_section(), &PartBytes::cmap);
  add(section::kCodePages, kNeeded, runs.code_pages_section(),
      &PartBytes::cmap);
  add(section::kMetrics, kNeeded, metrics_section(content),
      &PartBytes::metrics);
  add(section::kKerning, 0, kerning_section(content), &PartBytes::kerning);
  add(section::kGrid, 0, hints.section(), &PartBytes::hints);
  add(section::kCode, kNeeded, code_section(content), &PartBytes::glyphs);
  const bool is_strike = content.options.coding == Coding::strike;
  add(section::kGlyphs, kNeeded, glyphs_section(content, hints),
      is_strike ? &PartBytes::strikes : &PartBytes::glyphs);
  if (!is_strike && !content.strikes.empty()) {
    add(section::kStrikes, 0, strikes_section(content.strikes, false),
        &PartBytes::strikes);
  }
  add(section::kMorphs, 0, morphs_section(content), &PartBytes::morphs);
  add(section::kShaping, 0, content.shaping, &PartBytes::shaping);
  add(section::kKeptLayout, 0, content.kept_layout, &PartBytes::shaping);
  add(section::kLayers, 0, layers_section(content.layers), &PartBytes::layers);
  if (!is_strike) {
    add(section::kName, 0, name_section(content), &PartBytes::name);
  }
  return sections;
}

}  // namespace

// The reflected CRC-32 of Ethernet and PNG, bit by bit: the plain form of what
// the device computes by table.
uint32_t crc32(const uint8_t* data, size_t size, uint32_t crc) {
  crc = ~crc;
  for (size_t i = 0; i < size; ++i) {
    crc ^= data[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
    }
  }
  return ~crc;
}

Bytes metrics_section(const RomContent& content) {
  const std::vector<RomGlyph>& glyphs = content.glyphs;
  // Those from there on have the advance of the last glyph.
  size_t advances = glyphs.size();
  while (advances != 0 && glyphs[advances - 1].metrics.advance ==
                              glyphs.back().metrics.advance) {
    --advances;
  }
  MetricsRow least = metrics_row(glyphs[0].metrics);
  for (const RomGlyph& glyph : glyphs) {
    const MetricsRow row = metrics_row(glyph.metrics);
    for (size_t i = 0; i < row.size(); ++i) {
      least[i] = std::min(least[i], row[i]);
    }
  }
  // Rows of few glyphs alone are worth more bits of those before them.
  constexpr size_t kLeastAlone = 16;
  if (glyphs.size() - advances < kLeastAlone && advances != 0) {
    advances = glyphs.size();
  } else {
    least[0] = glyphs.back().metrics.advance;
  }
  std::array<unsigned, format::metrics::kColumns> widths = {};
  const auto number = [&](size_t glyph, size_t i) {
    return static_cast<uint32_t>(metrics_row(glyphs[glyph].metrics)[i] -
                                 least[i]) &
           0xffff;
  };
  for (size_t glyph = 0; glyph < glyphs.size(); ++glyph) {
    for (size_t i = 0; i < widths.size(); ++i) {
      widths[i] = std::max(widths[i], width_of(number(glyph, i)));
    }
  }
  Bytes out;
  for (const int base : least) {
    put_i16(out, base);
  }
  put_u16(out, static_cast<unsigned>(advances));
  for (const unsigned width : widths) {
    put_u8(out, width);
  }
  BitTableWriter table(out);
  for (size_t glyph = 0; glyph < glyphs.size(); ++glyph) {
    for (size_t i = glyph < advances ? 0 : 1; i < widths.size(); ++i) {
      table.put(number(glyph, i), widths[i]);
    }
  }
  return out;
}

Bytes glyphs_section(const RomContent& content, const HintCode& code) {
  if (content.options.coding == Coding::strike) {
    return strikes_section(content.strikes, true);
  }
  std::vector<Bytes> records;
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    records.push_back(hinted_record(content, i, code));
  }
  const OffsetUnits units = offset_units(content, records);
  Bytes out;
  out.reserve(units.total);
  put_u8(out, units.width);
  put_u8(out, units.unit_log2);
  BitTableWriter offsets(out);
  uint64_t end = units.begin;
  const auto put_end = [&] {
    offsets.put(static_cast<uint32_t>(end >> units.unit_log2), units.width);
  };
  put_end();
  for (const Bytes& record : records) {
    end += record.empty() ? 0 : units.round_up(record.size());
    put_end();
  }
  for (const Bytes& record : records) {
    pad(out, units.unit_log2);
    out.insert(out.end(), record.begin(), record.end());
  }
  pad(out, units.unit_log2);
  // Readers take four bytes at once, also where no glyph has ink.
  out.resize(std::max<size_t>(out.size(), 4));
  return out;
}

Bytes code_section(const RomContent& content) {
  Bytes out;
  for (const uint16_t word : content.outlines.table) {
    put_u16(out, word);
  }
  return out;
}

std::vector<uint8_t> glyph_record(const RomGlyph& glyph) {
  if (!glyph.outline_record.empty()) {
    return glyph.outline_record;
  }
  return glyph.field.tiles_x == 0 ? Bytes() : field_record(glyph.field);
}

std::vector<uint8_t> hinted_record(const RomContent& content,
                                   size_t i,
                                   const HintCode& code) {
  const RomGlyph& glyph = content.glyphs[i];
  Bytes record = glyph_record(glyph);
  if (record.empty() || content.hints.empty()) {
    return record;
  }
  const HintBits bits = code.bits(content.hints.glyphs[i]);
  record.resize((glyph.record_bits + bits.size() + 7) / 8);
  for (size_t bit = 0; bit < bits.size(); ++bit) {
    uint8_t& byte = record[record.size() - 1 - bit / 8];
    byte = static_cast<uint8_t>(byte | (bits[bit] ? 1u : 0u) << bit % 8);
  }
  return record;
}

std::vector<uint8_t> assemble_font(const RomContent& content,
                                   size_t glyph_count,
                                   const std::vector<FontSection>& sections,
                                   PartBytes& parts) {
  const size_t header_bytes =
      header::kBytes + section::kBytes * sections.size();
  Bytes out(header_bytes);
  set_u32(out, header::kMagic, format::kMagic);
  out[header::kFormatMinor] = kFormatMinor;
  out[header::kFormatMajor] = kFormatMajor;
  set_u16(out, header::kHeaderBytes, static_cast<unsigned>(header_bytes));
  set_u16(out, header::kGlyphCount, static_cast<unsigned>(glyph_count));
  set_u16(out, header::kSectionCount, static_cast<unsigned>(sections.size()));
  set_metrics(out, content);
  set_range(out, content);

  parts = PartBytes{};
  parts.header = header_bytes;
  size_t entry = header::kBytes;
  for (const FontSection& part : sections) {
    const size_t begin = out.size();
    set_u32(out, entry + section::kTag, part.tag);
    set_u32(out, entry + section::kOffset,
            static_cast<uint32_t>(begin) | part.must_understand);
    set_u32(out, entry + section::kSize,
            static_cast<uint32_t>(part.bytes.size()));
    entry += section::kBytes;
    out.insert(out.end(), part.bytes.begin(), part.bytes.end());
    pad(out, kAlignmentLog2);
    parts.*part.part += out.size() - begin;
  }
  // The last thing that is written: the header's checksum covers the others.
  set_u32(out, header::kTotalBytes, static_cast<uint32_t>(out.size()));
  set_u32(out, header::kContentCrc,
          crc32(out.data() + header_bytes, out.size() - header_bytes));
  const uint32_t before = crc32(out.data(), header::kHeaderCrc);
  set_u32(out, header::kHeaderCrc,
          crc32(out.data() + header::kContentCrc,
                header_bytes - header::kContentCrc, before));
  return out;
}

std::vector<uint8_t> write_rom_font(const RomContent& content,
                                    PartBytes& parts) {
  Bytes font = assemble_font(content, content.glyphs.size(),
                             make_sections(content), parts);
  const HintCode code = content.hint_code();
  size_t bits = 0;
  for (size_t i = 0; i < content.hints.glyphs.size(); ++i) {
    const bool has_record = !content.glyphs[i].outline_record.empty();
    bits += has_record ? code.bits(content.hints.glyphs[i]).size() : 0;
  }
  parts.hints += bits / 8;
  parts.glyphs -= bits / 8;
  return font;
}

}  // namespace inkcell::gen
