// Several faces in one font: the source of each character, and its position.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/encode.hpp"
#include "icon_folder.hpp"
#include "inkcell/font.hpp"
#include "opened_font.hpp"
#include "pipeline/generate.hpp"
#include "shape/shape.hpp"
#include "source/faces.hpp"

namespace inkcell::gen::test {
namespace {

Sfnt face_of(int units, std::vector<SfntGlyph> glyphs) {
  Sfnt font;
  font.units_per_em = units;
  font.glyphs = {{0, 600, {sfnt_rectangle(50, 0, 550, 700)}}};
  font.glyphs.insert(font.glyphs.end(), glyphs.begin(), glyphs.end());
  return font;
}

class Faces : public Icons {
 protected:
  Faces() {
    Sfnt text = face_of(1000, {{U'A', 500, {sfnt_rectangle(0, 0, 400, 700)}},
                               {U'C', 510, {sfnt_rectangle(0, 0, 410, 710)}}});
    text.kern_pairs = {{{1, 2}, -50}};
    Sfnt more =
        face_of(2000, {{U'A', 700, {sfnt_rectangle(0, 0, 600, 600)}},
                       {U'B', 1000, {sfnt_rectangle(0, 0, 900, 1200)}},
                       {U'D', 1200, {sfnt_rectangle(0, 0, 1100, 1400)}}});
    more.kern_pairs = {{{2, 3}, -100}};
    folder_.write("text.ttf", text);
    folder_.write("more.ttf", more);
  }

  SourceFont load(const std::string& characters,
                  const std::vector<std::string>& merge) {
    FontRequest first;
    first.file = folder_.path() / "text.ttf";
    add_ranges(characters, first.characters);
    std::vector<MergedFace> more;
    for (const std::string& face : merge) {
      more.push_back(parse_merged_face(file(face)));
    }
    warnings_.clear();
    return load_faces(first, more, {}, 1, warnings_);
  }

  // The first face, an icon at U+E001 and a file with this string, of which
  // nothing may be missing.
  GenerateRequest with_icon(const std::string& line) const {
    GenerateRequest request = with_string(line);
    request.svg_files = {write("icon.svg").string() + "=0xE001"};
    return request;
  }
  // The same without an icon.
  GenerateRequest with_string(const std::string& line) const {
    GenerateRequest request;
    request.target.max_px = 16;
    request.font = folder_.path() / "text.ttf";
    request.string_files = {write("ui.txt", line)};
    request.strict = true;
    return request;
  }

  Warnings warnings_;
};

int advance_of(const SourceFont& font, char32_t c) {
  for (const SourceGlyph& glyph : font.glyphs) {
    if (glyph.code_points == std::vector<char32_t>{c}) {
      return glyph.advance;
    }
  }
  return -1;
}

TEST_F(Faces, FirstFaceThatHasACharacterGivesIt) {
  const SourceFont font = load("A-D,0x20AC", {"more.ttf"});
  ASSERT_EQ(font.glyphs.size(), 5u);
  EXPECT_EQ(advance_of(font, U'A'), 500);
  EXPECT_EQ(advance_of(font, U'B'), 500);  // 1000 of 2000
  EXPECT_EQ(advance_of(font, U'C'), 510);
  EXPECT_EQ(advance_of(font, U'D'), 600);
  EXPECT_EQ(font.metrics.units_per_em, 1000);
  EXPECT_EQ(font.missing, std::vector<char32_t>{0x20ac});
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_EQ(warnings_[0].text.substr(0, 18), "text.ttf, more.ttf");
  // In the order of code points, and kerned within a face.
  EXPECT_EQ(font.glyphs[2].code_points.front(), U'B');
  EXPECT_EQ(font.kerning.value(1, 3), -50);
  EXPECT_EQ(font.kerning.value(2, 4), -50);
  EXPECT_EQ(font.kerning.value(1, 4), 0);
  EXPECT_EQ(font.kerning.value(2, 3), 0);
  const Box box = Shape(font.glyphs[2].outline).box();
  EXPECT_NEAR(box.x1, 0.45 * 1024, 0.01);
  EXPECT_NEAR(box.y1, 0.6 * 1024, 0.01);
}

TEST_F(Faces, ListSaysWhatAFaceIsAskedFor) {
  const SourceFont font = load("C", {"more.ttf=A,D"});
  ASSERT_EQ(font.glyphs.size(), 4u);
  EXPECT_EQ(advance_of(font, U'A'), 350);  // not asked of the first face
  EXPECT_EQ(advance_of(font, U'D'), 600);
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(Faces, UnusedFaceIsTold) {
  load("A,C", {"more.ttf"});
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_EQ(warnings_[0].kind, Warning::Kind::unused_face);
}

Box box_of(const SourceFont& font, char32_t c) {
  for (const SourceGlyph& glyph : font.glyphs) {
    if (glyph.code_points == std::vector<char32_t>{c}) {
      return Shape(glyph.outline).box();
    }
  }
  return {};
}

// A face whose glyphs fill its em square, centred in its line.
Sfnt square_face(int units, int descender, const std::u32string& characters) {
  Sfnt font = face_of(units, {});
  font.ascender = units + descender;
  font.descender = descender;
  for (const char32_t c : characters) {
    font.glyphs.push_back(
        {c, units, {sfnt_rectangle(0, descender, units, units + descender)}});
  }
  return font;
}

// Capitals of text.ttf are 0.7 em high. Material Symbols, Bootstrap Icons and
// Codicons are on the baseline, MDI and Font Awesome 1/8 em below.
TEST_F(Faces, IconsStandInTheMiddleOfCapitals) {
  for (const int descender : {0, -64, -128}) {
    folder_.write("icons.ttf", square_face(512, descender, U"\ue000\u2605"));
    const SourceFont font = load("A", {"icons.ttf=0xE000,0x2605"});
    for (const char32_t c : {char32_t{0xe000}, char32_t{0x2605}}) {
      EXPECT_NEAR(box_of(font, c).y0, 0.35 * 1024 - 512, 0.01);
      EXPECT_NEAR(box_of(font, c).y1, 0.35 * 1024 + 512, 0.01);
      EXPECT_EQ(advance_of(font, c), 1000);
    }
    EXPECT_NEAR(font.faces.at(1).shift_em, 0.35 - (0.5 + descender / 512.0),
                1e-9);
  }
  EXPECT_NEAR(box_of(load("A", {"more.ttf=B"}), U'B').y0, 0, 0.01);
}

TEST_F(Faces, OnlyIconsLeaveTheirBaseline) {
  const struct {
    std::u32string has;
    const char* taken;
    bool are_icons;
  } cases[] = {{U"\ue000", "0xE000", true},
               {U"\U000f02dc", "0xF02DC", true},
               {U"\u2605", "0x2605", true},
               {U"\u2605\ue000", "0x2605,0xE000", true},
               {U"A\ue000", "0xE000", true},  // of a patched face
               {U"a\u2605\ue000", "0x2605,0xE000", true},
               {U"A\u2605", "0x2605", false},  // an arrow of a text face
               {U"a\u20ac", "0x20AC", false},
               {U"\u0e01", "0xE01", false},  // letters of another script
               {U"\u0301\ue000", "0x301,0xE000", false},
               {U"7\ue000", "0x37,0xE000", false}};
  for (const auto& at : cases) {
    folder_.write("face.ttf", square_face(500, 0, at.has));
    const SourceFont font = load("C", {std::string("face.ttf=") + at.taken});
    EXPECT_EQ(font.faces.at(1).shift_em != 0, at.are_icons) << at.taken;
  }
  // Without capitals there is no middle of them.
  Sfnt none = square_face(1000, 0, U"\ue001");
  none.cap_height = 0;
  folder_.write("text.ttf", none);
  folder_.write("face.ttf", square_face(500, 0, U"\ue000"));
  EXPECT_EQ(load("0xE001", {"face.ttf=0xE000"}).faces.at(1).shift_em, 0);
  EXPECT_TRUE(contains(
      error_of([&] { load("0xE001", {"face.ttf:height=cap=0xE000"}); }),
      "how high its capitals are"));
}

TEST_F(Faces, StandAndScaleAsAsked) {
  folder_.write("icons.ttf", square_face(512, -64, U"\ue000"));
  const auto box = [&](const std::string& settings) {
    return box_of(load("A", {"icons.ttf:" + settings + "=0xE000"}), 0xe000);
  };
  EXPECT_NEAR(box("height=cap").y0, 0, 0.01);
  EXPECT_NEAR(box("height=cap").y1, 0.7 * 1024, 0.01);
  EXPECT_NEAR(box("baseline=bottom").y0, 0, 0.01);
  EXPECT_NEAR(box("height=1.5,baseline=-0.25").y0, -256, 0.01);
  EXPECT_NEAR(box("height=1.5,baseline=-0.25").y1, 1280, 0.01);
  EXPECT_NEAR(box("baseline=own").y0, -128, 0.01);
  EXPECT_NEAR(box("height=2,baseline=own").y0, -256, 0.01);
  // Text: advances and kerning are scaled, the baseline stays.
  const SourceFont text = load("A-D", {"more.ttf:height=0.5"});
  EXPECT_NEAR(box_of(text, U'B').y0, 0, 0.01);
  EXPECT_NEAR(box_of(text, U'B').y1, 0.3 * 1024, 0.01);
  EXPECT_EQ(advance_of(text, U'B'), 250);
  EXPECT_EQ(text.kerning.value(2, 4), -25);
  EXPECT_EQ(text.kerning.value(1, 3), -50);
}

// Advances in a string are those of the scaled face.
TEST_F(Faces, StringsAreScaled) {
  GenerateRequest request = with_string("three = ABA\n");
  request.symbols = "A";
  request.merge = {file("more.ttf") + ":height=0.5"};
  const RomFont font = generate(request);
  const auto& glyphs = font.strings.at(0).glyphs;
  ASSERT_EQ(glyphs.size(), 3u);
  EXPECT_EQ(glyphs[1].x, 500);
  EXPECT_EQ(glyphs[2].x, 250);
  EXPECT_EQ(font.strings[0].advance, 1250);
}

TEST_F(Faces, HaveFacesInstancesAndAxes) {
  Sfnt source = face_of(1000, {{U'B', 500, {sfnt_rectangle(0, 0, 400, 700)}}});
  source.wght_shift = 100;
  source.instances = {{"Regular", 400}, {"Extra Black", 900}};
  folder_.write("b.ttf", source);
  Sfnt second = source;
  second.glyphs[1].advance = 600;
  folder_.write("b.ttc", build_collection({source, second}));
  const auto advance = [&](const std::string& face) {
    return advance_of(load("A,B", {face}), U'B');
  };
  EXPECT_EQ(advance("b.ttf:wght=650"), 550);
  EXPECT_TRUE(warnings_.empty());
  EXPECT_EQ(advance("b.ttf:instance=extra black=B"), 600);
  EXPECT_EQ(advance("b.ttf:instance=Extra Black,wght=650=B"), 550);
  EXPECT_EQ(advance("b.ttc:face=1,wght=400"), 600);
  EXPECT_TRUE(warnings_.empty());
  const SourceFont font = load("A,B", {"b.ttf"});
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_EQ(warnings_[0].kind, Warning::Kind::default_instance);
  EXPECT_EQ(warnings_[0].text,
            "b.ttf: is a variable font, taken at its default, wght 400 of "
            "100..900 (Regular); choose with --merge FILE:instance=NAME or "
            "FILE:TAG=VALUE, instances: Regular, Extra Black");
  EXPECT_EQ(font.faces.at(1).variation.instance(), "Regular");
}

TEST_F(Faces, SettingsAreReadAfterTheName) {
  const auto file_of = [&](const std::string& text) {
    return parse_merged_face(text).file.string();
  };
  EXPECT_EQ(file_of("x.ttf"), "x.ttf");
  EXPECT_EQ(file_of("x.ttf=A"), "x.ttf");
  EXPECT_EQ(file_of("x.ttf:wght=400"), "x.ttf");
  EXPECT_EQ(file_of("x.ttf:wght=400,FILL=1=A,0x3D"), "x.ttf");
  EXPECT_EQ(file_of("C:\\fonts\\x.ttf=A"), "C:\\fonts\\x.ttf");
  EXPECT_EQ(file_of("C:\\x.ttf:wght=400=A"), "C:\\x.ttf");
  // Names of existing files are not split.
  for (const char* name : {"x=y.ttf", "x:y=z.ttf"}) {
    const std::string there = write(name).string();
    EXPECT_EQ(file_of(there), there);
    EXPECT_EQ(file_of(there + "=A"), there);
  }
  const MergedFace face = parse_merged_face("x.ttf:wght=400,FILL=1=A,0x3D");
  ASSERT_EQ(face.axes.size(), 2u);
  EXPECT_EQ(face.axes[1].tag, "FILL");
  EXPECT_EQ(face.axes[1].value, 1);
  EXPECT_EQ(face.characters, (CharSet{U'=', U'A'}));
  const struct {
    const char* text;
    const char* said;
  } wrong[] = {
      {"x.ttf:weight=400", "'weight' is no setting; they are TAG=VALUE of"},
      {"x.ttf:wght=bold", "'wght=bold' is not TAG=VALUE"},
      {"x.ttf:wght=400,bold=A", "'bold=A' is not TAG=VALUE"},
      {"x.ttf:wght=400,FILL", "'FILL' has no value; settings are"},
      {"x.ttf:instance=", "'instance' has no value"},
      {"x.ttf:face=-1", "face is a number from 0 on"},
      {"x.ttf:height=large", "'large' is not em, cap or a number of em"},
      {"x.ttf:baseline=top=A", "'top' is not middle, bottom or a number of"}};
  for (const auto& at : wrong) {
    const std::string said = error_of([&] { parse_merged_face(at.text); });
    EXPECT_TRUE(begins_with(said, std::string("--merge '") + at.text + "': "));
    EXPECT_TRUE(contains(said, at.said));
  }
}

TEST_F(Faces, WrongListIsExplained) {
  EXPECT_TRUE(
      contains(error_of([&] { load("A", {"more.ttf=D-B"}); }), "backwards"));
  for (const char* face : {"none.ttf", "none.ttf=A", "none.ttf=B"}) {
    EXPECT_TRUE(contains(error_of([&] { load("A", {face}); }), "no such file"))
        << face;
  }
}

// Glyph 2 of text.ttf is C, that of more.ttf is B.
TEST_F(Faces, StringsPreferGlyphsOfTheFirstFace) {
  GenerateRequest request = with_icon("both = CA\n");
  request.symbols = "B\uE001";
  request.merge = {file("more.ttf")};
  const RomFont font = generate(request);
  EXPECT_TRUE(font.warnings.empty());
  const Font reader = opened(font.bytes);
  ASSERT_EQ(font.strings.size(), 1u);
  ASSERT_EQ(font.strings[0].glyphs.size(), 2u);
  EXPECT_EQ(font.strings[0].glyphs[0].glyph, reader.glyph_or_notdef(U'C'));
  EXPECT_EQ(font.strings[0].glyphs[1].glyph, reader.glyph_or_notdef(U'A'));
  EXPECT_NE(reader.glyph_or_notdef(0xe001), 0);
}

// B, which text.ttf lacks, is 1000 of 2000 units wide, 500 of its 1000. A list
// limits the characters of a face, but not those of strings.
TEST_F(Faces, StringsTakeTheRestFromTheOthers) {
  GenerateRequest request = with_string("three = ABA\n");
  request.symbols = "A";
  request.merge = {file("more.ttf") + "=D"};
  const RomFont font = generate(request);
  const Font reader = opened(font.bytes);
  const auto& glyphs = font.strings[0].glyphs;
  ASSERT_EQ(glyphs.size(), 3u);
  const uint16_t a = reader.glyph_or_notdef(U'A');
  const uint16_t b = reader.glyph_or_notdef(U'B');
  EXPECT_NE(b, 0);
  EXPECT_NE(reader.glyph_or_notdef(U'D'), 0);
  EXPECT_EQ(glyphs[0].glyph, a);
  EXPECT_EQ(glyphs[1].glyph, b);
  EXPECT_EQ(glyphs[1].x, reader.advance(a));
  EXPECT_EQ(glyphs[2].glyph, a);
  EXPECT_EQ(glyphs[2].x, 500);
  EXPECT_EQ(font.strings[0].advance, 2 * reader.advance(a) + 500);
}

// The viewBox is twice as wide as high: 2000 units, where .notdef has 600.
TEST_F(Faces, StringsHaveIcons) {
  const RomFont font = generate(with_icon("one = ACA\n"));
  EXPECT_TRUE(font.warnings.empty());
  const Font reader = opened(font.bytes);
  const uint16_t a = reader.glyph_or_notdef(U'A');
  const uint16_t c = reader.glyph_or_notdef(U'C');
  const uint16_t icon = reader.glyph_or_notdef(0xe001);
  EXPECT_NE(icon, 0);
  EXPECT_EQ(reader.advance(icon), 2000);
  const uint16_t ids[] = {a, icon, c, icon, a};
  const int steps[] = {0, 500, 2000, 510, 2000};
  const auto& glyphs = font.strings[0].glyphs;
  ASSERT_EQ(glyphs.size(), 5u);
  for (size_t i = 0; i < glyphs.size(); ++i) {
    EXPECT_EQ(glyphs[i].glyph, ids[i]) << i;
    EXPECT_EQ(glyphs[i].x, steps[i]) << i;
  }
  EXPECT_EQ(font.strings[0].advance, 500 + 2000 + 510 + 2000 + 500);
}

TEST_F(Faces, StringsTellWhatNoFaceHas) {
  GenerateRequest request = with_string("one = BZ\n");
  request.merge = {file("more.ttf")};
  request.strict = false;
  EXPECT_EQ(generate(request).report.missing, std::vector<char32_t>{U'Z'});
  request.strict = true;
  EXPECT_TRUE(contains(error_of([&] { generate(request); }), "ui.txt:1: "));
}

// Records of a merged font equal those of each face's own font.
TEST_F(Faces, MergedGlyphsAreThoseOfTheirOwnFonts) {
  for (const Coding coding : {Coding::outline, Coding::field}) {
    GenerateRequest request;
    request.target.coding = coding;
    request.target.max_px = 16;
    request.hints = false;
    request.font = folder_.path() / "text.ttf";
    request.symbols = "AC";
    const RomFont text = generate(request);
    request.font = folder_.path() / "more.ttf";
    request.symbols = "BD";
    const RomFont more = generate(request);
    request.font = folder_.path() / "text.ttf";
    request.symbols = "ABCD";
    request.merge = {file("more.ttf")};
    const RomFont merged = generate(request);
    const auto report = [](const RomFont& font, const char* name) {
      const auto& glyphs = font.report.glyphs;
      return *std::find_if(glyphs.begin(), glyphs.end(),
                           [&](const auto& g) { return g.key == name; });
    };
    for (const char* name : {"A", "B", "C", "D"}) {
      const bool is_first = *name == 'A' || *name == 'C';
      const GlyphReport own = report(is_first ? text : more, name);
      const GlyphReport got = report(merged, name);
      EXPECT_EQ(got.points, own.points) << name;
      EXPECT_EQ(got.cells, own.cells) << name;
      EXPECT_LE(got.worst_error, request.target.tolerance) << name;
    }
  }
}

}  // namespace
}  // namespace inkcell::gen::test
