// Icons: files, code points, positions.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/encode.hpp"
#include "icon_folder.hpp"
#include "inkcell/font.hpp"
#include "outlines/unite.hpp"
#include "pipeline/generate.hpp"
#include "shape/shape.hpp"
#include "source/icons.hpp"

namespace inkcell::gen::test {
namespace {

using Pairs = std::vector<std::pair<char32_t, std::string>>;

Pairs pairs_of(const std::vector<IconFile>& icons) {
  Pairs pairs;
  for (const IconFile& icon : icons) {
    pairs.emplace_back(icon.code_point, icon.name);
  }
  return pairs;
}

TEST_F(Icons, FolderGivesCodePointsByNameOrFromE000) {
  for (const char* name :
       {"wifi-off.svg", "0xE002-home 2.svg", "U+E000.svg", "uE123_a.svg",
        "1f600.svg", "feed.svg", "ufeed.svg", "beef-1.svg", "x.txt"}) {
    write(name);
  }
  EXPECT_EQ(pairs_of(find_icons({}, {folder_.path()})),
            (Pairs{{0xe000, "UE000"},
                   {0xe001, "Beef1"},
                   {0xe002, "Home2"},
                   {0xe003, "Feed"},
                   {0xe004, "Ufeed"},
                   {0xe005, "WifiOff"},
                   {0xe123, "A"},
                   {0x1f600, "U1F600"}}));
}

TEST_F(Icons, ListOfAFolderChooses) {
  for (const char* name : {"a.svg", "b.svg", "c.svg"}) {
    write(name);
  }
  write("codepoints", "# chosen\nc e010\n\nb E00F # last\n");
  EXPECT_EQ(pairs_of(find_icons({file("a.svg=U+41")}, {folder_.path()})),
            (Pairs{{0x41, "A"}, {0xe00f, "B"}, {0xe010, "C"}}));
  EXPECT_EQ(icon_lists({folder_.path()}).size(), 1u);
}

TEST_F(Icons, WrongFilesAndCodePointsAreExplained) {
  write("a.svg");
  write("b.svg");
  const auto text = [&](const std::vector<std::string>& files) {
    return error_of([&] { find_icons(files, {}); });
  };
  for (const char* wrong :
       {"a.svg", "=0xE000", "a.svg=", "a.svg=x1", "a.svg=0x41-0x42"}) {
    EXPECT_TRUE(contains(text({wrong}), "is not FILE=CODE"));
  }
  EXPECT_TRUE(
      contains(text({"a.svg=0xE000", "b.svg=0xE000"}), "that of a.svg"));
  EXPECT_TRUE(
      contains(text({"a.svg=0xE000", "x/a.svg=0xE001"}), "would be kA"));
  EXPECT_TRUE(contains(text({"a.svg=0x9F"}), "no printable code point"));
  const auto folder = [&](const std::filesystem::path& path) {
    return error_of([&] { find_icons({}, {path}); });
  };
  EXPECT_TRUE(contains(folder("none"), "is no folder"));
  EXPECT_TRUE(contains(folder(TestFolder().path()), "holds no file *.svg"));
  write("codepoints", "a e000\nb\n");
  EXPECT_TRUE(contains(folder(folder_.path()), "codepoints:2: 'b'"));
}

struct Placed {
  Box box;  // [u]
  int advance;
};

TEST_F(Icons, LieBesideLettersAsAsked) {
  write("box.svg");
  const auto placed = [&](const char* height, const char* baseline) {
    IconPlace place;
    parse_icon_height(height, place);
    parse_icon_baseline(baseline, place);
    SourceFont font = font_for_icons();
    add_icons(find_icons({file("box.svg=0xE000")}, {}), place, false, font);
    return Placed{Shape(font.glyphs[1].outline).box(), font.glyphs[1].advance};
  };
  // Capitals are 0.7 em high: 717 u.
  const Placed middle = placed("em", "middle");
  EXPECT_NEAR(middle.box.y0, 358.5 - 512, 0.01);
  EXPECT_NEAR(middle.box.y1, 358.5 + 512, 0.01);
  EXPECT_NEAR(middle.box.x0, 0, 0.01);
  EXPECT_NEAR(middle.box.x1, 2048, 0.01);
  EXPECT_EQ(middle.advance, 2048);
  const Placed cap = placed("cap", "middle");
  EXPECT_NEAR(cap.box.y0, 0, 0.01);
  EXPECT_NEAR(cap.box.y1, 717, 0.01);
  EXPECT_EQ(cap.advance, 1434);
  const Placed low = placed("1.5", "-0.25");
  EXPECT_NEAR(low.box.y0, -256, 0.01);
  EXPECT_NEAR(low.box.y1, 1280, 0.01);
  EXPECT_NEAR(placed("1", "bottom").box.y0, 0, 0.01);
  IconPlace place;
  EXPECT_NE(error_of([&] { parse_icon_height("large", place); }), "no error");
  EXPECT_NE(error_of([&] { parse_icon_baseline("top", place); }), "no error");
}

TEST_F(Icons, NeedASizeAndAFreeCodePoint) {
  write("none.svg", "<svg><path d='M0 0h9v9z'/></svg>");
  write("bad.svg", "<svg viewBox='0 0 9 0'/>");
  write("size.svg", "<svg width='9px' height='9'><path d='M0 0h9v9z'/></svg>");
  write("torn.svg", "<svg>\n<path");
  write("page.svg", "<html/>");
  const auto text = [&](const std::string& icon) {
    return error_of([&] {
      GenerateRequest request;
      request.font = folder_.write("plain.ttf", Sfnt::plain());
      request.symbols = "H";
      request.svg_files = {file(icon)};
      generate(request);
    });
  };
  EXPECT_TRUE(contains(text("none.svg=0xE000"), "add a viewBox"));
  EXPECT_TRUE(contains(text("bad.svg=0xE000"), "a viewBox is four"));
  EXPECT_TRUE(
      contains(text("torn.svg=0xE000"), "torn.svg: line 2: is no sound XML"));
  EXPECT_TRUE(
      contains(text("page.svg=0xE000"), "page.svg: has no element <svg>"));
  EXPECT_TRUE(contains(text("gone.svg=0xE000"), "no such file"));
  EXPECT_TRUE(
      contains(text("size.svg=0x48"), "a character of plain.ttf already"));
  EXPECT_EQ(text("size.svg=0xE000"), "no error");
}

// Where round ends and joins coincide, a union of chords has hundreds of
// segments.
TEST_F(Icons, StrokesThatMeetStayCurves) {
  const char* drawings[] = {
      // back to the start, in decimals
      "M3.634 15.634l1.732-1l1 1.732l-1.732 1l-1-1.732",
      // a stroke that ends where curves pass, drawn 1/1000 beside it
      "M16.007 7.54a5.965 5.965 0 0 0-4.008-1.54a6 6 0 0 0-5.992 6c0 3.314 "
      "2.682 6 5.992 6a5.965 5.965 0 0 0 4-1.536M12 20v-2",
      // three ends in a point, and a piece of 1/1000
      "M16.023 9.348h4.992v-.001M2.985 19.644v-4.992m0 0h4.992m-4.993 0 3.181 "
      "3.183",
      // the end of a stroke on the middle of another
      "M5 4h14M12.3 4v9"};
  for (const char* drawing : drawings) {
    write("a.svg", std::string("<svg viewBox='0 0 24 24' fill='none' "
                               "stroke='#000' stroke-width='2' "
                               "stroke-linecap='round' "
                               "stroke-linejoin='round'><path d='") +
                       drawing + "'/></svg>");
    SourceFont font = font_for_icons();
    add_icons(find_icons({file("a.svg=0xE000")}, {}), IconPlace(), false, font);
    const Outline& outline = font.glyphs[1].outline;
    size_t segments = 0;
    size_t curves = 0;
    for (const Contour& contour : unite(outline).contours) {
      for (const Segment& segment : contour.segments) {
        ++segments;
        curves += segment.kind == Segment::Kind::line ? 0 : 1;
      }
    }
    EXPECT_GT(curves, 0u) << drawing;
    EXPECT_LT(segments, 100u) << drawing;
    GenerateRequest request;
    request.svg_files = {file("a.svg=0xE000")};
    EXPECT_LE(generate(request).report.worst_error, 16) << drawing;
  }
}

TEST_F(Icons, HaveConstantsInSource) {
  write("wifi-off.svg");
  GenerateRequest request;
  request.svg_files = {file("wifi-off.svg=0xE001")};
  request.target.max_px = 16;
  const RomFont font = generate(request);
  const std::string hpp = encode(font, OutputFormat::hpp, "ui");
  EXPECT_TRUE(
      contains(hpp,
               "namespace ui_icons {\ninline constexpr char kWifiOff[] = "
               "\"\\xEE\\x80\\x81\";  // U+E001, wifi-off.svg\n"));
  const std::string macro =
      "#define ui_icons_WifiOff \"\\xEE\\x80\\x81\" /* U+E001, wifi-off.svg "
      "*/\n";
  EXPECT_TRUE(contains(encode(font, OutputFormat::c, "ui"), macro));
  EXPECT_TRUE(contains(encode_c_header(font, "ui"), macro));
}

}  // namespace
}  // namespace inkcell::gen::test
