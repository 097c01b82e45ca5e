// Opens and exports a face: outlines, advances and kerning stay the same, as
// read by FreeType and HarfBuzz.
#include <gtest/gtest.h>

#include <algorithm>

#include "export/rom.hpp"
#include "export/tables.hpp"
#include "export/ttf.hpp"
#include "fixtures.hpp"
#include "model/contours.hpp"
#include "pipeline/built_glyphs.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::test {
namespace {

constexpr const char* kCharacters = "0x20-0x7E,0xA0-0x17F,0x1D400-0x1D402";

gen::SourceFont load(const std::filesystem::path& file) {
  gen::FontRequest request;
  request.file = file;
  gen::add_ranges(kCharacters, request.characters);
  request.with_components = true;
  gen::Warnings warnings;
  return gen::load_font(request, 1, warnings);
}

std::filesystem::path written(const TemporaryFolder& folder,
                              const std::vector<uint8_t>& bytes) {
  const std::filesystem::path file = folder.path() / "font.ttf";
  write_bytes(file, bytes);
  return file;
}

std::filesystem::path written(const TemporaryFolder& folder,
                              const Project& project) {
  return written(folder, write_ttf(project));
}

// Contours of a single point are marks in some fonts; they enclose nothing.
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

void expect_same(const gen::OutlineReferences& a,
                 const gen::OutlineReferences& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].glyph, b[i].glyph);
    EXPECT_EQ(a[i].dx, b[i].dx);
    EXPECT_EQ(a[i].dy, b[i].dy);
    EXPECT_EQ(a[i].matrix_q14, b[i].matrix_q14);
  }
}

class Face : public testing::TestWithParam<const char*> {};

TEST_P(Face, OpenedAndExportedIsTheSame) {
  const std::filesystem::path source =
      std::string("/usr/share/fonts/truetype/") + GetParam();
  const gen::SourceFont before = load(source);
  const TemporaryFolder folder;
  const gen::SourceFont after =
      load(written(folder, face(GetParam(), kCharacters)));
  EXPECT_EQ(after.name, before.name);
  EXPECT_EQ(after.metrics.ascender, before.metrics.ascender);
  EXPECT_EQ(after.metrics.descender, before.metrics.descender);
  EXPECT_EQ(after.metrics.line_gap, before.metrics.line_gap);
  EXPECT_EQ(after.metrics.x_height, before.metrics.x_height);
  EXPECT_EQ(after.metrics.cap_height, before.metrics.cap_height);
  ASSERT_EQ(after.glyphs.size(), before.glyphs.size());
  size_t kerned = 0;
  size_t composites = 0;
  for (size_t i = 0; i < before.glyphs.size(); ++i) {
    SCOPED_TRACE(before.glyphs[i].name());
    EXPECT_EQ(after.glyphs[i].code_points, before.glyphs[i].code_points);
    EXPECT_EQ(after.glyphs[i].advance, before.glyphs[i].advance);
    expect_same(after.glyphs[i].outline, before.glyphs[i].outline);
    expect_same(after.components[i], before.components[i]);
    composites += after.components[i].empty() ? 0u : 1u;
    for (size_t k = 0; k < before.glyphs.size(); ++k) {
      const int value = before.kerning.empty() ? 0 : before.kerning.value(i, k);
      EXPECT_EQ(after.kerning.empty() ? 0 : after.kerning.value(i, k), value);
      kerned += value != 0 ? 1 : 0;
    }
  }
  EXPECT_EQ(kerned != 0, !before.kerning.empty());
  EXPECT_GT(composites, 100u);
}

INSTANTIATE_TEST_SUITE_P(
    Faces,
    Face,
    testing::Values("dejavu/DejaVuSans.ttf",
                    "liberation/LiberationSerif-Italic.ttf",
                    "roboto/unhinted/RobotoTTF/Roboto-Regular.ttf"));

// Cubics become quadratics without a visible difference.
TEST(Ttf, CubicsKeepTheirShape) {
  Project project;
  add_glyph(project, "a", {U'a'},
            R"([[[100,0,"curve"],[100,200,"offcurve"],[600,300,"offcurve"],
            [500,700,"curve"],[300,900,"offcurve"],[-300,400,"offcurve"]]])");
  const gen::Shape before(outline_of(project, *project.glyph("a")));
  const TemporaryFolder folder;
  const gen::SourceFont font = load(written(folder, project));
  ASSERT_EQ(font.glyphs.size(), 2u);
  EXPECT_EQ(font.glyphs[1].advance, 600);
  const gen::Shape after(font.glyphs[1].outline);
  for (const gen::Edge& edge : after.edges()) {
    // A third of a unit, and the rounding of points to integers.
    EXPECT_LT(std::fabs(before.distance(edge.a.x, edge.a.y)), 1.1);
  }
}

// Each of kern and GPOS alone has all of the kerning.
TEST(Ttf, KerningIsInBothTables) {
  const Project project = face("lato/Lato-Regular.ttf", "0x20-0x7E,0xC0-0xFF");
  const KerningLookup lookup(*project.font);
  for (const std::string table : {"kern", "GPOS"}) {
    std::vector<uint8_t> bytes = write_ttf(project);
    const auto tag =
        std::search(bytes.begin(), bytes.end(), table.begin(), table.end());
    ASSERT_NE(tag, bytes.end());
    *tag = 'x';
    const TemporaryFolder folder;
    const gen::SourceFont font = load(written(folder, bytes));
    size_t pairs = 0;
    for (size_t i = 1; i < font.glyphs.size(); ++i) {
      for (size_t k = 1; k < font.glyphs.size(); ++k) {
        const auto name = [&](size_t glyph) {
          for (const auto& [found, each] : project.front().glyphs) {
            if (!each->unicodes.empty() &&
                each->unicodes == font.glyphs[glyph].code_points) {
              return found;
            }
          }
          return std::string();
        };
        const int value = font.kerning.empty() ? 0 : font.kerning.value(i, k);
        pairs += value != 0 ? 1u : 0u;
        if (i % 7 == 0 && k % 5 == 0) {
          EXPECT_EQ(value, lookup.value(name(i), name(k)));
        }
      }
    }
    EXPECT_GT(pairs, 1000u) << "without " << table;
  }
}

TEST(Ttf, LeavesOutPartsAndDrawsNotdef) {
  Project project;
  const char* triangle = "[[[0,0],[99,0],[9,99]]]";
  add_glyph(project, "_stem", {}, triangle);
  add_glyph(project, "accent", {}, triangle);
  add_glyph(project, "unused", {}, triangle);
  add_glyph(project, "A", {U'A'}, "[]", {{"_stem", {}, ""}});
  add_glyph(project, "B", {U'B'}, "[]", {{"accent", {}, ""}});
  TtfReport report;
  const TemporaryFolder folder;
  const std::vector<uint8_t> bytes = write_ttf(project, &report);
  EXPECT_EQ(report.left_out, (std::vector<std::string>{"_stem", "unused"}));
  const gen::SourceFont font = load(written(folder, bytes));
  ASSERT_EQ(font.glyphs.size(), 4u);  // .notdef, A, B and its component
  EXPECT_EQ(font.glyphs[0].outline.contours.size(), 2u);
  EXPECT_FALSE(gen::Shape(font.glyphs[0].outline).empty());
  EXPECT_EQ(font.glyphs[1].outline.contours.size(), 1u);
  EXPECT_TRUE(font.components[1].empty());
  EXPECT_EQ(font.components[2].size(), 1u);
}

// Two faces whose hhea and OS/2 differ, with and without USE_TYPO_METRICS.
TEST(Ttf, HeightsAndNoticesStayAsTheyWere) {
  for (const char* name : {"lato/Lato-BoldItalic.ttf", "dejavu/DejaVuSans.ttf",
                           "roboto/unhinted/RobotoTTF/Roboto-Regular.ttf"}) {
    Project before = face(name, "A");
    for (const char* selection : {"[]", "[7]"}) {
      run(before, {{"do", "set_info"},
                   {"key", "openTypeOS2Selection"},
                   {"value", Value::parse(selection)}});
      run(before, {{"do", "set_info"},
                   {"key", "openTypeOS2TypoLineGap"},
                   {"value", 123}});
      const TemporaryFolder folder;
      gen::Warnings warnings;
      const Project after =
          import_font(written(folder, before), {U'A'}, warnings);
      Value info = after.font->info;
      // The height that counts depends on the selection.
      for (const char* key : {"ascender", "descender"}) {
        info[key] = before.font->info[key];
      }
      EXPECT_EQ(info, before.font->info);
      EXPECT_TRUE(before.font->info.contains("copyright"));
      const gen::SourceFont read = load(written(folder, before));
      EXPECT_EQ(read.metrics.line_gap,
                std::string(selection) == "[7]"
                    ? 123
                    : before.font->info["openTypeHheaLineGap"].get<int>());
    }
  }
}

TEST(Ttf, NamesTheGlyphThatDoesNotFit) {
  Project project;
  add_glyph(project, "huge", {U'h'}, "[[[0,0],[40000,0],[0,10]]]");
  const std::string refusal = refusal_of([&] { write_ttf(project); });
  EXPECT_EQ(refusal.rfind("glyph 'huge': ", 0), 0u);
}

// Composite glyphs, drawn by FreeType.
class Components : public testing::Test {
 protected:
  Components() {
    add("d", R"([[[100,0],[400,0],[400,700],[100,700]],
                 [[200,100],[200,500],[300,500],[300,100]]])");
    add("flag", "[[[450,100],[700,120],[650,300]]]");
    add("space", "[]");
  }

  void add(const std::string& name,
           const char* contours,
           const std::vector<ComponentUse>& components = {}) {
    add_glyph(project_, name, {U'A' + count_++}, contours, components);
  }

  static ComponentUse use(const char* base, const Matrix& matrix) {
    return {base, matrix, ""};
  }

  // The number of components in the file; -1 if FreeType draws another shape.
  int components_of(const std::string& name) {
    const GlyphPointer glyph = project_.glyph(name);
    const TemporaryFolder folder;
    const gen::SourceFont font = load(written(folder, project_));
    const gen::Shape truth(outline_of(project_, *glyph));
    for (size_t i = 0; i < font.glyphs.size(); ++i) {
      if (font.glyphs[i].code_points ==
          std::vector<char32_t>(glyph->unicodes)) {
        const gen::Shape drawn(font.glyphs[i].outline);
        return are_near(truth, drawn)
                   ? static_cast<int>(font.components[i].size())
                   : -1;
      }
    }
    return -1;
  }

  // Within 1.5 font units on the border of either: components round the points
  // of others, and FreeType those of the components.
  static bool are_near(const gen::Shape& a, const gen::Shape& b) {
    constexpr double kBound_u = 1.6;
    const auto lies_on = [](const gen::Shape& shape, const gen::Shape& other) {
      for (const gen::Edge& edge : shape.edges()) {
        const double x = (edge.a.x + edge.b.x) / 2;
        const double y = (edge.a.y + edge.b.y) / 2;
        if (std::fabs(other.distance(x, y)) > kBound_u) {
          return false;
        }
      }
      return true;
    };
    return !a.empty() && lies_on(a, b) && lies_on(b, a);
  }

  Project project_;
  char32_t count_ = 0;
};

TEST_F(Components, StayReferences) {
  add("moved", "[]",
      {use("d", {}), use("space", {}), use("flag", {1, 0, 0, 1, 30.4, -900})});
  EXPECT_EQ(components_of("moved"), 2);
  add("scaled", "[]", {use("d", {0.7, 0, 0, 1.3, 0, 0})});
  EXPECT_EQ(components_of("scaled"), 1);
  add("turned", "[]", {use("d", {0.6, 0.8, -0.8, 0.6, 10, 20})});
  EXPECT_EQ(components_of("turned"), 1);
  add("reflected", "[]", {use("d", {-1, 0, 0, 1, 0, 0}), use("flag", {})});
  EXPECT_EQ(components_of("reflected"), 2);
  add("nested", "[]",
      {use("moved", {0.5, 0, 0, -0.5, 0, 0}), use("d", {1, 0, 0, 1, 400, 0})});
  EXPECT_EQ(components_of("nested"), 2);
  add("overlapping", "[]", {use("d", {}), use("flag", {1, 0, 0, 1, -100, 0})});
  EXPECT_EQ(components_of("overlapping"), 2);
}

TEST_F(Components, BecomeContoursWhereNoRecordStatesThem) {
  add("mixed", "[[[500,0],[600,0],[600,50]]]", {use("d", {})});
  EXPECT_EQ(components_of("mixed"), 0);
  add("large", "[]", {use("d", {2, 0, 0, 1, 0, 0})});
  EXPECT_EQ(components_of("large"), 0);
  add("wide", "[[[0,0],[8000,0],[8000,8000]]]");
  add("inexact", "[]", {use("wide", {0.70003, 0, 0, 0.70003, 0, 0})});
  EXPECT_EQ(components_of("inexact"), 0);
  add("crossing", "[]", {use("d", {}), use("flag", {-1, 0, 0, 1, 600, 0})});
  EXPECT_EQ(components_of("crossing"), 0);
}

TEST_F(Components, AreReferencesInAnInkcellFont) {
  add("moved", "[]", {use("d", {}), use("flag", {1, 0, 0, 1, 30, -900})});
  EXPECT_EQ(make_rom(project_, {}).report.composites, 1u);
  add("meeting", "[]", {use("d", {}), use("flag", {1, 0, 0, 1, -100, 0})});
  EXPECT_EQ(make_rom(project_, {}).report.composites, 1u);
}

TEST_F(Components, NameWhatIsWrong) {
  add("loop", "[]", {use("loop", {})});
  const std::string refusal = refusal_of([&] { write_ttf(project_); });
  EXPECT_EQ(refusal.rfind("glyph 'loop': ", 0), 0u);
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

// A font that reuses built glyphs, beside the same font built anew.
class Rebuilt : public testing::Test {
 protected:
  void change(const Value& command) { run(project_, command); }

  // Outlines that were reused.
  size_t reused() {
    gen::GenerateRequest request = request_;
    const gen::RomFont whole = make_rom(project_, request);
    request.built_glyphs = &glyphs_;
    const gen::RomFont font = make_rom(project_, request);
    EXPECT_EQ(font.bytes, whole.bytes);
    EXPECT_EQ(font.report.glyphs.size(), whole.report.glyphs.size());
    for (size_t i = 0; i < whole.report.glyphs.size(); ++i) {
      EXPECT_EQ(font.report.glyphs[i].worst_error,
                whole.report.glyphs[i].worst_error);
      EXPECT_EQ(font.report.glyphs[i].worst_px,
                whole.report.glyphs[i].worst_px);
    }
    return glyphs_.reused();
  }

  Project project_ = face("dejavu/DejaVuSans.ttf", "A-F,0xC1");
  gen::GenerateRequest request_;
  gen::BuiltGlyphs glyphs_;
};

TEST_F(Rebuilt, OnlyChangedOutlinesAreBuilt) {
  EXPECT_EQ(reused(), 0u);
  const size_t all = 9;  // .notdef, A to F, Aacute and the acute accent
  EXPECT_EQ(reused(), all);
  change({{"do", "move_points"},
          {"glyph", "B"},
          {"points", Value::parse("[[0, 0]]")},
          {"dx", 13},
          {"dy", 5}});
  EXPECT_EQ(reused(), all - 1);
  change({{"do", "set_advance"}, {"glyph", "C"}, {"width", 1500}});
  EXPECT_EQ(reused(), all);
  change({{"do", "transform"}, {"glyph", "A"}, {"matrix", {{"scale", 0.9}}}});
  EXPECT_EQ(reused(), all - 2);  // A and Aacute
}

TEST_F(Rebuilt, OtherConditionsBuildAllAnew) {
  EXPECT_EQ(reused(), 0u);
  request_.target.tolerance = 4;
  EXPECT_EQ(reused(), 0u);
  // A glyph that forces a coarser grid on all.
  change({{"do", "transform"}, {"glyph", "F"}, {"matrix", {{"scale", 7}}}});
  EXPECT_EQ(reused(), 0u);
}

}  // namespace
}  // namespace inkcell::design::test
