// Writes pictures: PNG through libpng, PGM and PPM directly.
#include "image.hpp"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "files.hpp"

namespace inkcell::tools {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file,
                         const std::string& why) {
  throw std::runtime_error(file.string() + ": cannot be written: " + why);
}

void write_pnm(const std::filesystem::path& file, const Image& image) {
  std::ofstream out(file, std::ios::binary);
  out << (image.channels == 1 ? "P5" : "P6") << '\n'
      << image.width << ' ' << image.height << "\n255\n";
  out.write(reinterpret_cast<const char*>(image.pixels.data()),
            static_cast<std::streamsize>(image.pixels.size()));
  out.close();
  if (!out) {
    refuse(file, std::strerror(errno));
  }
}

void write_png(const std::filesystem::path& file, const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = image.channels == 1 ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
  const int written = png_image_write_to_file(&header, file.c_str(), 0,
                                              image.pixels.data(), 0, nullptr);
  if (written == 0) {
    refuse(file, header.message);
  }
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
  if (file.extension() == ".png") {
    write_png(file, image);
  } else {
    write_pnm(file, image);
  }
}

}  // namespace inkcell::tools
