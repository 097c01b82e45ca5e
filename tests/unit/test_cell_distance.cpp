// Cells, drawn and asked for, against the plain reference.
#include "any_record.hpp"
#include "check.hpp"
#include "field_record.hpp"
#include "font_builder.hpp"
#include "inkcell/render.hpp"
#include "picture.hpp"
#include "reference/cell_distance.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;

constexpr int32_t kSide = 24;

alignas(4) uint8_t bytes[2048];

TextStyle style_of(Random& random) {
  constexpr int32_t kDirections[][2] = {{1 << 30, 0},
                                        {1 << 30, 0},
                                        {0, 1 << 30},
                                        {759250125, 759250125},
                                        {858993459, -644245094}};
  constexpr const Filter* kFilters[] = {&kFilterText, &kFilterPaperDisplay,
                                        &kFilterPaperBody};
  const int32_t size_q6 = random.below(4) == 0
                              ? random.between(4 * 64, 1024 * 64)
                              : random.between(4 * 64, 64 * 64);
  Direction direction;
  const uint32_t turn = random.below(5);
  direction.cosine.raw = kDirections[turn][0];
  direction.sine.raw = kDirections[turn][1];
  TextStyle style;
  CHECK_OK(TextStyle::make(Q26_6::from_raw(size_q6), *kFilters[random.below(3)],
                           direction, style));
  return style;
}

int32_t clamped(int32_t distance_q10) {
  return distance_q10 < INT16_MIN   ? INT16_MIN
         : distance_q10 > INT16_MAX ? INT16_MAX
                                    : distance_q10;
}

// A window of a glyph. Returns the number of pixels that are grey.
int check_window(const GlyphField& field, Random& random) {
  const TextStyle style = style_of(random);
  const FinePoint origin(random.between(-9999, 9999),
                         random.between(-9999, 9999));
  const Rect box = field_box(field, style, origin);
  const int32_t x0 = random.between(box.x0 - 3, box.x1 + 2);
  const int32_t y0 = random.between(box.y0 - 3, box.y1 + 2);
  Picture<kSide, kSide> picture(x0, y0);
  draw_field(field, style, origin, picture.sink());
  int grey = 0;
  for (int32_t y = y0; y < y0 + kSide; ++y) {
    Q6_10 row[kSide];
    distance_row(field, style, origin, x0, y, row);
    for (int32_t x = x0; x < x0 + kSide; ++x) {
      const int32_t expected =
          clamped(reference::distance_q10(field, style, origin, x, y));
      CHECK_EQ(row[x - x0].raw, expected);
      const uint8_t coverage = style.filter().coverage(expected);
      CHECK_EQ(picture.at(x, y), coverage);
      grey += coverage != 0 && coverage != 255 ? 1 : 0;
    }
  }
  return grey;
}

// Calls `round` with the random numbers of each.
template <typename Round>
void run(int32_t count, const Round& round) {
  int grey = 0;
  for (Rounds rounds(1, count); rounds.next();) {
    grey += round(rounds.random);
  }
  // Many windows lie beside the ink, or in it.
  CHECK(grey > count / 4);
}

}  // namespace

#if INKCELL_EDGE_CELLS

// Within the format's limits anywhere in a grid so small.
TEST(primitives_are_those_of_the_reference) {
  static FieldRecord record;
  run(INKCELL_BOARD_FIRMWARE ? 60 : 6000, [](Random& random) {
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
    GlyphField field;
    CHECK(record.size() <= sizeof(bytes));
    record.write(bytes);
    CHECK_OK(GlyphField::open({bytes, record.size()}, field));
    return check_window(field, random);
  });
}

#endif

// Of any bytes.
TEST(samples_are_those_of_the_reference) {
  static font_builder::Record record;
  run(INKCELL_BOARD_FIRMWARE ? 120 : 3000, [](Random& random) {
    make_any(record, random);
    GlyphField field;
    CHECK(record.size() <= sizeof(bytes));
    record.write(bytes);
    CHECK_OK(GlyphField::open({bytes, record.size()}, field));
    return check_window(field, random);
  });
}
