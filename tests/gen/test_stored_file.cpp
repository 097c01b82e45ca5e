// A font for storage as a program gets it: a file, and a header of its numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <fonts/few.hpp>
#include <fonts/hanzi.hpp>

#include "inkcell/painter.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "sfnt_builder.hpp"
#include "source/char_set.hpp"

namespace inkcell::gen::test {
namespace {

// The files that inkcell_add_font() made.
constexpr const char* kFewFile = INKCELL_FEW_FILE;
constexpr const char* kHanziFile = INKCELL_HANZI_FILE;

struct StoredFile {
  explicit StoredFile(const char* path) : bytes(read_file(path)) {}

  static bool read(void* context,
                   uint32_t offset,
                   uint8_t* to,
                   uint32_t count) {
    const auto& bytes = static_cast<StoredFile*>(context)->bytes;
    if (offset > bytes.size() || count > bytes.size() - offset) {
      return false;
    }
    std::copy_n(bytes.begin() + offset, count, to);
    return true;
  }

  std::vector<uint8_t> bytes;
};

void ignore_coverage(void*, int32_t, int32_t, const uint8_t*, int32_t) {}
void ignore_solid(void*, int32_t, int32_t, int32_t) {}

// Of lines with up to 12 different glyphs, each block is read once.
alignas(8) uint8_t lent[StoredFont::ram_bytes(
    fonts::hanzi::kBlockBytes, fonts::hanzi::blocks_of_line(12))];

// `count` characters from `first` on, `step` apart, as UTF-8.
std::string characters(char32_t first, uint32_t step, uint32_t count) {
  std::string text;
  for (uint32_t i = 0; i < count; ++i) {
    text += to_utf8(first + i * step);
  }
  return text;
}

// Reads of a line that is drawn, and of the same line drawn again.
std::pair<uint32_t, uint32_t> reads_of(StoredFile& file,
                                       Span<uint8_t> ram,
                                       const std::string& line) {
  StoredFont stored;
  EXPECT_EQ(StoredFont::open({StoredFile::read, &file}, ram, stored),
            Status::ok);
  const Sink sink = {{0, 0, 800, 40}, nullptr, ignore_coverage, ignore_solid};
  uint32_t reads[3] = {stored.stats().reads};
  for (int turn = 1; turn <= 2; ++turn) {
    Painter(sink).text(stored.font(), Style(16_px), {4, 28}, line.c_str());
    reads[turn] = stored.stats().reads;
  }
  EXPECT_EQ(stored.status(), Status::ok);
  return {reads[1] - reads[0], reads[2] - reads[1]};
}

// The same with RAM for so many blocks.
std::pair<uint32_t, uint32_t> reads_of(StoredFile& file,
                                       uint32_t block_bytes,
                                       uint32_t blocks,
                                       const std::string& line) {
  const size_t size = StoredFont::ram_bytes(block_bytes, blocks);
  std::vector<uint64_t> ram(size / 8 + 1);
  return reads_of(file, {reinterpret_cast<uint8_t*>(ram.data()), size}, line);
}

TEST(StoredFile, IsWhatItsHeaderSays) {
  StoredFile file(kFewFile);
  EXPECT_EQ(file.bytes.size(), fonts::few::kFileBytes);
  EXPECT_EQ(fonts::few::kBlockBytes, 512u);
  // A font as small as this has its index in RAM.
  EXPECT_EQ(fonts::few::kIndexBlocks, 0u);
  EXPECT_EQ(fonts::few::kPairBlocks, 0u);
  EXPECT_EQ(fonts::few::blocks_of_line(10), 10u);
  StoredFile hanzi(kHanziFile);
  EXPECT_EQ(hanzi.bytes.size(), fonts::hanzi::kFileBytes);
  EXPECT_GT(fonts::hanzi::kIndexBlocks, 1u);
  EXPECT_EQ(fonts::hanzi::kPairBlocks, 1u);
  EXPECT_EQ(fonts::hanzi::blocks_of_line(1), 3u);
  EXPECT_EQ(fonts::hanzi::blocks_of_line(1000),
            1000u + fonts::hanzi::kIndexBlocks + 1u);
}

// With the blocks that the formula gives, each is read once.
TEST(StoredFile, ReadsALineOnceWithAsManyBlocksAsTheFormulaGives) {
  StoredFile few(kFewFile);
  StoredFile hanzi(kHanziFile);
  for (const uint32_t count : {1u, 5u, 12u}) {
    const std::string near = characters(0x4e00, 5, count);
    uint32_t blocks = fonts::few::blocks_of_line(count);
    auto reads = reads_of(few, fonts::few::kBlockBytes, blocks, near);
    EXPECT_LE(reads.first, blocks) << count;
    EXPECT_EQ(reads.second, 0u) << count;
    for (const uint32_t step : {1u, 7u, 40u}) {
      const std::string line = characters(0x4e00, step, count) + "AV";
      blocks = fonts::hanzi::blocks_of_line(count + 2);
      reads = reads_of(hanzi, fonts::hanzi::kBlockBytes, blocks, line);
      EXPECT_LE(reads.first, blocks) << count << " " << step;
      EXPECT_EQ(reads.second, 0u) << count << " " << step;
    }
  }
  // Without room for the index, a line whose glyphs lie far apart is read
  // again.
  const std::string far = characters(0x4e00, 60, 12);
  EXPECT_EQ(reads_of(hanzi, lent, far).second, 0u);
  EXPECT_GT(reads_of(hanzi, fonts::hanzi::kBlockBytes, 11, far).second, 0u);
}

// The sum of docs/BUILD.md for 32-bit machines, of this machine's pointers.
TEST(StoredFile, TakesRamAsDocumented) {
  const size_t head = 768 + 40 * (sizeof(void*) - 4);
  EXPECT_EQ(StoredFont::ram_bytes(1024, 1), head + 1032);
  EXPECT_EQ(StoredFont::ram_bytes(1024, 24), head + 24 * 1032);
}

}  // namespace
}  // namespace inkcell::gen::test
