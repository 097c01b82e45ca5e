// Counts cells by walking over a field as the renderer does.
#include "census.hpp"

#include <algorithm>
#include <cstdio>

#include "bytes.hpp"
#include "cells.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/layers/verify.hpp"
#include "inkcell/shaping/verify.hpp"
#include "inkcell/strike/verify.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

std::vector<RecordPart> parts_of(const GlyphField& field) {
  const size_t references = static_cast<size_t>(field.tiles_x) * field.tiles_y +
                            4 * static_cast<size_t>(field.node_count);
  return {{"grid", format::glyph::kBytes},
          {"references", 2 * references},
          {"cells", format::samples::kBytes * field.cell_count}};
}

GlyphCensus take_glyph(const Font& font, uint16_t id) {
  GlyphCensus census;
  census.glyph = id;
  // What a broken font lacks stays empty.
  static_cast<void>(read_field(font, id, census.field));
  static_cast<void>(font.glyph_metrics(id, census.metrics));
  const Span<const uint8_t> record = font.record(id);
  census.bytes = record.size;
  if (font.has_outlines()) {
    census.outline = glyph_outline(font, id);
    return census;
  }
  const GlyphField& field = census.field;
  int leaves = 0;
  for_each_cell(field, [&](const Cell& cell) {
    ++leaves;
    census.depth = std::max(census.depth, field.tile_log2 - cell.size_log2);
    if (cell.is_saturated()) {
      ++(cell.inside ? census.inside : census.outside);
      return;
    }
    ++census.cells;
    ++census.by_size_log2[cell.size_log2];
  });
  // Every node puts four squares in the place of one.
  census.nodes = (leaves - field.tiles_x * field.tiles_y) / 3;
  if (record.size > 0) {
    census.parts = parts_of(field);
  }
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

void take_strikes(const Font& font, FontCensus& census) {
  namespace at = format::strike;
  const Span<const uint8_t> strikes =
      coding_name(font) == "strike" ? font.glyph_table()
                                    : font.section(format::section::kStrikes);
  size_t end = format::strikes::kBytes + at::kBytes;
  for (; end <= strikes.size && verify_strikes(font) == Status::ok &&
         census.strikes.size() < read_u16(strikes.data + 2);
       end += at::kBytes) {
    const uint8_t* const entry = strikes.data + end - at::kBytes;
    census.strikes.push_back(std::to_string(read_u16(entry + at::kPx)) +
                             " px, " + std::to_string(entry[at::kBits]) +
                             " bits, " +
                             std::to_string(read_u16(entry + at::kGlyphs)) +
                             " glyphs, fit " + std::to_string(entry[at::kFit]));
  }
}

void take_layers(const Font& font, FontCensus& census) {
  namespace at = format::layers;
  const Span<const uint8_t> layers = font.section(format::section::kLayers);
  if (layers.size == 0 || verify_layers(font) != Status::ok) {
    return;
  }
  census.layer_lists = static_cast<int>(read_u16(layers.data + at::kGlyphs));
  const uint32_t colours = read_u16(layers.data + at::kColours);
  const uint8_t* colour = layers.data + at::kBytes;
  for (int i = 0; i < layers.data[at::kPalettes]; ++i) {
    std::string palette;
    for (uint32_t n = 0; n < colours; ++n, colour += at::kColourBytes) {
      char text[12];
      const int digits = colour[3] == 255 ? 7 : 9;
      std::snprintf(text, sizeof text, "#%02x%02x%02x%02x", colour[0],
                    colour[1], colour[2], colour[3]);
      palette += (n == 0 ? "" : " ") +
                 std::string(text).substr(0, static_cast<size_t>(digits));
    }
    census.palettes.push_back(palette);
  }
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

void take_morphs(const Font& font, FontCensus& census) {
  const Span<const uint8_t> morphs = font.section(format::section::kMorphs);
  if (morphs.size >= format::morphs::kBytes) {
    census.morph_pairs =
        static_cast<int>(read_u16(morphs.data + format::morphs::kPairs));
    const auto first =
        static_cast<int>(read_u16(morphs.data + format::morphs::kMasters));
    const auto glyphs = static_cast<int>(font.glyph_count());
    census.masters = first == 0 || first > glyphs ? 0 : glyphs - first;
  }
}

}  // namespace

void add_parts(const std::vector<RecordPart>& parts,
               std::vector<RecordPart>& sum) {
  for (const RecordPart& part : parts) {
    const auto same = std::find_if(
        sum.begin(), sum.end(),
        [&](const RecordPart& other) { return other.name == part.name; });
    if (same == sum.end()) {
      sum.push_back(part);
    } else {
      same->bytes += part.bytes;
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
    sum += glyph.nodes;
  }
  return sum;
}

std::vector<RecordPart> FontCensus::parts() const {
  std::vector<RecordPart> sum;
  for (const GlyphCensus& glyph : glyphs) {
    add_parts(glyph.parts, sum);
  }
  return sum;
}

int64_t FontCensus::points() const {
  int64_t sum = 0;
  for (const GlyphCensus& glyph : glyphs) {
    sum += glyph.outline.components.empty() ? glyph.outline.points() : 0;
  }
  return sum;
}

int64_t FontCensus::points_of(PointKind kind) const {
  int64_t sum = 0;
  for (const GlyphCensus& glyph : glyphs) {
    sum += glyph.outline.components.empty() ? glyph.outline.points_of(kind) : 0;
  }
  return sum;
}

int FontCensus::composites() const {
  return static_cast<int>(
      std::count_if(glyphs.begin(), glyphs.end(), [](const GlyphCensus& glyph) {
        return !glyph.outline.components.empty();
      }));
}

int64_t FontCensus::uses(size_t word) const {
  int64_t sum = 0;
  for (const GlyphCensus& glyph : glyphs) {
    sum += word < glyph.outline.uses.size() ? glyph.outline.uses[word] : 0;
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
  census.coding_name = coding_name(font);
  census.verified = verify_fields(font);
  if (census.verified == Status::ok) {
    census.verified = verify_strikes(font);
  }
  if (census.verified == Status::ok) {
    census.verified = verify_shaping(font);
  }
  if (census.verified == Status::ok) {
    census.verified = verify_layers(font);
  }
  census.metrics = font.metrics();
  census.range = font.range();
  census.fixed_predicate = rom[format::header::kPredicate] ==
                           static_cast<uint8_t>(format::Predicate::fixed);
  census.header_bytes = read_u16(rom + format::header::kHeaderBytes);
  census.sections = take_sections(rom);
  census.words = code_words(font);
  census.grid_units = grid_units(font);
  census.max_points = max_points(font);
  take_kerning(font, census);
  take_strikes(font, census);
  take_layers(font, census);
  take_morphs(font, census);
  for (uint32_t glyph = 0; glyph < font.glyph_count(); ++glyph) {
    census.glyphs.push_back(take_glyph(font, static_cast<uint16_t>(glyph)));
  }
  census.hints = grid_hints(font);
  for (const Mapping& mapping : mappings(font)) {
    ++census.characters;
    if (mapping.glyph < census.glyphs.size()) {
      census.glyphs[mapping.glyph].code_points.push_back(mapping.code_point);
    }
  }
  return census;
}

}  // namespace inkcell::tools
