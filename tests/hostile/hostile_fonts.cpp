// A small font, broken in every way that one or two numbers can be broken.
//
// Each broken font lies in a heap block of exactly its size, so that the
// sanitizers see a read of a single byte too much. Prints how many were
// refused and how many opened; every one that opens is used (exercise.hpp).
//
//   hostile_fonts 1       kerning classes of one byte, all damage
//   hostile_fonts 2       kerning classes of two bytes
//   hostile_fonts outline glyphs of outlines
#include <stdio.h>
#include <time.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "exercise.hpp"
#include "font_builder.hpp"
#include "good_fonts.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/verify.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using font_builder::get_u16;
using font_builder::get_u32;
using hostile::Outcome;
namespace header = format::header;
namespace section = format::section;

using hostile::Bytes;

// The results of one kind of damage.
class Tally {
 public:
  explicit Tally(const char* kind) : kind_(kind) {}
  ~Tally() {
    printf("%-44s %7d tried %7d refused %7d opened %7d verified\n", kind_,
           tried_, tried_ - opened_, opened_, verified_);
    total_tried += tried_;
    total_opened += opened_;
    total_verified += verified_;
  }
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;

  // Uses a heap block of exactly this size.
  void try_font(Span<const uint8_t> font) {
    const auto block = std::make_unique<uint8_t[]>(font.size);
    std::copy(font.begin(), font.end(), block.get());
    const clock_t begin = clock();
    const Outcome outcome = hostile::exercise({block.get(), font.size});
    slowest = std::max(slowest, clock() - begin);
    ++tried_;
    opened_ += outcome.opened ? 1 : 0;
    verified_ += outcome.verified ? 1 : 0;
  }
  void try_font(const Bytes& font) { try_font({font.data(), font.size()}); }

  // Once as it is, if the checksums notice, and once with corrected checksums.
  void try_repaired(Bytes font) {
    font_builder::repair_checksums({font.data(), font.size()});
    try_font(font);
  }

  static inline int total_tried = 0;
  static inline int total_opened = 0;
  static inline int total_verified = 0;
  static inline clock_t slowest = 0;  // of all fonts

 private:
  const char* kind_;
  int tried_ = 0;
  int opened_ = 0;
  int verified_ = 0;
};

void change_header_bytes(const Bytes& good) {
  Tally repaired("header, every byte and value, repaired");
  Tally plain("header, every byte and value, as it is");
  const size_t end = get_u16(good.data() + header::kHeaderBytes);
  for (size_t i = 0; i < end; ++i) {
    for (int change = 1; change < 256; ++change) {
      Bytes font = good;
      font[i] = static_cast<uint8_t>(font[i] ^ change);
      plain.try_font(font);
      repaired.try_repaired(font);
    }
  }
}

void change_content_bytes(const Bytes& good) {
  Tally repaired("content, every byte, 8 values, repaired");
  Tally plain("content, every byte, 1 value, as it is");
  const size_t begin = get_u16(good.data() + header::kHeaderBytes);
  for (size_t i = begin; i < good.size(); ++i) {
    const uint8_t byte = good[i];
    const uint8_t changed[] = {0,
                               0x7f,
                               0x80,
                               0xff,
                               static_cast<uint8_t>(byte + 1),
                               static_cast<uint8_t>(byte - 1),
                               static_cast<uint8_t>(byte ^ 2),
                               static_cast<uint8_t>(byte ^ 0x10)};
    Bytes font = good;
    for (const uint8_t value : changed) {
      font[i] = value;
      if (value != byte) {
        repaired.try_repaired(font);
      }
    }
    font[i] = static_cast<uint8_t>(~byte);
    plain.try_font(font);
  }
}

void truncate(const Bytes& good) {
  Tally plain("every truncation, as it is");
  Tally repaired("every truncation, size and checksums repaired");
  for (size_t size = 0; size < good.size(); ++size) {
    Bytes font(good.begin(), good.begin() + static_cast<ptrdiff_t>(size));
    plain.try_font(font);
    if (size >= header::kBytes) {
      font_builder::put_u32(font.data() + header::kTotalBytes,
                            static_cast<uint32_t>(size));
      repaired.try_repaired(font);
    }
  }
}

// The last section shrinks with the font, so that the font still opens.
void truncate_last_section(const Bytes& good) {
  Tally tally("last section cut short, all repaired");
  const uint32_t count = get_u16(good.data() + header::kSectionCount);
  for (uint32_t moved = 0; moved < count; ++moved) {
    const uint8_t* entry =
        good.data() + header::kBytes + moved * section::kBytes;
    const uint32_t offset = get_u32(entry + section::kOffset);
    const uint32_t size = get_u32(entry + section::kSize);
    // A copy of the section at the end of the font.
    Bytes base = good;
    base.resize((base.size() + 3) / 4 * 4);
    const auto begin = static_cast<uint32_t>(base.size());
    base.insert(base.end(), good.begin() + offset,
                good.begin() + offset + size);
    uint8_t* changed = base.data() + header::kBytes + moved * section::kBytes;
    font_builder::put_u32(changed + section::kOffset, begin);
    for (uint32_t kept = 0; kept <= size; ++kept) {
      Bytes font(base.begin(), base.begin() + begin + kept);
      font_builder::put_u32(font.data() + header::kBytes +
                                moved * section::kBytes + section::kSize,
                            kept);
      font_builder::put_u32(font.data() + header::kTotalBytes, begin + kept);
      tally.try_repaired(font);
    }
  }
}

void change_numbers(const Bytes& good) {
  Tally tally("every u16 and u32, values at ends, repaired");
  const auto total = static_cast<uint32_t>(good.size());
  const uint32_t halves[] = {0, 1, 0x7ffe, 0x7fff, 0x8000, 0xfffe, 0xffff};
  const uint32_t wholes[] = {0,          1,          total - 4,  total - 1,
                             total,      total + 4,  0x7ffffffc, 0x80000000,
                             0xfffffff0, 0xfffffffc, 0xffffffff};
  for (size_t i = 0; i + 2 <= good.size(); i += 2) {
    for (const uint32_t value : halves) {
      Bytes font = good;
      font_builder::put_u16(font.data() + i, value);
      tally.try_repaired(font);
    }
    if (i % 4 != 0 || i + 4 > good.size()) {
      continue;
    }
    for (const uint32_t value : wholes) {
      Bytes font = good;
      font_builder::put_u32(font.data() + i, value);
      tally.try_repaired(font);
    }
  }
}

// The record of glyph 2 in the font.
size_t record_at(const Bytes& font) {
  Font opened;
  const Status status = open_any_font({font.data(), font.size()}, opened);
  hostile::require(status == Status::ok, "the font opens");
  return static_cast<size_t>(opened.record(2).data - font.data());
}

void knot_trees(const Bytes& good) {
  Tally tally("references: cycles, absent nodes and cells");
  const size_t record = record_at(good);
  const uint32_t tiles = good[record + format::glyph::kTilesX] *
                         uint32_t{good[record + format::glyph::kTilesY]};
  const uint32_t nodes =
      get_u16(good.data() + record + format::glyph::kNodeCount);
  const uint32_t cells =
      get_u16(good.data() + record + format::glyph::kCellCount);
  std::vector<uint32_t> values = {0x7fff, 0xffff, 0x8000 + cells - 1,
                                  0x8000 + cells, 1};
  for (uint32_t node = 0; node <= nodes; ++node) {
    values.push_back(format::glyph::kFirstNode + node);
  }
  const size_t references = record + format::glyph::kBytes;
  const auto knot = [&](const std::function<uint32_t(uint32_t)>& value) {
    Bytes font = good;
    for (uint32_t i = 0; i < tiles + 4 * nodes; ++i) {
      const uint32_t reference = value(i);
      if (reference != UINT32_MAX) {
        font_builder::put_u16(font.data() + references + 2 * i, reference);
      }
    }
    tally.try_repaired(font);
  };
  for (const uint32_t value : values) {
    knot([&](uint32_t) { return value; });  // all the same
    for (uint32_t i = 0; i < tiles + 4 * nodes; ++i) {
      knot([&](uint32_t j) { return i == j ? value : UINT32_MAX; });
    }
  }
}

void change_grids(const Bytes& good) {
  Tally tally("grids and counts of a glyph record");
  const size_t record = record_at(good);
  const uint32_t tile_counts[] = {0, 1, 2, 4, 8, 15, 16, 255};
  const uint32_t corners[] = {0, 0x8000, 0xc400, 0x3c00, 0x7fff};
  for (uint32_t log2 = 0; log2 <= 13; ++log2) {
    for (const uint32_t tiles_x : tile_counts) {
      for (const uint32_t tiles_y : tile_counts) {
        for (const uint32_t corner : corners) {
          Bytes font = good;
          uint8_t* at = font.data() + record;
          at[format::glyph::kTileLog2] = static_cast<uint8_t>(log2);
          at[format::glyph::kTilesX] = static_cast<uint8_t>(tiles_x);
          at[format::glyph::kTilesY] = static_cast<uint8_t>(tiles_y);
          font_builder::put_u16(at + format::glyph::kX0, corner);
          font_builder::put_u16(at + format::glyph::kY0, corner);
          tally.try_repaired(font);
        }
      }
    }
  }
}

void change_at_random(const Bytes& good) {
  Tally several("2 to 9 random bytes, repaired");
  Tally noise("random content, sizes kept, repaired");
  Random random(1);
  for (int round = 0; round < 12000; ++round) {
    Bytes font = good;
    for (uint32_t i = 2 + random.below(8); i > 0; --i) {
      const auto size = static_cast<uint32_t>(font.size());
      font[random.below(size)] = static_cast<uint8_t>(random.next() >> 24);
    }
    several.try_repaired(font);
  }
  Font opened;
  const Status status = open_any_font({good.data(), good.size()}, opened);
  hostile::require(status == Status::ok, "the font opens");
  // With other widths the tables would hardly ever fit.
  const auto keep_header = [&](Bytes& font, uint32_t tag, uint32_t bytes) {
    if (opened.section(tag).size == 0) {
      return;
    }
    const auto at = opened.section(tag).data - good.data();
    std::copy_n(good.begin() + at, bytes, font.begin() + at);
  };
  for (int round = 0; round < 2000; ++round) {
    Bytes font = good;
    for (size_t i = get_u16(good.data() + header::kHeaderBytes);
         i < font.size(); ++i) {
      font[i] = static_cast<uint8_t>(random.next() >> 24);
    }
    keep_header(font, section::kMetrics, format::metrics::kBytes);
    keep_header(font, section::kKerning, format::kerning::kBytes);
    keep_header(font, section::kGrid, format::grid::kBytes);
    keep_header(font, section::kGlyphs, format::glyphs::kBytes);
    noise.try_repaired(font);
  }
}

// Flash that is written while the font is open.
int change_while_open(const Bytes& good) {
  Random random(2);
  int count = 0;
  const auto block = std::make_unique<uint8_t[]>(good.size());
  for (size_t i = 0; i < good.size(); ++i, ++count) {
    std::copy(good.begin(), good.end(), block.get());
    Font font;
    const Status status = open_any_font({block.get(), good.size()}, font);
    hostile::require(status == Status::ok, "the font opens");
    block[i] = static_cast<uint8_t>(i % 2 != 0 ? 0xff : random.next() >> 24);
    if (i % 16 == 0) {
      std::fill(block.get() + i, block.get() + good.size(), uint8_t{0xff});
    }
    hostile::use(font);
    static_cast<void>(verify_fields(font) == Status::ok);
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc == 2 ? argv[1] : "";
  const Bytes good = hostile::good_font(kind);
  if (good.empty()) {
    fprintf(stderr, "usage: hostile_fonts 1|2|outline\n");
    return 2;
  }
  const bool wide = kind == "2";
  const bool has_cells = kind == "1" || wide;
  printf("font of %zu bytes\n", good.size());
  const Outcome outcome = hostile::exercise({good.data(), good.size()});
  hostile::require(outcome.verified, "the font is good");
  change_header_bytes(good);
  truncate(good);
  truncate_last_section(good);
  change_numbers(good);
  if (!wide) {
    change_content_bytes(good);
    change_at_random(good);
  }
  if (has_cells && !wide) {
    knot_trees(good);
    change_grids(good);
  }
  printf("%-44s %7d used\n", "changed while open", change_while_open(good));
  printf("%d fonts tried: %d refused, %d opened, %d of them verified\n",
         Tally::total_tried, Tally::total_tried - Tally::total_opened,
         Tally::total_opened, Tally::total_verified);
  const double slowest = static_cast<double>(Tally::slowest) / CLOCKS_PER_SEC;
  printf("slowest font: %.3f s of CPU\n", slowest);
  hostile::require(slowest < 1, "bounded time");
  return 0;
}
