// Frames are kept, packed, until the colours of all are known.
#include "gif.hpp"

#include <gif_lib.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "inkcell/geometry.hpp"

namespace inkcell::tools {
namespace {

constexpr size_t kCells = 32768;
constexpr size_t kMostBytes = 1'000'000;  // of ten seconds
constexpr uint64_t kSamples = 65536;      // that giflib chooses colours of
constexpr size_t kGroundPart = 128;  // a ground covers 1/128 of the first frame

// What is tried until the file is small enough.
struct Effort {
  int colours;
  size_t step;  // one frame of so many
};
constexpr std::array<Effort, 6> kEfforts = {
    {{255, 1}, {127, 1}, {63, 1}, {31, 1}, {63, 2}, {15, 2}}};

uint16_t cell_of(const uint8_t* rgb) {
  return static_cast<uint16_t>((rgb[0] >> 3) << 10 | (rgb[1] >> 3) << 5 |
                               rgb[2] >> 3);
}

int square(int value) {
  return value * value;
}

int append(GifFileType* gif, const GifByteType* bytes, int count) {
  auto& out = *static_cast<std::vector<uint8_t>*>(gif->UserData);
  out.insert(out.end(), bytes, bytes + count);
  return count;
}

struct CloseGif {
  void operator()(GifFileType* gif) const {
    int error = 0;
    EGifCloseFile(gif, &error);
  }
};
struct FreeMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

}  // namespace

struct GifWriter::Palette {
  std::array<GifColorType, 256> colours{};
  int count = 0;
  size_t grounds = 0;          // the first colours
  std::vector<uint8_t> index;  // of each cell

  static GifColorType mean_of(const Cell& cell) {
    const auto mean = [&](size_t k) {
      return static_cast<GifByteType>((cell.sum.at(k) + cell.count / 2) /
                                      cell.count);
    };
    return {mean(0), mean(1), mean(2)};
  }

  // The map has a power of two of entries, and one that is transparent.
  int map_size() const {
    int size = 2;
    while (size <= count) {
      size *= 2;
    }
    return size;
  }
};

GifWriter::GifWriter(const std::filesystem::path& file,
                     int width,
                     int height,
                     int frames_per_second)
    : file_(file),
      out_(file, std::ios::binary),
      frames_per_second_(frames_per_second),
      before_(width, height, 3) {
  if (!out_) {
    refuse(std::strerror(errno));
  }
  begin_part();
}

void GifWriter::begin_part() {
  if (parts_.empty() || parts_.back().first != frames_.size()) {
    parts_.push_back({frames_.size(), std::vector<Cell>(kCells), {}});
  }
}

// Cells that cover much of the first frame, the largest first.
void GifWriter::find_grounds(Part& part) const {
  for (const Cell& cell : part.cells) {
    if (cell.count * kGroundPart >= before_.pixels.size() / 3) {
      part.grounds.push_back(cell);
    }
  }
  std::sort(part.grounds.begin(), part.grounds.end(),
            [](const Cell& a, const Cell& b) { return a.count > b.count; });
}

void GifWriter::add(const Image& frame) {
  const size_t count = frame.pixels.size() / 3;
  Part& part = parts_.back();
  const bool is_first = part.first == frames_.size();
  std::vector<uint16_t> cells(count);
  for (size_t i = 0; i < count; ++i) {
    const uint8_t* rgb = &frame.pixels[3 * i];
    cells[i] = cell_of(rgb);
    if (is_first || std::memcmp(rgb, &before_.pixels[3 * i], 3) != 0) {
      Cell& cell = part.cells[cells[i]];
      ++cell.count;
      for (size_t k = 0; k < 3; ++k) {
        cell.sum.at(k) += rgb[k];
      }
    }
  }
  before_ = frame;
  if (is_first) {
    find_grounds(part);
  }
  uLongf bytes = compressBound(2 * count);
  std::vector<uint8_t> packed(bytes);
  if (compress2(packed.data(), &bytes,
                reinterpret_cast<const Bytef*>(cells.data()), 2 * count,
                1) != Z_OK) {
    throw std::runtime_error("zlib could not pack a frame");
  }
  packed.resize(bytes);
  packed.shrink_to_fit();
  frames_.push_back(std::move(packed));
}

// Grounds keep their colours, in up to half of the palette. For the others
// giflib cuts the space of colours by medians; each is then the mean of the
// pixels that are nearest to it.
GifWriter::Palette GifWriter::choose_colours(const Part& part, int most) {
  uint64_t total = 0;
  for (const Cell& cell : part.cells) {
    total += cell.count;
  }
  std::array<std::vector<GifByteType>, 3> planes;
  for (const Cell& cell : part.cells) {
    if (cell.count != 0) {
      const size_t weight = 1 + cell.count * kSamples / total;
      for (size_t k = 0; k < 3; ++k) {
        planes.at(k).insert(
            planes.at(k).end(), weight,
            static_cast<GifByteType>(cell.sum.at(k) / cell.count));
      }
    }
  }
  Palette palette;
  palette.grounds =
      std::min(part.grounds.size(), static_cast<size_t>(most) / 2);
  for (size_t n = 0; n < palette.grounds; ++n) {
    palette.colours.at(n) = Palette::mean_of(part.grounds[n]);
  }
  const int grounds = static_cast<int>(palette.grounds);
  palette.count = most - grounds;
  std::vector<GifByteType> chosen(planes[0].size());
  if (GifQuantizeBuffer(static_cast<unsigned>(chosen.size()), 1, &palette.count,
                        planes[0].data(), planes[1].data(), planes[2].data(),
                        chosen.data(),
                        &palette.colours.at(palette.grounds)) == GIF_ERROR) {
    throw std::runtime_error("giflib could not choose colours");
  }
  palette.count += grounds;
  std::array<Cell, 256> sums{};
  palette.index.resize(kCells);
  for (size_t i = 0; i < kCells; ++i) {
    const Cell& cell = part.cells[i];
    if (cell.count == 0) {
      continue;
    }
    const GifColorType mean = Palette::mean_of(cell);
    int least = std::numeric_limits<int>::max();
    for (int n = 0; n < palette.count; ++n) {
      const GifColorType& colour = palette.colours.at(static_cast<size_t>(n));
      const int distance = 3 * square(colour.Red - mean.Red) +
                           4 * square(colour.Green - mean.Green) +
                           2 * square(colour.Blue - mean.Blue);
      if (distance < least) {
        least = distance;
        palette.index[i] = static_cast<uint8_t>(n);
      }
    }
    Cell& sum = sums.at(palette.index[i]);
    sum.count += cell.count;
    for (size_t k = 0; k < 3; ++k) {
      sum.sum.at(k) += cell.sum.at(k);
    }
  }
  for (size_t n = palette.grounds; n < sums.size(); ++n) {
    if (sums.at(n).count != 0) {
      palette.colours.at(n) = Palette::mean_of(sums.at(n));
    }
  }
  return palette;
}

// Takes one frame of `step`.
std::vector<uint8_t> GifWriter::encode(const std::vector<Palette>& palettes,
                                       size_t step) const {
  std::vector<uint8_t> bytes;
  int error = 0;
  std::unique_ptr<GifFileType, CloseGif> gif(EGifOpen(&bytes, append, &error));
  if (gif == nullptr) {
    refuse(GifErrorString(error));
  }
  const auto require = [&](int result) {
    if (result == GIF_ERROR) {
      refuse(GifErrorString(gif->Error));
    }
  };
  const int width = before_.width;
  const int height = before_.height;
  std::vector<std::unique_ptr<ColorMapObject, FreeMap>> maps;
  for (const Palette& palette : palettes) {
    maps.emplace_back(
        GifMakeMapObject(palette.map_size(), palette.colours.data()));
  }
  EGifSetGifVersion(gif.get(), true);
  constexpr std::array<unsigned char, 3> kForEver = {1, 0, 0};
  require(EGifPutScreenDesc(gif.get(), width, height, 8, 0, maps[0].get()));
  require(EGifPutExtensionLeader(gif.get(), APPLICATION_EXT_FUNC_CODE));
  require(EGifPutExtensionBlock(gif.get(), 11, "NETSCAPE2.0"));
  require(EGifPutExtensionBlock(gif.get(), kForEver.size(), kForEver.data()));
  require(EGifPutExtensionTrailer(gif.get()));
  std::vector<uint16_t> cells(before_.pixels.size() / 3);
  Image before;
  Image now(width, height);
  size_t index = 0;  // of the part
  for (size_t number = 0; number < frames_.size(); number += step) {
    uLongf size = 2 * cells.size();
    if (uncompress(reinterpret_cast<Bytef*>(cells.data()), &size,
                   frames_[number].data(), frames_[number].size()) != Z_OK) {
      throw std::runtime_error("zlib could not unpack a frame");
    }
    while (index + 1 < parts_.size() && parts_[index + 1].first <= number) {
      ++index;
      before = {};
    }
    const Palette& palette = palettes[index];
    std::transform(cells.begin(), cells.end(), now.pixels.begin(),
                   [&](uint16_t cell) { return palette.index[cell]; });
    const bool is_first = before.pixels.empty();
    const Rect part =
        is_first ? Rect{0, 0, width, height} : changes(before, now);
    // Whole hundredths of a second from frame to frame; the mean is exact.
    const auto time = [&](size_t frame) {
      return static_cast<int>(frame * 100 /
                              static_cast<size_t>(frames_per_second_));
    };
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime =
        time(std::min(number + step, frames_.size())) - time(number);
    control.TransparentColor = palette.map_size() - 1;
    std::array<GifByteType, 4> block{};
    const size_t block_size = EGifGCBToExtension(&control, block.data());
    require(EGifPutExtension(gif.get(), GRAPHICS_EXT_FUNC_CODE,
                             static_cast<int>(block_size), block.data()));
    require(EGifPutImageDesc(gif.get(), part.x0, part.y0, part.x1 - part.x0,
                             part.y1 - part.y0, false,
                             index == 0 ? nullptr : maps[index].get()));
    std::vector<GifByteType> row(static_cast<size_t>(part.x1 - part.x0));
    for (int y = part.y0; y < part.y1; ++y) {
      for (int x = part.x0; x < part.x1; ++x) {
        row[static_cast<size_t>(x - part.x0)] =
            !is_first && *now.at(x, y) == *before.at(x, y)
                ? static_cast<GifByteType>(control.TransparentColor)
                : *now.at(x, y);
      }
      require(EGifPutLine(gif.get(), row.data(), static_cast<int>(row.size())));
    }
    before = now;
  }
  if (EGifCloseFile(gif.release(), &error) == GIF_ERROR) {
    refuse(GifErrorString(error));
  }
  return bytes;
}

void GifWriter::finish() {
  const size_t seconds =
      frames_.size() / static_cast<size_t>(frames_per_second_);
  const size_t most = std::max(kMostBytes, kMostBytes * seconds / 10);
  std::vector<uint8_t> bytes;
  for (const Effort& effort : kEfforts) {
    std::vector<Palette> palettes;
    for (const Part& part : parts_) {
      palettes.push_back(choose_colours(part, effort.colours));
    }
    bytes = encode(palettes, effort.step);
    if (bytes.size() < most) {
      break;
    }
  }
  out_.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  out_.close();
  if (!out_) {
    refuse(std::strerror(errno));
  }
}

void GifWriter::refuse(const char* why) const {
  throw std::runtime_error(file_.string() + ": cannot be written: " +
                           (why != nullptr ? why : "unknown error"));
}

}  // namespace inkcell::tools
