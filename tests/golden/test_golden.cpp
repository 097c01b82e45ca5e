// The test sheet has one SHA-256, on every machine.
#include "check_hash.hpp"
#include "expected.hpp"
#include "fonts.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/font.hpp"
#include "sheet.hpp"

namespace {

using namespace golden;
using inkcell::Font;
using inkcell::Span;
using inkcell::Strip;

constexpr int32_t kRows = 8;
constexpr size_t kBufferBytes =
    page_buffer_bytes(inkcell::port::PixelFormat::xrgb8888, kRows);

alignas(4) uint8_t buffer[kBufferBytes];

static_assert(sizeof(kPageHashes) / sizeof(*kPageHashes) == kPageCount,
              "a hash for each page");

Span<const uint8_t> bytes_of(const Strip& strip, const Page& page) {
  return {strip.pixels.data, page_buffer_bytes(page.format, strip.height)};
}

struct Hashes {
  Sha256 page;
  Sha256* sheet;
  const Page* format;
};

void add_strip(void* context, const Strip& strip) {
  auto& hashes = *static_cast<Hashes*>(context);
  const Span<const uint8_t> bytes = bytes_of(strip, *hashes.format);
  hashes.page.add(bytes);
  hashes.sheet->add(bytes);
}

void check_known(Span<const uint8_t> bytes, const char* expected) {
  Sha256 sha;
  sha.add(bytes);
  check_hash(nullptr, sha, expected);
}

}  // namespace

// FIPS 180-4's example, nothing at all, and two blocks less a byte.
TEST(sha256_is_sha256) {
  const uint8_t abc[] = {'a', 'b', 'c'};
  check_known(abc,
              "ba7816bf8f01cfea414140de5dae2223"
              "b00361a396177a9cb410ff61f20015ad");
  check_known({},
              "e3b0c44298fc1c149afbf4c8996fb924"
              "27ae41e4649b934ca495991b7852b855");
  static uint8_t zeros[127];
  check_known(zeros,
              "15dae5979058bfbf4f9166029b6e340e"
              "a3ca374fef578a11dc9e6e923860d7ae");
}

TEST(fonts_are_whole) {
  for (int i = 0; i < kFontCount; ++i) {
    const Span<const uint8_t> bytes = font_bytes(static_cast<FontId>(i));
    Font font;
    CHECK_OK(open_any_font(bytes, font));
    CHECK_OK(verify_fields(font));
    CHECK_EQ(font.rom().size, bytes.size);
  }
}

TEST(the_sheet_is_the_same_everywhere) {
  Sha256 sheet;
  for (int i = 0; i < kPageCount; ++i) {
    Hashes hashes = {{}, &sheet, &page(i)};
    CHECK(draw_page(i, kRows, buffer, add_strip, &hashes));
    check_hash(page(i).name, hashes.page, kPageHashes[i]);
  }
  check_hash("sheet", sheet, kSheetHash);
}

#if !INKCELL_BOARD_FIRMWARE

// Strips of any height: the whole page at once is the last of them.
TEST(the_sheet_is_the_same_in_any_strips) {
  static uint8_t large[page_buffer_bytes(inkcell::port::PixelFormat::xrgb8888,
                                         kPageHeight)];
  const int32_t heights[] = {16, 24, 40, 104, kPageHeight};
  for (const int32_t rows : heights) {
    for (int i = 0; i < kPageCount; ++i) {
      Sha256 sheet;
      Hashes hashes = {{}, &sheet, &page(i)};
      CHECK(draw_page(i, rows, large, add_strip, &hashes));
      check_hash(nullptr, hashes.page, kPageHashes[i]);
    }
  }
}

#endif
