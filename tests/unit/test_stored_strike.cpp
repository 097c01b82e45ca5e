// Fonts of strikes alone in storage: what they draw is what the same font in
// ROM draws.
#include "inkcell/strike/strike.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "inkcell/version.hpp"
#include "small_strike.hpp"

namespace {

using namespace inkcell;
using font_builder::put_u16;
using font_builder::put_u32;
using namespace small_strike;
namespace paged = format::paged;

constexpr uint32_t kBlock = 512;
constexpr int32_t kWidth = 64;
constexpr int32_t kHeight = 24;

alignas(4) uint8_t rom[2048];
alignas(4) uint8_t disk[2 * kBlock];
alignas(8) uint8_t ram[StoredFont::ram_bytes(kBlock, 2)];
alignas(4) uint8_t pixels[kWidth * kHeight];
uint8_t wanted[kWidth * kHeight];
uint32_t reads;
bool is_broken;

bool read(void*, uint32_t offset, uint8_t* bytes, uint32_t count) {
  CHECK(offset + count <= sizeof disk);
  ++reads;
  if (is_broken && offset != 0) {
    return false;
  }
  __builtin_memcpy(bytes, disk + offset, count);
  return true;
}

// The page behind METR: of its glyphs, from `first` on.
void write_page(uint8_t* out) {
  // METR: all glyphs have the advance of its column's base, boxes 16 bits.
  constexpr uint32_t kMetrics = 17;
  constexpr uint32_t kRecords = 60;
  put_u16(out, kAdvance);
  __builtin_memset(out + 13, 16, 4);
  static strike_font::StrikeWriter<512> strikes;
  strikes.begin(1);
  strikes.add({kPx, 1, format::StrikeFit::source, 0, kGlyphs, 0, 0},
              draw_glyph);
  const Span<const uint8_t> section = strikes.bytes();
  CHECK(kRecords + section.size <= kBlock - 16);
  __builtin_memcpy(out + kRecords, section.data, section.size);
  uint8_t boxes[10 * kGlyphs];
  strike_font::move_boxes(out + kRecords, boxes, 2);
  for (uint32_t glyph = 0; glyph != kGlyphs; ++glyph) {
    __builtin_memcpy(out + kMetrics + 8 * glyph, boxes + 10 * glyph, 8);
  }
  uint8_t* const trailer = out + kBlock - paged::trailer::kBytes;
  put_u32(trailer - 8, 'A');
  put_u16(trailer - 4, kGlyphs - 2);
  put_u16(trailer - 2, 1);
  put_u16(trailer + paged::trailer::kFirstGlyph, 1);
  trailer[paged::trailer::kGlyphs] = kGlyphs;
  trailer[paged::trailer::kRuns] = 1;
  put_u16(trailer + paged::trailer::kRecords, kRecords);
}

void write_disk() {
  constexpr uint32_t kFont = 36;  // behind the header and a root
  alignas(4) static uint8_t font[kBlock];
  const size_t size = build(1, font);
  CHECK(kFont + size <= paged::kMaxResidentBytes);
  __builtin_memset(disk, 0, sizeof disk);
  __builtin_memcpy(disk + kFont, font, size);
  put_u32(disk, paged::kMagic);
  disk[paged::kFormatMinor] = kFormatMinor;
  disk[paged::kFormatMajor] = kFormatMajor;
  put_u16(disk + paged::kResidentBytes, kFont + static_cast<uint32_t>(size));
  put_u16(disk + paged::kBlockBytes, kBlock);
  put_u16(disk + paged::kFontOffset, kFont);
  put_u16(disk + paged::kGlyphEnd, kGlyphs);
  disk[paged::kRoots] = 1;
  put_u16(disk + paged::kPages, 1);
  put_u16(disk + paged::kBytes + paged::entry::kGlyph, 1);
  put_u16(disk + paged::kBytes + paged::entry::kCodeLow, 'A');
  write_page(disk + kBlock);
  put_u32(disk + paged::kContentCrc,
          font_builder::crc32(0, {disk + kBlock, kBlock}));
  put_u32(disk + paged::kHeaderCrc,
          font_builder::crc32(
              font_builder::crc32(0, {disk, paged::kHeaderCrc}),
              {disk + paged::kContentCrc, kFont + size - paged::kContentCrc}));
}

Rect draw(const Font& font, int32_t px, const char* text) {
  __builtin_memset(pixels, 0, sizeof pixels);
  const port::A8Canvas canvas(
      {{pixels, sizeof pixels}, 0, 0, kWidth, kHeight, kWidth});
  CHECK_EQ(canvas.status(), Status::ok);
  const Painter painter(canvas);
  const Style style(Q26_6::from_int(px));
  CHECK_EQ(font.check(style), Status::ok);
  painter.text(font, style, {2, 20}, text);
  return painter.box(font, style, {2, 20}, text);
}

void check_same(const StoredFont& stored, const Font& mapped, int32_t px) {
  const Rect box = draw(mapped, px, "ACB");
  __builtin_memcpy(wanted, pixels, sizeof pixels);
  const Rect found = draw(stored.font(), px, "ACB");
  CHECK_EQ(found.x0, box.x0);
  CHECK_EQ(found.x1, box.x1);
  CHECK_EQ(found.y0, box.y0);
  CHECK_EQ(found.y1, box.y1);
  CHECK_EQ(__builtin_memcmp(wanted, pixels, sizeof pixels), 0);
  int32_t ink = 0;
  for (const uint8_t pixel : pixels) {
    ink += pixel != 0;
  }
  CHECK(ink > 3 * 20);
}

TEST(strikes_from_storage_show_what_those_in_rom_show) {
  write_disk();
  build(kGlyphs, rom);
  const Coding* const codings[] = {&kStrikeCoding, &kBitStrikeCoding};
  for (const Coding* coding : codings) {
    Font mapped;
    CHECK_EQ(Font::open(rom, *coding, mapped), Status::ok);
    StoredFont stored;
    is_broken = false;
    CHECK_EQ(StoredFont::open({read, nullptr}, ram, *coding, stored),
             Status::ok);
    CHECK_EQ(stored.verify(), Status::ok);
    check_same(stored, mapped, kPx);
    check_same(stored, mapped, 2 * kPx);
    const uint32_t before = reads;
    check_same(stored, mapped, kPx);
    CHECK_EQ(reads, before);
    CHECK_EQ(stored.status(), Status::ok);
  }
}

TEST(strikes_that_storage_does_not_give_are_notdef) {
  write_disk();
  build(kGlyphs, rom);
  Font mapped;
  CHECK_EQ(Font::open(rom, kStrikeCoding, mapped), Status::ok);
  StoredFont stored;
  is_broken = false;
  CHECK_EQ(StoredFont::open({read, nullptr}, ram, kStrikeCoding, stored),
           Status::ok);
  is_broken = true;
  draw(mapped, kPx, "?");
  __builtin_memcpy(wanted, pixels, sizeof pixels);
  draw(stored.font(), kPx, "A");
  CHECK_EQ(__builtin_memcmp(wanted, pixels, sizeof pixels), 0);
  CHECK_EQ(stored.status(), Status::read_failed);
}

TEST(strikes_are_stored_by_a_coding_that_looks_for_pages) {
  write_disk();
  is_broken = false;
  StoredFont stored;
  CHECK_EQ(StoredFont::open({read, nullptr}, ram, stored), Status::unsupported);
  CHECK_EQ(StoredFont::open({read, nullptr}, ram, kOutlineCoding, stored),
           Status::unsupported);
  CHECK_EQ(stored.font().glyph_count(), 0);
}

}  // namespace
