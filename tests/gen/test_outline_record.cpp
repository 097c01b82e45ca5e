// Outline and composite records: reading gives what was written.
#include <gtest/gtest.h>

#include "outlines/outline_record.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <utility>

#include "outline_reader.hpp"
#include "outlines/code_search.hpp"
#include "paths.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen::test {
namespace {

constexpr PointKind kOff = PointKind::off_curve;
constexpr PointKind kSmooth = PointKind::smooth;

// Random points within +-reach.
MinimalOutline random_outline(std::mt19937& random, int reach) {
  MinimalOutline outline;
  std::uniform_int_distribution<int> place(-reach, reach);
  const size_t contours = 1 + random() % 12;
  for (size_t i = 0; i < contours; ++i) {
    MinimalContour contour;
    const size_t points = 1 + random() % 30;
    for (size_t k = 0; k < points; ++k) {
      const auto kind = k == 0 ? kCorner : static_cast<PointKind>(random() % 3);
      const bool is_flat = k > 0 && random() % 3 == 0;
      contour.points.push_back(
          {place(random), is_flat ? contour.points.back().y : place(random),
           kind});
    }
    outline.contours.push_back(contour);
  }
  return outline;
}

OutlineCode code_of(const std::vector<OutlineStep>& steps) {
  StepCounts counts;
  counts.add(steps);
  return make_outline_code(counts);
}

TEST(OutlineRecord, RandomOutlinesAreReadAsWritten) {
  std::mt19937 random(5);
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE(round);
    const int reach = (1 << (round % 14)) - 1;  // steps of up to 14 bits
    const MinimalOutline outline = random_outline(random, reach);
    const GridPosition start = {-reach, -reach};
    const std::vector<OutlineStep> steps = outline_steps(outline, start);
    const OutlineCode code = code_of(steps);
    const std::vector<uint8_t> record = outline_record(steps, code);
    EXPECT_GE(record.at(0), 0x80);
    EXPECT_NE(record.back(), 0);
    EXPECT_LE(record.size(), (outline_bits(steps, code) + 7) / 8);
    EXPECT_TRUE(same(read_outline(record, code.table(), code.code_bits(), start,
                                  point_count(steps)),
                     outline));
    // One point less, and the last contour does not end.
    EXPECT_EQ(read_outline(record, code.table(), code.code_bits(), start, 1)
                  .contours.size(),
              1u);
  }
}

TEST(OutlineRecord, AnyOtherGlyphOfTheFontMayUseTheCode) {
  std::mt19937 random(6);
  std::vector<std::vector<OutlineStep>> glyphs;
  StepCounts counts;
  for (int i = 0; i < 40; ++i) {
    glyphs.push_back(outline_steps(random_outline(random, 1 << (i % 13)), {}));
    counts.add(glyphs.back());
  }
  const OutlineCode code = make_outline_code(counts);
  uint64_t bits = 0;
  for (const std::vector<OutlineStep>& steps : glyphs) {
    bits += outline_bits(steps, code);
    const auto last_end =
        static_cast<uint64_t>(code.words().front().length) + 1;
    bits -= 1 + last_end;
  }
  EXPECT_EQ(bits, stream_bits(counts, code));
}

// Strokes as of hanzi: steps along one axis follow those along the other.
MinimalOutline random_boxes(std::mt19937& random) {
  MinimalOutline outline;
  const auto below = [&random](unsigned n) {
    return static_cast<int>(random() % n);
  };
  for (int i = 0; i < 4; ++i) {
    const int x = below(900);
    const int y = below(900);
    const int width = 60 + below(20);
    const int length = 100 + below(700);
    const int right = x + (i % 2 == 0 ? width : length);
    const int top = y + (i % 2 == 0 ? length : width);
    outline.contours.push_back({{{x, y, kCorner},
                                 {right, y, kCorner},
                                 {right, top, kCorner},
                                 {x, top, kCorner}}});
  }
  return outline;
}

TEST(OutlineRecord, StrokesAreReadByTheTablesOfTheStepsBefore) {
  std::mt19937 random(9);
  std::vector<MinimalOutline> outlines;
  StepCounts counts;
  for (int i = 0; i < 500; ++i) {
    outlines.push_back(random_boxes(random));
    counts.add(outline_steps(outlines.back(), {0, 0}));
  }
  const OutlineCode code = make_outline_code(counts);
  EXPECT_GT(code.table_count(), 1u);
  EXPECT_EQ(code.table().size(), code.table_count() << code.code_bits());
  // 16 entries are a table.
  const OutlineCode single = make_outline_code(counts, 16);
  EXPECT_EQ(single.table_count(), 1u);
  EXPECT_LT(stream_bits(counts, code), stream_bits(counts, single) * 9 / 10);
  size_t shared = 0;
  for (size_t table = 0; table < code.table_count(); ++table) {
    for (const CodeWord& word : code.words(table)) {
      EXPECT_TRUE(word.symbol.kind != WordKind::end || word.word == 0);
      EXPECT_GT(word.length, word.shares_bit ? 1 : 0);
      shared += word.shares_bit ? 1u : 0u;
    }
  }
  EXPECT_GT(shared, 0u);
  for (const MinimalOutline& outline : outlines) {
    const std::vector<OutlineStep> steps = outline_steps(outline, {0, 0});
    const std::vector<uint8_t> record = outline_record(steps, code);
    EXPECT_LE(record.size(), (outline_bits(steps, code) + 7) / 8);
    EXPECT_TRUE(same(read_outline(record, code.table(), code.code_bits(),
                                  {0, 0}, point_count(steps)),
                     outline));
  }
}

TEST(OutlineRecord, BeginsAtTheBoxRoundedDownToTheGrid) {
  const auto start = [](int x, int y, int shift) {
    const GridPosition at = record_start(x, y, shift);
    return std::pair<int, int>(at.x, at.y);
  };
  EXPECT_EQ(start(-5, 7, 0), (std::pair<int, int>(-5, 7)));
  EXPECT_EQ(start(-5, 7, 1), (std::pair<int, int>(-3, 3)));
  EXPECT_EQ(start(-32768, 32767, 4), (std::pair<int, int>(-2048, 2047)));
  EXPECT_EQ(start(-32768, 32767, -4), (std::pair<int, int>(-524288, 524272)));
}

TEST(OutlineRecord, WidthsOfSteps) {
  const int values[] = {0, -1, 1, -2, 2, 3, -4, -16384, 16383, 16384, -16385};
  const int widths[] = {0, 1, 2, 2, 3, 3, 3, 15, 15, 16, 16};
  for (size_t i = 0; i < std::size(values); ++i) {
    EXPECT_EQ(step_bits(values[i]), widths[i]) << values[i];
  }
}

TEST(OutlineRecord, LongLinesAreHalved) {
  const MinimalOutline outline = {
      {{{{0, 0, kCorner}, {40000, 0, kCorner}, {0, 101, kCorner}}}}};
  const std::vector<OutlineStep> steps = outline_steps(outline, {0, 0});
  ASSERT_EQ(steps.size(), 10u);
  int x = 0;
  int y = 0;
  for (const OutlineStep& step : steps) {
    EXPECT_LE(step_bits(step.dx), 15);
    x += step.dx;
    y += step.dy;
    // On the returning line, within the rounding of two halvings.
    if (y != 0) {
      EXPECT_NEAR(x, 40000 * (101 - y) / 101, 1.5 * 40000 / 101);
    }
  }
  EXPECT_EQ(steps[1].kind, WordKind::smooth);
  EXPECT_EQ(steps[4].kind, WordKind::corner);
  EXPECT_EQ(x, 0);
  EXPECT_EQ(y, 101);
}

TEST(OutlineRecord, LongCurvesAreHalved) {
  // One with both ends stored, and two with an implied end between them.
  const MinimalOutline outline = {
      {{{{0, 0, kCorner}, {20000, 0, kOff}, {16000, 4000, kCorner}}},
       {{{0, 0, kCorner},
         {20000, 0, kOff},
         {20000, 30000, kOff},
         {0, 30000, kCorner}}}}};
  const std::vector<OutlineStep> steps = outline_steps(outline, {0, 0});
  MinimalOutline split;
  split.contours.resize(2);
  size_t contour = 0;
  GridPosition at = {0, 0};
  for (const OutlineStep& step : steps) {
    EXPECT_TRUE(step_bits(step.dx) <= 15 && step_bits(step.dy) <= 15);
    at = {at.x + step.dx, at.y + step.dy};
    if (step.kind == WordKind::end) {
      ++contour;
    } else {
      split.contours[contour].points.push_back(
          {at.x, at.y, static_cast<PointKind>(step.kind)});
    }
  }
  const MinimalOutline expected = {{{{{0, 0, kCorner},
                                      {10000, 0, kOff},
                                      {18000, 2000, kOff},
                                      {16000, 4000, kCorner}}},
                                    {{{0, 0, kCorner},
                                      {10000, 0, kOff},
                                      {20000, 7500, kOff},
                                      {20000, 15000, kSmooth},
                                      {20000, 22500, kOff},
                                      {10000, 30000, kOff},
                                      {0, 30000, kCorner}}}}};
  EXPECT_TRUE(same(split, expected));
}

std::string refusal(const MinimalOutline& outline) {
  try {
    outline_steps(outline, {0, 0});
  } catch (const GeometryError& error) {
    EXPECT_EQ(error.kind(), GeometryError::Kind::too_complex);
    return error.what();
  }
  return "no error";
}

TEST(OutlineRecord, LimitsAreNamed) {
  EXPECT_EQ(refusal({{{{{0, 16384, kCorner}}}}}),
            "a contour begins 0, 16384 grid units from the point before it; "
            "-16384..16383 fit");
  EXPECT_EQ(refusal({{{{{0, -16384, kCorner}}}}}), "no error");
  EXPECT_EQ(refusal({{{{{0, 0, kCorner}, {0, 524289, kCorner}}}}}),
            "the point 0, 524289 of the outline is farther than 524288 grid "
            "units from the origin");
  MinimalContour many;
  for (int i = 0; i < 65535; ++i) {
    many.points.push_back({i % 2, 0, kCorner});
  }
  EXPECT_EQ(refusal({{many}}), "the outline has 65536 points; 65535 fit");
  many.points.pop_back();
  EXPECT_EQ(refusal({{many}}), "no error");
  const std::vector<OutlineStep> steps = {{WordKind::smooth, 3, 0},
                                          {WordKind::end, 0, 0}};
  const OutlineCode code = code_of({{WordKind::corner, 3, 0}});
  EXPECT_THROW(outline_record(steps, code), GeometryError);
}

TEST(OutlineRecord, CompositesAreReadAsWritten) {
  std::mt19937 random(7);
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    OutlineReferences references(1 + random() % 5);
    const int reach = 1 << (round % 15);
    std::uniform_int_distribution<int> offset(-reach, reach - 1);
    for (OutlineReference& reference : references) {
      reference.glyph = random() % 65536;
      reference.dx = offset(random);
      reference.dy = offset(random);
      if (random() % 2 == 0) {
        // No matrix mirrors.
        do {
          for (int& value : reference.matrix_q14) {
            value = static_cast<int>(random() % 65536) - 32768;
          }
        } while (int64_t{reference.matrix_q14[0]} * reference.matrix_q14[3] <=
                 int64_t{reference.matrix_q14[1]} * reference.matrix_q14[2]);
      }
    }
    ASSERT_TRUE(fits_record(references));
    const std::vector<uint8_t> record = composite_record(references);
    EXPECT_LE(record.size(), (composite_bits(references) + 7) / 8);
    const OutlineReferences read = read_composite(record);
    ASSERT_EQ(read.size(), references.size());
    for (size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(read[i].glyph, references[i].glyph);
      EXPECT_EQ(read[i].dx, references[i].dx);
      EXPECT_EQ(read[i].dy, references[i].dy);
      EXPECT_EQ(read[i].matrix_q14, references[i].matrix_q14);
    }
  }
}

TEST(OutlineRecord, CompositesOfNumbersThatDoNotFit) {
  OutlineReference reference;
  EXPECT_TRUE(fits_record({reference}));
  reference.dx = 16384;
  EXPECT_FALSE(fits_record({reference}));
  reference.dx = -16384;
  EXPECT_TRUE(fits_record({reference}));
  reference.matrix_q14[2] = 32768;
  EXPECT_FALSE(fits_record({reference}));
  reference.matrix_q14[2] = -32768;
  EXPECT_TRUE(fits_record({reference}));
  reference.glyph = 65536;
  EXPECT_FALSE(fits_record({reference}));
}

// The first line of a hexadecimal dump after `begin` in the document.
std::vector<uint8_t> bytes_of_document(const std::string& begin) {
  std::ifstream in(std::string(kSourceFolder) + "/docs/FORMAT.md");
  const std::string document(std::istreambuf_iterator<char>(in), {});
  size_t at = document.find(begin);
  EXPECT_NE(at, std::string::npos);
  at = document.find("\n    0000  ", at);
  EXPECT_NE(at, std::string::npos);
  const size_t end = document.find("\n", at + 1);
  const std::string line = document.substr(at + 11, end - at - 11);
  std::istringstream bytes(line.substr(0, line.find("  ")));
  std::vector<uint8_t> result;
  int byte = 0;
  while (bytes >> std::hex >> byte) {
    result.push_back(static_cast<uint8_t>(byte));
  }
  return result;
}

TEST(OutlineRecord, TheExampleIsThatOfTheDocument) {
  const std::vector<CodeSymbol> symbols = {{WordKind::end, 0, 0},
                                           {WordKind::off_curve, 8, 8},
                                           {WordKind::corner, 10, 0},
                                           {WordKind::corner, 9, 10}};
  const OutlineCode code(2, symbols, {2, 2, 2, 2});
  const MinimalOutline triangle = {
      {{{{20, 0, kCorner}, {420, 0, kCorner}, {220, 500, kCorner}}}}};
  const std::vector<OutlineStep> steps = outline_steps(triangle, {20, 0});
  const std::vector<uint8_t> record = outline_record(steps, code);
  EXPECT_EQ(record, bytes_of_document("#### Example of an outline"));
  EXPECT_TRUE(
      same(read_outline(record, code.table(), 2, {20, 0}, 4), triangle));
  std::vector<uint8_t> table;
  for (const uint16_t entry : code.table()) {
    table.push_back(static_cast<uint8_t>(entry));
    table.push_back(static_cast<uint8_t>(entry >> 8));
  }
  EXPECT_EQ(table, bytes_of_document("#### Example of a code"));

  OutlineReference base;
  base.glyph = 69;
  OutlineReference accent;
  accent.glyph = 123;
  accent.dx = 40;
  accent.dy = -3;
  EXPECT_EQ(composite_record({base, accent}),
            bytes_of_document("#### Example of a composite"));
}

}  // namespace
}  // namespace inkcell::gen::test
