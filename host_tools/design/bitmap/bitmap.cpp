#include "bitmap/bitmap.hpp"

#include <png.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "model/error.hpp"
#include "rom_file.hpp"

namespace inkcell::design {
namespace {

// The largest side: an area of 4 em by 4 em at 4096 px/em in any shape.
constexpr int kMostSide = 65536;
constexpr size_t kMostPixels = size_t{1} << 28;

void check_size(size_t width, size_t height, const std::string& name) {
  if (height != 0 && width > kMostPixels / height) {
    throw Error(name + ": has " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels; the most is " +
                std::to_string(kMostPixels));
  }
}

// Reads PBM and PGM: P1, P2, P4 and P5.
class NetpbmReader {
 public:
  NetpbmReader(const std::vector<uint8_t>& bytes, std::string name)
      : bytes_(bytes), name_(std::move(name)) {}

  Bitmap read() {
    const int kind = bytes_[1] - '0';
    at_ = 2;
    Bitmap bitmap;
    bitmap.width = number(kMostSide);
    bitmap.height = number(kMostSide);
    const bool is_bits = kind == 1 || kind == 4;
    const int most = is_bits ? 1 : number(255);
    if (bitmap.width == 0 || bitmap.height == 0 || most == 0) {
      refuse();
    }
    ++at_;  // one white space
    check_size(static_cast<size_t>(bitmap.width),
               static_cast<size_t>(bitmap.height), name_);
    const size_t count =
        static_cast<size_t>(bitmap.width) * static_cast<size_t>(bitmap.height);
    const size_t row = (static_cast<size_t>(bitmap.width) + 7) / 8;
    const size_t needed =
        kind == 4 ? row * static_cast<size_t>(bitmap.height) : count;
    if (kind >= 4 && bytes_.size() < at_ + needed) {
      throw Error(name_ + ": ends before its last pixel");
    }
    bitmap.ink.resize(count);
    for (size_t i = 0; i < count; ++i) {
      const size_t y = i / static_cast<size_t>(bitmap.width);
      const size_t x = i % static_cast<size_t>(bitmap.width);
      if (kind == 4) {
        const int byte = bytes_[at_ + y * row + x / 8];
        bitmap.ink[i] = (byte >> (7 - x % 8) & 1) != 0 ? 255 : 0;
      } else if (kind == 5) {
        bitmap.ink[i] = dark(bytes_[at_ + i], most);
      } else {
        const int value = kind == 1 ? digit() : number(most);
        bitmap.ink[i] =
            kind == 1 ? static_cast<uint8_t>(255 * value) : dark(value, most);
      }
    }
    return bitmap;
  }

 private:
  [[noreturn]] void refuse() const {
    throw Error(name_ + ": is no sound PBM or PGM with up to 255 greys");
  }

  static uint8_t dark(int value, int most) {
    return static_cast<uint8_t>(255 - 255 * std::min(value, most) / most);
  }

  void skip_space() {
    while (at_ < bytes_.size() &&
           (std::isspace(bytes_[at_]) != 0 || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') {
          ++at_;
        }
      } else {
        ++at_;
      }
    }
  }

  int digit() {
    skip_space();
    if (at_ >= bytes_.size() || bytes_[at_] < '0' || bytes_[at_] > '1') {
      refuse();
    }
    return bytes_[at_++] - '0';
  }

  int number(int most) {
    skip_space();
    int value = 0;
    bool any = false;
    while (at_ < bytes_.size() && std::isdigit(bytes_[at_]) != 0) {
      value = value * 10 + (bytes_[at_++] - '0');
      any = true;
      if (value > most) {
        refuse();
      }
    }
    if (!any) {
      refuse();
    }
    return value;
  }

  const std::vector<uint8_t>& bytes_;
  std::string name_;
  size_t at_ = 0;
};

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
  const std::vector<uint8_t> bytes = tools::read_file(file);
  const bool is_netpbm = bytes.size() > 8 && bytes[0] == 'P' &&
                         (bytes[1] == '1' || bytes[1] == '2' ||
                          bytes[1] == '4' || bytes[1] == '5');
  if (is_netpbm) {
    return NetpbmReader(bytes, file.string()).read();
  }
  if (bytes.size() > 8 && bytes[0] == 0x89 && bytes[1] == 'P') {
    return parse_png(bytes, file.string());
  }
  throw Error(file.string() + ": is neither PNG nor PBM nor PGM");
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
