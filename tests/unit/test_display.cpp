// Display drivers against models of their controllers.
#include "check.hpp"
#include "inkcell/port/framebuffer.hpp"
#include "inkcell/port/ssd0303.hpp"
#include "inkcell/port/ssd0323.hpp"
#include "pixels.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::port;

// What arrived, so that a test can say that nothing did.
int bytes_received = 0;

// A panel of 32 x 16 pixels, with memory around it that must stay untouched.
constexpr int32_t kWidth = 32;
constexpr int32_t kHeight = 16;

// The SSD0323: commands set a window, data fill it and wrap around.
struct GreyModel {
  static constexpr int32_t kColumns = 20;  // bytes of two pixels
  static constexpr int32_t kRows = 20;

  uint8_t memory[kRows][kColumns] = {};
  int32_t first_column = 0, last_column = kColumns - 1, column = 0;
  int32_t first_row = 0, last_row = kRows - 1, row = 0;
  bool on = false;
  uint8_t contrast = 0;

  static int32_t parameters(uint8_t command) {
    switch (command) {
      case 0x15:
      case 0x75:
        return 2;
      case 0x81:
      case 0xa0:
      case 0xa1:
      case 0xa2:
      case 0xa8:
        return 1;
      default:
        return 0;
    }
  }

  void run(const uint8_t* c) {
    if (c[0] == 0x15) {
      column = first_column = c[1];
      last_column = c[2];
    } else if (c[0] == 0x75) {
      row = first_row = c[1];
      last_row = c[2];
    } else if (c[0] == 0xae || c[0] == 0xaf) {
      on = c[0] == 0xaf;
    } else if (c[0] == 0x81) {
      CHECK(c[1] < 128);
      contrast = c[1];
    } else if (c[0] == 0xa8) {
      CHECK_EQ(c[1], kHeight - 1);
    } else if (parameters(c[0]) == 1) {
      CHECK_EQ(c[1], 0);
    } else {
      CHECK_EQ(c[0], 0xa4);
    }
  }

  void put(uint8_t byte) {
    CHECK(row < kRows && column < kColumns);
    memory[row][column] = byte;
    if (++column > last_column) {
      column = first_column;
      row = row == last_row ? first_row : row + 1;
    }
  }

  static void command(void* context, const uint8_t* c, size_t count) {
    bytes_received += static_cast<int>(count);
    for (size_t i = 0; i < count;) {
      static_cast<GreyModel*>(context)->run(c + i);
      i += 1 + static_cast<size_t>(parameters(c[i]));
      CHECK(i <= count);
    }
  }

  static void data(void* context, const uint8_t* bytes, size_t count) {
    bytes_received += static_cast<int>(count);
    for (size_t i = 0; i < count; ++i) {
      static_cast<GreyModel*>(context)->put(bytes[i]);
    }
  }
};

// The SSD0303: commands set page and column, data move to the right.
struct PageModel {
  static constexpr int32_t kColumns = 64;
  static constexpr int32_t kPages = 4;

  uint8_t memory[kPages][kColumns] = {};
  int32_t page = 0, column = 0;
  bool on = false;
  uint8_t contrast = 0;

  static void command(void* context, const uint8_t* c, size_t count) {
    auto& model = *static_cast<PageModel*>(context);
    bytes_received += static_cast<int>(count);
    for (size_t i = 0; i < count; ++i) {
      const uint8_t low = c[i] & 15;
      switch (c[i] & 0xf0) {
        case 0x00:
          model.column = (model.column & 0xf0) | low;
          break;
        case 0x10:
          model.column = (model.column & 0x0f) | low << 4;
          break;
        case 0xb0:
          model.page = low;
          break;
        case 0x80:
          CHECK(c[i] == 0x81 && i + 1 < count);
          model.contrast = c[++i];
          break;
        default:
          model.on = c[i] == 0xaf;
      }
    }
  }

  static void data(void* context, const uint8_t* bytes, size_t count) {
    auto& model = *static_cast<PageModel*>(context);
    bytes_received += static_cast<int>(count);
    for (size_t i = 0; i < count; ++i) {
      CHECK(model.page < kPages && model.column < kColumns);
      model.memory[model.page][model.column++] = bytes[i];
    }
  }
};

uint8_t source[1024];  // of strips: no byte like its neighbours

Strip make_strip(int32_t x, int32_t y, int32_t w, int32_t h, int32_t stride) {
  for (size_t i = 0; i < sizeof source; ++i) {
    source[i] = static_cast<uint8_t>(i * 7 + i / 37 + 1);
  }
  return {source, x, y, w, h, stride};
}

// The memory `at(x, y)` of `columns` x `rows` bytes must hold the source, which
// has `stride` bytes a row, in the rectangle `bytes`, and zeros around it.
template <typename Memory>
void check_memory(const Memory& at,
                  const Rect& bytes,
                  int32_t stride,
                  int32_t columns,
                  int32_t rows) {
  for (const auto [x, y] : pixels_of(columns, rows)) {
    const int32_t i = (y - bytes.y0) * stride + x - bytes.x0;
    CHECK_EQ(at(x, y), holds(bytes, x, y) ? source[i] : 0);
  }
}

TEST(ssd0323_shows_strips_at_their_place) {
  const Rect places[] = {
      {0, 0, 32, 16}, {0, 8, 32, 16}, {6, 3, 14, 11}, {30, 15, 32, 16}};
  for (const Rect& r : places) {
    GreyModel model;
    const Ssd0323 display = {
        {&model, GreyModel::command, GreyModel::data}, kWidth, kHeight};
    init(display);
    CHECK(model.on);
    const Strip strip = make_strip(r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0, 19);
    CHECK_OK(write(display, strip));
    const auto at = [&model](int32_t x, int32_t y) {
      return model.memory[y][x];
    };
    const Rect bytes = {r.x0 / 2, r.y0, r.x1 / 2, r.y1};
    check_memory(at, bytes, 19, GreyModel::kColumns, GreyModel::kRows);
  }
}

TEST(ssd0303_shows_strips_at_their_place) {
  const Rect places[] = {
      {0, 0, 32, 16}, {0, 8, 32, 16}, {5, 0, 14, 8}, {31, 8, 32, 16}};
  for (const Rect& r : places) {
    PageModel model;
    constexpr uint8_t kFirstColumn = 21;
    const Ssd0303 display = {{&model, PageModel::command, PageModel::data},
                             kWidth,
                             kHeight,
                             kFirstColumn};
    init(display);
    CHECK(model.on);
    const Strip strip = make_strip(r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0, 35);
    CHECK_OK(write(display, strip));
    const auto at = [&model](int32_t x, int32_t y) {
      return model.memory[y][x];
    };
    const Rect bytes = {kFirstColumn + r.x0, r.y0 / 8, kFirstColumn + r.x1,
                        r.y1 / 8};
    check_memory(at, bytes, 35, PageModel::kColumns, PageModel::kPages);
  }
}

template <typename Model, typename Display>
void check_sleep_and_contrast(Model& model,
                              const Display& display,
                              int32_t most) {
  init(display);
  sleep(display);
  CHECK(!model.on);
  CHECK_OK(write(display, make_strip(0, 0, 8, 8, 8)));
  wake(display);
  CHECK(model.on);
  set_contrast(display, 255);
  CHECK_EQ(model.contrast, most);
  set_contrast(display, 0);
  CHECK_EQ(model.contrast, 0);
}

TEST(oled_panels_sleep_and_have_a_contrast) {
  GreyModel grey;
  check_sleep_and_contrast(
      grey,
      Ssd0323{{&grey, GreyModel::command, GreyModel::data}, kWidth, kHeight},
      127);
  PageModel page;
  check_sleep_and_contrast(
      page,
      Ssd0303{{&page, PageModel::command, PageModel::data}, kWidth, kHeight},
      255);
}

// A strip in bytes, for a format of `bits` to the pixel.
void check_framebuffer(PixelFormat format, const Rect& r) {
  static uint8_t pixels[kHeight][36 * 4];
  for (auto& row : pixels) {
    for (uint8_t& byte : row) {
      byte = 0;
    }
  }
  constexpr int32_t kStride = sizeof pixels[0];
  const bool pages = format == PixelFormat::mono_pages;
  const int32_t bits = pages ? 8 : bits_per_pixel(format);
  const int32_t rows = pages ? 8 : 1;
  const Framebuffer display = {
      {&pixels[0][0], sizeof pixels}, format, kWidth, kHeight, kStride};
  const int32_t stride = stride_bytes(format, r.x1 - r.x0);
  const Strip strip = make_strip(r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0, stride);
  CHECK_OK(write(display, strip));
  const auto at = [](int32_t x, int32_t y) { return pixels[y][x]; };
  const Rect bytes = {r.x0 * bits / 8, r.y0 / rows, r.x1 * bits / 8,
                      r.y1 / rows};
  check_memory(at, bytes, stride, kStride, kHeight);
}

TEST(framebuffer_shows_strips_at_their_place) {
  const Rect narrow = {16, 8, 24, 16};
  check_framebuffer(PixelFormat::mono_rows, {0, 0, 32, 16});
  check_framebuffer(PixelFormat::mono_rows, narrow);
  check_framebuffer(PixelFormat::mono_pages, {3, 8, 10, 16});
  check_framebuffer(PixelFormat::grey2, {4, 1, 12, 7});
  check_framebuffer(PixelFormat::grey4, {2, 1, 12, 7});
  check_framebuffer(PixelFormat::grey8, {3, 1, 10, 7});
  check_framebuffer(PixelFormat::rgb565, {3, 1, 10, 7});
  check_framebuffer(PixelFormat::rgb888, {3, 1, 10, 7});
  check_framebuffer(PixelFormat::xrgb8888, {0, 9, 32, 16});
}

// Each of these leaves a screen of 32 x 16, or its bytes.
TEST(strips_that_do_not_fit_are_refused) {
  constexpr int32_t kHuge = 0x7fffffff;
  const Strip wrong[] = {
      make_strip(-2, 0, 8, 8, 16),    make_strip(26, 0, 8, 8, 16),
      make_strip(0, -8, 8, 8, 16),    make_strip(0, 16, 8, 8, 16),
      make_strip(0, 0, 0, 8, 16),     make_strip(0, 0, 8, 0, 16),
      make_strip(0, 0, 34, 8, 34),    make_strip(0, 0, 8, 24, 16),
      make_strip(0, 0, -8, 8, 16),    make_strip(kHuge, 0, 8, 8, 16),
      make_strip(0, 0, kHuge, 8, 16), make_strip(0, 0, 8, 8, 3),
      make_strip(0, 0, 8, 8, -16),    make_strip(0, 0, 8, 8, 65536),
  };
  GreyModel grey;
  PageModel page;
  uint8_t pixels[kWidth / 2 * kHeight] = {};
  const Ssd0323 ssd0323 = {
      {&grey, GreyModel::command, GreyModel::data}, kWidth, kHeight};
  const Ssd0303 ssd0303 = {
      {&page, PageModel::command, PageModel::data}, kWidth, kHeight, 0};
  const Framebuffer framebuffer = {pixels, PixelFormat::grey4, kWidth, kHeight,
                                   kWidth / 2};
  bytes_received = 0;
  for (const Strip& strip : wrong) {
    CHECK_EQ(write(ssd0323, strip), Status::bad_argument);
    CHECK_EQ(write(ssd0303, strip), Status::bad_argument);
    CHECK_EQ(write(framebuffer, strip), Status::bad_argument);
  }
  CHECK_EQ(write(ssd0323, make_strip(1, 0, 8, 8, 16)), Status::bad_argument);
  CHECK_EQ(write(ssd0323, make_strip(0, 0, 7, 8, 16)), Status::bad_argument);
  CHECK_EQ(write(ssd0303, make_strip(0, 4, 8, 8, 16)), Status::bad_argument);
  CHECK_EQ(write(ssd0303, make_strip(0, 0, 8, 4, 16)), Status::bad_argument);
  CHECK_EQ(bytes_received, 0);
  for (const uint8_t byte : pixels) {
    CHECK_EQ(byte, 0);
  }
}

// A display that the controller has no memory for, whatever the strip.
TEST(displays_that_are_too_large_are_refused) {
  GreyModel grey;
  PageModel page;
  const DisplayBus grey_bus = {&grey, GreyModel::command, GreyModel::data};
  const DisplayBus page_bus = {&page, PageModel::command, PageModel::data};
  const Strip strip = make_strip(0, 0, 8, 8, 8);
  bytes_received = 0;
  CHECK_EQ(write(Ssd0323{grey_bus, 130, 64}, strip), Status::bad_argument);
  CHECK_EQ(write(Ssd0323{grey_bus, 128, 81}, strip), Status::bad_argument);
  CHECK_EQ(write(Ssd0303{page_bus, 133, 64, 0}, strip), Status::bad_argument);
  CHECK_EQ(write(Ssd0303{page_bus, 132, 72, 0}, strip), Status::bad_argument);
  CHECK_EQ(write(Ssd0303{page_bus, 96, 16, 37}, strip), Status::bad_argument);
  CHECK_EQ(bytes_received, 0);
  CHECK_OK(write(Ssd0323{grey_bus, 128, 80}, strip));
  CHECK_OK(write(Ssd0303{page_bus, 96, 64, 36}, strip));
}

// Widths whose bits are more than 2^31.
TEST(absurd_framebuffers_are_refused) {
  uint8_t pixels[64] = {};
  for (const int32_t width : each_of({0x7ffffff8, 32768})) {
    const Framebuffer display = {pixels, PixelFormat::xrgb8888, width, 16,
                                 65535};
    CHECK_EQ(write(display, make_strip(0, 0, width, 8, 65535)),
             Status::bad_argument);
    CHECK_EQ(write(display, make_strip(0, 0, 8, 8, 32)), Status::bad_argument);
  }
}

TEST(too_few_pixels_are_refused) {
  GreyModel grey;
  const Ssd0323 ssd0323 = {
      {&grey, GreyModel::command, GreyModel::data}, kWidth, kHeight};
  Strip strip = make_strip(0, 0, 8, 4, 10);
  strip.pixels.size = 3 * 10 + 4;
  CHECK_OK(write(ssd0323, strip));
  --strip.pixels.size;
  bytes_received = 0;
  CHECK_EQ(write(ssd0323, strip), Status::buffer_small);
  CHECK_EQ(bytes_received, 0);

  uint8_t pixels[kWidth / 2 * kHeight];
  Framebuffer framebuffer = {pixels, PixelFormat::grey4, kWidth, kHeight,
                             kWidth / 2};
  CHECK_OK(write(framebuffer, make_strip(0, 0, 8, 4, 10)));
  --framebuffer.pixels.size;
  CHECK_EQ(write(framebuffer, make_strip(0, 0, 8, 4, 10)),
           Status::buffer_small);
}

}  // namespace
