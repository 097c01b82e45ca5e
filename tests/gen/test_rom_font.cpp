// The container byte by byte, and the closed loop that checks it.
#include <gtest/gtest.h>

#include "judge/rom_check.hpp"
#include "rom/rom_font.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>

#include "field/record.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/format/rom.hpp"
#include "opened_font.hpp"
#include "paths.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen::test {
namespace {

// The font in docs/FORMAT.md: .notdef without ink and a '.' of a single cell,
// 16 u wide, whose middle is 4 u inside.
RomContent smallest() {
  RomContent content;
  content.name = "Dot";
  content.metrics = {1000, 800, -200, 90, 480, 700};
  content.options.min_px = 12;
  content.options.max_px = 24;
  content.glyphs.resize(2);
  content.glyphs[0].metrics.advance = 500;
  RomGlyph& dot = content.glyphs[1];
  dot.metrics = {300, 100, 0, 108, 8};
  dot.field.tile_log2 = 4;
  dot.field.x0_u = 98;
  dot.field.y0_u = -4;
  dot.field.tiles_x = 1;
  dot.field.tiles_y = 1;
  dot.field.references = {format::glyph::kCellFlag};
  dot.field.cells = {
      SampleCell{0x00, 0x01, 0x9c, 0xc0, 0x9c, 0xc0, 0xc0, 0x9c, 0xc0, 0x9c}};
  content.glyph_of[U'.'] = 1;
  return content;
}

// Two glyphs with ink, three levels, kerning.
RomContent larger() {
  RomContent content = smallest();
  content.glyphs.resize(4);
  content.glyphs[2].metrics = {400, 0, 0, 0, 0};
  RomGlyph& tree = content.glyphs[3];
  tree.metrics = {1200, -20, -200, 1100, 800};
  tree.field.tile_log2 = 8;
  tree.field.x0_u = -100;
  tree.field.y0_u = -300;
  tree.field.tiles_x = 2;
  tree.field.tiles_y = 1;
  tree.field.depth = 2;
  const uint16_t cell = format::glyph::kCellFlag;
  const auto cell_number = [&](int n) {
    return static_cast<uint16_t>(cell + n);
  };
  tree.field.references = {2,
                           0,  // tiles
                           3,
                           1,
                           0,
                           cell_number(2),  // node 0
                           cell_number(0),
                           cell_number(1),
                           0,
                           1};  // node 1
  tree.field.cells.resize(3);
  tree.field.cells[2][1] = 0x7f;
  content.glyph_of[U'A'] = 2;
  content.glyph_of[U'B'] = 3;
  content.glyph_of[0x10ffff] = 3;
  content.kerning = join_classes(4, {1, 3}, {{0, 0, 0, -40}, {0, 12, 0, -300}});
  return content;
}

std::vector<uint8_t> write(const RomContent& content) {
  PartBytes parts;
  return write_rom_font(content, parts);
}

size_t bytes_of(size_t bits) {
  return (bits + 7) / 8;
}

size_t padded(size_t size) {
  return (size + 3) / 4 * 4;
}

// The device's values of all glyphs and pairs.
void expect_tables(const std::vector<uint8_t>& rom, const RomContent& content) {
  const Font font = opened(rom);
  EXPECT_EQ(verify_fields(font), Status::ok);
  int wrong = 0;
  const size_t count = content.glyphs.size();
  for (size_t left = 0; left < count; ++left) {
    const auto glyph = static_cast<uint16_t>(left);
    const GlyphMetrics& m = content.glyphs[left].metrics;
    GlyphMetrics found;
    EXPECT_EQ(font.glyph_metrics(glyph, found), Status::ok);
    wrong += found.advance != m.advance || found.x_min != m.x_min ||
             found.y_min != m.y_min || found.x_max != m.x_max ||
             found.y_max != m.y_max;
    for (size_t right = 0; right < count && !content.kerning.empty(); ++right) {
      wrong += font.kerning(glyph, static_cast<uint16_t>(right)) !=
               content.kerning.value(left, right);
    }
  }
  EXPECT_EQ(wrong, 0);
}

// Lines as printed by hexdump -C, without the last one.
std::string hex_dump(const std::vector<uint8_t>& bytes) {
  std::string dump;
  for (size_t line = 0; line < bytes.size(); line += 16) {
    char text[24];
    std::snprintf(text, sizeof text, "%04zx ", line);
    dump += text;
    for (size_t i = line; i < std::min(line + 16, bytes.size()); ++i) {
      std::snprintf(text, sizeof text, " %02x", bytes[i]);
      dump += text;
    }
    dump += '\n';
  }
  return dump;
}

TEST(RomFont, SmallestFontIsTheOneOfTheDocument) {
  const std::vector<uint8_t> bytes = write(smallest());
  check_rom_font(bytes, smallest());
  std::ifstream in(std::string(kSourceFolder) + "/docs/FORMAT.md");
  const std::string document(std::istreambuf_iterator<char>(in), {});
  ASSERT_FALSE(document.empty());
  std::string shown;
  size_t at = document.find("## The smallest font");
  ASSERT_NE(at, std::string::npos);
  at = document.find("    0000  ", at);
  ASSERT_NE(at, std::string::npos);
  while (document.compare(at, 4, "    ") == 0) {
    const size_t end = document.find('\n', at);
    // Only the bytes: the text after two blanks is explanation.
    const std::string line = document.substr(at + 4, end - at - 4);
    shown += line.substr(0, line.find("  ", 6)) + "\n";
    at = end + 1;
  }
  EXPECT_EQ(shown, hex_dump(bytes)) << "Put the dump into docs/FORMAT.md";
}

TEST(RomFont, PartsAddUp) {
  PartBytes parts;
  const std::vector<uint8_t> bytes = write_rom_font(larger(), parts);
  EXPECT_EQ(parts.total(), bytes.size());
  EXPECT_EQ(parts.header, 64u + 5 * 12);
  EXPECT_EQ(parts.cmap, 24u);
  // Advances 300..1200, x -20..100 and 0..1100, y -200..0 and 0..800.
  EXPECT_EQ(parts.metrics, padded(15 + bytes_of(4 * (10 + 7 + 8 + 11 + 10))));
  // Two glyphs and classes, three pairs of -300..12.
  EXPECT_EQ(parts.kerning,
            padded(17 + bytes_of(2 * (2 + 2 + 2) + 3 * 2 + 3 * (2 + 9))));
  EXPECT_EQ(parts.hints, 0u);
  EXPECT_EQ(parts.glyphs, 2 + bytes_of(5 * 6) + (12 + 2 + 10) + (12 + 20 + 30));
  EXPECT_EQ(parts.name, 4u);
}

TEST(RomFont, ClosedLoopAcceptsWhatWasWritten) {
  check_rom_font(write(smallest()), smallest());
  check_rom_font(write(larger()), larger());
}

TEST(RomFont, NoGlyphNeedsInk) {
  for (size_t count = 1; count < 20; ++count) {
    RomContent content = smallest();
    content.glyphs.assign(count, RomGlyph());
    content.glyph_of.clear();
    for (size_t i = 0; i < count; ++i) {
      content.glyphs[i].metrics.advance = static_cast<int>(300 + i);
      content.glyph_of[static_cast<char32_t>(U' ' + i)] =
          static_cast<uint16_t>(i);
    }
    const std::vector<uint8_t> bytes = write(content);
    check_rom_font(bytes, content);
    const Font font = opened(bytes);
    for (size_t i = 0; i < count; ++i) {
      GlyphField field;
      EXPECT_EQ(read_field(font, static_cast<uint16_t>(i), field), Status::ok);
      EXPECT_EQ(field.tiles_x, 0);
    }
  }
}

TEST(RomFont, JoinsRunsOfCharacters) {
  RomContent content = larger();
  content.glyph_of.clear();
  content.glyph_of[U'a'] = 1;
  content.glyph_of[U'b'] = 2;
  content.glyph_of[U'c'] = 3;
  content.glyph_of[U'd'] = 3;
  PartBytes parts;
  const std::vector<uint8_t> bytes = write_rom_font(content, parts);
  EXPECT_EQ(parts.cmap, 2 * format::cmap::kBytes);
  check_rom_font(bytes, content);
}

TEST(RomFont, WideKerningClassesTakeTwoBytes) {
  RomContent content = larger();
  content.glyphs.resize(300);
  std::vector<size_t> lefts;
  std::vector<std::vector<int16_t>> rows;
  for (size_t i = 0; i < 300; ++i) {
    lefts.push_back(i);
    std::vector<int16_t> row(300);
    row[i] = static_cast<int16_t>(i + 1);
    rows.push_back(row);
  }
  content.kerning = join_classes(300, lefts, rows);
  ASSERT_EQ(content.kerning.left_classes, 300);
  PartBytes parts;
  const std::vector<uint8_t> bytes = write_rom_font(content, parts);
  EXPECT_EQ(parts.kerning,
            padded(17 + bytes_of(300 * 27 + 301 * 9 + 300 * 18)));
  check_rom_font(bytes, content);
  expect_tables(bytes, content);
}

// Numbers of `bits` bits, around 0 or up to the ends of i16.
TEST(RomFont, MetricsOfEveryWidthAreExact) {
  std::mt19937 random(11);
  for (unsigned bits = 0; bits <= 16; ++bits) {
    for (const int side : {-1, 0, 1}) {
      const int span = (1 << bits) - 1;
      const int low = side < 0   ? -32768
                      : side > 0 ? 32767 - span
                                 : -(span + 1) / 2;
      const auto any = [&](int from) {
        return from + static_cast<int>(random() & static_cast<unsigned>(span));
      };
      RomContent content = smallest();
      content.glyphs.resize(40);
      for (size_t i = 0; i < 40; ++i) {
        GlyphMetrics& m = content.glyphs[i].metrics;
        m.advance = side > 0 ? 65535 - span + any(0) : any(0);
        m.x_min = static_cast<int16_t>(any(low));
        m.y_min = static_cast<int16_t>(i == 7 ? low : any(low));
        m.x_max = static_cast<int16_t>(i == 8 ? low + span : any(low));
        m.y_max = static_cast<int16_t>(any(low));
      }
      expect_tables(write(content), content);
    }
  }
}

TEST(RomFont, RandomKerningIsExact) {
  std::mt19937 random(12);
  const auto below = [&](unsigned n) {
    return static_cast<unsigned>(random() % n);
  };
  for (int round = 0; round < 60; ++round) {
    const size_t count = 2 + below(90);
    const unsigned sparsity = 1 + below(12);
    const int most = 1 << below(16);
    std::vector<size_t> lefts;
    std::vector<std::vector<int16_t>> rows;
    for (size_t left = 0; left < count; ++left) {
      if (below(3) == 0) {
        continue;
      }
      lefts.push_back(left);
      std::vector<int16_t> row(count);
      for (int16_t& value : row) {
        const int any = static_cast<int>(below(2u * unsigned(most))) - most;
        value = static_cast<int16_t>(below(sparsity) == 0 ? any : 0);
      }
      rows.push_back(row);
    }
    RomContent content = smallest();
    content.glyphs.resize(count);
    content.kerning = join_classes(count, lefts, rows);
    const std::vector<uint8_t> bytes = write(content);
    expect_tables(bytes, content);
    check_rom_font(bytes, content);
  }
}

TEST(RomFont, TablesOfRealFacesAreExact) {
  for (const char* file :
       {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
        "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf",
        "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/"
        "Roboto-Regular.ttf"}) {
    FontRequest request;
    request.file = file;
    add_ranges("0x20-0x7E", request.characters);
    Warnings ignored;
    const SourceFont source = load_font(request, 2, ignored);
    RomContent content = smallest();
    content.glyphs.clear();
    content.glyph_of.clear();
    for (const SourceGlyph& glyph : source.glyphs) {
      const Box box = Shape(glyph.outline).box();
      const double scale = source.metrics.units_per_em / 1024.0;
      GlyphMetrics m;
      m.advance = glyph.advance;
      m.x_min = static_cast<int16_t>(std::floor(box.x0 * scale));
      m.y_min = static_cast<int16_t>(std::floor(box.y0 * scale));
      m.x_max = static_cast<int16_t>(std::ceil(box.x1 * scale));
      m.y_max = static_cast<int16_t>(std::ceil(box.y1 * scale));
      content.glyphs.emplace_back();
      content.glyphs.back().metrics = m;
    }
    content.kerning = source.kerning;
    PartBytes parts;
    expect_tables(write_rom_font(content, parts), content);
    EXPECT_LE(parts.metrics, 660u) << file;
    EXPECT_LE(parts.kerning, 660u) << file;
  }
}

// More than 2^25 units of 2 bytes.
TEST(RomFont, LargeFontsCountInLargerUnits) {
  RomContent content = smallest();
  content.glyphs[1].field.cells.resize(32767, content.glyphs[1].field.cells[0]);
  content.glyphs.resize(206, content.glyphs[1]);
  PartBytes parts;
  const std::vector<uint8_t> rom = write_rom_font(content, parts);
  ASSERT_GT(rom.size(), size_t{1} << 26);
  const Font font = opened(rom);
  const Span<const uint8_t> glyphs = font.section(format::section::kGlyphs);
  EXPECT_EQ(glyphs[format::glyphs::kUnitLog2], 2);
  EXPECT_EQ(glyphs[format::glyphs::kOffsetBits], 25);
  EXPECT_EQ(font.record(205).size,
            padded(glyph_record(content.glyphs[205]).size()));
  check_rom_font(rom, content);
}

TEST(RomFont, HeaderSaysNothingOfOutlinesWhereThereAreCells) {
  const std::vector<uint8_t> bytes = write(larger());
  EXPECT_EQ(bytes[format::header::kCoding], 0);
  EXPECT_EQ(bytes[format::header::kMaxCells], 3);
  EXPECT_EQ(bytes[format::header::kMaxNodes], 2);
  EXPECT_EQ(bytes[format::header::kReserved0], 0);
  EXPECT_EQ(bytes[format::header::kReserved1], 0);
  EXPECT_EQ(bytes[format::header::kGridShift], 0);
  EXPECT_EQ(bytes[format::header::kCodeBits], 0);
  EXPECT_EQ(bytes[format::header::kMaxPoints], 0);
  EXPECT_EQ(bytes[format::header::kMaxPoints + 1], 0);
}

TEST(RomFont, RecordsAreThoseOfTheCells) {
  const RomContent content = larger();
  EXPECT_EQ(glyph_record(content.glyphs[3]),
            field_record(content.glyphs[3].field));
  EXPECT_TRUE(glyph_record(content.glyphs[0]).empty());
  EXPECT_TRUE(content.glyphs[3].has_ink());
  EXPECT_FALSE(content.glyphs[0].has_ink());
}

// The check of the unchanged bytes must find each change of the source.
TEST(RomFont, ClosedLoopSeesEveryDifference) {
  const std::vector<uint8_t> bytes = write(larger());
  int seen = 0;
  const auto refuses = [&](auto change) {
    RomContent content = larger();
    change(content);
    EXPECT_THROW(check_rom_font(bytes, content), Error) << seen;
    ++seen;
  };
  refuses([](RomContent& c) { c.metrics.ascender = 1; });
  refuses([](RomContent& c) { c.metrics.descender = 1; });
  refuses([](RomContent& c) { c.metrics.line_gap = 1; });
  refuses([](RomContent& c) { c.metrics.x_height = 1; });
  refuses([](RomContent& c) { c.metrics.cap_height = 1; });
  refuses([](RomContent& c) { c.metrics.units_per_em = 999; });
  refuses([](RomContent& c) { c.options.max_px = 25; });
  refuses([](RomContent& c) { c.name = "Dos"; });
  refuses([](RomContent& c) { c.glyph_of[U'A'] = 1; });
  refuses([](RomContent& c) { c.glyph_of.erase(U'B'); });
  refuses([](RomContent& c) { c.glyph_of[U'C'] = 1; });
  refuses([](RomContent& c) { c.glyphs[3].metrics.advance = 1; });
  refuses([](RomContent& c) { c.glyphs[3].metrics.y_min = 1; });
  refuses([](RomContent& c) { c.kerning.values[0] = 1; });
  refuses([](RomContent& c) { c.kerning.left_class[0] = 1; });
  refuses([](RomContent& c) { c.kerning.right_class[0] = 1; });
  refuses([](RomContent& c) { c.glyphs[3].field.x0_u = 1; });
  refuses([](RomContent& c) { c.glyphs[3].field.references[1] = 1; });
  refuses([](RomContent& c) { c.glyphs[3].field.references[4] = 1; });
  refuses([](RomContent& c) { c.glyphs[3].field.cells[2][9] = 1; });
  refuses([](RomContent& c) { c.glyphs[1].field.cells[0][0] = 1; });
  EXPECT_EQ(seen, 21);
}

TEST(RomFont, ClosedLoopSeesEveryChangedByte) {
  const std::vector<uint8_t> good = write(larger());
  for (size_t i = 0; i < good.size(); ++i) {
    std::vector<uint8_t> bytes = good;
    bytes[i] ^= 0x10;
    EXPECT_THROW(check_rom_font(bytes, larger()), Error) << i;
  }
}

}  // namespace
}  // namespace inkcell::gen::test
