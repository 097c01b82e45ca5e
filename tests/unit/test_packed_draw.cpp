// Packed fonts: the same pictures as direct ones, in any workspace that holds
// a row of tiles.
#include "check.hpp"
#include "hints_record.hpp"
#include "inkcell/effects.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/text.hpp"
#include "packed_record.hpp"

#if INKCELL_PACKED

namespace {

using namespace inkcell;
using namespace font_builder;

constexpr int32_t kSide = 40;
constexpr size_t kRoom = 2 * PackedRecord::kMaxUnits;

// Too large for the stack of a small board.
PackedRecord record;
alignas(4) uint8_t packed_rom[1250];
alignas(4) uint8_t direct_rom[kRoom + 550];
alignas(4) uint8_t memory[kRoom];
uint8_t linked[kRoom + 10];
uint8_t picture[2][kSide * kSide];

const uint8_t kQuantisation[8] = {16, 24, 9, 6, 8, 0, 0x34, 0x22};

// Keeps what is drawn; fails if pixels leave the window.
struct Canvas {
  Rect window;
  Rect shown;
  uint8_t* pixels;

  Canvas(const Rect& all, uint8_t* to) : window(all), shown(all), pixels(to) {
    for (int32_t i = 0; i < kSide * kSide; ++i) {
      pixels[i] = 0;
    }
  }
  void show(int32_t y0, int32_t y1) {
    shown.y0 = y0;
    shown.y1 = y1;
  }
  Sink sink() { return {shown, this, coverage, solid}; }

  uint8_t* begin(int32_t x, int32_t y, int32_t count) {
    const bool fits = count >= 1 && y >= shown.y0 && y < shown.y1 &&
                      x >= shown.x0 && count <= shown.x1 - x;
    CHECK(fits && "pixels inside the window");
    return fits ? pixels + (y - window.y0) * kSide + x - window.x0 : nullptr;
  }
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    uint8_t* at = static_cast<Canvas*>(context)->begin(x, y, count);
    for (int32_t i = 0; i < count && at != nullptr; ++i) {
      at[i] = coverage[i];
    }
  }
  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    uint8_t* at = static_cast<Canvas*>(context)->begin(x, y, count);
    for (int32_t i = 0; i < count && at != nullptr; ++i) {
      at[i] = 255;
    }
  }
};

bool pictures_equal() {
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    if (picture[0][i] != picture[1][i]) {
      return false;
    }
  }
  return true;
}

bool is_blank(const uint8_t* pixels) {
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    if (pixels[i] != 0) {
      return false;
    }
  }
  return true;
}

// The same glyph in two fonts.
struct Fonts {
  Font packed;
  Font direct;
  size_t workspace = 0;  // [bytes]
  size_t row_workspace = 0;
};

Font build(Span<const uint8_t> glyph,
           const PackedSpec& packed,
           Span<uint8_t> rom) {
  static constexpr CmapEntry kCmap[] = {{'A', 0, 1}};
  const GlyphSpec glyphs[] = {
      {500, {0, 0, 0, 0}, nullptr, nullptr, {}},
      {600, {-200, -200, 900, 900}, nullptr, nullptr, glyph}};
  HintsRecord hints;
  hints.make_usual();
  FontSpec spec;
  spec.cmap = {kCmap, 1};
  spec.glyphs = {glyphs, 2};
  spec.hints = hints.write(2);
  spec.packed = packed;
  const size_t size = build_font(spec, rom);
  CHECK(size != 0);
  Font font;
  CHECK_OK(Font::open({rom.data, size}, font));
  return font;
}

Fonts make_fonts(Random& random) {
  record.make(random);
  Fonts fonts;
  for (uint32_t row = 0; row < record.tiles_y; ++row) {
    record.expect(row, 1);
    const size_t bytes = 2 * record.units;
    fonts.row_workspace =
        bytes > fonts.row_workspace ? bytes : fonts.row_workspace;
  }
  record.expect(0, record.tiles_y);
  fonts.workspace = 2 * record.units;
  const size_t size = record.write_linked(0, record.tiles_y, linked);
  fonts.direct = build({linked, size}, {}, direct_rom);
  const PackedSpec packed = {kQuantisation,
                             static_cast<uint32_t>(fonts.row_workspace),
                             static_cast<uint32_t>(fonts.workspace)};
  fonts.packed = build({record.bytes, record.size}, packed, packed_rom);
  return fonts;
}

Brush brush_of(Random& random, bool upright) {
  constexpr int32_t kOne = 1 << 30;
  constexpr int32_t kDirections[][2] = {
      {kOne, 0}, {0, kOne}, {759250125, 759250125}, {858993459, -644245094}};
  const auto& turn = kDirections[upright ? 0 : 1 + random.below(3)];
  Direction direction;
  direction.cosine.raw = turn[0];
  direction.sine.raw = turn[1];
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_raw(random.between(8 * 64, 80 * 64)),
                       kFilterText, direction, brush));
  return brush;
}

// A window that the glyph is likely to meet, drawn in strips of `rows`.
void draw_both(const Fonts& fonts,
               const Brush& brush,
               const Point& origin,
               Workspace workspace,
               int32_t rows) {
  const Rect window = {0, 0, kSide, kSide};
  Canvas direct(window, picture[0]);
  draw_glyph(fonts.direct, 1, brush, origin, direct.sink());
  Canvas packed(window, picture[1]);
  for (int32_t y = 0; y < kSide; y += rows) {
    packed.show(y, y + rows < kSide ? y + rows : kSide);
    draw_glyph(fonts.packed, 1, brush, origin, packed.sink(), workspace);
  }
}

Point origin_of(Random& random, const Brush& brush) {
  const int32_t size = brush.size().raw;
  return {Q26_6::from_raw(random.between(0, kSide * 64 / 2)),
          Q26_6::from_raw(random.between(0, kSide * 64) + size / 8)};
}

// Two tiles and more each way, and more in all than in a row.
Fonts tall_fonts(Random& random) {
  Fonts fonts;
  do {
    fonts = make_fonts(random);
  } while (record.tiles_y < 2 || record.tiles_x < 2 || record.x0_u < -200 ||
           record.y0_u < -200 || fonts.row_workspace + 2 > fonts.workspace);
  return fonts;
}

}  // namespace

TEST(packed_pictures_equal_direct_ones) {
  Random random(21);
  int shown = 0;
  const int rounds = INKCELL_BOARD_FIRMWARE ? 30 : 1000;
  for (int round = 0; round < rounds && !check::failed(); ++round) {
    const Fonts fonts = make_fonts(random);
    const Brush brush = brush_of(random, round % 4 != 0);
    const Point origin = origin_of(random, brush);
    // All at once, and row by row where that is enough.
    const int32_t rows = random.between(1, kSide);
    draw_both(fonts, brush, origin, {memory, fonts.workspace}, rows);
    CHECK(pictures_equal());
    shown += is_blank(picture[0]) ? 0 : 1;
    if (brush.is_upright()) {
      draw_both(fonts, brush, origin, {memory, fonts.row_workspace}, rows);
      CHECK(pictures_equal());
    }
  }
  CHECK(shown > rounds / 2);
}

// What rows show depends on the whole glyph and not on the rows of tiles that
// are there.
TEST(fitted_pictures_are_equal_as_well) {
  Random random(25);
  int moved = 0;
  const int rounds = INKCELL_BOARD_FIRMWARE ? 30 : 600;
  for (int round = 0; round < rounds && !check::failed(); ++round) {
    const Fonts fonts = make_fonts(random);
    const Brush plain = brush_of(random, true);
    Brush brush = plain;
    FitOptions options;
    options.stems = round % 2 == 0;
    options.strength_q8 = static_cast<uint16_t>(random.between(128, 256));
    Fit fit;
    CHECK_OK(Fit::make(fonts.packed, brush, options, fit));
    brush.set_fitter(fit_glyph, &fit);
    const Point origin = origin_of(random, brush);
    const int32_t rows = random.between(1, kSide);
    draw_both(fonts, brush, origin, {memory, fonts.row_workspace}, rows);
    CHECK(pictures_equal());
    draw_both(fonts, brush, origin, {memory, fonts.workspace}, rows);
    CHECK(pictures_equal());
    Canvas as_designed({0, 0, kSide, kSide}, picture[1]);
    draw_glyph(fonts.direct, 1, plain, origin, as_designed.sink());
    moved += pictures_equal() ? 0 : 1;
  }
  CHECK(moved > rounds / 8);
}

TEST(what_does_not_fit_is_left_out) {
  Random random(22);
  Fonts fonts;
  do {
    fonts = make_fonts(random);
  } while (record.tiles_y < 2 || record.tiles_x < 2 || record.x0_u < -200 ||
           record.y0_u < -200);
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(24), kFilterText, brush));
  const Point origin = {Q26_6::from_int(8), Q26_6::from_int(34)};
  draw_both(fonts, brush, origin, {memory, fonts.workspace}, kSide);
  CHECK(!is_blank(picture[1]) && pictures_equal());
  draw_both(fonts, brush, origin, {}, kSide);
  CHECK(is_blank(picture[1]));
  draw_both(fonts, brush, origin, {memory + 1, kRoom - 1}, kSide);
  CHECK(is_blank(picture[1]));
  // A turned glyph is expanded all at once.
  Direction up;
  up.cosine.raw = 0;
  up.sine.raw = 1 << 30;
  CHECK_OK(Brush::make(Q26_6::from_int(24), kFilterText, up, brush));
  const Point corner = {Q26_6::from_int(36), Q26_6::from_int(36)};
  draw_both(fonts, brush, corner, {memory, fonts.workspace}, kSide);
  CHECK(!is_blank(picture[1]) && pictures_equal());
  draw_both(fonts, brush, corner, {memory, 2u * record.tiles_x}, kSide);
  CHECK(is_blank(picture[1]));
}

TEST(calls_without_a_workspace_leave_packed_glyphs_out) {
  Random random(23);
  const Fonts fonts = make_fonts(random);
  CHECK(fonts.packed.is_packed() && !fonts.direct.is_packed());
  CHECK_EQ(fonts.packed.workspace_bytes(), fonts.workspace);
  CHECK_EQ(fonts.packed.row_workspace_bytes(), fonts.row_workspace);
  CHECK_EQ(fonts.direct.workspace_bytes(), 0);
  CHECK(!Font().is_packed() && Font().workspace_bytes() == 0);
  GlyphField field;
  CHECK_EQ(fonts.packed.field(1, field), Status::unsupported);
  CHECK_OK(fonts.packed.field(0, field));  // no ink
  CHECK_EQ(fonts.packed.field(2, field), Status::no_glyph);
  PackedGlyph glyph;
  CHECK_OK(PackedGlyph::open(fonts.packed, 1, glyph));
  CHECK_EQ(glyph.tiles_x, record.tiles_x);
  CHECK_OK(PackedGlyph::open(fonts.packed, 0, glyph));
  CHECK_EQ(glyph.tiles_y, 0);
  CHECK_EQ(PackedGlyph::open(fonts.packed, 2, glyph), Status::no_glyph);
  CHECK_EQ(PackedGlyph::open(fonts.direct, 1, glyph), Status::unsupported);
  const Rect window = {0, 0, kSide, kSide};
  Canvas canvas(window, picture[0]);
  const Brush brush;
  draw_glyph(fonts.packed, 1, brush, {}, canvas.sink());
  draw_glyph(fonts.packed, 0, brush, {}, canvas.sink(), {memory, kRoom});
  draw_glyph(fonts.packed, 2, brush, {}, canvas.sink(), {memory, kRoom});
  CHECK(is_blank(picture[0]));
}

// Lines of text, and direct fonts with a workspace that they do not need.
TEST(lines_are_drawn_alike) {
  Random random(24);
  for (int round = 0; round < 20; ++round) {
    const Fonts fonts = make_fonts(random);
    const Brush brush = brush_of(random, true);
    const Point origin = origin_of(random, brush);
    const Workspace workspace(memory, fonts.row_workspace);
    const Rect window = {0, 0, kSide, kSide};
    PositionedGlyph buffer[2];
    Span<const PositionedGlyph> run;
    CHECK_OK(layout(fonts.direct, "A", buffer, run));
    Canvas direct(window, picture[0]);
    draw(fonts.direct, run, brush, origin, direct.sink());
    {
      Canvas packed(window, picture[1]);
      draw(fonts.packed, run, brush, origin, packed.sink(), workspace);
      CHECK(pictures_equal());
    }
    {
      Canvas packed(window, picture[1]);
      draw_text(fonts.packed, "A", brush, origin, packed.sink(), workspace);
      CHECK(pictures_equal());
    }
    {
      Canvas again(window, picture[1]);
      draw_text(fonts.direct, "A", brush, origin, again.sink(), {});
      CHECK(pictures_equal());
    }
  }
}

TEST(verifies_what_glyphs_expand_to) {
  Random random(25);
  Fonts fonts = make_fonts(random);
  const Workspace workspace(memory, fonts.workspace);
  CHECK_OK(fonts.packed.verify());
  CHECK_OK(fonts.packed.verify(workspace));
  CHECK_EQ(fonts.packed.verify({memory, fonts.workspace - 1}),
           Status::buffer_small);
  CHECK_OK(fonts.direct.verify({}));
  // Less than it takes is stated.
  const Span<const uint8_t> bytes(record.bytes, record.size);
  const auto whole = static_cast<uint32_t>(fonts.workspace);
  const auto row = static_cast<uint32_t>(fonts.row_workspace);
  const PackedSpec wrong[] = {{kQuantisation, row, whole - 2},
                              {kQuantisation, row - 2, whole},
                              {kQuantisation, whole + 2, whole}};
  for (const PackedSpec& spec : wrong) {
    const Font font = build(bytes, spec, packed_rom);
    CHECK_OK(font.verify());
    CHECK_EQ(font.verify(workspace), Status::corrupt);
  }
  // A stream that is cut short, and one that does not begin.
  const PackedSpec spec = {kQuantisation, row, whole};
  record.bytes[1] = static_cast<uint8_t>(record.bytes[1] & 0xf0);
  CHECK_EQ(build(bytes, spec, packed_rom).verify(), Status::corrupt);
}

TEST(turned_glyphs_are_drawn_from_all_rows_or_not_at_all) {
  Random random(22);
  const Fonts fonts = tall_fonts(random);
  Direction up;
  up.cosine.raw = 0;
  up.sine.raw = 1 << 30;
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(24), kFilterText, up, brush));
  const Point corner = {Q26_6::from_int(36), Q26_6::from_int(36)};
  draw_both(fonts, brush, corner, {memory, fonts.workspace}, kSide);
  CHECK(!is_blank(picture[1]));
  CHECK(pictures_equal());
  const int32_t strips[] = {1, 7, kSide};
  for (const int32_t rows : strips) {
    draw_both(fonts, brush, corner, {memory, fonts.row_workspace}, rows);
    CHECK(is_blank(picture[1]));
  }
}

// Also where a strip shows some of the rows of tiles only.
TEST(nearly_upright_glyphs_are_drawn_from_all_rows_or_not_at_all) {
  Random random(31);
  Direction turn;
  turn.sine.raw = 1;
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(24), kFilterText, turn, brush));
  const Point origin = {Q26_6::from_int(8), Q26_6::from_int(34)};
  for (int round = 0; round < 10; ++round) {
    const Fonts fonts = tall_fonts(random);
    draw_both(fonts, brush, origin, {memory, fonts.row_workspace}, 1);
    CHECK(!is_blank(picture[0]));
    CHECK(is_blank(picture[1]));
  }
}

TEST(painted_glyphs_are_drawn_from_all_rows_or_not_at_all) {
  Random random(22);
  const Fonts fonts = tall_fonts(random);
  const Outline outline =
      make_outline(kFilterText, Q6_10::from_raw(1500), OutlinePlace::outer);
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(24), outline.outer, brush));
  brush.set_painter(paint_outline, &outline.inner);
  const Point origin = {Q26_6::from_int(8), Q26_6::from_int(34)};
  draw_both(fonts, brush, origin, {memory, fonts.workspace}, 3);
  CHECK(!is_blank(picture[1]));
  CHECK(pictures_equal());
  draw_both(fonts, brush, origin, {memory, fonts.row_workspace}, kSide);
  CHECK(is_blank(picture[1]));
}

TEST(a_workspace_that_is_stated_too_small_is_enough_for_rows) {
  Random random(22);
  Fonts fonts = tall_fonts(random);
  const auto row = static_cast<uint32_t>(fonts.row_workspace);
  fonts.packed =
      build({record.bytes, record.size}, {kQuantisation, row, row}, packed_rom);
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(24), kFilterText, brush));
  draw_both(fonts, brush, {Q26_6::from_int(8), Q26_6::from_int(34)},
            {memory, fonts.row_workspace}, kSide);
  CHECK(!is_blank(picture[1]));
  CHECK(pictures_equal());
}

// 2^32 / 1024 px and more, which would wrap.
TEST(far_glyphs_show_nothing) {
  Random random(22);
  const Fonts fonts = tall_fonts(random);
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(24), kFilterText, brush));
  const int32_t far[] = {1 << 28, -(1 << 28), 1 << 29};
  for (const int32_t way : far) {
    for (int32_t axis = 0; axis < 2; ++axis) {
      const Point origin = {Q26_6::from_raw(8 * 64 + (axis == 0 ? way : 0)),
                            Q26_6::from_raw(34 * 64 + (axis == 1 ? way : 0))};
      Canvas canvas({0, 0, kSide, kSide}, picture[1]);
      draw_glyph(fonts.packed, 1, brush, origin, canvas.sink(),
                 {memory, fonts.workspace});
      draw_glyph(fonts.direct, 1, brush, origin, canvas.sink());
      CHECK(is_blank(picture[1]));
    }
  }
}

TEST(positions_of_runs_do_not_wrap) {
  Random random(22);
  const Fonts fonts = tall_fonts(random);
  const Workspace workspace(memory, fonts.workspace);
  // An em of 1000 units: 2^24 of them are 2^22 px.
  Brush brush;
  CHECK_OK(Brush::make(Q26_6::from_int(250), kFilterText, brush));
  const auto draw_at = [&](Point origin, int32_t x_units) {
    PositionedGlyph at;
    at.glyph = 1;
    at.x = x_units;
    Canvas canvas({0, 0, kSide, kSide}, picture[1]);
    draw(fonts.packed, {&at, 1}, brush, origin, canvas.sink(), workspace);
  };
  // Where the window shows some of the glyph.
  Point origin = {Q26_6::from_int(-20), Q26_6::from_int(0)};
  do {
    origin.y.raw += 20 * 64;
    draw_at(origin, 0);
  } while (is_blank(picture[1]) && origin.y.raw < 400 * 64);
  CHECK(!is_blank(picture[1]));
  draw_at(origin, 1 << 24);
  CHECK(is_blank(picture[1]));
  draw_at(origin, -(1 << 24));
  CHECK(is_blank(picture[1]));
}

// Where the uppermost row takes more than all others.
TEST(the_last_row_must_fit_what_is_stated) {
  Random random(77);
  uint32_t others = 0;
  uint32_t last = 0;
  Fonts fonts;
  do {
    fonts = make_fonts(random);
    others = 0;
    last = 0;
    for (uint32_t row = 0; row < record.tiles_y; ++row) {
      others = last > others ? last : others;
      record.expect(row, 1);
      last = 2 * record.units;
    }
  } while (record.tiles_y < 2 || last <= others);
  const auto whole = static_cast<uint32_t>(fonts.workspace);
  const Span<const uint8_t> bytes(record.bytes, record.size);
  const Workspace workspace(memory, fonts.workspace);
  CHECK_OK(
      build(bytes, {kQuantisation, last, whole}, packed_rom).verify(workspace));
  CHECK_EQ(build(bytes, {kQuantisation, others, whole}, packed_rom)
               .verify(workspace),
           Status::corrupt);
}

TEST(direct_fonts_hold_no_packed_records) {
  Random random(23);
  make_fonts(random);
  const Font font = build({record.bytes, record.size}, {}, direct_rom);
  CHECK_EQ(font.verify(), Status::unsupported);
}

#else

TEST(packed_fonts_are_refused) {
  alignas(4) static uint8_t rom[400];
  const uint8_t quantisation[8] = {};
  const font_builder::GlyphSpec glyphs[] = {
      {500, {0, 0, 0, 0}, nullptr, nullptr, {}}};
  font_builder::FontSpec spec;
  spec.glyphs = {glyphs, 1};
  inkcell::Font font;
  size_t size = font_builder::build_font(spec, rom);
  CHECK_OK(inkcell::Font::open({rom, size}, font));
  spec.packed.quantisation = quantisation;
  size = font_builder::build_font(spec, rom);
  CHECK_EQ(inkcell::Font::open({rom, size}, font),
           inkcell::Status::unsupported);
}

#endif
