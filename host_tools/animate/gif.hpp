// GIF files: 256 colours a frame, through giflib.
#pragma once

#include <cstdint>
#include <filesystem>

#include "image.hpp"

struct GifFileType;

namespace inkcell::tools {

/// Writes frames one by one, as an endless loop. giflib reduces frames of more
/// than 256 colours.
class GifWriter {
 public:
  /// Frames have three channels and this size; GIF counts time in 1/100 s.
  /// Throws std::runtime_error, also below, if the file cannot be written.
  GifWriter(const std::filesystem::path& file,
            int width,
            int height,
            int frames_per_second);
  ~GifWriter();
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  void add(const Image& frame);
  void finish();

 private:
  [[noreturn]] void refuse(int error) const;

  std::filesystem::path file_;
  GifFileType* gif_ = nullptr;
  int frames_per_second_;
  int frames_ = 0;
};

}  // namespace inkcell::tools
