// Writes pictures: PNG through libpng, PGM and PPM directly.
#include "image.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "files.hpp"
#include "png.hpp"

namespace inkcell::tools {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file,
                         const std::string& why) {
  throw std::runtime_error(file.string() + ": cannot be written: " + why);
}

std::string encode_pnm(const Image& image) {
  return (image.channels == 1 ? "P5\n" : "P6\n") + std::to_string(image.width) +
         " " + std::to_string(image.height) + "\n255\n" +
         std::string(image.pixels.begin(), image.pixels.end());
}

}  // namespace

Image::Image(int w, int h, int channel_count, uint8_t value)
    : width(w),
      height(h),
      channels(channel_count),
      pixels(static_cast<size_t>(w) * static_cast<size_t>(h) *
                 static_cast<size_t>(channel_count),
             value) {}

Image enlarge(const Image& image, int factor) {
  Image result(image.width * factor, image.height * factor, image.channels);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      std::memcpy(result.at(x, y), image.at(x / factor, y / factor),
                  static_cast<size_t>(image.channels));
    }
  }
  return result;
}

Image cut(const Image& image, const Rect& part) {
  Image result(part.x1 - part.x0, part.y1 - part.y0, image.channels);
  for (int y = 0; y < result.height; ++y) {
    std::copy_n(image.at(part.x0, part.y0 + y), result.width * image.channels,
                result.at(0, y));
  }
  return result;
}

Rect changes(const Image& before, const Image& now) {
  Rect box;
  for (int y = 0; y < now.height; ++y) {
    for (int x = 0; x < now.width; ++x) {
      if (std::memcmp(before.at(x, y), now.at(x, y),
                      static_cast<size_t>(now.channels)) != 0) {
        box = bounding_box(box, {x, y, x + 1, y + 1});
      }
    }
  }
  return is_empty(box) ? Rect{0, 0, 1, 1} : box;
}

void paste(const Image& from, int x, int y, Image& to) {
  for (int row = 0; row < from.height; ++row) {
    const uint8_t* line = from.at(0, row);
    std::copy(line, line + from.channels * from.width, to.at(x, y + row));
  }
}

void invert(Image& image) {
  for (uint8_t& value : image.pixels) {
    value = static_cast<uint8_t>(255 - value);
  }
}

void round_to_levels(Image& image, int levels) {
  const int step = 255 / (levels - 1);
  for (uint8_t& value : image.pixels) {
    value = static_cast<uint8_t>((value + step / 2) / step * step);
  }
}

std::string encode_png(const Image& image) {
  return encode_png(image.width, image.height, image.channels == 1,
                    image.pixels);
}

void check_folder_of(const std::filesystem::path& file) {
  if (file == "-") {
    refuse(file,
           "it is not standard output here; name a file, ./- if it shall be "
           "called so");
  }
  const std::filesystem::path folder = file.parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
    refuse(file, "there is no folder " + folder.string());
  }
  if (!file.empty()) {
    refuse_among_fonts(file);
  }
}

void check_image_file(const std::filesystem::path& file, int channels) {
  const std::string suffix = file.extension().string();
  const std::string plain = channels == 1 ? ".pgm" : ".ppm";
  if (suffix != ".png" && suffix != plain) {
    refuse(file, "the name must end in .png or " + plain);
  }
  check_folder_of(file);
}

void write_image(const std::filesystem::path& file, const Image& image) {
  check_image_file(file, image.channels);
  if (image.width <= 0 || image.height <= 0) {
    refuse(file, "the picture has no pixels");
  }
  const std::string bytes =
      file.extension() == ".png" ? encode_png(image) : encode_pnm(image);
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) {
    refuse(file, std::strerror(errno));
  }
}

}  // namespace inkcell::tools
