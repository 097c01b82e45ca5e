// Pictures in memory and in files: PNG, PGM and PPM.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "inkcell/geometry.hpp"

namespace inkcell::tools {

/// 8-bit pixels, row by row from the top; grey or red, green, blue.
struct Image {
  int width = 0;  // [px]
  int height = 0;
  int channels = 1;  // 1 or 3
  std::vector<uint8_t> pixels;

  Image() = default;
  /// All pixels `value`.
  Image(int w, int h, int channel_count = 1, uint8_t value = 0);

  uint8_t* at(int x, int y) { return pixels.data() + index(x, y); }
  const uint8_t* at(int x, int y) const { return pixels.data() + index(x, y); }

 private:
  size_t index(int x, int y) const {
    return (static_cast<size_t>(y) * static_cast<size_t>(width) +
            static_cast<size_t>(x)) *
           static_cast<size_t>(channels);
  }
};

/// Every pixel as a square of `factor` x `factor` pixels.
Image enlarge(const Image& image, int factor);

/// A part of a picture.
Image cut(const Image& image, const Rect& part);

/// The box of the pixels that differ between pictures of one size and kind; one
/// pixel if none do.
Rect changes(const Image& before, const Image& now);

/// Copies `from` to `to`, its upper left pixel at (x, y). Both have as
/// many channels.
void paste(const Image& from, int x, int y, Image& to);

/// 255 - value, everywhere.
void invert(Image& image);

/// As a display of so many levels stores them. [2, 4, 256]
void round_to_levels(Image& image, int levels);

/// Throws std::runtime_error, before work begins, for a name that write_image()
/// would refuse: in a folder that does not exist, or with another suffix.
void check_image_file(const std::filesystem::path& file, int channels);

/// The same for any kind of file; also refuses '-', which many take for
/// standard output.
void check_folder_of(const std::filesystem::path& file);

/// The content of a PNG file. Throws std::runtime_error.
std::string encode_png(const Image& image);

/// Writes by the file's suffix: .png, .pgm (grey) or .ppm (colour).
///
/// Throws std::runtime_error that names the file.
void write_image(const std::filesystem::path& file, const Image& image);

}  // namespace inkcell::tools
