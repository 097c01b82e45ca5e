#include "bitmap/bitmap.hpp"

#include <png.h>

#include <algorithm>
#include <cstring>

#include "model/error.hpp"
#include "rom_file.hpp"

namespace inkcell::design {
namespace {

// An area of 4 em by 4 em at 4096 px/em in any shape.
constexpr size_t kMostPixels = size_t{1} << 28;

void check_size(size_t width, size_t height, const std::string& name) {
  if (height != 0 && width > kMostPixels / height) {
    throw Error(name + ": has " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels; the most is " +
                std::to_string(kMostPixels));
  }
}

}  // namespace

bool Bitmap::is_bilevel() const {
  return std::all_of(ink.begin(), ink.end(),
                     [](uint8_t v) { return v == 0 || v == 255; });
}

Bitmap parse_png(const std::vector<uint8_t>& bytes, const std::string& name) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  Bitmap bitmap;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) !=
      0) {
    check_size(image.width, image.height, name);
    image.format = PNG_FORMAT_GRAY;
    bitmap.width = static_cast<int>(image.width);
    bitmap.height = static_cast<int>(image.height);
    bitmap.ink.resize(PNG_IMAGE_SIZE(image));
    // Transparent pixels become white.
    const png_color white = {255, 255, 255};
    png_image_finish_read(&image, &white, bitmap.ink.data(), 0, nullptr);
  }
  if (image.warning_or_error >= 2) {
    throw Error(name + ": is no sound PNG: " + image.message);
  }
  for (uint8_t& pixel : bitmap.ink) {
    pixel = static_cast<uint8_t>(255 - pixel);
  }
  return bitmap;
}

Bitmap read_bitmap(const std::filesystem::path& file) {
  return parse_png(tools::read_file(file), file.string());
}

int otsu_threshold(const Bitmap& bitmap) {
  double count[256] = {};
  for (const uint8_t v : bitmap.ink) {
    ++count[v];
  }
  double all = 0;
  double sum = 0;
  for (int v = 0; v < 256; ++v) {
    all += count[v];
    sum += v * count[v];
  }
  double below = 0;
  double sum_below = 0;
  double best = -1;
  int threshold = 128;
  for (int v = 0; v < 255; ++v) {
    below += count[v];
    sum_below += v * count[v];
    if (below == 0 || below == all) {
      continue;
    }
    const double gap = sum_below / below - (sum - sum_below) / (all - below);
    const double between = below * (all - below) * gap * gap;
    if (between > best) {
      best = between;
      threshold = v + 1;
    }
  }
  return threshold;
}

void make_bilevel(Bitmap& bitmap, int threshold) {
  for (uint8_t& v : bitmap.ink) {
    v = v >= threshold ? 255 : 0;
  }
}

}  // namespace inkcell::design
