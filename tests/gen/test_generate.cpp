// The whole generator in memory: determinism, closed loop, report, refusals.
#include <gtest/gtest.h>

#include "pipeline/generate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/report.hpp"
#include "field/record.hpp"
#include "field/symmetry.hpp"
#include "glyph_outlines.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/font.hpp"
#include "messages.hpp"
#include "opened_font.hpp"
#include "pipeline/field_images.hpp"
#include "sfnt_builder.hpp"
#include "shape/outline.hpp"
#include "source/char_set.hpp"

namespace inkcell::gen::test {
namespace {

// All of ASCII if `symbols` is empty.
GenerateRequest dejavu(const std::string& symbols = "") {
  GenerateRequest request;
  request.font = kDejaVuSans;
  request.symbols = symbols;
  request.target.min_px = 12;
  request.target.max_px = 16;
  return request;
}

std::string refusal(const GenerateRequest& request) {
  return error_of([&] { generate(request); });
}

Target options_of(Coding coding) {
  Target options = dejavu().target;
  options.coding = coding;
  return options;
}

const std::vector<Target> kCodings = {options_of(Coding::field),
                                      options_of(Coding::outline)};

TEST(Generate, GivesTheSameBytesForAnyNumberOfThreads) {
  GenerateRequest request = dejavu();
  request.chars = {"A-C,a"};
  for (const Target& options : kCodings) {
    request.target = options;
    request.threads = 1;
    const std::vector<uint8_t> one = generate(request).bytes;
    for (const int jobs : {3, 8}) {
      request.threads = jobs;
      EXPECT_EQ(generate(request).bytes, one) << jobs;
    }
  }
}

TEST(Generate, MakesOutlinesUnlessTold) {
  EXPECT_EQ(GenerateRequest().target.coding, Coding::outline);
  EXPECT_EQ(GenerateRequest().target.predicate, Predicate::size_aware);
}

// Outlines take less than half of what fields take.
TEST(Generate, MakesSmallerFontsOfOutlines) {
  size_t before = 1000000;
  for (const Target& options : kCodings) {
    GenerateRequest request = dejavu("Rag8");
    request.target = options;
    const RomFont rom = generate(request);
    const Font font = opened(rom.bytes);
    EXPECT_EQ(verify_fields(font), Status::ok);
    EXPECT_LT(rom.report.bytes.glyphs, before / 2);
    before = rom.report.bytes.glyphs;
    EXPECT_LE(rom.report.worst_error, 16);
  }
}

TEST(Generate, MakesAFontThatTheDeviceReads) {
  const RomFont rom = generate(dejavu());
  const Font font = opened(rom.bytes);
  EXPECT_EQ(verify_fields(font), Status::ok);
  EXPECT_EQ(font.glyph_count(), 96);
  EXPECT_EQ(font.units_per_em(), 2048);
  EXPECT_EQ(font.range().min_px, 12);
  EXPECT_EQ(font.range().max_px, 16);
  EXPECT_EQ(font.range().tolerance, 16);
  EXPECT_TRUE(font.has_outlines());
  uint16_t glyph = 0;
  ASSERT_EQ(font.glyph_of('H', glyph), Status::ok);
  GlyphMetrics m;
  ASSERT_EQ(font.glyph_metrics(glyph, m), Status::ok);
  // As in the file's own tables.
  EXPECT_EQ(m.advance, 1540);
  EXPECT_EQ(m.x_min, 201);
  EXPECT_EQ(m.y_min, 0);
  EXPECT_EQ(m.x_max, 1339);
  EXPECT_EQ(m.y_max, 1493);
}

TEST(Generate, TakesTheUnionOfAllCharacters) {
  const TestFolder folder;
  GenerateRequest request = dejavu();
  request.chars = {"0x41-0x43", "U+B0"};
  request.symbols = "Cx";
  request.text_files = {folder.write("t.txt", std::vector<uint8_t>{'y', '\n'})};
  const FontReport report = generate(request).report;
  EXPECT_EQ(report.characters, 6u + 3u);  // and a space, '-', '.'
  EXPECT_EQ(report.glyphs.size(), 7u + 3u);
}

// Characters that layout inserts: a space always, signs only with letters and
// digits, one of each, and only if the face has them.
TEST(Generate, AddsWhatLayoutPutsIntoText) {
  const auto added = [](const std::string& chars, bool signs) {
    GenerateRequest request = dejavu();
    request.chars = {chars};
    request.layout_glyphs = signs;
    request.strict = true;
    const RomFont rom = generate(request);
    const Font font = opened(rom.bytes);
    std::u32string found;
    size_t bytes = 0;
    for (const char32_t c : rom.report.added) {
      uint16_t glyph = 0;
      EXPECT_EQ(font.glyph_of(c, glyph), Status::ok);
      EXPECT_GT(font.advance(glyph), 0);
      bytes += rom.report.glyphs[glyph].bytes;
      found += c;
    }
    EXPECT_EQ(rom.report.added_bytes, bytes);
    EXPECT_EQ(rom.report.characters, rom.report.glyphs.size() - 1);
    return found;
  };
  EXPECT_EQ(added("0-9,:", true), U" -.");
  EXPECT_EQ(added("0-9,:", false), U" ");
  EXPECT_EQ(added("0x20,0-1,U+2026,U+2010", true), U"");
  EXPECT_EQ(added("0-1,.", true), U" -");
  EXPECT_EQ(added("U+2600", true), U" ");  // an icon
  EXPECT_EQ(added("0x20-0x7E", true), U"");
}

TEST(Generate, AddsNothingThatTheFaceLacks) {
  const TestFolder folder;
  GenerateRequest request;
  request.font = folder.write("plain.ttf", Sfnt::plain());
  request.symbols = "H";
  request.strict = true;
  request.target.max_px = 16;
  const RomFont rom = generate(request);
  EXPECT_TRUE(rom.warnings.empty());
  EXPECT_EQ(rom.report.added, (std::vector<char32_t>{U' ', U'.'}));
  const auto json = nlohmann::json::parse(report_as_json(rom.report));
  EXPECT_EQ(json.at("added").at("characters"), " .");
  EXPECT_TRUE(contains(report_for_people(rom.report), "for layout"));
}

TEST(Generate, AddsSignsOfTheFirstFaceThatHasThem) {
  const TestFolder folder;
  GenerateRequest request = dejavu();
  request.font = folder.write("plain.ttf", Sfnt::plain());
  request.symbols = "H";
  request.merge = {std::string(kDejaVuSans) + "=U+B0"};
  const FontReport report = generate(request).report;
  EXPECT_EQ(report.added, (std::vector<char32_t>{U' ', U'-', U'.'}));
  for (const GlyphReport& glyph : report.glyphs) {
    const bool is_of_second = glyph.key == "-" || glyph.key == "\u00b0";
    EXPECT_EQ(glyph.file_name != "plain.ttf", is_of_second) << glyph.key;
  }
}

TEST(Generate, ReportsEveryKeyOfTheDesign) {
  GenerateRequest request = dejavu("Hamburg 8");
  request.target = options_of(Coding::field);
  const RomFont rom = generate(request);
  const auto json = nlohmann::json::parse(report_as_json(rom.report));
  EXPECT_EQ(json.at("font"), "DejaVu Sans Book");
  EXPECT_EQ(json.at("glyphs"), 10 + 2);  // and '-', '.'
  EXPECT_EQ(json.at("coding"), "field");
  EXPECT_EQ(json.at("min_px"), 12);
  EXPECT_EQ(json.at("max_px"), 16);
  EXPECT_EQ(json.at("tolerance"), 16);
  size_t sum = 0;
  for (const char* part :
       {"header", "cmap", "metrics", "kerning", "hints", "glyphs", "name"}) {
    sum += json.at("bytes").at(part).get<size_t>();
  }
  EXPECT_EQ(json.at("bytes").at("total"), rom.bytes.size());
  EXPECT_EQ(sum, rom.bytes.size());
  size_t cells = 0;
  for (const auto& item : json.at("cells_per_glyph")) {
    cells += item.get<size_t>();
  }
  EXPECT_EQ(json.at("cells_per_glyph").size(), 12u);
  EXPECT_EQ(json.at("cells_per_glyph").at(" "), 0);
  EXPECT_GT(json.at("cells_per_glyph").at("a").get<int>(), 10);
  EXPECT_GT(json.at("bytes_per_glyph").at("a").get<int>(), 50);
  EXPECT_EQ(json.at("bytes_per_glyph").at(" "), 0);
  EXPECT_LE(json.at("error_per_glyph").at("a").get<double>(), 16);
  const auto& worst_pixel = json.at("worst_pixel_per_glyph").at("a");
  EXPECT_GE(worst_pixel.at("px"), 12);
  EXPECT_LE(worst_pixel.at("px"), 16);
  EXPECT_EQ(json.at("worst_pixel_per_glyph").count(" "), 0u);
  EXPECT_EQ(json.at("cell_count"), cells);
  EXPECT_EQ(json.at("leaf_list_bytes"), 15 * cells);
  EXPECT_LE(json.at("error").at("max").get<double>(), 16);
  EXPECT_GT(json.at("error").at("max").get<double>(), 1);
  EXPECT_LE(json.at("error").at("mean").get<double>(), 3);
  // Every size from 12 to 16; the worst of them is the worst of all.
  const auto& sizes = json.at("error_by_size");
  ASSERT_EQ(sizes.size(), 5u);
  double worst = 0;
  double mean = 0;
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(sizes[i].at("px"), 12 + i);
    worst = std::max(worst, sizes[i].at("worst").get<double>());
    mean = std::max(mean, sizes[i].at("mean").get<double>());
  }
  EXPECT_EQ(json.at("error").at("max"), worst);
  EXPECT_EQ(json.at("error").at("mean"), mean);
  const std::string table = report_for_people(rom.report);
  for (const char* word :
       {"DejaVu Sans", "kerning", "total", "worst", "size, px", " s\n"}) {
    EXPECT_TRUE(contains(table, word)) << word;
  }
}

// Of outlines the promise is that of areas, at any position: not less than what
// the loop sees. What it sees by distance stands beside it.
TEST(Generate, ReportsAreasAndDistances) {
  GenerateRequest request = dejavu("ag&");
  request.target.coding = Coding::outline;
  request.target.max_px = 64;
  const RomFont rom = generate(request);
  const auto json = nlohmann::json::parse(report_as_json(rom.report));
  const double promised = json.at("error").at("max").get<double>();
  EXPECT_LE(promised, 16);
  EXPECT_TRUE(rom.warnings.empty());
  double worst = 0;
  for (const auto& size : json.at("error_by_size")) {
    worst = std::max(worst, size.at("worst").get<double>());
  }
  EXPECT_GT(worst, 2);
  EXPECT_LE(worst, promised);
  EXPECT_GT(json.at("distance_error").at("max").get<double>(), worst / 2);
  EXPECT_LE(json.at("distance_error").at("max").get<double>(), 16);
  EXPECT_LT(json.at("distance_error").at("mean").get<double>(), 1);
  EXPECT_TRUE(contains(report_for_people(rom.report), "by distance"));
}

// A font made for coarser sizes than it holds is wrong by more than a pixel may
// be.
TEST(Generate, WarnsOfAreasBeyondTheTolerance) {
  GenerateRequest request = dejavu("g");
  request.target.coding = Coding::outline;
  request.target.max_px = 64;
  request.target.tolerance = 5;  // roundings alone take nearly as much
  const RomFont rom = generate(request);
  ASSERT_EQ(rom.warnings.size(), 1u);
  EXPECT_EQ(rom.warnings[0].kind, Warning::Kind::tolerance_missed);
  EXPECT_TRUE(contains(rom.warnings[0].text, "'g'"));
  EXPECT_GT(rom.report.worst_error, 5);
  const Font font = opened(rom.bytes);
  EXPECT_EQ(font.range().tolerance, std::ceil(rom.report.worst_error));
}

// A sampled field in the generator's representation.
SampleTree tree_of(const GlyphField& field) {
  SampleTree tree;
  tree.tile_log2 = field.tile_log2;
  tree.x0_u = field.x0_u;
  tree.y0_u = field.y0_u;
  tree.tiles_x = field.tiles_x;
  tree.tiles_y = field.tiles_y;
  const size_t references =
      static_cast<size_t>(field.tiles_x * field.tiles_y + 4 * field.node_count);
  for (size_t i = 0; i < references; ++i) {
    const uint8_t* bytes = field.references + 2 * i;
    tree.references.push_back(static_cast<uint16_t>(bytes[0] | bytes[1] << 8));
  }
  tree.cells.resize(field.cell_count);
  const uint8_t* from = field.cells;
  for (SampleCell& cell : tree.cells) {
    std::copy_n(from, cell.size(), cell.begin());
    from += cell.size();
  }
  return tree;
}

// The file states that the right bracket is the left one reflected: their
// fields are the same, bit by bit.
TEST(Generate, ReflectedComponentsHaveReflectedFields) {
  constexpr uint32_t kLeft = 0x2E1C;
  constexpr uint32_t kRight = 0x2E1D;
  constexpr int kStep_u = 421;  // 842 of 2048 units
  GenerateRequest request = dejavu();
  request.font =
      "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf";
  request.chars = {"0x2E1C-0x2E1D,0xC9"};
  request.layout_glyphs = false;
  request.target.coding = Coding::field;
  const RomFont rom = generate(request);
  EXPECT_EQ(rom.report.glyphs.size(), 5u);  // no acute of its own
  const Font font = opened(rom.bytes);
  GlyphField fields[2];
  for (const uint32_t character : {kLeft, kRight}) {
    uint16_t glyph = 0;
    ASSERT_EQ(font.glyph_of(character, glyph), Status::ok);
    ASSERT_EQ(read_field(font, glyph, fields[character - kLeft]), Status::ok);
  }
  EXPECT_GT(fields[0].cell_count, 10);
  EXPECT_EQ(
      field_record(tree_of(fields[1])),
      field_record(permuted(tree_of(fields[0]), {-1, 0, 0, 1}, kStep_u, 0)));
}

// Images are made in parallel: none may wait for another one.
TEST(Generate, ImagesOfImagesAreNoImages) {
  SourceFont font;
  font.metrics.units_per_em = 1024;
  font.glyphs.resize(4);
  font.components.resize(4);
  for (size_t i = 1; i < 4; ++i) {
    font.glyphs[i].code_points = {static_cast<char32_t>(U'a' + i)};
  }
  OutlineReference reference;
  for (size_t i = 2; i < 4; ++i) {
    reference.glyph = i - 1;
    font.components[i] = {reference};
  }
  const std::vector<FieldImage> images = find_field_images(font);
  ASSERT_EQ(images.size(), 1u);
  EXPECT_EQ(images[0].glyph, 2u);
  EXPECT_EQ(images[0].of, 1u);
}

TEST(Generate, RefusesWrongRequests) {
  const auto range = [](double min_px, double max_px, double tolerance) {
    GenerateRequest request = dejavu("H");
    request.target.min_px = min_px;
    request.target.max_px = max_px;
    request.target.tolerance = tolerance;
    return refusal(request);
  };
  EXPECT_EQ(range(4, 4, 255), "no error");
  for (const std::string& text : {range(3, 64, 16), range(8, 1025, 16),
                                  range(20, 19, 16), range(8.5, 20, 16)}) {
    EXPECT_TRUE(contains(text, "-px "));
  }
  EXPECT_TRUE(contains(range(8, 64, 0), "--tolerance"));
  EXPECT_TRUE(contains(range(8, 64, 256), "--tolerance"));
  for (const int effort : {-1, 10}) {
    GenerateRequest request = dejavu();
    request.target.effort = effort;
    EXPECT_TRUE(begins_with(refusal(request), "--effort"));
  }
  GenerateRequest request = dejavu("\n");
  EXPECT_TRUE(contains(refusal(request), "no characters"));
}

TEST(Generate, RefusesWhatDoesNotGoTogether) {
  GenerateRequest request = dejavu("H");
  request.target = options_of(Coding::outline);
  request.target.predicate = Predicate::fixed;
  EXPECT_TRUE(begins_with(refusal(request), "--predicate fixed"));
  EXPECT_TRUE(contains(refusal(request), "--coding field"));
}

TEST(Generate, DrawsOddOutlines) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  // Crosses itself; runs the wrong way; has no area; a single point; overlaps.
  source.glyphs.push_back(
      {U'1', 500, {{{0, 0}, {400, 400}, {400, 0}, {0, 400}}}});
  source.glyphs.push_back(
      {U'2', 500, {{{0, 0}, {400, 0}, {400, 400}, {0, 400}}}});
  source.glyphs.push_back({U'3', 500, {{{0, 0}, {400, 0}, {200, 0}}}});
  source.glyphs.push_back({U'4', 500, {{{7, 7}}}});
  source.glyphs.push_back(
      {U'5',
       500,
       {sfnt_rectangle(0, 0, 300, 300), sfnt_rectangle(100, 100, 400, 400)}});
  GenerateRequest request;
  request.font = folder.write("odd.ttf", source);
  request.target.coding = Coding::field;
  request.target.max_px = 16;
  const RomFont rom = generate(request);
  const std::map<std::string, bool> has_ink = {
      {"1", true}, {"2", true}, {"3", false}, {"4", false}, {"5", true}};
  int checked = 0;
  for (const GlyphReport& glyph : rom.report.glyphs) {
    const auto found = has_ink.find(glyph.key);
    if (found != has_ink.end()) {
      EXPECT_EQ(glyph.cells > 0, found->second) << glyph.key;
      ++checked;
    }
  }
  EXPECT_EQ(checked, 5);
}

TEST(Generate, NamesTheGlyphThatDoesNotFit) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  for (auto& corner : source.glyphs[3].contours[0]) {
    corner.first *= 40;
  }
  GenerateRequest request;
  request.font = folder.write("wide.ttf", source);
  request.symbols = "H";
  const std::string message = refusal(request);
  EXPECT_TRUE(begins_with(message, "wide.ttf: U+0048 'H': "));
  EXPECT_FALSE(contains(message, "--max-px"));
  EXPECT_TRUE(contains(message, "leave the character out"));
  std::swap(source.glyphs[0].contours, source.glyphs[3].contours);
  request.font = folder.write("wide.ttf", source);
  const std::string notdef = refusal(request);
  EXPECT_TRUE(begins_with(notdef, "wide.ttf: .notdef: "));
  EXPECT_FALSE(contains(notdef, "leave the character out"));
}

// The format holds the grid of everything within the limit of coordinates,
// except the large tiles of the paper's predicate.
TEST(Generate, HoldsOutlinesUpToTheLimit) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.units_per_em = 1024;
  const int limit = static_cast<int>(kCoordinateLimit);
  GenerateRequest request;
  request.symbols = "H";
  request.target.min_px = 4;
  request.target.max_px = 4;
  for (const int far : {limit, limit - 1, limit - 77, limit - 255}) {
    source.glyphs[3].contours = {sfnt_rectangle(far - 9, far - 9, far, far),
                                 sfnt_rectangle(-far, -far, 9 - far, 9 - far)};
    request.font = folder.write("wide.ttf", source);
    request.target.coding = far % 2 == 0 ? Coding::field : Coding::outline;
    EXPECT_EQ(refusal(request), "no error") << far;
  }
  request.target.coding = Coding::field;
  request.target.predicate = Predicate::fixed;
  const std::string message = refusal(request);
  EXPECT_TRUE(contains(message, "beyond 15 em"));
  EXPECT_FALSE(contains(message, "--max-px"));
}

TEST(Generate, NamesGlyphsThatMissTheTolerance) {
  const TestFolder folder;
  GenerateRequest request;
  request.font = folder.write("plain.ttf", Sfnt::plain());
  request.symbols = ".";
  request.target.coding = Coding::field;
  request.target.max_px = 128;
  request.target.tolerance = 1;
  request.target.effort = 0;
  const RomFont rom = generate(request);
  const Font font = opened(rom.bytes);
  EXPECT_EQ(font.range().tolerance, std::ceil(rom.report.worst_error));
  const auto dot =
      std::find_if(rom.report.glyphs.begin(), rom.report.glyphs.end(),
                   [](const GlyphReport& glyph) { return glyph.key == "."; });
  ASSERT_NE(dot, rom.report.glyphs.end());
  ASSERT_FALSE(dot->within_tolerance);
  char figures[64];
  std::snprintf(figures, sizeof figures, "U+002E '.' %.1f/255 at %d px",
                dot->worst_error, dot->worst_px);
  ASSERT_EQ(rom.warnings.size(), 1u);
  EXPECT_EQ(rom.warnings[0].kind, Warning::Kind::tolerance_missed);
  EXPECT_TRUE(contains(rom.warnings[0].text, figures));
  std::snprintf(figures, sizeof figures, ". %.1f at %d px", dot->worst_error,
                dot->worst_px);
  EXPECT_TRUE(contains(report_for_people(rom.report), figures));
  const auto missed =
      nlohmann::json::parse(report_as_json(rom.report)).at("missed");
  const auto in_list =
      std::find_if(missed.begin(), missed.end(),
                   [](const auto& miss) { return miss.at("glyph") == "."; });
  ASSERT_NE(in_list, missed.end());
  EXPECT_EQ(in_list->at("file"), "plain.ttf");
  EXPECT_EQ(in_list->at("px"), dot->worst_px);
  EXPECT_NEAR(in_list->at("error").get<double>(), dot->worst_error, 0.001);
  // As a limit it is an error with a useful remedy.
  request.tolerance_is_limit = true;
  const std::string refused = refusal(request);
  const std::string remedy =
      "give --tolerance " +
      std::to_string(static_cast<int>(std::ceil(rom.report.worst_error))) +
      "/255";
  EXPECT_TRUE(contains(refused, "U+002E '.' "));
  EXPECT_TRUE(contains(refused, remedy));
  request.target.tolerance = std::ceil(rom.report.worst_error);
  EXPECT_EQ(refusal(request), "no error");
}

// On the grid that 1024 px/em ask for, a step of 1900 units has 16 bits.
TEST(Generate, GridHasRoomForWideGlyphs) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.units_per_em = 2048;
  source.glyphs[3].advance = 2048;
  source.glyphs[3].contours = {sfnt_rectangle(0, 0, 40, 1400),
                               sfnt_rectangle(1900, 0, 1940, 1400)};
  GenerateRequest request;
  request.font = folder.write("wide.ttf", source);
  request.symbols = "H";
  request.target.min_px = 1000;
  request.target.max_px = 1024;
  const RomFont rom = generate(request);
  EXPECT_LE(rom.report.worst_error, request.target.tolerance);
}

TEST(Generate, TellsOfProgress) {
  GenerateRequest request = dejavu();
  request.chars = {"A-F"};
  std::vector<size_t> told;
  request.progress = [&](size_t done, size_t count) {
    EXPECT_EQ(count, 7u + 3u);
    told.push_back(done);
  };
  generate(request);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.front(), 0u);
  EXPECT_EQ(told.back(), 7u + 3u);
}

TEST(Generate, FollowsThePaperWithTheFixedPredicate) {
  GenerateRequest request = dejavu("aD");
  request.target.coding = Coding::field;
  request.target.predicate = Predicate::fixed;
  const RomFont rom = generate(request);
  const auto json = nlohmann::json::parse(report_as_json(rom.report));
  EXPECT_EQ(json.at("predicate"), "fixed");
  EXPECT_EQ(json.at("error").at("unit"), "1/1024 em");
  EXPECT_EQ(json.at("tolerance"), 0);
  EXPECT_EQ(rom.bytes[format::header::kPredicate], 1);
  EXPECT_EQ(rom.bytes[format::header::kTolerance], 0);
}

}  // namespace
}  // namespace inkcell::gen::test
