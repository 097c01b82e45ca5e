// Rows that a cache keeps come back as they were.
#include "check.hpp"
#include "random.hpp"
#include "rounds.hpp"
#include "row_codes.hpp"
#include "sink_calls.hpp"

namespace {

using namespace inkcell;
using detail::Packing;

constexpr int32_t kMostRows = 20;
constexpr int32_t kMostValues = detail::kMostRowValues;

uint8_t rows[kMostRows * kMostValues];
uint8_t kept[kMostRows * (kMostValues + 16)];

// What comes back; 1 where nothing was drawn, which no row has.
struct Canvas : SinkCalls<Canvas> {
  Rect box;
  Rect window;
  int32_t channels;
  uint8_t pixels[kMostRows * kMostValues];

  uint8_t* at(int32_t x, int32_t y) {
    return pixels + ((y - box.y0) * (box.x1 - box.x0) + x - box.x0) * channels;
  }
  void put(int32_t x, int32_t y, const uint8_t* values, int32_t count) {
    const bool is_inside = fits(window, x, y, count);
    for (int32_t i = 0; is_inside && i != count * channels; ++i) {
      CHECK_EQ(at(x, y)[i], 1);
      at(x, y)[i] = values == nullptr ? 255 : values[i];
    }
  }
};

Canvas canvas;

// A value: often that of its neighbour, often empty or solid; never 1.
uint8_t value(Random& random, uint8_t before, uint32_t bits) {
  constexpr uint8_t kEnds[] = {0, 255};
  switch (random.below(4)) {
    case 0:
      return kEnds[random.below(2)];
    case 1:
      return static_cast<uint8_t>(bits == 4 ? 17 * random.below(16)
                                            : 2 + random.below(254));
    default:
      return before;
  }
}

void make_rows(Random& random, uint32_t bits, int32_t values, int32_t count) {
  for (int32_t y = 0; y != count; ++y) {
    uint8_t* const row = rows + y * values;
    const bool is_repeated = y != 0 && random.below(2) == 0;
    uint8_t last = 0;
    for (int32_t i = 0; i != values; ++i) {
      last = is_repeated ? row[i - values] : value(random, last, bits);
      row[i] = last;
    }
  }
}

// Returns the bytes that rows take.
size_t keep(Packing packing, int32_t width, int32_t count) {
  const int32_t values = width * packing.channels;
  uint8_t* last = nullptr;
  uint8_t* end = kept;
  for (int32_t y = 0; y != count; ++y) {
    uint8_t* const added =
        detail::record_row(rows + y * values, width, packing, last, end);
    CHECK(added - end <= detail::most_row_bytes(width, packing));
    if (added != end) {
      last = end;
      end = added;
    }
  }
  return static_cast<size_t>(end - kept);
}

void play(Random& random, Packing packing, const Rect& box) {
  canvas.box = box;
  canvas.channels = packing.channels;
  const int32_t width = box.x1 - box.x0;
  const int32_t count = box.y1 - box.y0;
  for (int32_t i = 0; i != width * count * packing.channels; ++i) {
    canvas.pixels[i] = 1;
  }
  Sink sink = {{}, &canvas, Canvas::coverage, Canvas::solid};
  sink.block = random.below(2) == 0 ? Canvas::block : nullptr;
  sink.coverage_rgb = packing.channels == 3 ? Canvas::coverage : nullptr;
  // In four parts.
  const int32_t x = random.between(box.x0, box.x1);
  const int32_t y = random.between(box.y0, box.y1);
  const Rect parts[] = {{-500, -500, x, y},
                        {x, -500, 500, y},
                        {-500, y, x, 500},
                        {x, y, 500, 500}};
  for (const Rect& part : parts) {
    canvas.window = part;
    sink.window = part;
    detail::replay(kept, packing, box, sink);
  }
}

TEST(rows_come_back) {
  for (Random& random : Rounds(20261124, 400)) {
    const Packing packing = {
        static_cast<uint8_t>(random.below(2) == 0 ? 4 : 8),
        static_cast<uint8_t>(random.below(3) == 0 ? 3 : 1)};
    const int32_t width = random.between(1, kMostValues / packing.channels);
    const int32_t count = random.between(1, kMostRows);
    const int32_t values = width * packing.channels;
    make_rows(random, packing.bits, values, count);
    const size_t bytes = keep(packing, width, count);
    CHECK(bytes <= sizeof kept);
    const int32_t x = random.between(-200, 200);
    const int32_t y = random.between(-60, 60);
    play(random, packing, {x, y, x + width, y + count});
    for (int32_t i = 0; i != values * count && !check::failed(); ++i) {
      const bool is_drawn = canvas.pixels[i] != 1;
      CHECK_EQ(is_drawn ? canvas.pixels[i] : 0, rows[i]);
    }
  }
}

// Values of 4 bits come back as the nearest level.
TEST(four_bits_are_rounded) {
  constexpr Packing kPacking = {4, 1};
  Random random(1);
  for (int32_t value = 0; value != 256; ++value) {
    rows[0] = static_cast<uint8_t>(value);
    keep(kPacking, 1, 1);
    play(random, kPacking, {0, 0, 1, 1});
    const int32_t drawn = canvas.pixels[0] == 1 ? 0 : canvas.pixels[0];
    CHECK_EQ(drawn, (value + 8) / 17 * 17);
  }
}

// A row of a stem, and rows that are equal to it, take the bytes of one.
TEST(what_is_plain_takes_no_bytes) {
  constexpr Packing kPacking = {4, 1};
  for (int32_t y = 0; y != 16; ++y) {
    for (int32_t i = 0; i != 16; ++i) {
      rows[y * 16 + i] = i >= 4 && i < 8 ? 255 : 0;
    }
  }
  CHECK_EQ(keep(kPacking, 16, 16), 2u);
}

}  // namespace
