// Morphs of digits: from font files to section MORP, and to pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "glyph_outlines.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/port/a8.hpp"
#include "messages.hpp"
#include "morph/find_morph.hpp"
#include "morph/master_morph.hpp"
#include "morph_font.hpp"
#include "morph_reader.hpp"
#include "outline_reader.hpp"
#include "outlines/outline_steps.hpp"
#include "pipeline/generate.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen::test {
namespace {

using motion::OutlineMorph;
using Polygons = std::vector<std::vector<Point>>;

constexpr int kSteps = 16;
constexpr int kSide = 136;  // of a canvas [px]
constexpr Q26_6 kSize = Q26_6::from_int(96);
constexpr inkcell::Point kOrigin = {16, 84};

const char* const kFaces[] = {
    kDejaVuSans, "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", kLiberationSerif,
    kRoboto};

bool cross_each_other(const Point& a,
                      const Point& b,
                      const Point& c,
                      const Point& d) {
  const auto side = [](const Point& from, const Point& to, const Point& at) {
    return cross(to - from, at - from);
  };
  constexpr double kSlack = 1e-3;  // twice an area [grid units]
  const auto apart = [](double x, double y) {
    return std::min(x, y) < -kSlack && std::max(x, y) > kSlack;
  };
  return apart(side(a, b, c), side(a, b, d)) &&
         apart(side(c, d, a), side(c, d, b));
}

int crossings(const Polygons& polygons) {
  std::vector<std::pair<Point, Point>> edges;
  for (const auto& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      edges.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  int count = 0;
  for (size_t i = 0; i < edges.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      count += cross_each_other(edges[i].first, edges[i].second, edges[j].first,
                                edges[j].second)
                   ? 1
                   : 0;
    }
  }
  return count;
}

double area(const Polygons& polygons) {
  double twice = 0;
  for (const auto& polygon : polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  return twice / 2;
}

// How far a series is from one that only rises or only falls.
double detour(const std::vector<double>& values) {
  const double sign = values.back() >= values.front() ? 1 : -1;
  double top = sign * values.front();
  double most = 0;
  for (const double value : values) {
    top = std::max(top, sign * value);
    most = std::max(most, top - sign * value);
  }
  return most / std::max(std::abs(values.front()), std::abs(values.back()));
}

// How far a series leaves what lies between its ends.
double beyond(const std::vector<double>& values) {
  const auto [least, most] = std::minmax(values.front(), values.back());
  double far = 0;
  for (const double value : values) {
    far = std::max({far, least - value, value - most});
  }
  return far / most;
}

using Pixels = std::vector<uint8_t>;

// What `draw` draws with a painter.
template <typename Draw>
Pixels drawn(const Draw& draw) {
  alignas(4) static uint8_t ram[8192];
  Pixels pixels(size_t{kSide} * kSide);
  const port::A8Canvas canvas(
      {{pixels.data(), pixels.size()}, 0, 0, kSide, kSide, kSide});
  draw(Painter(canvas, Span<uint8_t>(ram)));
  return pixels;
}

Pixels frame(const OutlineMorph& morph, int step) {
  return drawn([&](const Painter& painter) {
    morph.draw(painter, Style(kSize), kOrigin,
               Q16_16::from_raw(step * 65536 / kSteps));
  });
}

Pixels plain(const Font& font, int glyph) {
  return drawn([&](const Painter& painter) {
    painter.glyph(font, Style(kSize), kOrigin, static_cast<uint16_t>(glyph));
  });
}

// The coverage of a frame. [px]
double ink(const OutlineMorph& morph, int step) {
  double sum = 0;
  for (const uint8_t pixel : frame(morph, step)) {
    sum += pixel / 255.0;
  }
  return sum;
}

// Figures of all pairs of digits of a face: they are printed.
class DigitMorphs : public testing::TestWithParam<const char*> {};

TEST_P(DigitMorphs, KeepTheirAreaAndDoNotCross) {
  const char* const file = GetParam();
  const MorphFont& digits = digits_of(file, "0123456789");
  const std::vector<uint8_t> section =
      bytes_of(digits.font.section(format::section::kMorphs));
  const std::vector<MorphEntry> pairs = read_morphs(section);
  double worst_area = 0;
  double worst_ink = 0;
  for (const MorphEntry& pair : pairs) {
    const std::string name = std::string(file) + ", glyphs " +
                             std::to_string(pair.first) + " and " +
                             std::to_string(pair.second);
    const MinimalOutline first = digits.outline_of(pair.first);
    const MinimalOutline second = digits.outline_of(pair.second);
    OutlineMorph morph;
    ASSERT_EQ(OutlineMorph::open(digits.font, static_cast<uint16_t>(pair.first),
                                 static_cast<uint16_t>(pair.second), morph),
              Status::ok)
        << name;
    std::vector<double> areas;
    std::vector<double> inks;
    for (int step = 0; step <= kSteps; ++step) {
      const Polygons polygons = read_morph(
          pair.record, first, second, static_cast<double>(step) / kSteps, 5);
      areas.push_back(area(polygons));
      inks.push_back(ink(morph, step));
      for (const auto& polygon : polygons) {
        ASSERT_FALSE(polygon.empty()) << name << ": a contour is open";
      }
      if (step != 0 && step != kSteps) {
        ASSERT_EQ(crossings(polygons), 0) << name << ", step " << step;
      }
    }
    const double error = beyond(areas);
    worst_area = std::max(worst_area, error);
    worst_ink = std::max(worst_ink, beyond(inks));
    EXPECT_LE(error, 0.05) << name;
    EXPECT_LE(beyond(inks), 0.05) << name;
  }
  std::printf(
      "%s: %zu of 45 pairs, %zu bytes, area off by %.1f %% at worst, ink by "
      "%.1f %%\n",
      file, pairs.size(), section.size(), 100 * worst_area, 100 * worst_ink);
  EXPECT_LE(section.size(), 60 * pairs.size()) << file;
}

INSTANTIATE_TEST_SUITE_P(Faces, DigitMorphs, testing::ValuesIn(kFaces));

struct Masters {
  const char* file;
  std::vector<const char*> axes;
};

// Figures of printable ASCII of a variable font: they are printed.
class MasterMorphs : public testing::TestWithParam<Masters> {};

TEST_P(MasterMorphs, KeepTheirAreaAndDoNotCross) {
  const auto& [file, axes] = GetParam();
  GenerateRequest request;
  request.font = file;
  request.target.max_px = 96;
  for (const char* const axis : axes) {
    request.axes.push_back(parse_axis_range(axis));
  }
  const MorphFont letters(request);
  EXPECT_TRUE(letters.warnings.empty());
  const std::vector<uint8_t> section =
      bytes_of(letters.font.section(format::section::kMorphs));
  const std::vector<MorphEntry> pairs = read_morphs(section);
  const size_t masters = section.at(6) + size_t{section.at(7)} * 256;
  EXPECT_EQ(letters.font.glyph_count(), masters + pairs.size());
  int composites = 0;
  double worst_area = 0;
  double worst_ink = 0;
  for (const MorphEntry& pair : pairs) {
    const std::string name =
        std::string(file) + ", glyph " + std::to_string(pair.first);
    const auto first = static_cast<uint16_t>(pair.first);
    OutlineMorph morph;
    ASSERT_EQ(OutlineMorph::open_master(letters.font, first, morph), Status::ok)
        << name;
    ASSERT_EQ(morph.to(), pair.second) << name;
    ASSERT_GE(morph.to(), masters) << name;
    EXPECT_EQ(frame(morph, 0), plain(letters.font, pair.first)) << name;
    EXPECT_EQ(frame(morph, kSteps), plain(letters.font, pair.second)) << name;
    if (letters.font.record(first).size == 0) {
      EXPECT_EQ(ink(morph, kSteps / 2), 0) << name;
      continue;
    }
    std::vector<double> inks;
    for (int step = 0; step <= kSteps; ++step) {
      inks.push_back(ink(morph, step));
    }
    worst_ink = std::max(worst_ink, detour(inks));
    EXPECT_LE(detour(inks), kMostMasterAreaError + 0.01) << name;
    if (letters.is_composite(pair.first) || letters.is_composite(pair.second)) {
      ++composites;  // the plain reader below reads none
      continue;
    }
    std::vector<double> areas;
    for (int step = 0; step <= kSteps; ++step) {
      const Polygons polygons =
          read_morph(pair.record, letters.outline_of(pair.first),
                     letters.outline_of(pair.second),
                     static_cast<double>(step) / kSteps, 5);
      areas.push_back(area(polygons));
      if (step != 0 && step != kSteps) {
        ASSERT_EQ(crossings(polygons), 0) << name << ", step " << step;
      }
    }
    worst_area = std::max(worst_area, detour(areas));
    EXPECT_LE(detour(areas), kMostMasterAreaError + 0.001) << name;
  }
  std::printf(
      "%s %s: %zu of 94 letters, %d by their ink alone, %zu bytes, area off by "
      "%.1f %% at worst, ink by %.1f %%\n",
      file, axes.front(), pairs.size() - 1, composites, section.size(),
      100 * worst_area, 100 * worst_ink);
  EXPECT_EQ(pairs.size(), 95u);  // with the blank, whose advance changes
  EXPECT_LE(composites, 4);
  EXPECT_LE(section.size(), 20 * pairs.size());
}

INSTANTIATE_TEST_SUITE_P(
    Faces,
    MasterMorphs,
    testing::Values(Masters{kInterVariable, {"wght=300..800"}},
                    Masters{kInterVariable, {"wght=900..100"}},
                    Masters{kInterVariable, {"slnt=0..-10", "wght=300..800"}},
                    Masters{kInterItalicVariable, {"wght=300..800"}}));

// Between two masters a variable font moves its points along lines, too: half
// of the way is the font's own weight in the middle, but for the fit.
TEST(MasterMorphs, HalfWayIsTheWeightInTheMiddle) {
  GenerateRequest request;
  request.font = kInterVariable;
  request.target.max_px = 96;
  request.axes = {parse_axis_range("wght=400..900")};
  const MorphFont letters(request);
  FontRequest middle;
  middle.file = request.font;
  middle.axes = {parse_axis("wght=650")};
  for (const uint32_t c : ascii()) {
    middle.characters.insert(c);
  }
  Warnings warnings;
  const SourceFont truth = load_font(middle, 1, warnings);
  double worst = 0;
  double sum = 0;
  size_t count = 0;
  for (const MorphEntry& pair :
       read_morphs(bytes_of(letters.font.section(format::section::kMorphs)))) {
    const auto found = std::find_if(
        truth.glyphs.begin(), truth.glyphs.end(), [&](const SourceGlyph& of) {
          return !of.code_points.empty() &&
                 letters.font.glyph_or_notdef(of.code_points.front()) ==
                     static_cast<uint32_t>(pair.first);
        });
    if (found == truth.glyphs.end() || letters.is_composite(pair.first) ||
        letters.is_composite(pair.second)) {
      continue;
    }
    const Shape shape(found->outline);
    for (const auto& polygon :
         read_morph(pair.record, letters.outline_of(pair.first),
                    letters.outline_of(pair.second), 0.5, 4)) {
      for (const Point& p : polygon) {
        const double x = p.x * letters.grid_u();
        const double y = p.y * letters.grid_u();
        const double off = std::abs(shape.distance(x, y));
        worst = std::max(worst, off);
        sum += off;
        ++count;
      }
    }
  }
  const double mean = sum / static_cast<double>(count);
  std::printf("%zu points, off by %.2f u, %.2f at worst\n", count, mean, worst);
  EXPECT_GT(count, 5000u);
  EXPECT_LE(mean, 0.1);
  EXPECT_LE(worst, 2);
}

TEST(Morph, RecordIsThatOfTheDocument) {
  // A contour of two triangles.
  const std::vector<uint8_t> record = {0x34, 0x19, 0x08};
  const MinimalOutline first = {
      {{{{0, 0, kCorner}, {100, 0, kCorner}, {0, 100, kCorner}}}}};
  const MinimalOutline second = {
      {{{{0, 300, kCorner}, {200, 100, kCorner}, {300, 300, kCorner}}}}};
  const Polygons middle = read_morph(record, first, second, 0.5, 1);
  ASSERT_EQ(middle.size(), 1u);
  ASSERT_EQ(middle[0].size(), 3u);
  // From 0, 0 and 200, 100 on.
  EXPECT_EQ(middle[0][0].x, 100);
  EXPECT_EQ(middle[0][0].y, 50);
  EXPECT_EQ(middle[0][1].x, 200);
  EXPECT_EQ(middle[0][1].y, 150);
  EXPECT_EQ(middle[0][2].x, 0);
  EXPECT_EQ(middle[0][2].y, 200);
}

TEST(Morph, GroupsArePairedAndTheRestIsNot) {
  const MorphFont& digits = digits_of(kDejaVuSans, "01 23");
  const auto opens = [&digits](char from, char to) {
    OutlineMorph morph;
    return OutlineMorph::open(
               digits.font,
               digits.font.glyph_or_notdef(static_cast<uint32_t>(from)),
               digits.font.glyph_or_notdef(static_cast<uint32_t>(to)),
               morph) == Status::ok;
  };
  EXPECT_TRUE(opens('0', '1'));
  EXPECT_TRUE(opens('1', '0'));
  EXPECT_TRUE(opens('2', '3'));
  EXPECT_FALSE(opens('1', '2'));
  EXPECT_FALSE(opens('0', '3'));
}

std::string refusal(const GenerateRequest& request) {
  return error_of([&] { generate(request); });
}

TEST(Morph, RefusesWhatItCannotPair) {
  GenerateRequest request;
  request.font = kDejaVuSans;
  request.morphs = {"12 3"};
  EXPECT_EQ(
      refusal(request),
      "--morph U+0033 '3': a glyph morphs into another one; name at least two "
      "characters, such as 01");
  request.morphs = {"\xee\x80\x81"};
  EXPECT_TRUE(begins_with(refusal(request), "--morph U+E001: a glyph"));
  request.morphs = {"12"};
  request.target.coding = Coding::field;
  EXPECT_EQ(refusal(request),
            "--morph moves outlines; use --coding outline, or leave it out");
  request.target.coding = Coding::outline;
  request.morphs = {"1\xee\x84\xa3"};  // U+E123
  request.strict = true;
  EXPECT_TRUE(contains(refusal(request), "--morph: "));
}

TEST(Morph, RefusesMastersThatFontsCannotHold) {
  GenerateRequest request;
  request.font = kInterVariable;
  request.axes = {parse_axis_range("wght=300..950")};
  EXPECT_EQ(refusal(request),
            "Inter.var.ttf: wght=950 is out of range; the axes are wght "
            "100..900 (default 400), slnt -10..0 (default 0)");
  request.axes = {parse_axis_range("wght=300..800")};
  request.target.coding = Coding::field;
  EXPECT_EQ(refusal(request),
            "--axis with two values makes outlines that morph; use --coding "
            "outline, or give one value");
  request.target.coding = Coding::outline;
  request.paged = 512;
  EXPECT_EQ(refusal(request),
            "--axis with two values needs a font in mapped memory; leave "
            "--paged out, or give one value");
}

std::string refused_axis(const char* text) {
  return error_of([&] { parse_axis_range(text); });
}

TEST(Morph, ReadsAxesThatMove) {
  const AxisSetting moved = parse_axis_range("opsz=14.5..-32");
  EXPECT_EQ(moved.tag, "opsz");
  EXPECT_EQ(moved.value, 14.5);
  EXPECT_EQ(moved.second, -32);
  EXPECT_FALSE(parse_axis_range("wght=300").second);
  for (const char* const text : {"wght=..800", "wght=300..", "wght=3..4..5"}) {
    EXPECT_EQ(refused_axis(text),
              "'" + std::string(text) +
                  "' is not TAG=FROM..TO, such as wght=300..800");
  }
  EXPECT_EQ(refused_axis("wght=300..300"),
            "'wght=300..300' moves nothing: both masters are at the same "
            "place; give two values, such as wght=300..800");
}

// A triangle of three lines.
Contour triangle(double x, double y) {
  return polygon({{x, y}, {x + 300, y}, {x, y + 300}});
}

// How far the cuts of two contours that were one are apart, at their ends. [u]
double gap_between_parts(const MorphPair& pair, double progress) {
  std::vector<Point> ends;
  const MorphPolygons polygons = morph_polygons(pair, progress, 1);
  for (size_t i = 0; i < pair.contours.size(); ++i) {
    const auto& pieces = pair.contours[i].pieces;
    for (size_t k = 0; k < pieces.size(); ++k) {
      if (pieces[k].side[1].move == MorphMove::jump) {
        ends.push_back(polygons[i][k]);
        ends.push_back(polygons[i][(k + 1) % pieces.size()]);
      }
    }
  }
  EXPECT_EQ(ends.size(), 4u);
  // One runs up, the other one down.
  return std::max(length(ends[0] - ends[3]), length(ends[1] - ends[2]));
}

TEST(Morph, BoxesStayBoxes) {
  const Outline low = outline({rectangle(0, 0, 100, 200)});
  const Outline full = outline({rectangle(0, 0, 600, 200)});
  const std::optional<MorphPair> pair = find_morph(low, full);
  ASSERT_TRUE(pair);
  const MorphPolygons half = morph_polygons(*pair, 0.5, 1);
  ASSERT_EQ(half.size(), 1u);
  ASSERT_EQ(half[0].size(), 4u);
  for (const Point& p : half[0]) {
    EXPECT_TRUE(p.x == 0 || p.x == 350) << p.x;
    EXPECT_TRUE(p.y == 0 || p.y == 200) << p.y;
  }
}

TEST(Morph, ContoursSplitAndJoin) {
  // Two bars become one triangle, as pause becomes play: each bar is a part.
  const Outline pause =
      outline({rectangle(100, 0, 300, 700), rectangle(450, 0, 650, 700)});
  const Outline play = outline({polygon({{100, 0}, {700, 350}, {100, 700}})});
  const std::optional<MorphPair> pair = find_morph(pause, play);
  ASSERT_TRUE(pair);
  ASSERT_EQ(pair->contours.size(), 2u);
  EXPECT_TRUE(quality_of(*pair).crossings.empty());
  // The cut is closed for the last eighth of the time.
  EXPECT_EQ(gap_between_parts(*pair, 1), 0);
  EXPECT_EQ(gap_between_parts(*pair, 0.9), 0);
  EXPECT_GT(gap_between_parts(*pair, 0.5), 20);
  // Two become two, the near ones each other.
  const Outline left = outline({triangle(0, 0), triangle(400, 0)});
  const Outline right = outline({triangle(420, 40), triangle(20, 40)});
  const std::optional<MorphPair> both = find_morph(left, right);
  ASSERT_TRUE(both);
  ASSERT_EQ(both->contours.size(), 2u);
  for (const MorphContour& contour : both->contours) {
    for (const MorphPiece& piece : contour.pieces) {
      EXPECT_LT(length(piece.side[0].p[0] - piece.side[1].p[0]), 50);
    }
  }
}

// How far the morph is from its mirror image: across x = 350, or y = 350. [u]
double unlike_image(const MorphPair& pair, double progress, bool is_upright) {
  std::vector<Point> points;
  for (const auto& polygon : morph_polygons(pair, progress, 4)) {
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  double most = 0;
  for (const Point& p : points) {
    const Point image =
        is_upright ? Point{700 - p.x, p.y} : Point{p.x, 700 - p.y};
    double least = kInfinity;
    for (const Point& other : points) {
      least = std::min(least, length(other - image));
    }
    most = std::max(most, least);
  }
  return most;
}

TEST(Morph, MirrorImagesStayMirrorImages) {
  const Outline play = outline({polygon({{100, 0}, {700, 350}, {100, 700}})});
  const Outline pause =
      outline({rectangle(100, 0, 300, 700), rectangle(450, 0, 650, 700)});
  const Outline up = outline({polygon({{50, 0}, {650, 0}, {350, 500}})});
  const Outline house = outline(
      {polygon({{100, 50}, {600, 50}, {600, 400}, {350, 600}, {100, 400}})});
  const Outline tie = outline({polygon({{0, 0},
                                        {400, 100},
                                        {700, 0},
                                        {600, 350},
                                        {700, 700},
                                        {400, 600},
                                        {0, 700}})});
  const struct {
    const Outline& first;
    const Outline& second;
    bool is_upright;
  } kPairs[] = {{play, pause, false}, {pause, play, false}, {up, house, true},
                {house, up, true},    {play, tie, false},   {tie, play, false}};
  for (const auto& [first, second, is_upright] : kPairs) {
    const std::optional<MorphPair> pair = find_morph(first, second);
    ASSERT_TRUE(pair);
    EXPECT_TRUE(quality_of(*pair).is_within(kMostAreaError));
    for (int i = 0; i <= kSteps; ++i) {
      EXPECT_LT(unlike_image(*pair, double{1} * i / kSteps, is_upright), 1e-6);
    }
  }
}

TEST(Morph, MastersSayWhatBecomesWhat) {
  // Both bars move to the right: the nearest one is not the partner.
  const Outline first =
      outline({rectangle(0, 0, 400, 100), rectangle(0, 300, 400, 400)});
  const Outline second =
      outline({rectangle(50, 300, 450, 410), rectangle(1200, 300, 1500, 420)});
  const std::optional<MorphPair> pair =
      find_master_morph(first, second, {first, second});
  ASSERT_TRUE(pair);
  ASSERT_EQ(pair->contours.size(), 2u);
  const MorphPolygons end = morph_polygons(*pair, 1, 1);
  EXPECT_EQ(end[0][0].x, 50);
  EXPECT_EQ(end[1][0].x, 1200);
  // Other numbers of points: the masters say nothing.
  EXPECT_FALSE(find_master_morph(
      first, second, {first, outline({triangle(0, 0), triangle(400, 0)})}));
}

TEST(Morph, NothingMorphsIntoABlank) {
  EXPECT_FALSE(find_morph(outline({triangle(0, 0)}), Outline()));
}

}  // namespace
}  // namespace inkcell::gen::test
