// UFO 3: files that are read are written again; foreign data survives.
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "ufo/file_names.hpp"
#include "ufo/glif.hpp"
#include "ufo/plist.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design::test {
namespace {

class Ufo : public testing::Test {
 protected:
  Ufo() : path_(folder_.path() / "Test.ufo") { make_foreign_ufo(path_); }

  TemporaryFolder folder_;
  std::filesystem::path path_;
};

TEST_F(Ufo, SavedUnchangedIsTheSameBytes) {
  const auto before = contents_of(path_);
  UfoFiles files = read_ufo(path_);
  write_ufo(files.project, path_, files);
  EXPECT_EQ(contents_of(path_), before);
  EXPECT_EQ(before.size(), 15u);
}

TEST_F(Ufo, OnlyTheChangedGlyphIsWrittenAnew) {
  const auto before = contents_of(path_);
  UfoFiles files = read_ufo(path_);
  Project project = files.project;
  run(project, {{"do", "set_advance"}, {"glyph", "A"}, {"width", 701}});
  write_ufo(project, path_, files);
  auto after = contents_of(path_);
  const Glyph a = parse_glif(after["glyphs/A_.glif"], "A_.glif");
  after["glyphs/A_.glif"] = before.at("glyphs/A_.glif");
  EXPECT_EQ(after, before);
  // Everything but the advance is unchanged.
  Glyph old = parse_glif(before.at("glyphs/A_.glif"), "A_.glif");
  old.width = 701;
  EXPECT_EQ(a, old);
  EXPECT_EQ(a.lib["com.foreign.tool"]["blob"].get_binary(),
            Value::binary_t({0, 1, 2, 255}));
}

TEST_F(Ufo, GlyphsComeBackAsTheyWereWritten) {
  const UfoFiles files = read_ufo(path_);
  for (const auto& [name, glyph] : files.project.front().glyphs) {
    EXPECT_EQ(parse_glif(write_glif(*glyph), name), *glyph) << name;
  }
}

TEST_F(Ufo, GoesToAnotherFolderWithAllFiles) {
  const auto before = contents_of(path_);
  UfoFiles files = read_ufo(path_);
  write_ufo(files.project, folder_.path() / "Copy.ufo", files);
  EXPECT_EQ(contents_of(folder_.path() / "Copy.ufo"), before);
  EXPECT_EQ(contents_of(path_), before);
}

TEST_F(Ufo, PicturesStayWhileAGlyphNamesThem) {
  write_text(path_ / "images/other.png", "of no glyph");
  const auto before = contents_of(path_);
  UfoFiles files = read_ufo(path_);
  Project project = files.project;
  run(project, {{"do", "set_image"}, {"glyph", "o"}, {"file", "A.png"}});
  run(project, {{"do", "set_image"}, {"glyph", "A"}});
  write_ufo(project, path_, files);
  EXPECT_EQ(contents_of(path_)["images/A.png"], before.at("images/A.png"));
  run(project, {{"do", "decompose"}, {"glyph", "aacute"}});
  run(project, {{"do", "delete_glyph"}, {"glyph", "o"}});
  write_ufo(project, path_, files);
  EXPECT_EQ(contents_of(path_).count("images/A.png"), 0u);
  EXPECT_EQ(contents_of(path_)["images/other.png"], "of no glyph");
}

TEST_F(Ufo, APictureThatIsMissingIsNoError) {
  std::filesystem::remove(path_ / "images/A.png");
  const auto before = contents_of(path_);
  UfoFiles files = read_ufo(path_);
  EXPECT_TRUE(files.project.font->images.empty());
  write_ufo(files.project, path_, files);
  EXPECT_EQ(contents_of(path_), before);
}

TEST_F(Ufo, ErrorsNameTheFile) {
  const auto refusal = [this] {
    return refusal_of([this] { read_ufo(path_); });
  };
  const std::string glif = (path_ / "glyphs/o.glif").string();
  write_text(glif, "<glyph name=\"o\">\n<outline>\n</glyph>\n");
  EXPECT_EQ(refusal().rfind(glif + ":3: ", 0), 0u) << refusal();
  write_text(glif, R"(<glyph name="o" format="2"><outline><contour>
      <point x="1" y="2" type="spline"/></contour></outline></glyph>)");
  EXPECT_EQ(refusal(), glif +
                           ": glyph 'o': point type 'spline' is not known; "
                           "use move, line, curve, qcurve or offcurve");
  std::filesystem::remove(glif);
  EXPECT_EQ(refusal(), glif +
                           ": is missing; glyphs/contents.plist lists it "
                           "for the glyph 'o'");
}

TEST(Plist, KeepsEveryKindOfValue) {
  Value value = {{"a", -5},
                 {"b", 0.1},
                 {"c", {true, false, "text <&> \n line"}},
                 {"d", Value::binary({1, 2, 3, 4})},
                 {"e", Value::object()},
                 {"f", 3u},
                 {"", "empty key"}};
  EXPECT_EQ(parse_plist(write_plist(value), "test"), value);
}

TEST(FileNames, FollowTheRulesOfUfo) {
  std::set<std::string> taken;
  EXPECT_EQ(glif_file_name("a", taken), "a.glif");
  EXPECT_EQ(glif_file_name("A", taken), "A_.glif");
  EXPECT_EQ(glif_file_name("A_", taken), "A__.glif");
  EXPECT_EQ(glif_file_name(".notdef", taken), "_notdef.glif");
  EXPECT_EQ(glif_file_name("con", taken), "_con.glif");
  EXPECT_EQ(glif_file_name("a.con.x", taken), "a._con.x.glif");
  EXPECT_EQ(glif_file_name("f/i", taken), "f_i.glif");
  EXPECT_EQ(glif_file_name("f:i", taken), "f_i000000000000001.glif");
}

}  // namespace
}  // namespace inkcell::design::test
