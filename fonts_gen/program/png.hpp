// PNG files, through libpng.
#pragma once

#include <png.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace inkcell::tools {

/// Rows of 8-bit pixels, grey or red, green, blue, as the content of a file.
/// Throws std::runtime_error.
inline std::string encode_png(int width,
                              int height,
                              bool is_grey,
                              const std::vector<uint8_t>& pixels) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(width);
  header.height = static_cast<png_uint_32>(height);
  header.format = is_grey ? PNG_FORMAT_GRAY : PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string png(size, '\0');
  if (png_image_write_to_memory(&header, png.data(), &size, 0, pixels.data(), 0,
                                nullptr) == 0) {
    throw std::runtime_error(std::string("no PNG: ") + header.message);
  }
  png.resize(size);
  return png;
}

}  // namespace inkcell::tools
