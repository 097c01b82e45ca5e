// Bitmap masters: drawn, rendered or scanned glyphs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace inkcell::design {

/// Ink of each pixel, 0..255, row by row from the top.
struct Bitmap {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> ink;

  uint8_t at(int x, int y) const {
    return x < 0 || y < 0 || x >= width || y >= height
               ? uint8_t{0}
               : ink[static_cast<size_t>(y) * static_cast<size_t>(width) +
                     static_cast<size_t>(x)];
  }
  /// Whether all pixels are 0 or 255.
  bool is_bilevel() const;
};

/// The PNG in `bytes`, as read_bitmap() reads it; `name` is for messages.
Bitmap parse_png(const std::vector<uint8_t>& bytes, const std::string& name);

/// Reads a PNG; dark pixels are ink, transparent ones are not. Throws Error
/// that names the file.
Bitmap read_bitmap(const std::filesystem::path& file);

/// The threshold that divides the histogram best (Otsu 1979).
int otsu_threshold(const Bitmap& bitmap);

/// Sets pixels >= `threshold` to 255, others to 0.
void make_bilevel(Bitmap& bitmap, int threshold);

}  // namespace inkcell::design
