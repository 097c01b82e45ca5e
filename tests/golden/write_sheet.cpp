// Writes the pages of the test sheet as pictures, and compares one with a file.
//
//   golden_write_sheet sheet FILE.ppm     all pages, four in a row
//   golden_write_sheet grey FILE.pgm      the page in 8-bit grey
//   golden_write_sheet compare FILE.pgm   1, and where, if that page differs
#include <stdio.h>

#include <cstring>
#include <string>
#include <vector>

#include "inkcell/strip.hpp"
#include "sheet.hpp"

namespace {

using namespace golden;
using inkcell::Strip;
using inkcell::port::PixelFormat;

constexpr int kGreyPage = 1;
constexpr int kColumns = 4;
constexpr int kGap = 4;

using Bytes = std::vector<uint8_t>;

void append_strip(void* context, const Strip& strip) {
  auto& bytes = *static_cast<Bytes*>(context);
  bytes.insert(bytes.end(), strip.pixels.begin(), strip.pixels.end());
}

Bytes draw_whole(int number) {
  Bytes buffer(page_buffer_bytes(page(number).format, kPageHeight));
  Bytes whole;
  if (!draw_page(number, kPageHeight, {buffer.data(), buffer.size()},
                 append_strip, &whole)) {
    fprintf(stderr, "golden_write_sheet: page %d was not drawn\n", number);
  }
  return whole;
}

struct Colour {
  uint8_t red;
  uint8_t green;
  uint8_t blue;
};

Colour grey(uint32_t level, uint32_t highest) {
  const auto value = static_cast<uint8_t>(level * 255 / highest);
  return {value, value, value};
}

Colour from_565(uint32_t pixel) {
  return {static_cast<uint8_t>((pixel >> 11) * 255 / 31),
          static_cast<uint8_t>((pixel >> 5 & 63) * 255 / 63),
          static_cast<uint8_t>((pixel & 31) * 255 / 31)};
}

// The orders of bits and bytes are in the names of pages.
Colour pixel_of(int number, const Bytes& bytes, size_t x, size_t y) {
  const PixelFormat format = page(number).format;
  const bool second = std::strstr(page(number).name, "low left") != nullptr ||
                      std::strstr(page(number).name, "high first") != nullptr ||
                      std::strstr(page(number).name, "blue") != nullptr;
  if (format == PixelFormat::mono_pages) {
    return grey(bytes[y / 8 * kPageWidth + x] >> (y % 8) & 1, 1);
  }
  const auto bits = static_cast<size_t>(inkcell::port::bits_per_pixel(format));
  const size_t bit = (y * kPageWidth + x) * bits;
  const uint8_t* at = &bytes[bit / 8];
  switch (format) {
    case PixelFormat::rgb565:
      return from_565(second ? at[0] * 256u + at[1] : at[1] * 256u + at[0]);
    case PixelFormat::rgb888:
      return second ? Colour{at[2], at[1], at[0]} : Colour{at[0], at[1], at[2]};
    case PixelFormat::xrgb8888:
      return {at[2], at[1], at[0]};
    default:
      break;
  }
  const size_t shift = second ? bit % 8 : 8 - bits - bit % 8;
  const uint32_t highest = (1u << bits) - 1;
  return grey(uint32_t{at[0]} >> shift & highest, highest);
}

bool write_file(const std::string& path,
                const char* kind,
                size_t width,
                size_t height,
                const Bytes& bytes) {
  FILE* file = fopen(path.c_str(), "wb");
  if (file == nullptr) {
    fprintf(stderr, "golden_write_sheet: cannot write %s\n", path.c_str());
    return false;
  }
  fprintf(file, "%s\n%zu %zu\n255\n", kind, width, height);
  const bool written =
      fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return fclose(file) == 0 && written;
}

bool write_sheet(const std::string& path) {
  const size_t rows = (kPageCount + kColumns - 1) / kColumns;
  const size_t width = kColumns * (kPageWidth + kGap) - kGap;
  const size_t height = rows * (kPageHeight + kGap) - kGap;
  Bytes picture(width * height * 3, 0x40);
  for (int number = 0; number < kPageCount; ++number) {
    const Bytes bytes = draw_whole(number);
    const auto left =
        static_cast<size_t>(number % kColumns * (kPageWidth + kGap));
    const auto top =
        static_cast<size_t>(number / kColumns * (kPageHeight + kGap));
    for (size_t y = 0; y < kPageHeight; ++y) {
      for (size_t x = 0; x < kPageWidth; ++x) {
        const Colour colour = pixel_of(number, bytes, x, y);
        uint8_t* at = &picture[((top + y) * width + left + x) * 3];
        at[0] = colour.red;
        at[1] = colour.green;
        at[2] = colour.blue;
      }
    }
  }
  return write_file(path, "P6", width, height, picture);
}

bool compare(const std::string& path) {
  FILE* file = fopen(path.c_str(), "rb");
  unsigned width = 0;
  unsigned height = 0;
  if (file == nullptr ||
      fscanf(file, "P5 %u %u 255%*1[\n]", &width, &height) != 2) {
    fprintf(stderr, "golden_write_sheet: cannot read %s\n", path.c_str());
    return false;
  }
  Bytes expected(kPageWidth * kPageHeight);
  const size_t size = fread(expected.data(), 1, expected.size(), file);
  fclose(file);
  const Bytes drawn = draw_whole(kGreyPage);
  int different = 0;
  for (size_t i = 0; i < drawn.size() && i < size; ++i) {
    if (drawn[i] != expected[i] && ++different <= 10) {
      printf("pixel (%zu, %zu): %d, expected %d\n", i % kPageWidth,
             i / kPageWidth, drawn[i], expected[i]);
    }
  }
  printf("%d of %zu pixels differ\n", different, drawn.size());
  return different == 0 && size == drawn.size();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string command = argc == 3 ? argv[1] : "";
  bool done = false;
  if (command == "sheet") {
    done = write_sheet(argv[2]);
  } else if (command == "grey") {
    done = write_file(argv[2], "P5", kPageWidth, kPageHeight,
                      draw_whole(kGreyPage));
  } else if (command == "compare") {
    done = compare(argv[2]);
  } else {
    fprintf(stderr, "usage: golden_write_sheet sheet|grey|compare FILE\n");
    return 2;
  }
  return done ? 0 : 1;
}
