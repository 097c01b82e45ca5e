#include "gif.hpp"

#include <gif_lib.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace inkcell::tools {

GifWriter::GifWriter(const std::filesystem::path& file,
                     int width,
                     int height,
                     int frames_per_second)
    : file_(file), frames_per_second_(frames_per_second) {
  int error = 0;
  gif_ = EGifOpenFileName(file.c_str(), false, &error);
  if (gif_ == nullptr) {
    refuse(error);
  }
  EGifSetGifVersion(gif_, true);
  constexpr std::array<unsigned char, 3> kForEver = {1, 0, 0};
  if (EGifPutScreenDesc(gif_, width, height, 8, 0, nullptr) == GIF_ERROR ||
      EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_ERROR ||
      EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") == GIF_ERROR ||
      EGifPutExtensionBlock(gif_, kForEver.size(), kForEver.data()) ==
          GIF_ERROR ||
      EGifPutExtensionTrailer(gif_) == GIF_ERROR) {
    refuse(gif_->Error);
  }
}

GifWriter::~GifWriter() {
  if (gif_ != nullptr) {
    int error = 0;
    EGifCloseFile(gif_, &error);
  }
}

void GifWriter::add(const Image& frame) {
  const size_t count =
      static_cast<size_t>(frame.width) * static_cast<size_t>(frame.height);
  std::array<std::vector<GifByteType>, 3> planes;
  for (size_t channel = 0; channel < planes.size(); ++channel) {
    planes.at(channel).resize(count);
    for (size_t i = 0; i < count; ++i) {
      planes.at(channel)[i] = frame.pixels[3 * i + channel];
    }
  }
  std::array<GifColorType, 256> colours{};
  int colour_count = static_cast<int>(colours.size());
  std::vector<GifByteType> pixels(count);
  if (GifQuantizeBuffer(static_cast<unsigned>(frame.width),
                        static_cast<unsigned>(frame.height), &colour_count,
                        planes[0].data(), planes[1].data(), planes[2].data(),
                        pixels.data(), colours.data()) == GIF_ERROR) {
    throw std::runtime_error("giflib could not choose colours");
  }
  ColorMapObject* map =
      GifMakeMapObject(static_cast<int>(colours.size()), colours.data());
  // Whole hundredths of a second from frame to frame; the mean is exact.
  const int begin = frames_ * 100 / frames_per_second_;
  const int end = (frames_ + 1) * 100 / frames_per_second_;
  GraphicsControlBlock control{};
  control.DisposalMode = DISPOSE_DO_NOT;
  control.DelayTime = end - begin;
  control.TransparentColor = NO_TRANSPARENT_COLOR;
  std::array<GifByteType, 4> block{};
  const size_t size = EGifGCBToExtension(&control, block.data());
  bool is_written =
      EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size),
                       block.data()) == GIF_OK &&
      EGifPutImageDesc(gif_, 0, 0, frame.width, frame.height, false, map) ==
          GIF_OK;
  for (int y = 0; is_written && y < frame.height; ++y) {
    is_written = EGifPutLine(gif_, pixels.data() + y * frame.width,
                             frame.width) == GIF_OK;
  }
  GifFreeMapObject(map);
  if (!is_written) {
    refuse(gif_->Error);
  }
  ++frames_;
}

void GifWriter::finish() {
  int error = 0;
  GifFileType* gif = gif_;
  gif_ = nullptr;
  if (EGifCloseFile(gif, &error) == GIF_ERROR) {
    refuse(error);
  }
}

void GifWriter::refuse(int error) const {
  const char* why = GifErrorString(error);
  throw std::runtime_error(file_.string() + ": cannot be written: " +
                           (why != nullptr ? why : "unknown error"));
}

}  // namespace inkcell::tools
