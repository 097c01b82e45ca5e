// A face opened and exported: the same outlines, advances and kerning, as
// FreeType and HarfBuzz read them.
#include <gtest/gtest.h>

#include <fstream>

#include "export/tables.hpp"
#include "export/ttf.hpp"
#include "folders.hpp"
#include "import/font_import.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "shape/shape.hpp"
#include "source/font_source.hpp"

namespace inkcell::design::test {
namespace {

gen::SourceFont load(const std::filesystem::path& file) {
  gen::FontRequest request;
  request.file = file;
  gen::add_ranges("0x20-0x7E,0xC0-0xFF,0x1D400-0x1D402", request.characters);
  gen::Warnings warnings;
  return gen::load_font(request, 1, warnings);
}

std::filesystem::path written(const TemporaryFolder& folder,
                              const Project& project) {
  const std::filesystem::path file = folder.path() / "font.ttf";
  const std::vector<uint8_t> bytes = write_ttf(project);
  write_text(file, std::string(bytes.begin(), bytes.end()));
  return file;
}

// Contours of a single point mark places in some fonts; they enclose nothing.
std::vector<gen::Contour> with_ink(const gen::Outline& outline) {
  std::vector<gen::Contour> contours;
  for (const gen::Contour& contour : outline.contours) {
    if (contour.segments.size() > 1) {
      contours.push_back(contour);
    }
  }
  return contours;
}

void expect_same(const gen::Outline& a, const gen::Outline& b) {
  const std::vector<gen::Contour> first = with_ink(a);
  const std::vector<gen::Contour> second = with_ink(b);
  ASSERT_EQ(first.size(), second.size());
  for (size_t c = 0; c < first.size(); ++c) {
    ASSERT_EQ(first[c].segments.size(), second[c].segments.size());
    for (size_t s = 0; s < first[c].segments.size(); ++s) {
      const gen::Segment& p = first[c].segments[s];
      const gen::Segment& q = second[c].segments[s];
      ASSERT_EQ(p.kind, q.kind);
      for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(p.p[i].x, q.p[i].x);
        EXPECT_EQ(p.p[i].y, q.p[i].y);
      }
    }
  }
}

class Face : public testing::TestWithParam<const char*> {};

TEST_P(Face, OpenedAndExportedIsTheSame) {
  const std::filesystem::path source =
      std::string("/usr/share/fonts/truetype/") + GetParam();
  const gen::SourceFont before = load(source);
  gen::CharSet characters;
  gen::add_ranges("0x20-0x7E,0xC0-0xFF,0x1D400-0x1D402", characters);
  gen::Warnings warnings;
  const TemporaryFolder folder;
  const gen::SourceFont after =
      load(written(folder, import_font(source, characters, warnings)));
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.metrics.ascender, before.metrics.ascender);
  EXPECT_EQ(after.metrics.descender, before.metrics.descender);
  EXPECT_EQ(after.metrics.line_gap, before.metrics.line_gap);
  EXPECT_EQ(after.metrics.x_height, before.metrics.x_height);
  EXPECT_EQ(after.metrics.cap_height, before.metrics.cap_height);
  ASSERT_EQ(after.glyphs.size(), before.glyphs.size());
  size_t kerned = 0;
  for (size_t i = 0; i < before.glyphs.size(); ++i) {
    SCOPED_TRACE(before.glyphs[i].name());
    EXPECT_EQ(after.glyphs[i].code_points, before.glyphs[i].code_points);
    EXPECT_EQ(after.glyphs[i].advance, before.glyphs[i].advance);
    expect_same(after.glyphs[i].outline, before.glyphs[i].outline);
    for (size_t k = 0; k < before.glyphs.size(); ++k) {
      const int value = before.kerning.empty() ? 0 : before.kerning.value(i, k);
      EXPECT_EQ(after.kerning.empty() ? 0 : after.kerning.value(i, k), value);
      kerned += value != 0 ? 1 : 0;
    }
  }
  EXPECT_EQ(kerned != 0, !before.kerning.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Faces,
    Face,
    testing::Values("dejavu/DejaVuSans.ttf",
                    "liberation/LiberationSerif-Italic.ttf",
                    "roboto/unhinted/RobotoTTF/Roboto-Regular.ttf"));

// Cubics become quadratics that nobody can tell from them.
TEST(Ttf, CubicsKeepTheirShape) {
  Project project;
  Glyph glyph;
  glyph.name = "a";
  glyph.width = 600;
  glyph.unicodes = {U'a'};
  glyph.contours.push_back(parse_contour(Value::parse(
      R"([[100,0,"curve"],[100,200,"offcurve"],[600,300,"offcurve"],
          [500,700,"curve"],[300,900,"offcurve"],[-300,400,"offcurve"]])")));
  const gen::Shape before(outline_of(project, glyph));
  project.front().glyphs["a"] = std::make_shared<const Glyph>(glyph);
  const TemporaryFolder folder;
  const gen::SourceFont font = load(written(folder, project));
  ASSERT_EQ(font.glyphs.size(), 2u);
  EXPECT_EQ(font.glyphs[1].advance, 600);
  const gen::Shape after(font.glyphs[1].outline);
  for (const gen::Edge& edge : after.edges()) {
    // A third of a unit, and the rounding of points to whole ones.
    EXPECT_LT(std::fabs(before.distance(edge.a.x, edge.a.y)), 1.1);
  }
}

TEST(Ttf, NamesTheGlyphThatDoesNotFit) {
  Project project;
  Glyph glyph;
  glyph.name = "huge";
  glyph.contours.push_back(
      parse_contour(Value::parse("[[0,0],[40000,0],[0,10]]")));
  project.front().glyphs["huge"] = std::make_shared<const Glyph>(glyph);
  try {
    write_ttf(project);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).rfind("glyph 'huge': ", 0), 0u);
  }
}

TEST(Kerning, PairsOfGlyphsComeBeforeGroups) {
  FontData font;
  font.groups = {{"public.kern1.A", {"A", "B"}}, {"public.kern2.V", {"V"}}};
  font.kerning = {{"public.kern1.A", {{"public.kern2.V", -50}, {"W", -20}}},
                  {"B", {{"V", 7}}}};
  const KerningLookup lookup(font);
  EXPECT_EQ(lookup.value("A", "V"), -50);
  EXPECT_EQ(lookup.value("B", "V"), 7);
  EXPECT_EQ(lookup.value("B", "W"), -20);
  EXPECT_EQ(lookup.value("V", "A"), 0);
}

}  // namespace
}  // namespace inkcell::design::test
