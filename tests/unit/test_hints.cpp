// Grid-fitting hints at the limits of what they may hold, and just beyond them.
#include "check.hpp"
#include "font_builder.hpp"
#include "hints_record.hpp"
#include "inkcell/font.hpp"
#include "inkcell/hints.hpp"

namespace {

using namespace inkcell;
using namespace font_builder;

alignas(4) uint8_t rom[2048];
uint8_t bytes[640];

// A font of .notdef and one glyph, with these hints.
Status make_font(Span<const uint8_t> hints, Font& font) {
  static constexpr CmapEntry kCmap[] = {{'A', 0, 1}};
  static constexpr GlyphSpec kGlyphs[] = {
      {600, {0, 0, 0, 0}, nullptr, nullptr},
      {600, {195, 0, 430, 625}, bar, nullptr}};
  FontSpec spec;
  spec.cmap = {kCmap, 1};
  spec.glyphs = {kGlyphs, 2};
  spec.hints = hints;
  const size_t size = build_font(spec, rom);
  CHECK(size != 0);
  return Font::open({rom, size}, font);
}

// A section of so many levels and zones, and rows of these widths, all 0.
Span<const uint8_t> section_of(uint32_t levels,
                               uint32_t zones,
                               uint8_t start,
                               uint8_t count,
                               uint8_t stem,
                               uint8_t gap) {
  for (uint8_t& byte : bytes) {
    byte = 0;
  }
  bytes[0] = static_cast<uint8_t>(levels);
  bytes[1] = static_cast<uint8_t>(zones);
  bytes[2] = start;
  bytes[3] = count;
  bytes[4] = stem;
  bytes[5] = gap;
  const uint32_t row = uint32_t{start} + count + stem + gap + 1;
  return {bytes, 10 + 2 * levels + zones + (2 * row + 7) / 8};
}

Status open_hints(Span<const uint8_t> section) {
  Font font;
  CHECK_OK(make_font(section, font));
  Hints hints;
  return Hints::open(font, hints);
}

Status verify_of(HintsRecord& record) {
  Font font;
  CHECK_OK(make_font(record.write(2), font));
  return font.verify();
}

}  // namespace

TEST(counts_of_hints_are_limited) {
  CHECK_OK(open_hints(section_of(128, 15, 20, 4, 12, 12)));
  CHECK_EQ(open_hints(section_of(129, 15, 20, 4, 12, 12)), Status::corrupt);
  CHECK_EQ(open_hints(section_of(128, 16, 20, 4, 12, 12)), Status::corrupt);
  CHECK_EQ(open_hints(section_of(128, 255, 20, 4, 12, 12)), Status::corrupt);
  CHECK_EQ(open_hints(section_of(128, 15, 21, 4, 12, 12)), Status::corrupt);
  CHECK_EQ(open_hints(section_of(128, 15, 20, 5, 12, 12)), Status::corrupt);
  CHECK_EQ(open_hints(section_of(128, 15, 20, 4, 13, 12)), Status::corrupt);
  CHECK_EQ(open_hints(section_of(128, 15, 20, 4, 12, 13)), Status::corrupt);
}

TEST(lists_lie_in_the_section) {
  // Rows of 4 bits of start, 4 of count, and one: a list of three bytes.
  for (uint32_t start = 0; start < 16; ++start) {
    for (uint32_t count = 0; count < 16; ++count) {
      section_of(1, 0, 4, 4, 0, 0);
      bytes[12] = static_cast<uint8_t>(start | count << 4);
      Font font;
      CHECK_OK(make_font({bytes, 12 + 3 + 3}, font));
      Hints hints;
      CHECK_OK(Hints::open(font, hints));
      Span<const uint8_t> edges;
      CHECK_EQ(hints.edges(0, edges), start + count <= 3);
      CHECK_EQ(edges.size, start + count <= 3 ? count : 0);
      if (edges.size != 0) {
        const Span<const uint8_t> s = font.section(format::section::kHints);
        CHECK(edges.data == s.data + 15 + start);
      }
    }
  }
}

TEST(stems_of_absent_glyphs) {
  // Rows of 2 bits: stem, third. The bits behind the second row are 1.
  section_of(1, 0, 0, 0, 1, 0);
  bytes[12] = 0xff;
  Font font;
  CHECK_OK(make_font({bytes, 13}, font));
  Hints hints;
  CHECK_OK(Hints::open(font, hints));
  CHECK_EQ(hints.stems(1).count, 1);
  CHECK_EQ(hints.stems(2).count, 0);
}

TEST(zones_of_absent_levels) {
  HintsRecord r;
  r.level(100, 1);
  r.level(200, 1);
  r.zone(2, true);
  r.edge(0, false);
  Font font;
  CHECK_OK(make_font(r.write(2), font));
  Hints hints;
  CHECK_OK(Hints::open(font, hints));
  CHECK_EQ(hints.zone(0).height_u, 0);
  CHECK_EQ(font.verify(), Status::corrupt);
}

TEST(one_stem) {
  HintsRecord r;
  r.level(0, 0);
  r.edge(0, false);
  r.stem = 32;
  Font font;
  CHECK_OK(make_font(r.write(2), font));
  Hints hints;
  CHECK_OK(Hints::open(font, hints));
  CHECK_EQ(hints.stems(1).count, 1);
}

TEST(wrong_hints_are_found) {
  struct {
    uint32_t level_count;
    struct {
      int32_t height_u;
      uint32_t zone;
    } levels[2];
    bool has_zone;  // of level 0
    uint32_t edge_count;
    uint32_t edges[2];
    Status said;
  } const cases[] = {
      {2, {{0, 0}, {9, 0}}, false, 1, {1}, Status::ok},
      {2, {{9, 0}, {9, 0}}, false, 1, {0}, Status::ok},  // one of them is used
      {0, {}, false, 0, {}, Status::corrupt},            // no level
      {2, {{0, 0}, {9, 0}}, false, 1, {2}, Status::corrupt},  // no such level
      {2, {{0, 0}, {9, 0}}, true, 1, {2}, Status::corrupt},
      {2, {{9, 0}, {9, 0}}, false, 2, {0, 1}, Status::corrupt},  // not upwards
      {2, {{9, 0}, {8, 0}}, false, 1, {0}, Status::corrupt},
      {1, {{9, 1}}, false, 1, {0}, Status::corrupt},  // no such zone
      {1, {{9, 2}}, true, 1, {0}, Status::corrupt},
  };
  for (const auto& one : cases) {
    HintsRecord record;
    for (uint32_t i = 0; i < one.level_count; ++i) {
      record.level(one.levels[i].height_u, one.levels[i].zone);
    }
    if (one.has_zone) {
      record.zone(0, true);
    }
    for (uint32_t i = 0; i < one.edge_count; ++i) {
      record.edge(one.edges[i], false);
    }
    CHECK_EQ(verify_of(record), one.said);
  }
}

TEST(glyphs_have_ten_edges_at_most) {
  for (uint32_t count = 10; count <= 11; ++count) {
    HintsRecord record;
    for (uint32_t i = 0; i < count; ++i) {
      record.level(static_cast<int32_t>(10 * i), 0);
      record.edge(i, false);
    }
    CHECK_EQ(verify_of(record), count == 10 ? Status::ok : Status::corrupt);
  }
}
