// Counts cells by walking over a field as the renderer does.
#include "census.hpp"

#include <algorithm>

#include "bytes.hpp"
#include "inkcell/format.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

GlyphCensus take_glyph(const Font& font, uint16_t glyph) {
  GlyphCensus census;
  census.glyph = glyph;
  // What a broken font lacks stays empty.
  static_cast<void>(font.glyph_metrics(glyph, census.metrics));
  static_cast<void>(font.field(glyph, census.field));
  census.bytes = font.record(glyph).size;
  for_each_cell(census.field, [&census](const Cell& cell) {
    census.depth =
        std::max(census.depth, census.field.tile_log2 - cell.size_log2);
    if (cell.samples != nullptr) {
      ++census.cells;
      ++census.by_size_log2[cell.size_log2];
    } else {
      ++(cell.inside ? census.inside : census.outside);
    }
  });
  return census;
}

std::vector<SectionCensus> take_sections(const uint8_t* rom) {
  namespace section = format::section;
  std::vector<SectionCensus> result;
  const uint32_t count = read_u16(rom + format::header::kSectionCount);
  for (uint32_t i = 0; i < count; ++i) {
    const uint8_t* entry = rom + format::header::kBytes + i * section::kBytes;
    SectionCensus census;
    census.tag.assign(reinterpret_cast<const char*>(entry + section::kTag), 4);
    const uint32_t offset = read_u32(entry + section::kOffset);
    census.offset = offset & section::kOffsetMask;
    census.size = read_u32(entry + section::kSize);
    census.must_understand = (offset & section::kMustUnderstand) != 0;
    result.push_back(census);
  }
  return result;
}

void take_kerning(const Font& font, FontCensus& census) {
  const Span<const uint8_t> kerning = font.section(format::section::kKerning);
  if (kerning.size >= format::kerning::kBytes) {
    census.left_classes = static_cast<int>(
        read_u16(kerning.data + format::kerning::kLeftClasses));
    census.right_classes = static_cast<int>(
        read_u16(kerning.data + format::kerning::kRightClasses));
  }
}

}  // namespace

void for_each_cell(const GlyphField& field,
                   const std::function<void(const Cell&)>& visit) {
  for (int32_t y = field.y0_u; y < field.y1_u(); ++y) {
    for (int32_t x = field.x0_u; x < field.x1_u();) {
      const Cell cell = locate(field, x, y);
      if (cell.y0_u == y) {
        visit(cell);
      }
      x = cell.x0_u + (1 << cell.size_log2);
    }
  }
}

std::string GlyphCensus::name() const {
  if (!code_points.empty()) {
    return to_utf8(code_points.front());
  }
  return glyph == 0 ? ".notdef" : "#" + std::to_string(glyph);
}

int64_t FontCensus::cells() const {
  int64_t sum = 0;
  for (const GlyphCensus& glyph : glyphs) {
    sum += glyph.cells;
  }
  return sum;
}

int64_t FontCensus::nodes() const {
  int64_t sum = 0;
  for (const GlyphCensus& glyph : glyphs) {
    sum += glyph.field.node_count;
  }
  return sum;
}

FontCensus take_census(const Font& font) {
  const uint8_t* rom = font.rom().data;
  FontCensus census;
  census.name.assign(font.name().data, font.name().size);
  census.bytes = font.rom().size;
  census.format_major = rom[format::header::kFormatMajor];
  census.format_minor = rom[format::header::kFormatMinor];
  census.verified = font.verify();
  census.metrics = font.metrics();
  census.range = font.range();
  census.fixed_predicate = rom[format::header::kPredicate] ==
                           static_cast<uint8_t>(format::Predicate::fixed);
  census.header_bytes = read_u16(rom + format::header::kHeaderBytes);
  census.sections = take_sections(rom);
  take_kerning(font, census);
  for (uint32_t glyph = 0; glyph < font.glyph_count(); ++glyph) {
    census.glyphs.push_back(take_glyph(font, static_cast<uint16_t>(glyph)));
  }
  for (const Mapping& mapping : mappings(font)) {
    ++census.characters;
    if (mapping.glyph < census.glyphs.size()) {
      census.glyphs[mapping.glyph].code_points.push_back(mapping.code_point);
    }
  }
  return census;
}

}  // namespace inkcell::tools
