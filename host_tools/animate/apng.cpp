// Puts pictures that libpng packs into the chunks of an animation.
#include "apng.hpp"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace inkcell::tools {
namespace {

constexpr std::array<char, 8> kSignature = {'\x89', 'P',  'N',    'G',
                                            '\r',   '\n', '\x1a', '\n'};

void put_u16(std::vector<uint8_t>& out, uint32_t value) {
  out.push_back(static_cast<uint8_t>(value >> 8));
  out.push_back(static_cast<uint8_t>(value));
}

void put_u32(std::vector<uint8_t>& out, uint32_t value) {
  put_u16(out, value >> 16);
  put_u16(out, value & 0xffff);
}

// The pixels of a picture as libpng packs them: what its chunks IDAT hold.
std::string packed(const Image& image) {
  constexpr size_t kAround = 12;  // length, kind and checksum of a chunk
  const std::string png = encode_png(image);
  std::string pixels;
  for (size_t at = kSignature.size(); at + kAround <= png.size();) {
    size_t size = 0;
    for (size_t i = 0; i < 4; ++i) {
      size = size << 8 | static_cast<uint8_t>(png[at + i]);
    }
    if (png.compare(at + 4, 4, "IDAT") == 0) {
      pixels += png.substr(at + 8, size);
    }
    at += size + kAround;
  }
  return pixels;
}

}  // namespace

ApngWriter::ApngWriter(const std::filesystem::path& file,
                       int width,
                       int height,
                       uint32_t frame_count,
                       int frames_per_second)
    : file_(file),
      out_(file, std::ios::binary),
      before_(width, height, 3),
      frame_count_(frame_count),
      frames_per_second_(static_cast<uint16_t>(frames_per_second)) {
  out_.write(kSignature.data(), kSignature.size());
  std::vector<uint8_t> header;
  put_u32(header, static_cast<uint32_t>(width));
  put_u32(header, static_cast<uint32_t>(height));
  constexpr std::array<uint8_t, 5> kEightBitRgb = {8, 2, 0, 0, 0};
  header.insert(header.end(), kEightBitRgb.begin(), kEightBitRgb.end());
  write_chunk("IHDR", header);
  std::vector<uint8_t> control;
  put_u32(control, frame_count);
  put_u32(control, 0);  // endless
  write_chunk("acTL", control);
}

void ApngWriter::add(const Image& frame) {
  const Rect part = frames_ == 0 ? Rect{0, 0, frame.width, frame.height}
                                 : changes(before_, frame);
  std::vector<uint8_t> control;
  put_u32(control, sequence_++);
  put_u32(control, static_cast<uint32_t>(part.x1 - part.x0));
  put_u32(control, static_cast<uint32_t>(part.y1 - part.y0));
  put_u32(control, static_cast<uint32_t>(part.x0));
  put_u32(control, static_cast<uint32_t>(part.y0));
  put_u16(control, 1);
  put_u16(control, frames_per_second_);
  put_u16(control, 0);  // keep the frame, replace its pixels
  write_chunk("fcTL", control);
  std::vector<uint8_t> data;
  if (frames_ != 0) {
    put_u32(data, sequence_++);
  }
  const std::string pixels = packed(cut(frame, part));
  data.insert(data.end(), pixels.begin(), pixels.end());
  if (frames_ == 0) {
    write_chunk("IDAT", data);
  } else {
    write_chunk("fdAT", data);
  }
  before_ = frame;
  ++frames_;
}

void ApngWriter::finish() {
  if (frames_ != frame_count_) {
    throw std::runtime_error(file_.string() + ": frames are missing");
  }
  write_chunk("IEND", {});
  out_.close();
  check();
}

void ApngWriter::write_chunk(const char (&kind)[5],
                             const std::vector<uint8_t>& data) {
  std::vector<uint8_t> chunk;
  put_u32(chunk, static_cast<uint32_t>(data.size()));
  chunk.insert(chunk.end(), kind, kind + 4);
  chunk.insert(chunk.end(), data.begin(), data.end());
  put_u32(chunk,
          static_cast<uint32_t>(
              crc32(0, chunk.data() + 4, static_cast<uInt>(chunk.size() - 4))));
  out_.write(reinterpret_cast<const char*>(chunk.data()),
             static_cast<std::streamsize>(chunk.size()));
  check();
}

void ApngWriter::check() const {
  if (!out_) {
    throw std::runtime_error(file_.string() +
                             ": cannot be written: " + std::strerror(errno));
  }
}

}  // namespace inkcell::tools
