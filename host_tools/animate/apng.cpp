// Filters rows by the heuristic of the PNG specification and packs them by
// zlib.
#include "apng.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "inkcell/strip.hpp"

namespace inkcell::tools {
namespace {

constexpr size_t kChannels = 3;

void put_u16(std::vector<uint8_t>& out, uint32_t value) {
  out.push_back(static_cast<uint8_t>(value >> 8));
  out.push_back(static_cast<uint8_t>(value));
}

void put_u32(std::vector<uint8_t>& out, uint32_t value) {
  put_u16(out, value >> 16);
  put_u16(out, value & 0xffff);
}

// The box of the pixels that differ; one pixel if none do.
Rect changes(const Image& a, const Image& b) {
  Rect rect = {b.width, b.height, 0, 0};
  for (int y = 0; y < b.height; ++y) {
    for (int x = 0; x < b.width; ++x) {
      if (std::memcmp(a.at(x, y), b.at(x, y), kChannels) != 0) {
        rect = {std::min(rect.x0, x), std::min(rect.y0, y),
                std::max(rect.x1, x + 1), std::max(rect.y1, y + 1)};
      }
    }
  }
  return is_empty(rect) ? Rect{0, 0, 1, 1} : rect;
}

uint8_t paeth(int left, int up, int corner) {
  const int guess = left + up - corner;
  const int to_left = std::abs(guess - left);
  const int to_up = std::abs(guess - up);
  const int to_corner = std::abs(guess - corner);
  const int best = to_left <= to_up && to_left <= to_corner ? left
                   : to_up <= to_corner                     ? up
                                                            : corner;
  return static_cast<uint8_t>(best);
}

// Applies each of the five filters to a row and keeps the one with the smallest
// sum of absolute values.
void filter_row(const uint8_t* row,
                const uint8_t* above,
                size_t size,
                std::vector<uint8_t>& out) {
  std::array<std::vector<uint8_t>, 5> candidates;
  size_t best = 0;
  uint64_t least = UINT64_MAX;
  for (size_t kind = 0; kind < candidates.size(); ++kind) {
    std::vector<uint8_t>& bytes = candidates.at(kind);
    bytes.push_back(static_cast<uint8_t>(kind));
    uint64_t sum = 0;
    for (size_t i = 0; i < size; ++i) {
      const int left = i >= kChannels ? row[i - kChannels] : 0;
      const int up = above != nullptr ? above[i] : 0;
      const int corner =
          above != nullptr && i >= kChannels ? above[i - kChannels] : 0;
      const int guess = kind == 0   ? 0
                        : kind == 1 ? left
                        : kind == 2 ? up
                        : kind == 3 ? (left + up) / 2
                                    : paeth(left, up, corner);
      const auto byte = static_cast<uint8_t>(row[i] - guess);
      bytes.push_back(byte);
      sum += static_cast<uint64_t>(std::abs(static_cast<int8_t>(byte)));
    }
    if (sum < least) {
      least = sum;
      best = kind;
    }
  }
  out.insert(out.end(), candidates.at(best).begin(), candidates.at(best).end());
}

std::vector<uint8_t> packed(const Image& image, const Rect& part) {
  const size_t size = static_cast<size_t>(part.x1 - part.x0) * kChannels;
  std::vector<uint8_t> rows;
  for (int y = part.y0; y < part.y1; ++y) {
    filter_row(image.at(part.x0, y),
               y == part.y0 ? nullptr : image.at(part.x0, y - 1), size, rows);
  }
  uLongf bytes = compressBound(rows.size());
  std::vector<uint8_t> result(bytes);
  if (compress2(result.data(), &bytes, rows.data(), rows.size(), 6) != Z_OK) {
    throw std::runtime_error("zlib could not pack a frame");
  }
  result.resize(bytes);
  return result;
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
  constexpr std::array<char, 8> kSignature = {'\x89', 'P',  'N',    'G',
                                              '\r',   '\n', '\x1a', '\n'};
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
  const std::vector<uint8_t> pixels = packed(frame, part);
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
