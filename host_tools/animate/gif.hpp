// GIF files: 256 colours a frame, through giflib.
#pragma once

#include <cstdint>
#include <filesystem>

#include "image.hpp"

struct GifFileType;

namespace inkcell::tools {

/// Writes frames as they come, to be shown for ever. A frame of more than 256
/// colours takes the nearest of 256 that giflib chooses.
class GifWriter {
 public:
  /// Frames are of three channels and this size; GIF counts time in 1/100 s.
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
