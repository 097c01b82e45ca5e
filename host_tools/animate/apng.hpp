// Animated PNG files, as endless loops.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "image.hpp"

namespace inkcell::tools {

/// Writes frames one by one (PNG third edition, chunks acTL, fcTL, fdAT). After
/// the first each is the rectangle that changed. The same frames give the same
/// bytes with the same libpng and zlib.
class ApngWriter {
 public:
  /// Frames have three channels and this size; each is shown for 1 /
  /// `frames_per_second` s. Throws std::runtime_error, also below, if the file
  /// cannot be written.
  ApngWriter(const std::filesystem::path& file,
             int width,
             int height,
             uint32_t frame_count,
             int frames_per_second);

  void add(const Image& frame);

  /// Throws also if the number of frames is not frame_count.
  void finish();

 private:
  void write_chunk(const char (&kind)[5], const std::vector<uint8_t>& data);
  void check() const;

  std::filesystem::path file_;
  std::ofstream out_;
  Image before_;
  uint32_t frame_count_;
  uint16_t frames_per_second_;
  uint32_t frames_ = 0;
  uint32_t sequence_ = 0;
};

}  // namespace inkcell::tools
