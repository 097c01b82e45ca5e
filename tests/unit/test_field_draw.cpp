// Drawing cells of primitives: every way to draw a picture gives the same one.
#include "check.hpp"
#include "field_record.hpp"
#include "inkcell/render.hpp"
#include "rounds.hpp"

#if INKCELL_EDGE_CELLS

namespace {

using namespace inkcell;

constexpr int32_t kSide = 40;

alignas(4) uint8_t bytes[1024];
FieldRecord record;  // too large for the stack of a small board
uint8_t picture[kSide * kSide];
bool drawn[kSide * kSide];

// Keeps what is drawn; fails if pixels leave the window or come twice.
struct Canvas {
  Rect window;
  Rect shown;  // the part that may be drawn to

  explicit Canvas(const Rect& all) : window(all), shown(all) {
    for (uint8_t& pixel : picture) {
      pixel = 0;
    }
    show(all);
  }
  void show(const Rect& part) {
    shown = part;
    for (bool& pixel : drawn) {
      pixel = false;
    }
  }
  Sink sink() { return {shown, this, coverage, solid}; }

  uint8_t* begin(int32_t x, int32_t y, int32_t count) {
    const bool fits = count >= 1 && y >= shown.y0 && y < shown.y1 &&
                      x >= shown.x0 && count <= shown.x1 - x;
    CHECK(fits && "pixels inside the window");
    if (!fits) {
      return nullptr;
    }
    const int32_t at = (y - window.y0) * kSide + x - window.x0;
    for (int32_t i = at; i < at + count; ++i) {
      CHECK(!drawn[i] && "no pixel twice");
      drawn[i] = true;
    }
    return picture + at;
  }
  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    uint8_t* at = static_cast<Canvas*>(context)->begin(x, y, count);
    CHECK(count <= kMaxSpan);
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

constexpr int32_t kOne = 1 << 30;

constexpr int32_t kDirections[][2] = {{kOne, 0},
                                      {0, kOne},
                                      {-kOne, 0},
                                      {759250125, 759250125},
                                      {858993459, -644245094},
                                      {kOne, 1},
                                      {kOne - kOne / 1100, 0}};

constexpr const Filter* kFilters[] = {&kFilterText, &kFilterPaperDisplay,
                                      &kFilterPaperBody};

// Of a size's px to the em: as Matrix has them. [Q10]
constexpr int32_t kMatrices[][4] = {{1000, 0, 200, 1000},  {-1024, 0, 0, 512},
                                    {300, 600, -700, 250}, {512, 0, 0, 1024},
                                    {990, 30, 960, 60},    {0, 1024, 1024, 0}};

constexpr int kTurns = 7;
constexpr int kWays = kTurns + 6;

// A matrix whose stretches do not fit becomes another that does.
TextStyle style_of(int32_t size_q6, int way, const Filter& filter) {
  TextStyle style;
  if (way >= kTurns) {
    const int32_t(&entries)[4] = kMatrices[way - kTurns];
    const Matrix matrix = {Q16_16::from_raw(size_q6 * entries[0]),
                           Q16_16::from_raw(size_q6 * entries[1]),
                           Q16_16::from_raw(size_q6 * entries[2]),
                           Q16_16::from_raw(size_q6 * entries[3])};
    if (TextStyle::make(matrix, filter, style) == Status::ok) {
      return style;
    }
  }
  Direction turn;
  turn.cosine.raw = kDirections[way % kTurns][0];
  turn.sine.raw = kDirections[way % kTurns][1];
  CHECK_OK(TextStyle::make(Q26_6::from_raw(size_q6), filter, turn, style));
  return style;
}

GlyphField open() {
  GlyphField field;
  CHECK(record.size() <= sizeof(bytes));
  record.write(bytes);
  CHECK_OK(GlyphField::open({bytes, record.size()}, field));
  return field;
}

Rect window_in(Random& random, const Rect& box) {
  const int32_t x0 = random.between(box.x0 - 3, box.x1 + 2);
  const int32_t y0 = random.between(box.y0 - 3, box.y1 + 2);
  return {x0, y0, x0 + random.between(1, kSide), y0 + random.between(1, kSide)};
}

// draw_field against distances one by one and the filter. Returns the number
// of pixels that are neither empty nor full.
int check_plain_chain(const GlyphField& field,
                      const TextStyle& style,
                      const FinePoint& origin,
                      const Rect& window) {
  Canvas canvas(window);
  draw_field(field, style, origin, canvas.sink());
  int grey = 0;
  for (int32_t y = window.y0; y < window.y1; ++y) {
    Q6_10 distances[kSide];
    const auto width = static_cast<size_t>(window.x1 - window.x0);
    distance_row(field, style, origin, window.x0, y, {distances, width});
    const uint8_t* row = picture + (y - window.y0) * kSide;
    for (size_t i = 0; i < width; ++i) {
      const uint8_t expected = style.filter().coverage(distances[i].raw);
      CHECK_EQ(row[i], expected);
      grey += expected != 0 && expected != 255 ? 1 : 0;
    }
  }
  return grey;
}

// A record like those of fonts: tiles of 256 u and smaller. Its grid is so
// small that any field is within the format's limits anywhere in it.
void make_record(Random& random) {
  record = FieldRecord();
  record.linked = (random.next() & 1) != 0;
  record.tile_log2 = static_cast<uint8_t>(6 + random.below(3));
  const uint32_t most = record.tile_log2 == 8 ? 1 : 3;
  record.tiles_x = static_cast<uint8_t>(1 + random.below(most));
  record.tiles_y = static_cast<uint8_t>(1 + random.below(most));
  record.x0_u = static_cast<int16_t>(random.between(-300, 100));
  record.y0_u = static_cast<int16_t>(random.between(-300, 100));
  record.make(random, 1 << (record.tile_log2 - 1));
  for (FieldRecord::Field& field : record.fields) {
    field.bend = field.bend * 2 / 5;
  }
}

int32_t any_size(Random& random) {
  const uint32_t kind = random.below(8);
  if (kind < 2) {
    return kind == 0 ? 4 * 64 : 1024 * 64;
  }
  return kind < 5 ? random.between(4 * 64, 64 * 64)
                  : random.between(4 * 64, 1024 * 64);
}

// check_plain_chain somewhere, in three windows.
int check_windows(const GlyphField& field,
                  const TextStyle& style,
                  Random& random) {
  const FinePoint origin(random.between(-9999, 9999),
                         random.between(-9999, 9999));
  const Rect box = field_box(field, style, origin);
  int grey = 0;
  for (int i = 0; i < 3; ++i) {
    grey += check_plain_chain(field, style, origin, window_in(random, box));
  }
  return grey;
}

}  // namespace

TEST(fields_equal_the_plain_chain) {
  int grey = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 60 : 20000;
  for (Rounds rounds(101, round_count); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    make_record(random);
    const GlyphField field = open();
    const TextStyle style =
        style_of(any_size(random),
                 round % 3 != 0 ? 0 : static_cast<int>(random.below(kWays)),
                 *kFilters[random.below(3)]);
    grey += check_windows(field, style, random);
  }
  CHECK(grey > round_count);
}

namespace {

// Stretched to `most_q16` px along the falling diagonal and to `least_q16`
// along the rising one.
TextStyle stretched_style(int32_t most_q16,
                          int32_t least_q16,
                          const Filter& filter) {
  const auto diagonal = [](int32_t px_q16) {
    return static_cast<int32_t>((int64_t{px_q16} * 46341) >> 16);
  };
  const int32_t most = diagonal(most_q16);
  const int32_t least = diagonal(least_q16);
  TextStyle style;
  CHECK_OK(TextStyle::make({Q16_16::from_raw(-most), Q16_16::from_raw(least),
                            Q16_16::from_raw(most), Q16_16::from_raw(least)},
                           filter, style));
  return style;
}

// A leaf of 256 u, or of 2048, and one or two lines, about along a diagonal,
// that lie 256 u or a little more from its middle.
void make_far_lines(Random& random) {
  record = FieldRecord();
  record.linked = random.below(2) == 0;
  record.x0_u = static_cast<int16_t>(random.between(-300, 100));
  record.y0_u = static_cast<int16_t>(random.between(-300, 100));
  if (random.below(4) == 0) {
    record.tile_log2 = 11;
    record.x0_u -= 960;
    record.y0_u -= 960;
  }
  const int32_t half_u = 1 << (record.tile_log2 - 1);
  record.line_count = 2;
  record.pair_count = 1;
  record.pairs[0][1] = 1;
  for (uint32_t i = 0; i < 2; ++i) {
    FieldRecord::Field& field = record.fields[i];
    const int32_t turn = random.between(-160, 160);
    const int32_t x_sign = random.below(2) == 0 ? 1 : -1;
    const int32_t y_sign = random.below(2) == 0 ? 1 : -1;
    field.nx = x_sign * (11585 + turn);
    field.ny = y_sign * (11585 - turn);
    const int32_t way_q4 = random.between(256 * 16, 260 * 16);
    const int32_t middle_q4 = (field.nx * (record.x0_u + half_u) +
                               field.ny * (record.y0_u + half_u)) >>
                              10;
    field.c = (random.below(2) == 0 ? way_q4 : -way_q4) - middle_q4;
  }
  record.references[0] = random.below(2) == 0 ? record.field_reference(0)
                                              : record.pair_reference(0);
}

// Sizes of which a px is a whole number of units, and centres that lie on them:
// borders of cells and of the grid are met exactly.
TEST(borders_that_are_met_exactly_equal_the_plain_chain) {
  int grey = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 40 : 4000;
  for (Rounds rounds(17, round_count); rounds.next();) {
    Random& random = rounds.random;
    make_record(random);
    const GlyphField field = open();
    const TextStyle style =
        style_of(256 << random.below(9), 0, *kFilters[random.below(3)]);
    const FinePoint origin(512 + 1024 * random.between(-9, 9),
                           512 + 1024 * random.between(-9, 9));
    const Rect box = field_box(field, style, origin);
    for (int i = 0; i < 3; ++i) {
      grey += check_plain_chain(field, style, origin, window_in(random, box));
    }
  }
  CHECK(grey > round_count);
}

}  // namespace

// A px there is many px of the style's size, and fields matter far away.
TEST(strongly_stretched_fields_equal_the_plain_chain) {
  int grey = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 60 : 2000;
  for (Rounds rounds(47, round_count); rounds.next();) {
    Random& random = rounds.random;
    make_far_lines(random);
    const TextStyle style =
        stretched_style(random.between(1000 << 16, (1023 << 16) + 60000),
                        random.between(5 << 16, 7 << 16), kFilterPaperBody);
    const GlyphField field = open();
    for (int i = 0; i < 4; ++i) {
      grey += check_windows(field, style, random);
    }
  }
  CHECK(grey > round_count / 8);
}

// Positions in the glyph are kept modulo 2^16 u. Around a grid that is strongly
// stretched they pass that, in corners that could show it once more.
TEST(far_corners_of_stretched_grids_are_empty) {
  record = FieldRecord();
  record.tiles_x = record.tiles_y = 4;
  record.x0_u = record.y0_u = -512;
  for (uint32_t i = 0; i < record.reference_count(); ++i) {
    record.references[i] = format::glyph::kInside;
  }
  const GlyphField field = open();
  // Along the rising diagonal of the screen, and across it.
  const auto most = Q16_16::from_raw(723 << 16);
  const auto least = Q16_16::from_raw(231705);
  const auto less = Q16_16::from_raw(-231705);
  TextStyle style;
  CHECK_OK(TextStyle::make({most, most, less, least}, kFilterText, style));
  const FinePoint origin(77, -99);
  const Rect box = field_box(field, style, origin);
  CHECK(box.x1 - box.x0 > 700 && box.y1 - box.y0 > 700);
  const int32_t middle_x = (box.x0 + box.x1) / 2 - kSide / 2;
  const int32_t middle_y = (box.y0 + box.y1) / 2 - kSide / 2;
  const int32_t step = INKCELL_BOARD_FIRMWARE ? 226 : kSide;
  for (int32_t way = 0; way < 400; way += step) {
    for (int32_t x_sign = -1; x_sign < 2; x_sign += 2) {
      for (int32_t y_sign = -1; y_sign < 2; y_sign += 2) {
        const int32_t x0 = middle_x + x_sign * way;
        const int32_t y0 = middle_y + y_sign * way;
        check_plain_chain(field, style, origin,
                          {x0, y0, x0 + kSide, y0 + kSide});
      }
    }
  }
}

// Ramps that lie on one side of the edge.
constexpr Filter kFilterInside =
    make_filter({Q6_10::from_raw(100), Q6_10::from_raw(500)});
constexpr Filter kFilterOutside =
    make_filter({Q6_10::from_raw(-500), Q6_10::from_raw(-100)});

// Roundings of the greater of two fields reach farther than such a ramp.
TEST(ramps_beside_the_edge_equal_the_plain_chain) {
  int grey = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 60 : 20000;
  for (Rounds rounds(46, round_count); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    record = FieldRecord();
    record.linked = (round & 2) != 0;
    record.tile_log2 = 6;
    record.make(random, 8);
    record.node_count = 0;
    const uint32_t fields = record.arc_count + record.line_count;
    record.triple_count = 1;
    record.triples[0][0] = static_cast<uint16_t>(2 + (round & 1));
    for (uint32_t i = 0; i < 3; ++i) {
      record.triples[0][1 + i] = static_cast<uint16_t>(i % fields);
    }
    record.references[0] = record.triple_reference(0);
    const GlyphField field = open();
    const TextStyle style =
        style_of(random.between(40 * 64, 400 * 64), 0,
                 random.below(2) == 0 ? kFilterInside : kFilterOutside);
    grey += check_windows(field, style, random);
  }
  CHECK(grey > round_count);
}

// Numbers without sense make a picture without sense, in the window.
TEST(any_fields_stay_in_the_window) {
  const int round_count = INKCELL_BOARD_FIRMWARE ? 60 : 20000;
  for (Rounds rounds(42, round_count); rounds.next();) {
    Random& random = rounds.random;
    make_record(random);
    for (FieldRecord::Field& f : record.fields) {
      const uint32_t mild = random.below(3);
      f.nx = random.between(INT16_MIN, INT16_MAX);
      f.ny = random.between(INT16_MIN, INT16_MAX);
      f.c = random.between(INT16_MIN, INT16_MAX) >> mild;
      f.along = random.between(INT16_MIN, INT16_MAX) >> mild;
      f.bend = random.between(INT16_MIN, INT16_MAX) >> (4 * mild);
    }
    for (uint32_t i = 0; i < record.reference_count(); ++i) {
      if (random.below(8) == 0) {
        record.references[i] = static_cast<uint16_t>(random.below(40));
      }
    }
    const GlyphField field = open();
    const TextStyle style =
        style_of(any_size(random), static_cast<int>(random.below(kWays)),
                 *kFilters[random.below(3)]);
    const FinePoint origin(random.between(-9999, 9999),
                           random.between(-9999, 9999));
    const Rect box = field_box(field, style, origin);
    for (int i = 0; i < 3; ++i) {
      Canvas canvas(window_in(random, box));
      draw_field(field, style, origin, canvas.sink());
    }
  }
}

TEST(windows_do_not_change_fields) {
  static uint8_t whole[kSide * kSide];
  const Rect all = {-3, -2, -3 + kSide, -2 + kSide};
  for (Rounds rounds(43, INKCELL_BOARD_FIRMWARE ? 2 : 40); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    make_record(random);
    const GlyphField field = open();
    const TextStyle style =
        style_of(random.between(8 * 64, 64 * 64),
                 round % 4 == 0 ? 3 + round % 10 : 0, kFilterText);
    const FinePoint origin(random.between(0, 9999),
                           random.between(9999, 30000));
    Canvas canvas(all);
    draw_field(field, style, origin, canvas.sink());
    for (int32_t i = 0; i < kSide * kSide; ++i) {
      whole[i] = picture[i];
    }
    for (int32_t cut = 1; cut < kSide; cut += 3) {
      Canvas parts(all);
      const int32_t x = all.x0 + cut;
      for (int32_t y = all.y0; y < all.y1; y += cut) {
        parts.show(intersect(all, {all.x0, y, x, y + cut}));
        draw_field(field, style, origin, parts.sink());
        parts.show(intersect(all, {x, y, all.x1, y + cut}));
        draw_field(field, style, origin, parts.sink());
      }
      for (int32_t i = 0; i < kSide * kSide; ++i) {
        CHECK_EQ(picture[i], whole[i]);
      }
    }
  }
}

// What lies farther from the ink than the filter reaches is left out, and no
// more.
TEST(nothing_is_drawn_far_from_the_ink) {
  static uint8_t whole[kSide * kSide];
  int cut = 0;
  int kept = 0;
  for (Rounds rounds(45, INKCELL_BOARD_FIRMWARE ? 40 : 300); rounds.next();) {
    Random& random = rounds.random;
    make_record(random);
    GlyphField field = open();
    const Filter& filter = *kFilters[random.below(3)];
    const TextStyle style =
        style_of(random.between(8 * 64, 64 * 64), 0, filter);
    const FinePoint origin(random.between(-9999, 9999),
                           random.between(-9999, 9999));
    const Rect window = window_in(random, field_box(field, style, origin));
    Canvas all(window);
    draw_field(field, style, origin, all.sink());
    for (int32_t i = 0; i < kSide * kSide; ++i) {
      whole[i] = picture[i];
    }
    field.ink.x0_u = static_cast<int16_t>(random.between(-300, 300));
    field.ink.y0_u = static_cast<int16_t>(random.between(-300, 300));
    field.ink.x1_u = static_cast<int16_t>(random.between(-300, 900));
    field.ink.y1_u = static_cast<int16_t>(random.between(-300, 900));
    Canvas part(window);
    draw_field(field, style, origin, part.sink());
    const double u_per_px = 65536.0 / style.size().raw;
    const double reach_u = -filter.outside_q10 / 1024.0 * u_per_px;
    for (int32_t y = window.y0; y < window.y1; ++y) {
      for (int32_t x = window.x0; x < window.x1; ++x) {
        const double x_u =
            (x + 0.5 - static_cast<double>(origin.x_q10) / 1024) * u_per_px;
        const double y_u =
            (static_cast<double>(origin.y_q10) / 1024 - y - 0.5) * u_per_px;
        const double left = field.ink.x0_u - x_u;
        const double right = x_u - field.ink.x1_u;
        const double below = field.ink.y0_u - y_u;
        const double above = y_u - field.ink.y1_u;
        const double across = left > right ? left : right;
        const double up = below > above ? below : above;
        const double away_u = (across > up ? across : up) - reach_u;
        const int32_t i = (y - window.y0) * kSide + x - window.x0;
        if (away_u < -0.1) {
          CHECK_EQ(picture[i], whole[i]);
          kept += whole[i] != 0 ? 1 : 0;
        } else if (away_u > 1.1) {
          CHECK_EQ(picture[i], 0);
          cut += whole[i] != 0 ? 1 : 0;
        }
      }
    }
  }
  CHECK(cut > 0);
  CHECK(kept > 0);
}

// Distances in px against real numbers, at the pixel's centre, for sizes and
// origins that bring it to 1/256 px exactly.
TEST(pixels_follow_their_equations) {
  double worst = 0;
  int compared = 0;
  const int round_count = INKCELL_BOARD_FIRMWARE ? 60 : 2000;
  for (Rounds rounds(44, round_count); rounds.next();) {
    Random& random = rounds.random;
    make_record(random);
    record.node_count = 0;
    record.tiles_x = 1;
    record.tiles_y = 1;
    const uint32_t number = random.below(record.arc_count + record.line_count);
    record.references[0] = record.field_reference(number);
    const GlyphField field = open();
    const int32_t size_q6 = any_size(random);
    const TextStyle style = style_of(size_q6, 0, kFilterText);
    const FinePoint origin(4 * random.between(-999, 999),
                           4 * random.between(-999, 999));
    const Rect box = field_box(field, style, origin);
    for (int i = 0; i < 10; ++i) {
      const int32_t x = random.between(box.x0, box.x1 - 1);
      const int32_t y = random.between(box.y0, box.y1 - 1);
      Q6_10 distance;
      distance_row(field, style, origin, x, y, {&distance, 1});
      const double px_per_u = size_q6 / 65536.0;
      const double x_u =
          (x + 0.5 - static_cast<double>(origin.x_q10) / 1024) / px_per_u;
      const double y_u =
          (static_cast<double>(origin.y_q10) / 1024 - y - 0.5) / px_per_u;
      if (x_u < record.x0_u + 1 || x_u > field.x1_u() - 1 ||
          y_u < record.y0_u + 1 || y_u > field.y1_u() - 1) {
        continue;
      }
      const FieldRecord::Field& f = record.fields[number];
      const bool is_arc = number < record.arc_count;
      const double w = (f.nx * y_u - f.ny * x_u) / 16384 + f.along / 16.0;
      const double sag = f.bend / 524288.0 * w * w;
      const double expected =
          field_equation::value(f, is_arc, x_u, y_u).f * px_per_u;
      if (expected > 4 || expected < -4 ||
          (is_arc && (w > 256 || w < -256 || sag > 255 || sag < -255))) {
        continue;
      }
      const double error = expected - distance.raw / 1024.0;
      worst = error > worst ? error : worst;
      worst = -error > worst ? -error : worst;
      ++compared;
    }
  }
  check::write("largest error of pixels: ");
  check::write_number(static_cast<int64_t>(worst * 10000));
  check::write(" px / 10000 of ");
  check::write_number(compared);
  check::write("\n");
  CHECK(worst <= 1.0 / 80);
  CHECK(compared > round_count / 2);
}

#endif
