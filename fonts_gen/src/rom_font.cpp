#include "rom_font.hpp"

#include <algorithm>
#include <cmath>

#include "inkcell/format.hpp"
#include "inkcell/version.hpp"

namespace inkcell::gen {
namespace {

namespace header = format::header;
namespace section = format::section;

using Bytes = std::vector<uint8_t>;

// The reflected CRC-32 of Ethernet and PNG, bit by bit: the plain form of what
// the device computes by table.
uint32_t crc32(const uint8_t* data, size_t size, uint32_t crc = 0) {
  crc = ~crc;
  for (size_t i = 0; i < size; ++i) {
    crc ^= data[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
    }
  }
  return ~crc;
}

void put_u8(Bytes& out, unsigned value) {
  out.push_back(static_cast<uint8_t>(value));
}

void put_u16(Bytes& out, unsigned value) {
  put_u8(out, value & 0xff);
  put_u8(out, value >> 8 & 0xff);
}

void put_i16(Bytes& out, int value) {
  put_u16(out, static_cast<uint16_t>(value));
}

void put_u32(Bytes& out, uint32_t value) {
  put_u16(out, value & 0xffff);
  put_u16(out, value >> 16);
}

void set_u16(Bytes& out, size_t at, unsigned value) {
  out[at] = static_cast<uint8_t>(value);
  out[at + 1] = static_cast<uint8_t>(value >> 8);
}

void set_i16(Bytes& out, size_t at, int value) {
  set_u16(out, at, static_cast<uint16_t>(value));
}

void set_u32(Bytes& out, size_t at, uint32_t value) {
  set_u16(out, at, value & 0xffff);
  set_u16(out, at + 2, value >> 16);
}

void pad(Bytes& out) {
  while (out.size() % format::kAlignment != 0) {
    out.push_back(0);
  }
}

// Consecutive code points on consecutive glyphs become one entry.
Bytes cmap_section(const RomContent& content) {
  struct Entry {
    char32_t first;
    uint32_t extra;
    uint32_t glyph;
  };
  std::vector<Entry> entries;
  for (const auto& [code_point, glyph] : content.glyph_of) {
    if (!entries.empty()) {
      Entry& last = entries.back();
      const uint32_t step = last.extra + 1;
      if (code_point == last.first + step && glyph == last.glyph + step &&
          step <= 0xffff) {
        last.extra = step;
        continue;
      }
    }
    entries.push_back({code_point, 0, glyph});
  }
  Bytes out;
  for (const Entry& entry : entries) {
    put_u32(out, entry.first);
    put_u16(out, entry.extra);
    put_u16(out, entry.glyph);
  }
  return out;
}

Bytes metrics_section(const RomContent& content) {
  Bytes out;
  for (const RomGlyph& glyph : content.glyphs) {
    put_u16(out, static_cast<unsigned>(glyph.metrics.advance));
    put_i16(out, glyph.metrics.x_min);
    put_i16(out, glyph.metrics.y_min);
    put_i16(out, glyph.metrics.x_max);
    put_i16(out, glyph.metrics.y_max);
  }
  return out;
}

Bytes kerning_section(const KerningMatrix& kerning) {
  Bytes out;
  if (kerning.empty()) {
    return out;
  }
  const int most = std::max(kerning.left_classes, kerning.right_classes);
  put_u16(out, static_cast<unsigned>(kerning.left_classes));
  put_u16(out, static_cast<unsigned>(kerning.right_classes));
  for (const auto* classes : {&kerning.left_class, &kerning.right_class}) {
    for (const uint16_t number : *classes) {
      if (most <= 255) {
        put_u8(out, number);
      } else {
        put_u16(out, number);
      }
    }
  }
  for (const int16_t value : kerning.values) {
    put_i16(out, value);
  }
  return out;
}

void put_record(Bytes& out, const AdfGlyph& field) {
  put_u8(out, format::glyph::kTypeSamples);
  put_u8(out, static_cast<unsigned>(field.tile_log2));
  put_i16(out, field.x0_u);
  put_i16(out, field.y0_u);
  put_u8(out, static_cast<unsigned>(field.tiles_x));
  put_u8(out, static_cast<unsigned>(field.tiles_y));
  put_u16(out, static_cast<unsigned>(field.node_count()));
  put_u16(out, static_cast<unsigned>(field.cells.size()));
  for (const uint16_t reference : field.references) {
    put_u16(out, reference);
  }
  for (const SampleCell& cell : field.cells) {
    out.insert(out.end(), cell.begin(), cell.end());
  }
  pad(out);
}

Bytes glyphs_section(const RomContent& content) {
  const uint64_t offsets = 4 * (uint64_t{content.glyphs.size()} + 1);
  uint64_t size = offsets;
  for (const RomGlyph& glyph : content.glyphs) {
    size += record_bytes(glyph.field);
  }
  // All offsets of the font are 32 bits wide; the rest of it is far smaller
  // than what this leaves.
  if (size > 0xf0000000u) {
    throw Error(content.name +
                ": the font would pass 4 GB; ask for fewer characters");
  }
  Bytes out;
  out.reserve(size);
  uint32_t end = static_cast<uint32_t>(offsets);
  put_u32(out, end);
  for (const RomGlyph& glyph : content.glyphs) {
    end += static_cast<uint32_t>(record_bytes(glyph.field));
    put_u32(out, end);
  }
  for (const RomGlyph& glyph : content.glyphs) {
    if (glyph.field.tiles_x != 0) {
      put_record(out, glyph.field);
    }
  }
  return out;
}

// Box of all ink; zero if there is none.
GlyphMetrics font_box(const RomContent& content) {
  GlyphMetrics box;
  bool first = true;
  for (const RomGlyph& glyph : content.glyphs) {
    if (glyph.field.tiles_x == 0) {
      continue;
    }
    const GlyphMetrics& m = glyph.metrics;
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
  const AdfOptions& options = content.options;
  const bool fixed = options.predicate == Predicate::fixed;
  set_u16(out, header::kMinPx, static_cast<unsigned>(options.min_px));
  set_u16(out, header::kMaxPx, static_cast<unsigned>(options.max_px));
  out[header::kTolerance] =
      fixed ? uint8_t{0} : static_cast<uint8_t>(options.tolerance);
  out[header::kCellKind] = static_cast<uint8_t>(format::CellKind::samples);
  out[header::kCoding] = static_cast<uint8_t>(format::Coding::direct);
  out[header::kPredicate] = static_cast<uint8_t>(
      fixed ? format::Predicate::fixed : format::Predicate::size_aware);
  set_u16(out, header::kBand,
          static_cast<unsigned>(std::floor(band_u(options))));
  size_t cells = 0;
  int nodes = 0;
  int depth = 0;
  for (const RomGlyph& glyph : content.glyphs) {
    cells = std::max(cells, glyph.field.cells.size());
    nodes = std::max(nodes, glyph.field.node_count());
    depth = std::max(depth, glyph.field.depth);
  }
  set_u16(out, header::kMaxCells, static_cast<unsigned>(cells));
  set_u16(out, header::kMaxNodes, static_cast<unsigned>(nodes));
  out[header::kMaxDepth] = static_cast<uint8_t>(depth);
}

// The last thing that is written: the header's checksum covers the others.
void set_checksums(Bytes& out, size_t header_bytes) {
  set_u32(out, header::kTotalBytes, static_cast<uint32_t>(out.size()));
  set_u32(out, header::kContentCrc,
          crc32(out.data() + header_bytes, out.size() - header_bytes));
  const uint32_t before = crc32(out.data(), header::kHeaderCrc);
  set_u32(out, header::kHeaderCrc,
          crc32(out.data() + header::kContentCrc,
                header_bytes - header::kContentCrc, before));
}

struct Section {
  uint32_t tag;
  uint32_t flags;
  Bytes bytes;
  size_t PartBytes::*part;
};

std::vector<Section> make_sections(const RomContent& content) {
  constexpr uint32_t kNeeded = section::kMustUnderstand;
  std::vector<Section> sections;
  const auto add = [&](uint32_t tag, uint32_t flags, Bytes bytes,
                       size_t PartBytes::*part) {
    if (!bytes.empty()) {
      sections.push_back({tag, flags, std::move(bytes), part});
    }
  };
  add(section::kCmap, kNeeded, cmap_section(content), &PartBytes::cmap);
  add(section::kMetrics, kNeeded, metrics_section(content),
      &PartBytes::metrics);
  add(section::kKerning, 0, kerning_section(content.kerning),
      &PartBytes::kerning);
  add(section::kGlyphs, kNeeded, glyphs_section(content), &PartBytes::cells);
  add(section::kName, 0, Bytes(content.name.begin(), content.name.end()),
      &PartBytes::name);
  return sections;
}

}  // namespace

size_t record_bytes(const AdfGlyph& field) {
  if (field.tiles_x == 0) {
    return 0;
  }
  const size_t bytes = format::glyph::kBytes + 2 * field.references.size() +
                       format::samples::kBytes * field.cells.size();
  return (bytes + format::kAlignment - 1) / format::kAlignment *
         format::kAlignment;
}

std::vector<uint8_t> write_rom_font(const RomContent& content,
                                    PartBytes& parts) {
  const std::vector<Section> sections = make_sections(content);
  const size_t header_bytes =
      header::kBytes + section::kBytes * sections.size();
  Bytes out(header_bytes);
  set_u32(out, header::kMagic, format::kMagic);
  out[header::kFormatMinor] = kFormatMinor;
  out[header::kFormatMajor] = kFormatMajor;
  set_u16(out, header::kHeaderBytes, static_cast<unsigned>(header_bytes));
  set_u16(out, header::kGlyphCount,
          static_cast<unsigned>(content.glyphs.size()));
  set_u16(out, header::kSectionCount, static_cast<unsigned>(sections.size()));
  set_metrics(out, content);
  set_range(out, content);

  parts = PartBytes{};
  parts.header = header_bytes;
  size_t entry = header::kBytes;
  for (const Section& part : sections) {
    const size_t begin = out.size();
    set_u32(out, entry + section::kTag, part.tag);
    set_u32(out, entry + section::kFlags, part.flags);
    set_u32(out, entry + section::kOffset, static_cast<uint32_t>(begin));
    set_u32(out, entry + section::kSize,
            static_cast<uint32_t>(part.bytes.size()));
    entry += section::kBytes;
    out.insert(out.end(), part.bytes.begin(), part.bytes.end());
    pad(out);
    parts.*part.part += out.size() - begin;
  }
  set_checksums(out, header_bytes);
  return out;
}

}  // namespace inkcell::gen
