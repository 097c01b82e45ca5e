// Loading: characters, faces, axes, metrics, outlines, and errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "glyph_outlines.hpp"
#include "messages.hpp"
#include "sfnt_builder.hpp"
#include "source/font_source.hpp"
#include "web_fonts.hpp"

namespace inkcell::gen::test {
namespace {

FontRequest request_of(const std::filesystem::path& file,
                       std::string_view chars = "0x20-0x7E") {
  FontRequest request;
  request.file = file;
  add_ranges(chars, request.characters);
  return request;
}

SourceFont load(const FontRequest& request) {
  Warnings ignored;
  return load_font(request, 1, ignored);
}

// The message of the Error thrown by loading.
std::string refusal(const FontRequest& request) {
  return error_of([&] { load(request); });
}

TEST(FontSource, ReadsGlyphsInOrderOfCodePoints) {
  const TestFolder folder;
  const SourceFont font =
      load(request_of(folder.write("a.ttf", Sfnt::plain())));
  ASSERT_EQ(font.glyphs.size(), 4u);
  EXPECT_EQ(font.glyphs[0].name(), ".notdef");
  EXPECT_EQ(font.glyphs[1].name(), "U+0020 ' '");
  EXPECT_EQ(font.glyphs[2].name(), "U+002E '.'");
  EXPECT_EQ(font.glyphs[3].name(), "U+0048 'H'");
  EXPECT_TRUE(font.glyphs[1].outline.contours.empty());
  EXPECT_EQ(font.glyphs[1].advance, 250);
  EXPECT_EQ(font.glyphs[3].advance, 800);
  EXPECT_EQ(font.missing.size(), 92u);
}

TEST(FontSource, ScalesOutlinesToTheEm) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.units_per_em = 2000;
  const SourceFont font = load(request_of(folder.write("a.ttf", source), "H"));
  ASSERT_EQ(font.glyphs.size(), 2u);
  const Outline& outline = font.glyphs[1].outline;
  ASSERT_EQ(outline.contours.size(), 1u);
  double x_max = 0;
  double y_max = 0;
  for (const Segment& segment : outline.contours[0].segments) {
    EXPECT_EQ(segment.kind, Segment::Kind::line);
    x_max = std::max(x_max, segment.p[1].x);
    y_max = std::max(y_max, segment.p[1].y);
  }
  EXPECT_DOUBLE_EQ(x_max, 700 * 1024.0 / 2000);
  EXPECT_DOUBLE_EQ(y_max, 700 * 1024.0 / 2000);
}

TEST(FontSource, ReadsQuadraticAndCubicCurves) {
  const auto kinds = [](const char* file, int face) {
    FontRequest request = request_of(file, "S");
    request.face = face;
    std::set<Segment::Kind> found;
    const SourceFont font = load(request);
    for (const Contour& contour : font.glyphs[1].outline.contours) {
      for (const Segment& segment : contour.segments) {
        found.insert(segment.kind);
      }
    }
    return found;
  };
  EXPECT_EQ(kinds(kDejaVuSans, 0).count(Segment::Kind::quadratic), 1u);
  EXPECT_EQ(kinds("/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", 2)
                .count(Segment::Kind::cubic),
            1u);
}

TEST(FontSource, SharesGlyphsOfSeveralCharacters) {
  // Liberation draws the soft hyphen with the hyphen's glyph.
  const SourceFont font = load(request_of(kLiberationSerif, "0x2D,0xAD,0x2E"));
  ASSERT_EQ(font.glyphs.size(), 3u);
  EXPECT_EQ(font.glyphs[1].code_points, (std::vector<char32_t>{0x2d, 0xad}));
}

TEST(FontSource, ReadsMetrics) {
  const TestFolder folder;
  const SourceMetrics m =
      load(request_of(folder.write("a.ttf", Sfnt::plain()))).metrics;
  EXPECT_EQ(m.units_per_em, 1000);
  EXPECT_EQ(m.ascender, 800);
  EXPECT_EQ(m.descender, -200);
  EXPECT_EQ(m.line_gap, 90);
  EXPECT_EQ(m.x_height, 480);
  EXPECT_EQ(m.cap_height, 700);
}

// The offset of a table in a small font.
size_t table_in(const std::vector<uint8_t>& file, std::string_view name) {
  const auto found =
      std::search(file.begin(), file.end(), name.begin(), name.end());
  const size_t entry = static_cast<size_t>(found - file.begin());
  return file.at(entry + 10) * 256u + file.at(entry + 11);
}

TEST(FontSource, PrefersTypographicMetricsWhereTheFontSaysSo) {
  const TestFolder folder;
  std::vector<uint8_t> file = Sfnt::plain().build();
  file[table_in(file, "OS/2") + 63] |= 0x80;  // fsSelection
  const SourceMetrics m = load(request_of(folder.write("a.ttf", file))).metrics;
  EXPECT_EQ(m.ascender, 750);
  EXPECT_EQ(m.descender, -150);
  EXPECT_EQ(m.line_gap, 0);
}

// As FreeType: OS/2's typographic heights, else those for Windows.
TEST(FontSource, TakesLinesFromOs2WhereHheaIsEmpty) {
  const TestFolder folder;
  std::vector<uint8_t> file = Sfnt::plain().build();
  const auto clear = [&](const char* table, size_t at, size_t count) {
    const auto begin =
        file.begin() + static_cast<ptrdiff_t>(table_in(file, table) + at);
    std::fill(begin, begin + static_cast<ptrdiff_t>(count), uint8_t{0});
  };
  Warnings warnings;
  const auto lines = [&] {
    warnings.clear();
    const SourceMetrics m =
        load_font(request_of(folder.write("a.ttf", file), "H"), 1, warnings)
            .metrics;
    return std::vector<int>{m.ascender, m.descender, m.line_gap};
  };
  clear("hhea", 4, 4);  // the line gap stays, but is ignored
  EXPECT_EQ(lines(), (std::vector<int>{750, -150, 0}));
  EXPECT_TRUE(warnings.empty());
  clear("OS/2", 68, 4);
  EXPECT_EQ(lines(), (std::vector<int>{800, -200, 0}));
  EXPECT_TRUE(warnings.empty());
  clear("OS/2", 74, 4);
  EXPECT_EQ(lines(), (std::vector<int>{2000, -2000, 0}));  // as in head
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, Warning::Kind::measure);
  EXPECT_TRUE(contains(warnings[0].text, "a.ttf: states no height of a line"));
}

TEST(FontSource, MeasuresHeightsThatTheFontDoesNotState) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.x_height = 0;
  source.cap_height = 0;
  source.glyphs.push_back({U'x', 500, {sfnt_rectangle(0, 0, 400, 512)}});
  const SourceMetrics m =
      load(request_of(folder.write("a.ttf", source))).metrics;
  EXPECT_EQ(m.x_height, 512);
  EXPECT_EQ(m.cap_height, 700);
}

TEST(FontSource, OpensTheFaceOfACollection) {
  const TestFolder folder;
  Sfnt second = Sfnt::plain();
  second.glyphs[3].advance = 901;
  FontRequest request = request_of(
      folder.write("a.ttc", build_collection({Sfnt::plain(), second})), "H");
  EXPECT_EQ(load(request).glyphs[1].advance, 800);
  request.face = 1;
  EXPECT_EQ(load(request).glyphs[1].advance, 901);
  request.face = 2;
  EXPECT_TRUE(contains(refusal(request), "has no face 2; choose 0 to 1"));
  request.face = -1;
  EXPECT_TRUE(contains(refusal(request), "has no face -1"));
}

TEST(FontSource, SetsTheAxesOfAVariableFont) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.wght_shift = 100;
  FontRequest request = request_of(folder.write("a.ttf", source), "H");
  const auto left_and_advance = [&] {
    const SourceGlyph glyph = load(request).glyphs[1];
    const double left = glyph.outline.contours.at(0).segments.at(0).p[0].x;
    return std::make_pair(left * 1000 / 1024, glyph.advance);
  };
  EXPECT_EQ(left_and_advance(), std::make_pair(100.0, 800));
  request.axes = {parse_axis("wght=900")};
  EXPECT_EQ(left_and_advance(), std::make_pair(200.0, 900));
  request.axes = {parse_axis("wght=650")};
  EXPECT_EQ(left_and_advance(), std::make_pair(150.0, 850));
}

TEST(FontSource, TakesInstancesByName) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.wght_shift = 100;
  source.instances = {{"Thin", 100}, {"Regular", 400}, {"Extra Black", 900}};
  FontRequest request = request_of(folder.write("a.ttf", source), "H");
  const auto made = [&] {
    const SourceFont font = load(request);
    return std::make_tuple(font.glyphs[1].advance, font.name,
                           font.faces.at(0).variation.place());
  };
  EXPECT_EQ(made(), std::make_tuple(800, std::string("Test"),
                                    "wght 400 of 100..900 (Regular)"));
  request.instance = "extra-black";
  EXPECT_EQ(made(), std::make_tuple(900, std::string("Test, Extra Black"),
                                    "wght 900 of 100..900 (Extra Black)"));
  // Axes move away from it.
  request.axes = {parse_axis("wght=650")};
  EXPECT_EQ(made(), std::make_tuple(850, std::string("Test, wght 650"),
                                    "wght 650 of 100..900"));
  request.instance = "Bold";
  EXPECT_TRUE(
      contains(refusal(request),
               "a.ttf: has no instance 'Bold', but Thin, Regular, Extra "
               "Black; choose one, or set axes: wght 100..900 (default 400)"));
  source.instances.clear();
  request.file = folder.write("b.ttf", source);
  EXPECT_TRUE(contains(refusal(request), "b.ttf: has no named instances"));
  source.wght_shift = 0;
  request.axes.clear();
  request.file = folder.write("fixed.ttf", source);
  EXPECT_TRUE(contains(refusal(request), "fixed.ttf: is not a variable font"));
}

TEST(FontSource, RefusesWrongAxes) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  FontRequest request = request_of(folder.write("fixed.ttf", source));
  request.axes = {parse_axis("wght=600")};
  EXPECT_TRUE(contains(refusal(request), "fixed.ttf: is not a variable font"));
  source.wght_shift = 100;
  request.file = folder.write("a.ttf", source);
  request.axes = {parse_axis("wght=901")};
  EXPECT_TRUE(contains(refusal(request),
                       "a.ttf: wght=901 is out of range; the axes are wght "
                       "100..900 (default 400)"));
  request.axes = {parse_axis("wdth=75")};
  EXPECT_TRUE(contains(refusal(request),
                       "has no axis 'wdth'; the axes are wght 100..900"));
  EXPECT_THROW(parse_axis("wght"), Error);
  EXPECT_THROW(parse_axis("=600"), Error);
  EXPECT_THROW(parse_axis("weight=600"), Error);
  EXPECT_THROW(parse_axis("wght=bold"), Error);
  EXPECT_THROW(parse_axis("wght=nan"), Error);
}

TEST(FontSource, RefusesWhatIsNoFont) {
  const TestFolder folder;
  const auto refused = [&](const std::vector<uint8_t>& bytes) {
    return refusal(request_of(folder.write("a.ttf", bytes)));
  };
  EXPECT_TRUE(contains(refusal(request_of(folder.path() / "none.ttf")),
                       "none.ttf: there is no such file"));
  EXPECT_TRUE(contains(refused({}), "a.ttf: is not a font: only 0 bytes"));
  const std::string text = "This is a text and not a font at all.";
  EXPECT_TRUE(
      contains(refused({text.begin(), text.end()}), "is not a font; TTF"));
}

// The first bytes of a file.
std::vector<uint8_t> first(const std::vector<uint8_t>& whole, size_t size) {
  return {whole.begin(), whole.begin() + static_cast<ptrdiff_t>(size)};
}

using Pack = std::vector<uint8_t> (*)(const std::vector<uint8_t>&);
constexpr Pack kPacks[] = {pack_woff, pack_woff2};

// Outlines come from FreeType; metrics, kerning and instances from HarfBuzz.
TEST(FontSource, ReadsWebFonts) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.kern_pairs = {{{2, 3}, -70}};
  source.wght_shift = 100;
  const std::vector<uint8_t> plain = source.build();
  FontRequest request = request_of(folder.write("a.ttf", plain), ".,H");
  request.axes = {parse_axis("wght=900")};
  const SourceFont expected = load(request);
  ASSERT_EQ(expected.kerning.value(1, 2), -70);
  ASSERT_EQ(expected.glyphs[2].advance, 900);
  for (const Pack pack : kPacks) {
    request.file = folder.write("a.woff", pack(plain));
    const SourceFont font = load(request);
    ASSERT_EQ(font.glyphs.size(), 3u);
    EXPECT_EQ(font.metrics.ascender, 800);
    EXPECT_EQ(font.kerning.value(1, 2), -70);
    EXPECT_EQ(font.glyphs[2].advance, 900);
    const auto corner = [](const SourceFont& of) {
      return of.glyphs[2].outline.contours.at(0).segments.at(0).p[0].x;
    };
    EXPECT_EQ(corner(font), corner(expected));
    request.face = 1;
    EXPECT_TRUE(contains(refusal(request), "a.woff: has no face 1; choose 0"));
    request.face = 0;
  }
}

TEST(FontSource, RefusesDamagedWebFonts) {
  const TestFolder folder;
  const std::vector<uint8_t> plain = Sfnt::plain().build();
  const auto refused = [&](const std::vector<uint8_t>& bytes) {
    return refusal(request_of(folder.write("a.woff", bytes)));
  };
  for (const Pack pack : kPacks) {
    const std::vector<uint8_t> whole = pack(plain);
    const std::string tool =
        pack == pack_woff ? "woff2sfnt" : "woff2_decompress";
    for (size_t size = 12; size < whole.size(); size += 5) {
      const std::string message = refused(first(whole, size));
      EXPECT_TRUE(
          contains(message, "a.woff: FreeType cannot unpack this WOFF"));
      EXPECT_TRUE(contains(message, "get it anew, or unpack it with " + tool));
    }
  }
}

TEST(FontSource, RefusesEveryTruncation) {
  const TestFolder folder;
  FontRequest request = request_of("");
  for (const int face : {0, 1}) {
    const std::vector<uint8_t> whole =
        face == 0 ? Sfnt::plain().build()
                  : build_collection({Sfnt::plain(), Sfnt::plain()});
    request.face = face;
    // The last bytes may be padding.
    for (size_t size = 0; size + 4 < whole.size(); ++size) {
      request.file = folder.write("a.ttf", first(whole, size));
      const std::string message = refusal(request);
      EXPECT_TRUE(contains(message, "truncated") ||
                  contains(message, "is not a font"))
          << face << ", " << size << ": " << message;
    }
  }
}

TEST(FontSource, RefusesTruncatedRealFonts) {
  const TestFolder folder;
  const std::vector<uint8_t> whole = read_file(kDejaVuSans);
  for (const size_t percent : {1u, 10u, 50u, 90u, 99u}) {
    const FontRequest request = request_of(
        folder.write("a.ttf", first(whole, whole.size() * percent / 100)));
    EXPECT_TRUE(contains(refusal(request), "a.ttf: is truncated: table '"));
  }
}

TEST(FontSource, RefusesFontsWithoutOutlines) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.tables["glyf"] = {};
  source.tables["loca"] = {};
  // Strikes without any content make it a bitmap font.
  source.tables["EBLC"] = {0, 2, 0, 0, 0, 0, 0, 0};
  source.tables["EBDT"] = {0, 2, 0, 0};
  const std::string message =
      refusal(request_of(folder.write("bitmaps.ttf", source)));
  EXPECT_TRUE(contains(message, "bitmaps.ttf: "));
  EXPECT_TRUE(contains(message, "has no outlines, only bitmaps"));
}

TEST(FontSource, RefusesAbsurdUnitsPerEm) {
  const TestFolder folder;
  for (const int units : {0, 1, 15, 16385, 65535}) {
    Sfnt source = Sfnt::plain();
    source.units_per_em = units;
    EXPECT_TRUE(contains(
        refusal(request_of(folder.write("a.ttf", source))),
        "a.ttf: has " + std::to_string(units) + " units per em, OpenType"));
  }
  for (const int units : {16, 16384}) {
    Sfnt source = Sfnt::plain();
    source.units_per_em = units;
    EXPECT_EQ(refusal(request_of(folder.write("a.ttf", source))), "no error");
  }
}

TEST(FontSource, RefusesFontsWithoutGlyphs) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.glyphs.clear();
  EXPECT_TRUE(contains(refusal(request_of(folder.write("none.ttf", source))),
                       "none.ttf: holds no glyphs"));
  // One glyph: only .notdef.
  source.glyphs = {Sfnt::plain().glyphs[0]};
  EXPECT_TRUE(contains(refusal(request_of(folder.write("one.ttf", source))),
                       "one.ttf: holds none of the 95 characters asked for"));
}

// Its last glyph, H, is the only one with an outline, whose last contour refers
// to points that do not exist.
Sfnt damaged() {
  Sfnt source = Sfnt::plain();
  std::vector<uint8_t> glyf(64, 0xff);
  glyf[0] = 0;
  glyf[1] = 9;
  source.tables["glyf"] = glyf;
  std::vector<uint8_t> loca(5 * 4);
  loca.back() = 64;
  source.tables["loca"] = loca;
  return source;
}

TEST(FontSource, NamesTheGlyphThatIsDamaged) {
  const TestFolder folder;
  Sfnt broken = damaged();
  const std::string message =
      refusal(request_of(folder.write("a.ttf", broken)));
  EXPECT_TRUE(contains(message, "a.ttf: glyph 3 (U+0048 'H') cannot be read"));
  EXPECT_TRUE(
      contains(message, "get the font anew or leave the character out"));
  // .notdef cannot be left out.
  broken.tables["loca"] = {0, 0,  0, 0, 0, 0,  0, 64, 0, 0,
                           0, 64, 0, 0, 0, 64, 0, 0,  0, 64};
  const std::string notdef = refusal(request_of(folder.write("a.ttf", broken)));
  EXPECT_TRUE(contains(notdef, "a.ttf: glyph 0 (.notdef) cannot be read"));
  EXPECT_TRUE(contains(notdef, "get the font anew"));
  EXPECT_FALSE(contains(notdef, "leave the character out"));
}

TEST(FontSource, BearsDamageInGlyphsThatAreNotAskedFor) {
  const TestFolder folder;
  Sfnt source = damaged();
  source.cap_height = 0;
  Warnings warnings;
  const SourceFont font =
      load_font(request_of(folder.write("a.ttf", source), "."), 1, warnings);
  EXPECT_EQ(font.metrics.cap_height, 0);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, Warning::Kind::measure);
  EXPECT_TRUE(
      contains(warnings[0].text, "a.ttf: glyph 3 (U+0048 'H') cannot be"));
}

TEST(FontSource, ReadsAdvancesOf16Bits) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  for (const int advance : {32767, 32768, 65535}) {
    source.glyphs[3].advance = advance;
    Warnings warnings;
    const SourceFont font =
        load_font(request_of(folder.write("a.ttf", source), "H"), 1, warnings);
    EXPECT_EQ(font.glyphs[1].advance, advance);
    EXPECT_TRUE(warnings.empty());
  }
  source.glyphs[3].advance = 40000;
  source.wght_shift = 100;
  FontRequest request = request_of(folder.write("a.ttf", source), "H");
  request.axes = {parse_axis("wght=900")};
  EXPECT_EQ(load(request).glyphs[1].advance, 40100);
}

TEST(FontSource, WarnsOfGlyphsThatArePictures) {
  const TestFolder folder;
  Sfnt source = Sfnt::plain();
  source.glyphs.push_back({U'*', 500, {}});
  // One picture for the glyphs 3 and 4, H and the star.
  source.tables["SVG "] = {0, 0, 0, 0, 0,   10,  0,   0,   0,   0,
                           0, 1, 0, 3, 0,   4,   0,   0,   0,   14,
                           0, 0, 0, 6, '<', 's', 'v', 'g', '/', '>'};
  Warnings warnings;
  load_font(request_of(folder.write("a.ttf", source), "0x20,.,H,*"), 1,
            warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, Warning::Kind::no_outline);
  EXPECT_TRUE(
      contains(warnings[0].text, "a.ttf: 1 glyph is a bitmap or a colour"));
  EXPECT_TRUE(contains(warnings[0].text, "empty: U+002A '*'"));
  EXPECT_FALSE(contains(warnings[0].text, "U+0048"));
}

TEST(FontSource, WarnsOfMissingCharacters) {
  const TestFolder folder;
  Warnings warnings;
  load_font(request_of(folder.write("a.ttf", Sfnt::plain()), "H,0x400-0x40F"),
            1, warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].kind, Warning::Kind::missing_characters);
  EXPECT_TRUE(
      contains(warnings[0].text, "a.ttf: 16 characters are not in the font"));
  EXPECT_TRUE(contains(warnings[0].text, "U+0409"));
  EXPECT_FALSE(contains(warnings[0].text, "U+040A"));
  EXPECT_TRUE(contains(warnings[0].text, ", ..."));
}

TEST(FontSource, WarnsOfEmbeddingRestrictions) {
  const TestFolder folder;
  const auto warning = [&](uint16_t fs_type) {
    Sfnt source = Sfnt::plain();
    source.fs_type = fs_type;
    Warnings warnings;
    load_font(request_of(folder.write("a.ttf", source), "H"), 1, warnings);
    if (warnings.empty()) {
      return std::string("none");
    }
    EXPECT_EQ(warnings[0].kind, Warning::Kind::embedding);
    return warnings[0].text;
  };
  EXPECT_EQ(warning(0), "none");
  EXPECT_TRUE(contains(warning(2), "fsType 2, restricted licence: must not"));
  EXPECT_TRUE(contains(warning(4), "preview and print"));
  EXPECT_TRUE(contains(warning(8), "editable"));
  EXPECT_TRUE(contains(warning(0x100), "no subsetting"));
  EXPECT_TRUE(contains(warning(0x208), "editable"));
  EXPECT_TRUE(contains(warning(0x208), "bitmap embedding only"));
}

}  // namespace
}  // namespace inkcell::gen::test
