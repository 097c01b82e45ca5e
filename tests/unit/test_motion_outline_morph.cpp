// Outlines that become others: their ends, what lies between, lines of them,
// and any bytes.
#include "check.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/weight_pulse.hpp"
#include "inkcell/painter.hpp"
#include "outline_record.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;
using namespace outline_record;

constexpr int32_t kSide = 56;
constexpr Point kOrigin = {4, 50};
// A u is a 16th of a px: what lies half-way is exact.
constexpr Q26_6 kSize = 64_px;
constexpr Q16_16 kHalf = Q16_16::from_raw(1 << 15);

// Glyph 3 lies between 1 and 2, 6 between 4 and 5, 9 between 7 and 8.
constexpr OutlinePoint kBarAndEll[] = {{start, 150, 0},    {corner, 500, 0},
                                       {corner, 500, 88},  {corner, 318, 88},
                                       {corner, 318, 690}, {corner, 150, 690}};
constexpr OutlinePoint kSquare[] = {
    {start, 0, 0}, {corner, 640, 0}, {corner, 640, 640}, {corner, 0, 640}};
constexpr OutlinePoint kWideFrame[] = {{start, 0, 0},      {corner, 640, 0},
                                       {corner, 640, 640}, {corner, 0, 640},
                                       {start, 160, 160},  {corner, 160, 480},
                                       {corner, 480, 480}, {corner, 480, 160}};
constexpr OutlinePoint kNarrowFrame[] = {
    {start, 0, 0},      {corner, 640, 0},  {corner, 640, 640},
    {corner, 0, 640},   {start, 240, 240}, {corner, 240, 400},
    {corner, 400, 400}, {corner, 400, 240}};

OutlinePoint moved_disc[2][13];

// The pairs 1 2, 4 5, 7 8.
constexpr uint32_t kPairs = 3;
constexpr size_t kRecordBytes = 16;

void put_stop(BitWriter& bits, uint32_t width, uint32_t point, uint32_t part) {
  bits.put(point, width);
  bits.put(part, 3);
}

void begin(BitWriter& bits, uint32_t kind, uint32_t pieces) {
  bits.put(kind, 2);
  bits.put(pieces, 7);
}

// The bar's right side makes the inner corner of the L.
size_t write_bar_and_ell(Span<uint8_t> out) {
  BitWriter bits(out);
  bits.put(3, 4);
  begin(bits, 1, 6);
  put_stop(bits, 3, 1, 0);
  put_stop(bits, 3, 1, 0);
  bits.put(0, 2);
  bits.put(6, 3);  // an 8th of the side
  bits.put(1, 3);
  bits.put(0, 1);
  bits.put(2, 2);  // stays
  bits.put(0, 1);
  bits.put(0, 6);
  bits.put(0, 2);
  return bits.bytes();
}

size_t write_discs(Span<uint8_t> out) {
  BitWriter bits(out);
  bits.put(4, 4);
  begin(bits, 1, 12);
  put_stop(bits, 4, 5, 0);
  put_stop(bits, 4, 5, 0);
  bits.put(0, 24);
  bits.put(0, 2);
  return bits.bytes();
}

// The frame's hole is born at a quarter of the way.
constexpr uint32_t kBirth = 4;
constexpr uint32_t kSwell = 0;

size_t write_frame(Span<uint8_t> out) {
  BitWriter bits(out);
  bits.put(4, 4);
  begin(bits, 1, 4);
  put_stop(bits, 4, 1, 0);
  put_stop(bits, 4, 1, 0);
  bits.put(0, 8);
  begin(bits, 2, 4);
  put_stop(bits, 4, 1, 4);
  put_stop(bits, 4, 3, 4);
  bits.put(kBirth, 4);
  bits.put(kSwell, 3);
  put_stop(bits, 4, 6, 0);
  bits.put(0, 4);
  bits.put(0, 2);
  return bits.bytes();
}

// Rows of 4, 4 and 8 bits.
constexpr size_t kTable = 8;
constexpr size_t kTableEnd = kTable + 2 * kPairs;
constexpr size_t kMorphBytes = kTableEnd + kPairs * kRecordBytes;

size_t write_morphs(uint8_t (&out)[kMorphBytes]) {
  for (uint8_t& byte : out) {
    byte = 0;
  }
  font_builder::put_u16(out, kPairs);
  out[2] = 4;
  out[3] = 8;
  font_builder::put_u16(out + 4, 80);
  size_t (*const write[])(Span<uint8_t>) = {write_bar_and_ell, write_discs,
                                            write_frame};
  for (uint32_t i = 0; i < kPairs; ++i) {
    const uint32_t first = 1 + 3 * i;
    out[kTable + 2 * i] = static_cast<uint8_t>(first | (first + 1) << 4);
    out[kTable + 2 * i + 1] = static_cast<uint8_t>(i * kRecordBytes);
    CHECK(write[i]({out + kTableEnd + i * kRecordBytes, kRecordBytes}) <=
          kRecordBytes);
  }
  return kMorphBytes;
}

alignas(4) uint8_t font_bytes[1024];
size_t font_size;

void build_font() {
  uint8_t morphs[kMorphBytes];
  const size_t size = write_morphs(morphs);
  for (int32_t k = 0; k < 2; ++k) {
    for (size_t i = 0; i < 13; ++i) {
      moved_disc[k][i] = kDisc[i];
      const int32_t moved = 32 * (k + 1);
      moved_disc[k][i].x = static_cast<int16_t>(kDisc[i].x + moved);
    }
  }
  const OutlineSource glyphs[] = {
      {600, {kBar, 4}},           {600, {kBar, 4}},
      {600, {kEll, 6}},           {600, {kBarAndEll, 6}},
      {768, {kDisc, 13}},         {768, {moved_disc[1], 13}},
      {768, {moved_disc[0], 13}}, {640, {kSquare, 4}},
      {640, {kWideFrame, 8}},     {640, {kNarrowFrame, 8}}};
  font_size =
      build_outline_font({glyphs, 10}, 0, 'A', font_bytes, {}, {morphs, size});
  CHECK(font_size != 0);
}

const Font& font_of_morphs() {
  static Font font;
  if (font.glyph_count() == 0) {
    build_font();
    CHECK_OK(Font::open({font_bytes, font_size}, font));
  }
  return font;
}

using Page = Picture<kSide, kSide, Overlap::greatest>;
Page picture;
Page expected;
alignas(8) uint8_t ram[2048];

void draw(const OutlineMorph& morph,
          const Style& style,
          Q16_16 progress,
          size_t ram_bytes = sizeof ram,
          int32_t rows = kSide) {
  picture.clear();
  picture.draw_strips(rows, [&](const Sink& sink) {
    morph.draw(Painter(sink, Workspace(ram, ram_bytes)), style, kOrigin,
               progress);
  });
}

void draw_plain(uint16_t glyph, const Style& style) {
  expected.clear();
  Painter(expected.sink(), Workspace(ram, sizeof ram))
      .glyph(font_of_morphs(), style, kOrigin, glyph);
}

OutlineMorph morph_of(uint16_t from, uint16_t to) {
  OutlineMorph morph;
  CHECK_OK(OutlineMorph::open(font_of_morphs(), from, to, morph));
  CHECK_EQ(morph.from(), from);
  CHECK_EQ(morph.to(), to);
  return morph;
}

}  // namespace

TEST(ends_are_plain_glyphs) {
  const Style style(kSize);
  for (uint16_t from = 1; from <= 7; from = static_cast<uint16_t>(from + 3)) {
    const auto to = static_cast<uint16_t>(from + 1);
    const int32_t kEnds[] = {INT32_MIN, 0, 63, 1 << 16, INT32_MAX};
    for (const int32_t raw : kEnds) {
      draw(morph_of(from, to), style, Q16_16::from_raw(raw));
      draw_plain(raw < 64 ? from : to, style);
      CHECK(picture == expected);
      draw(morph_of(to, from), style, Q16_16::from_raw(raw));
      draw_plain(raw < 64 ? to : from, style);
      CHECK(picture == expected);
    }
  }
}

// Exact areas are those of chords, whose number depends on where curves are
// cut: the implied points of a disc are points of its morph.
TEST(half_way_lies_what_is_between) {
  const struct {
    Style style;
    int32_t most;
  } kLooks[] = {{Style(kSize), 4},
                {Style(kSize, kFilterText), 0},
                {Style(kSize, kFilterMotion), 0}};
  for (const auto& look : kLooks) {
    for (uint16_t from = 1; from <= 7; from = static_cast<uint16_t>(from + 3)) {
      const auto to = static_cast<uint16_t>(from + 1);
      const int32_t most = from == 4 ? look.most : 0;
      draw_plain(static_cast<uint16_t>(from + 2), look.style);
      draw(morph_of(from, to), look.style, kHalf);
      CHECK(picture.difference(expected) <= most);
      draw(morph_of(to, from), look.style, kHalf);
      CHECK(picture.difference(expected) <= most);
    }
  }
}

// The hole of 320 u is born at 1/4, and has half of its size 1/32 later.
TEST(holes_are_born_within_a_16th) {
  const Style style(kSize);
  const OutlineMorph morph = morph_of(7, 8);
  draw_plain(7, style);
  for (int32_t step = 1; step <= 8; ++step) {
    draw(morph, style, Q16_16::from_raw(step << 11));
    CHECK(picture == expected);
  }
  // 320 u x 9/32 / 2 = 45 u: 2.8 px.
  draw(morph, style, Q16_16::from_raw(9 << 11));
  const int32_t before = expected.ink();
  CHECK(before - picture.ink() > 7 * 255 && before - picture.ink() < 9 * 255);
  CHECK_EQ(picture.at(4 + 20, 50 - 20), 0);
  // 100 u: 6.25 px.
  draw(morph, style, Q16_16::from_raw(10 << 11));
  CHECK(before - picture.ink() > 38 * 255 && before - picture.ink() < 40 * 255);
}

TEST(strips_and_boxes_of_morphs) {
  const Style style(kSize);
  const OutlineMorph morph = morph_of(1, 2);
  for (int32_t raw = 0; raw <= 1 << 16; raw += 1 << 12) {
    const Q16_16 progress = Q16_16::from_raw(raw);
    draw(morph, style, progress);
    expected = picture;
    CHECK(picture.ink() > 0);
    CHECK(picture.lies_in(morph.box(style, kOrigin, progress)));
    draw(morph, style, progress, sizeof ram, 5);
    CHECK(picture == expected);
    draw(morph, style, progress,
         OutlineMorph::workspace_bytes(font_of_morphs()));
    CHECK(picture == expected);
  }
}

TEST(frames_keep_their_points) {
  alignas(4) static uint8_t points[1024];
  const Style style(kSize);
  const OutlineMorph morph = morph_of(4, 5);
  for (int32_t raw = 0; raw <= 1 << 16; raw += 1 << 13) {
    const Q16_16 progress = Q16_16::from_raw(raw);
    draw(morph, style, progress);
    expected = picture;
    picture.clear();
    MorphFrame frame(morph, style, kOrigin, progress,
                     Workspace(points, sizeof points));
    picture.draw_strips(7,
                        [&](const Sink& sink) { frame.draw(Painter(sink)); });
    CHECK(picture == expected);
  }
  picture.clear();
  MorphFrame(morph, style, kOrigin, kHalf, Workspace(points, 200))
      .draw(Painter(picture.sink()));
  CHECK_EQ(picture.ink(), 0);
}

TEST(small_workspaces_draw_the_ends_only) {
  const Style style(kSize);
  const size_t kSizes[] = {0, 100};
  for (const size_t size : kSizes) {
    // 53 points, more than the stack has room for.
    draw(morph_of(4, 5), style, kHalf, size);
    CHECK_EQ(picture.ink(), 0);
    draw(morph_of(4, 5), style, Q16_16(), size);
    draw_plain(4, style);
    CHECK(picture == expected);
  }
}

TEST(pairs_that_fonts_do_not_hold) {
  const Font& font = font_of_morphs();
  OutlineMorph morph;
  CHECK(OutlineMorph::open(font, 1, 3, morph) == Status::no_glyph);
  CHECK(OutlineMorph::open(font, 1, 10, morph) == Status::no_glyph);
  CHECK(OutlineMorph::open(font, 60000, 1, morph) == Status::no_glyph);
  CHECK(OutlineMorph::open(Font(), 0, 0, morph) == Status::no_glyph);
  const Style style(kSize);
  CHECK(is_empty(morph.box(style, kOrigin, kHalf)));
  draw(morph, style, kHalf);
  CHECK_EQ(picture.ink(), 0);
  CHECK_OK(OutlineMorph::open(font, 3, 3, morph));
  draw(morph, style, kHalf);
  draw_plain(3, style);
  CHECK(picture == expected);
}

// The font, in which a byte of the section became another.
Font font_with(size_t at, uint8_t value) {
  build_font();
  Font font;
  CHECK_OK(Font::open({font_bytes, font_size}, font));
  const Span<const uint8_t> section = font.section(format::section::kMorphs);
  font_bytes[section.data - font_bytes + static_cast<ptrdiff_t>(at)] = value;
  return font;
}

TEST(masters_of_glyphs) {
  // Glyph 2 is the second master of 1, 5 that of 4, 8 that of 7.
  Font font = font_with(6, 5);
  OutlineMorph morph;
  CHECK_OK(OutlineMorph::open_master(font, 4, morph));
  CHECK_EQ(morph.from(), 4);
  CHECK_EQ(morph.to(), 5);
  CHECK_OK(OutlineMorph::open_master(font, 7, morph));
  CHECK_EQ(morph.to(), 8);
  const uint16_t kOthers[] = {0, 1, 2, 3, 5, 8, 9, 10, 0xffff};
  for (const uint16_t glyph : kOthers) {
    CHECK(OutlineMorph::open_master(font, glyph, morph) == Status::no_glyph);
    CHECK_EQ(morph.to(), 8);
    CHECK_EQ(OutlineMorph::to_master(font, glyph).to(), glyph < 10 ? glyph : 0);
  }
  CHECK_EQ(OutlineMorph::to_master(font, 7).to(), 8);
  // There are none.
  font = font_with(6, 0);
  CHECK(OutlineMorph::open_master(font, 4, morph) == Status::no_glyph);
  CHECK(OutlineMorph::open_master(Font(), 0, morph) == Status::no_glyph);
  build_font();
}

TEST(morphs_in_poses) {
  const Font& font = font_of_morphs();
  PoseRenderer renderer(font, kSize);
  PosedGlyph glyph;
  glyph.at = {28_px, 28_px};
  glyph.pivot_x = glyph.pivot_y = Q16_16::from_int(24);
  glyph.pose.angle.raw = 5000;
  glyph.pose.scale_y = Scale::from_raw(2600);
  glyph.pose.opacity = 200;
  const OutlineMorph morph = morph_of(4, 5);
  const auto draw_pose = [&](bool morphs, int32_t rows) {
    picture.clear();
    picture.draw_strips(rows, [&](const Sink& sink) {
      const Painter painter(sink, Workspace(ram));
      glyph.glyph = morphs ? 4 : 6;
      if (morphs) {
        renderer.draw(glyph, morph, kHalf, painter);
      } else {
        renderer.draw({&glyph, 1}, painter);
      }
    });
  };
  draw_pose(false, kSide);
  expected = picture;
  draw_pose(true, kSide);
  CHECK(picture.difference(expected) <= 2);  // points are rounded twice
  const Rect box = renderer.box(glyph, morph, kHalf);
  int32_t ink = 0;
  for (const auto [x, y] : pixels_of(kSide, kSide)) {
    ink += picture.at(x, y);
    CHECK(picture.at(x, y) == 0 || holds(box, x, y));
  }
  CHECK(ink > 100 * 200);
  expected = picture;
  draw_pose(true, 5);
  CHECK(picture == expected);
  glyph.pose.opacity = 0;
  draw_pose(true, kSide);
  expected.clear();
  CHECK(picture == expected);
  CHECK(is_empty(renderer.box(glyph, morph, kHalf)));
}

TEST(advances_between_glyphs) {
  // 768 and 640 units of 1024: 48 and 40 px.
  // The pair 6 7 in place of 7 8.
  const Font font = font_with(kTable + 4, 6 | 7 << 4);
  const Style style(kSize);
  OutlineMorph morph;
  CHECK_OK(OutlineMorph::open(font, 6, 7, morph));
  CHECK_EQ(morph.advance(style, Q16_16()).raw, 48 * 64);
  CHECK_EQ(morph.advance(style, kHalf).raw, 44 * 64);
  CHECK_EQ(morph.advance(style, Q16_16::from_int(1)).raw, 40 * 64);
  CHECK_EQ(morph.advance(style, Q16_16::from_int(3)).raw, 40 * 64);
  CHECK_EQ(morph.advance(style, Q16_16::from_int(-1)).raw, 48 * 64);
  CHECK_EQ(OutlineMorph().advance(style, kHalf).raw, 0);
  build_font();
}

// Glyphs 4 and 7 have second masters, 1 has none.
void draw_pulse(const WeightPulse& line, size_t ram_bytes, int32_t rows) {
  picture.clear();
  picture.draw_strips(rows, [&](const Sink& sink) {
    line.draw(Painter(sink, Workspace(ram, ram_bytes)));
  });
}

TEST(weight_runs_along_a_line) {
  const Font font = font_with(6, 5);
  const Style style(24_px, kFilterMotion);
  PulseMotion motion;
  motion.swell_ms = 400;
  motion.timing = {0, 1000, 0};
  motion.stagger.step_ms = 100;
  constexpr Point kAt = {2, 30};
  WeightPulse line(font, style, kAt, "DA", motion);
  static Page last;
  last.clear();
  int32_t still = 0;
  for (int32_t now = 0; now <= 2000; now += 50) {
    const Rect changed = line.at(now);
    draw_pulse(line, sizeof ram, kSide);
    for (const auto [x, y] : pixels_of(kSide, kSide)) {
      CHECK(picture.at(x, y) == last.at(x, y) || holds(changed, x, y));
    }
    last = expected = picture;
    still += is_empty(changed) ? 1 : 0;
    draw_pulse(line, sizeof ram, 5);
    CHECK(picture == expected);
  }
  // D pulses for 400 ms of each second; A has no second master.
  CHECK_EQ(still, 24);
  // At the top D is its second master, and A stands behind its advance.
  for (int32_t top = 0; top < 2; ++top) {
    line.at(200 + 600 * top);
    draw_pulse(line, sizeof ram, kSide);
    expected.clear();
    const Sink sink = expected.sink();
    const Painter painter(sink, Workspace(ram, sizeof ram));
    OutlineMorph morph;
    CHECK_OK(OutlineMorph::open_master(font, 4, morph));
    const Q16_16 part = Q16_16::from_int(1 - top);
    morph.draw(painter, style, kAt, part);
    painter.glyph(
        font, style,
        {Q26_6::from_raw(kAt.x.raw + morph.advance(style, part).raw), kAt.y},
        1);
    CHECK(picture == expected);
  }
  // Without a workspace all is plain.
  draw_pulse(line, sizeof ram, kSide);
  expected = picture;
  line.at(100);
  draw_pulse(line, 0, kSide);
  CHECK(picture == expected);
  line.at(INT32_MIN);
  line.at(INT32_MAX);
  build_font();
}

// What Font::verify says after one byte of the section became another.
Status verify_with(size_t at, uint8_t value) {
  Font font = font_with(at, value);
  CHECK(font_builder::repair_checksums({font_bytes, font_size}));
  CHECK_OK(Font::open({font_bytes, font_size}, font));
  return font.verify();
}

TEST(verify_reads_morphs) {
  CHECK_EQ(verify_with(0, kPairs), Status::ok);
  CHECK_EQ(verify_with(0, 200), Status::corrupt);  // rows beyond the section
  CHECK_EQ(verify_with(2, 17), Status::corrupt);   // bits of a glyph
  CHECK_EQ(verify_with(3, 26), Status::corrupt);   // bits of an offset
  CHECK_EQ(verify_with(4, 12), Status::corrupt);   // points of the L: 13
  // Pairs 1 2, 4 5, 7 8.
  CHECK_EQ(verify_with(8, 1 | 1 << 4), Status::corrupt);
  CHECK_EQ(verify_with(10, 1 | 2 << 4), Status::corrupt);
  CHECK_EQ(verify_with(10, 1 | 3 << 4), Status::ok);
  CHECK_EQ(verify_with(12, 7 | 10 << 4), Status::corrupt);  // of ten glyphs
  CHECK_EQ(verify_with(11, 0), Status::corrupt);            // no bytes
  CHECK_EQ(verify_with(11, 200), Status::corrupt);
  // Masters from 8 on: glyph 7 has one. From 7 on: 7 is one itself.
  CHECK_EQ(verify_with(6, 8), Status::ok);
  CHECK_EQ(verify_with(6, 7), Status::corrupt);
  // Glyph 1 with 2, 3 and 8: from 8 on one of them is a master, from 3 on two.
  const uint8_t kMasters[] = {8, 3};
  for (const uint8_t masters : kMasters) {
    Font font = font_with(10, 1 | 3 << 4);
    uint8_t* const bytes =
        font_bytes + (font.section(format::section::kMorphs).data - font_bytes);
    bytes[12] = 1 | 8 << 4;
    bytes[6] = masters;
    CHECK(font_builder::repair_checksums({font_bytes, font_size}));
    CHECK_OK(Font::open({font_bytes, font_size}, font));
    CHECK_EQ(font.verify(), masters == 8 ? Status::ok : Status::corrupt);
  }
  // 96 pieces: too many points.
  CHECK_EQ(verify_with(kTableEnd, 0x37), Status::corrupt);
  build_font();
}

// Whatever a section holds, drawing stays in its window and its RAM, and ends.
TEST(morphs_of_any_bytes) {
  static uint8_t morphs[kMorphBytes];
  font_of_morphs();
  Font font;
  CHECK_OK(Font::open({font_bytes, font_size}, font));
  const Span<const uint8_t> section = font.section(format::section::kMorphs);
  CHECK_EQ(section.size, kMorphBytes);
  uint8_t* const bytes = font_bytes + (section.data - font_bytes);
  int32_t drawn = 0;
  for (Random& random : Rounds(77, 300)) {
    static_cast<void>(write_morphs(morphs));
    // Records alone, or all of the section.
    const size_t from = random.below(4) == 0 ? 0 : kTableEnd;
    const uint32_t count = 1 + random.below(24);
    for (uint32_t i = 0; i < count; ++i) {
      const size_t at =
          from + random.below(static_cast<uint32_t>(kMorphBytes - from));
      morphs[at] = static_cast<uint8_t>(random.next() >> 24);
    }
    for (size_t i = 0; i < kMorphBytes; ++i) {
      bytes[i] = morphs[i];
    }
    const size_t room = 900 + 4 * random.below(200);
    for (size_t i = room; i < sizeof ram; ++i) {
      ram[i] = 0xa5;
    }
    OutlineMorph morph;
    const auto first = static_cast<uint16_t>(random.below(10));
    if (OutlineMorph::open(font, first, static_cast<uint16_t>(first ^ 3),
                           morph) != Status::ok) {
      static_cast<void>(OutlineMorph::open(font, 4, 5, morph));
    }
    const Style style(Q26_6::from_raw(random.between(64, 64 * 300)),
                      kFilterMotion);
    draw(morph, style, Q16_16::from_raw(random.between(0, 1 << 16)), room);
    drawn += picture.ink() == 0 ? 0 : 1;
    for (size_t i = room; i < sizeof ram; ++i) {
      CHECK_EQ(ram[i], 0xa5);
    }
  }
  CHECK(drawn > 100 || check::failed());
  static_cast<void>(write_morphs(morphs));
  for (size_t i = 0; i < kMorphBytes; ++i) {
    bytes[i] = morphs[i];
  }
}
