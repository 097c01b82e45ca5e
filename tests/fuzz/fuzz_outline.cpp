// Outlines from a fuzzer: a font is made around the bytes, so that its header
// and checksums are always right; the promises of outline_pictures.hpp are
// checked. Front ends: front_ends.hpp. Input: outline_input.hpp.
//
// An input is a code table and records as they are, or points. Of those a
// record is made that keeps the rules of the format, so that pictures must not
// depend on windows and workspaces.
#include <algorithm>
#include <memory>

#include "exercise.hpp"
#include "font_builder.hpp"
#include "front_ends.hpp"
#include "outline_input.hpp"
#include "outline_pictures.hpp"
#include "outline_record.hpp"

namespace {

using namespace inkcell;
using font_builder::get_u16;
using font_builder::get_u32;
using font_builder::GlyphSpec;
namespace input = outline_input;

constexpr size_t kMaxPoints = 96;
constexpr size_t kMaxCodeBytes = 2 * format::outline::kMaxTables
                                 << format::outline::kMaxCodeBits;

using Bytes = Span<const uint8_t>;

Bytes take(Bytes& bytes, size_t count) {
  count = std::min(count, bytes.size);
  const Bytes taken = {bytes.data, count};
  bytes = {bytes.data + count, bytes.size - count};
  return taken;
}

// In a block of exactly its size: the sanitizer sees one byte too much.
struct Rom {
  std::unique_ptr<uint8_t[]> block;
  size_t size = 0;
};

Rom rom_of(const font_builder::FontSpec& spec) {
  static uint8_t buffer[8192];
  Rom rom;
  rom.size = font_builder::build_font(spec, {buffer, sizeof(buffer)});
  hostile::require(rom.size != 0, "the font fits its buffer");
  rom.block = std::make_unique<uint8_t[]>(rom.size);
  std::copy(buffer, buffer + rom.size, rom.block.get());
  return rom;
}

Rom font_of_records(const uint8_t* choice, Bytes rest) {
  static uint8_t code[kMaxCodeBytes];
  static uint8_t composite[1 << 12];
  font_builder::FontSpec spec;
  spec.units_per_em = static_cast<uint16_t>(
      std::clamp(get_u16(choice + input::kEm), uint32_t{16}, uint32_t{16384}));
  spec.outlines.code_bits = static_cast<uint8_t>(
      choice[input::kCodeBits] % format::outline::kMaxCodeBits + 1);
  spec.outlines.grid_shift =
      static_cast<int8_t>(choice[input::kGridShift] % 8 - 4);
  spec.outlines.max_points =
      static_cast<uint16_t>(get_u16(choice + input::kMaxPoints) % 512);
  // 1, 2, 4 or 8 tables.
  const size_t code_bytes = size_t{2} << spec.outlines.code_bits
                                      << choice[input::kCodeBits] / 64;
  const Bytes table = take(rest, code_bytes);
  std::fill(code, code + code_bytes, uint8_t{0});
  std::copy(table.begin(), table.end(), code);
  spec.outlines.code = {code, code_bytes};

  GlyphSpec glyphs[4] = {};
  for (uint32_t i = 0; i < 4; ++i) {
    glyphs[1].box[i] = glyphs[2].box[i] =
        static_cast<int16_t>(get_u16(choice + input::kBoxes + 2 * i));
    glyphs[3].box[i] =
        static_cast<int16_t>(get_u16(choice + input::kBoxes + 8 + 2 * i));
  }
  glyphs[1].bytes = take(rest, choice[input::kSizes]);
  glyphs[2].bytes = take(rest, choice[input::kSizes + 1]);
  composite[0] = format::composite::kType;
  const Bytes parts = take(rest, sizeof(composite) - 1);
  std::copy(parts.begin(), parts.end(), composite + 1);
  glyphs[3].bytes = {composite, parts.size + 1};
  spec.glyphs = {glyphs, 4};
  return rom_of(spec);
}

// Within 8 em of the origin; the first contour may not be empty.
Rom font_of_points(Bytes rest, int8_t grid_shift) {
  using outline_record::OutlinePoint;
  static OutlinePoint points[kMaxPoints];
  static uint8_t buffer[4096];
  constexpr int32_t kLimit = 8191;
  size_t count = 0;
  int32_t x = 0;
  int32_t y = 0;
  for (; rest.size >= 4 && count < kMaxPoints; take(rest, 4)) {
    const uint8_t* at = rest.data;
    x += static_cast<int8_t>(at[1]) * 32 + (at[3] & 15);
    y += static_cast<int8_t>(at[2]) * 32 + (at[3] >> 4);
    x = std::clamp(x, -kLimit, kLimit);
    y = std::clamp(y, -kLimit, kLimit);
    points[count] = {count == 0 ? outline_record::start
                                : static_cast<outline_record::Kind>(at[0] & 3),
                     static_cast<int16_t>(x), static_cast<int16_t>(y)};
    ++count;
  }
  static const outline_record::Component parts[] = {
      {1, 0, 0}, {1, 900, -300, true, {9000, -8192, 8192, 12000}}};
  const outline_record::OutlineSource glyphs[] = {
      {600}, {600, {points, count}}, {600}, {900, {}, {parts, 2}}};
  Rom rom;
  rom.size = outline_record::build_outline_font({glyphs, count == 0 ? 2u : 4u},
                                                grid_shift, 'A',
                                                {buffer, sizeof(buffer)});
  hostile::require(rom.size != 0, "the font fits its buffer");
  rom.block = std::make_unique<uint8_t[]>(rom.size);
  std::copy(buffer, buffer + rom.size, rom.block.get());
  return rom;
}

// Near the picture for small exponents, anywhere for large ones.
Q26_6 place(const uint8_t* choice, uint32_t axis) {
  const auto raw =
      static_cast<int32_t>(get_u32(choice + input::kOrigin + 4 * axis));
  return Q26_6::from_raw(raw >> (choice[input::kShift] % 24));
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size < input::kBytes) {
    return;
  }
  const uint8_t* choice = data;
  const Bytes rest = {data + input::kBytes, size - input::kBytes};
  const bool has_points = (choice[input::kFlags] & input::kHasPoints) != 0;
  const Rom rom =
      has_points
          ? font_of_points(
                rest, static_cast<int8_t>(choice[input::kGridShift] % 3 - 1))
          : font_of_records(choice, rest);
  Font font;
  if (Font::open({rom.block.get(), rom.size}, font) != Status::ok) {
    hostile::require(false, "the font opens");
    return;
  }
  const bool is_verified = font.verify() == Status::ok;
  hostile::require(!has_points || is_verified, "a font of points is verified");

  hostile::OutlineLook look;
  look.size_q6 = static_cast<int32_t>(256 + get_u16(choice + input::kSize) %
                                                (65536 - 256 + 1));
  look.filter = choice[input::kFilter] % hostile::kFilterCount;
  look.effect = choice[input::kEffect] % hostile::kEffectCount;
  look.map = choice[input::kMap] % hostile::kMapCount;
  look.is_fitted = (choice[input::kFlags] & input::kIsFitted) != 0;
  hostile::OutlineCut cut;
  cut.origin = {place(choice, 0), place(choice, 1)};
  cut.x0 = cut.y0 = -5;
  cut.x_cut = choice[input::kCut] % hostile::kPictureWidth + 1;
  cut.y_cut = choice[input::kCut + 1] % hostile::kPictureHeight + 1;
  cut.whole_bytes = get_u16(choice + input::kWorkspaces) % 4096;
  cut.part_bytes = get_u16(choice + input::kWorkspaces + 2) % 4096;
  cut.odd = choice[input::kOdd] % 4;
  const auto glyph = static_cast<uint16_t>(choice[input::kGlyph] % 5);
  // The box of the composite is not that of its parts.
  hostile::check_outline(font, glyph, look, cut, has_points && glyph != 3);
  if ((choice[input::kFlags] & input::kHasField) != 0) {
    hostile::check_generated_field(font, glyph, look, cut);
  }
}
