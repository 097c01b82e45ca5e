// GIF files: one palette for all frames, or for those of a part, through
// giflib.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "image.hpp"

namespace inkcell::tools {

/// Writes frames as an endless loop, at the end. After the first each is the
/// rectangle that changed, with what stays as it is left transparent. Takes 255
/// colours, or fewer, or half of the frames, until ten seconds take less than
/// 1 MB. Colours that cover much of the first frame stay as they are. Parts
/// have a palette each, and begin with a whole frame.
class GifWriter {
 public:
  /// Frames have three channels and this size; GIF counts time in 1/100 s.
  /// Throws std::runtime_error, also below, if the file cannot be written.
  GifWriter(const std::filesystem::path& file,
            int width,
            int height,
            int frames_per_second);

  /// The next frame begins a part.
  void begin_part();
  void add(const Image& frame);
  void finish();

 private:
  // Colours that are equal in the five upper bits of each channel.
  struct Cell {
    uint64_t count = 0;  // pixels that became one of them
    std::array<uint64_t, 3> sum{};
  };
  struct Part {
    size_t first = 0;  // frame
    std::vector<Cell> cells;
    std::vector<Cell> grounds;  // of the first frame
  };
  struct Palette;

  void find_grounds(Part& part) const;
  static Palette choose_colours(const Part& part, int most);
  std::vector<uint8_t> encode(const std::vector<Palette>& palettes,
                              size_t step) const;
  [[noreturn]] void refuse(const char* why) const;

  std::filesystem::path file_;
  std::ofstream out_;
  int frames_per_second_;
  Image before_;
  std::vector<Part> parts_;
  std::vector<std::vector<uint8_t>> frames_;  // a cell each pixel, packed
};

}  // namespace inkcell::tools
