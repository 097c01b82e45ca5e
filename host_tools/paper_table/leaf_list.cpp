// Writes the leaves of a field as the paper's linear quadtree.
#include "leaf_list.hpp"

#include <zlib.h>

#include <stdexcept>

#include "base/byte_writer.hpp"

namespace inkcell::tools {
namespace {

// Walks the trees of a glyph and writes its leaves.
class LeafWriter {
 public:
  LeafWriter(const gen::SampleTree& glyph, std::vector<uint8_t>& out)
      : glyph_(glyph), out_(out) {}

  void run() {
    const int size = 1 << glyph_.tile_log2;
    size_t tile = 0;
    for (int y = 0; y < glyph_.tiles_y; ++y) {
      for (int x = 0; x < glyph_.tiles_x; ++x) {
        visit(glyph_.references[tile++], x * size, y * size, size, 0);
      }
    }
  }

 private:
  void visit(uint16_t reference, int x, int y, int size, int level) {
    namespace layout = format::glyph;
    if (reference == layout::kOutside || reference == layout::kInside) {
      return;
    }
    if ((reference & layout::kCellFlag) != 0) {
      write(glyph_.cells[reference % layout::kCellFlag], x, y, level);
      return;
    }
    const size_t tiles = static_cast<size_t>(glyph_.tiles_x) *
                         static_cast<size_t>(glyph_.tiles_y);
    const size_t first =
        tiles + 4 * static_cast<size_t>(reference - layout::kFirstNode);
    const int half = size / 2;
    for (int child = 0; child < 4; ++child) {
      visit(glyph_.references[first + static_cast<size_t>(child)],
            x + (child & 1) * half, y + (child >> 1) * half, half, level + 1);
    }
  }

  void write(const gen::SampleCell& cell, int x, int y, int level) {
    gen::put_u16(out_, static_cast<unsigned>(x));
    gen::put_u16(out_, static_cast<unsigned>(y));
    gen::put_u8(out_, static_cast<unsigned>(level));
    out_.insert(out_.end(), cell.begin(), cell.end());
  }

  const gen::SampleTree& glyph_;
  std::vector<uint8_t>& out_;
};

}  // namespace

std::vector<uint8_t> leaf_list(const gen::SampleTree& glyph) {
  std::vector<uint8_t> out;
  LeafWriter(glyph, out).run();
  return out;
}

size_t compressed_bytes(const std::vector<uint8_t>& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<uint8_t> out(size);
  if (compress2(out.data(), &size, bytes.data(),
                static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib cannot compress");
  }
  return size;
}

}  // namespace inkcell::tools
