// TrueType files from a fuzzer: bytes in, and the promises of exercise.hpp
// checked; from storage, too, where code points have the same glyphs.
//
// The last 16 bytes of an input choose how glyphs are drawn.
#include <algorithm>
#include <memory>

#include "exercise.hpp"
#include "font_builder.hpp"
#include "front_ends.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/prepared_glyph.hpp"
#include "inkcell/supersample.hpp"
#include "inkcell/truetype/plain_truetype.hpp"
#include "inkcell/truetype/stored_truetype.hpp"
#include "inkcell/truetype/truetype_font.hpp"

namespace {

using namespace inkcell;
using font_builder::get_u16;
using font_builder::get_u32;

constexpr size_t kChoiceBytes = 16;
constexpr size_t kRam = 1600;
constexpr uint32_t kRecordBytes = 2048;
constexpr Supersample kSampled;
constexpr EdgeContrast kContrast;

Style style_of(const uint8_t* choice) {
  const Q26_6 size = Q26_6::from_raw(
      256 + static_cast<int32_t>(get_u16(choice + 1)) % (200 * 64));
  switch (choice[0] >> 1 & 3) {
    case 0:
      return Style(size);
    case 1:
      return Style(size).set_effect(kSampled);
    case 2:
      return Style(size).set_effect(kContrast);
    default: {
      Direction direction;
      direction.cosine.raw = 759250125;
      direction.sine.raw = -759250125;
      return Style(size, kFilterArea, direction);
    }
  }
}

bool read(void* context, uint32_t offset, uint8_t* bytes, uint32_t count) {
  const auto& file = *static_cast<const Span<const uint8_t>*>(context);
  for (uint32_t i = 0; i != count; ++i) {
    bytes[i] = offset + i < file.size ? file.data[offset + i] : 0;
  }
  return true;
}

// The same file in storage.
void use_stored(Span<const uint8_t> file,
                const Coding& coding,
                const Font& font,
                uint16_t glyph,
                const Style& style,
                const uint8_t* choice) {
  const size_t bytes =
      StoredTrueType::ram_bytes(1 + (choice[3] & 3), kRecordBytes);
  const auto ram = std::make_unique<uint64_t[]>(bytes / 8);
  StoredTrueTypeOptions options;
  options.coding = &coding;
  options.face = choice[3] >> 6;
  options.record_bytes = kRecordBytes;
  StoredTrueType stored;
  if (StoredTrueType::open({read, &file},
                           {reinterpret_cast<uint8_t*>(ram.get()), bytes},
                           stored, options) != Status::ok) {
    return;
  }
  const Font& same = stored.font();
  for (uint32_t code = 32; code < 96; ++code) {
    // A run that was found before may overlap with that of this one.
    stored.clear();
    hostile::require(font.glyph_or_notdef(code) == same.glyph_or_notdef(code),
                     "code points have the same glyph in storage");
  }
  for (uint16_t other = 0; other < 8; ++other) {
    static_cast<void>(same.kerning(glyph, other));
  }
  hostile::draw_checked(same, glyph, style, {});
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size <= kChoiceBytes) {
    return;
  }
  const uint8_t* const choice = data + size - kChoiceBytes;
  // In a block of its size.
  const size_t bytes = size - kChoiceBytes;
  const auto block = std::make_unique<uint8_t[]>(bytes);
  std::copy(data, data + bytes, block.get());
  TrueTypeFont opened;
  const Coding& coding =
      (choice[0] & 1) != 0 ? kPlainTrueTypeCoding : kTrueTypeCoding;
  if (opened.open({block.get(), bytes}, coding, choice[3] >> 6) != Status::ok) {
    hostile::require(opened.glyph_count() == 0, "a refused file stays closed");
    return;
  }
  const Font& font = opened.font();
  const Style style = style_of(choice);
  const uint32_t shift = choice[4] % 24;
  const Point origin = {
      Q26_6::from_raw(static_cast<int32_t>(get_u32(choice + 5)) >> shift),
      Q26_6::from_raw(static_cast<int32_t>(get_u32(choice + 9)) >> shift)};
  uint16_t glyph = 0;
  static_cast<void>(font.glyph_of(get_u16(choice + 13), glyph) == Status::ok);
  for (const uint16_t id : {glyph, static_cast<uint16_t>(choice[15])}) {
    hostile::draw_checked(font, id, style, origin);
    GlyphMetrics metrics;
    static_cast<void>(font.glyph_metrics(id, metrics) == Status::ok);
    static_cast<void>(font.kerning(id, glyph) + font.kerning(glyph, id));
  }
  const auto ram = std::make_unique<uint64_t[]>(kRam / 8);
  PreparedGlyph prepared;
  static_cast<void>(PreparedGlyph::make(
      font, glyph, style, origin, {reinterpret_cast<uint8_t*>(ram.get()), kRam},
      prepared));
  hostile::use_text(font, "AB CKL", Style(9_px), {1_px, 12_px});
  use_stored({block.get(), bytes}, coding, font, glyph, style, choice);
}
