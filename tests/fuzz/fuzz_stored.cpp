// Fonts in storage from a fuzzer: bytes in, and bytes that change between
// reads.
//
// The last 64 bytes of an input choose what is asked for, and the faults: reads
// that fail, and bytes that differ each time. The rest is the file. What would
// make open() refuse it at once is put right: magic, version and checksums.
#include <algorithm>
#include <utility>
#include <vector>

#include "exercise.hpp"
#include "font_builder.hpp"
#include "front_ends.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/layers/colour_glyphs.hpp"
#include "inkcell/layers/verify.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/stored/paged.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "inkcell/strike/strike.hpp"
#include "inkcell/version.hpp"
#include "random.hpp"
#include "repair_font.hpp"

namespace {

using namespace inkcell;
using font_builder::get_u16;
namespace paged = format::paged;

constexpr size_t kChoiceBytes = 64;

struct File {
  std::vector<uint8_t> bytes;
  Random random;
  uint32_t failing;   // of 256 reads
  uint32_t changing;  // of 256 reads

  static bool read(void* context,
                   uint32_t offset,
                   uint8_t* bytes,
                   uint32_t count) {
    File& self = *static_cast<File*>(context);
    const bool fails = self.random.below(256) < self.failing;
    // Zeros behind the end, and half of what fails.
    for (uint32_t i = 0; i < (fails ? count / 2 : count); ++i) {
      const size_t at = size_t{offset} + i;
      bytes[i] = at < self.bytes.size() ? self.bytes[at] : uint8_t{0};
    }
    if (self.random.below(256) < self.changing) {
      for (uint32_t i = self.random.below(16); i != 0; --i) {
        bytes[self.random.below(count)] =
            static_cast<uint8_t>(self.random.below(256));
      }
    }
    return !fails;
  }
};

void repair(std::vector<uint8_t>& bytes) {
  bytes.resize(std::max<size_t>(bytes.size(), 2 * paged::kMinBlockBytes));
  uint8_t* const at = bytes.data();
  font_builder::put_u32(at, paged::kMagic);
  at[paged::kFormatMajor] = kFormatMajor;
  at[paged::kFormatMinor] = kFormatMinor;
  const uint32_t block =
      std::min(get_u16(at + paged::kBlockBytes), paged::kMaxBlockBytes);
  const uint32_t resident = std::min(get_u16(at + paged::kResidentBytes) & ~3u,
                                     paged::kMaxResidentBytes);
  const uint32_t offset =
      std::min(get_u16(at + paged::kFontOffset) & ~3u, resident);
  if (resident < paged::kBytes + format::header::kBytes ||
      offset < paged::kBytes) {
    return;
  }
  // The font ends with the block in the window.
  std::vector<uint8_t> font(at + offset, at + resident);
  font.resize(font.size() + block);
  repair_font({font.data(), font.size()});
  std::copy(font.begin(), font.begin() + (resident - offset), at + offset);
  const uint32_t crc = font_builder::crc32(
      font_builder::crc32(0, {at, paged::kHeaderCrc}),
      {at + paged::kContentCrc, resident - paged::kContentCrc});
  font_builder::put_u32(at + paged::kHeaderCrc, crc);
}

// Layers, wherever the bytes of COLR are said to end.
void use_layers(const StoredFont& stored,
                const Style& style,
                const uint8_t* choice) {
  StoredLayers layers = stored.layers();
  layers.bytes = choice[15] * 40u;
  uint32_t colour = 0;
  ColourGlyphs colours({&colour,
                        [](void* canvas, uint32_t pixel) noexcept {
                          return std::exchange(*static_cast<uint32_t*>(canvas),
                                               pixel);
                        },
                        [](const LayerColour& from) noexcept -> uint32_t {
                          return from.red + 1u;
                        }});
  colours.set_stored(layers).set_palette(choice[14]);
  static_cast<void>(verify_layers(stored.font(), &layers));
  Sink sink;
  sink.window = {0, 0, 40, 40};
  sink.coverage = [](void*, int32_t, int32_t, const uint8_t*, int32_t) {};
  sink.solid = [](void*, int32_t, int32_t, int32_t) {};
  for (uint16_t glyph = 0; glyph != 8; ++glyph) {
    Painter(sink, {}, &colours)
        .glyph(stored.font(), style, {4_px, 30_px}, glyph);
    hostile::require(colour == 0, "the colour of the text is back");
  }
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size < kChoiceBytes) {
    return;
  }
  const uint8_t* choice = data + size - kChoiceBytes;
  File file = {{data, choice}, Random(font_builder::get_u32(choice) | 1), 0, 0};
  repair(file.bytes);
  // RAM of exactly the size that is lent: the sanitizer sees one byte too much.
  const size_t blocks = 1 + choice[4] % 4;
  const size_t bytes = StoredFont::ram_bytes(paged::kMinBlockBytes, blocks);
  std::vector<uint64_t> ram((bytes + 7) / 8);
  StoredFont stored;
  if (StoredFont::open({File::read, &file},
                       {reinterpret_cast<uint8_t*>(ram.data()), ram.size() * 8},
                       stored) != Status::ok &&
      StoredFont::open({File::read, &file},
                       {reinterpret_cast<uint8_t*>(ram.data()), ram.size() * 8},
                       kStrikeCoding, stored) != Status::ok) {
    return;
  }
  file.failing = choice[5];
  file.changing = choice[6];
  const Font& font = stored.font();
  const Font copy = font;
  Style style(
      Q26_6::from_raw(static_cast<int32_t>(256 + get_u16(choice + 7) % 6000)));
  // Strikes have one size and its multiples.
  if (!font.has_outlines()) {
    style =
        Style(Q26_6::from_int(font.range().min_px % 256 * (1 + choice[7] % 4)));
  }
  hostile::expect_changing_bytes();
  Fit fit;
  FitOptions options;
  options.across = choice[9] % 2 != 0;
  if (choice[10] % 2 != 0 &&
      Fit::make(font, style, options, fit) == Status::ok) {
    style.set_fit(fit);
  }
  const Point origin = {Q26_6::from_int(4), Q26_6::from_int(40)};
  const auto* text = reinterpret_cast<const char*>(choice + 16);
  hostile::use_text(font, {text, kChoiceBytes - 16}, style, origin);
  for (uint32_t i = 11; i < 32; i += 2) {
    const auto glyph = static_cast<uint16_t>(get_u16(choice + (i & ~1u)));
    hostile::draw_checked(copy, glyph, style, origin);
    static_cast<void>(font.advance(static_cast<uint16_t>(i)));
    static_cast<void>(font.kerning(glyph, static_cast<uint16_t>(i)));
    uint16_t found = 0;
    const Status status = font.glyph_of(glyph, found);
    hostile::require(status == Status::ok || found == 0, "glyph of no status");
  }
  if (font.has_outlines()) {
    use_layers(stored, style, choice);
  }
  static_cast<void>(stored.verify());
  hostile::use_text(copy, {text, kChoiceBytes - 16}, style, origin);
}
