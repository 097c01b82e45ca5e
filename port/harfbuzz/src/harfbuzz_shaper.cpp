#include "inkcell/port/harfbuzz_shaper.hpp"

#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace {

namespace kept = format::kept_layout;
using detail::KeptLayout;

// Clusters are byte offsets of 16 bits, a character up to 4 of them.
constexpr uint32_t kMostCharacters = 65535 / 4;

// 0 where there are no bytes.
uint32_t number_at(const Span<const uint8_t>& bytes,
                   size_t at,
                   size_t width) noexcept {
  uint32_t number = 0;
  for (size_t i = width; i-- > 0 && at + width <= bytes.size;) {
    number = number << 8 | bytes.data[at + i];
  }
  return number;
}

// Where the script of the bytes [begin, end) changes; signs belong to the
// script before them, or else behind.
uint32_t script_end(const Text& text,
                    uint32_t begin,
                    uint32_t end,
                    hb_script_t& script) noexcept {
  script = HB_SCRIPT_COMMON;
  Text rest(text.data + begin, end - begin);
  while (rest.size != 0) {
    const uint32_t at = end - static_cast<uint32_t>(rest.size);
    const hb_script_t own = hb_unicode_script(hb_unicode_funcs_get_default(),
                                              next_code_point(rest));
    const bool is_sign = own == HB_SCRIPT_COMMON ||
                         own == HB_SCRIPT_INHERITED || own == HB_SCRIPT_UNKNOWN;
    if (!is_sign && own != script && script != HB_SCRIPT_COMMON) {
      return at;
    }
    script = is_sign ? script : own;
  }
  return end;
}

// The glyph of the source that glyph `glyph` is; 0: none.
uint32_t source_of(const KeptLayout& in, uint32_t glyph) noexcept {
  return glyph < number_at(in.bytes, kept::kGlyphs, 2)
             ? number_at(in.bytes, kept::kSources + 4 * glyph, 2)
             : 0;
}

// The other way round: the second numbers are ids in the order of sources.
uint32_t id_of(const KeptLayout& in, uint32_t source) noexcept {
  uint32_t low = 0;
  uint32_t high = source == 0 ? 0 : number_at(in.bytes, kept::kGlyphs, 2);
  while (low < high) {
    const uint32_t middle = (low + high) / 2;
    const uint32_t id = number_at(in.bytes, kept::kSources + 4 * middle + 2, 2);
    const uint32_t found = source_of(in, id);
    if (found == source) {
      return id;
    }
    (found < source ? low : high) = found < source ? middle + 1 : middle;
  }
  return 0;
}

// Empty for what is not kept.
hb_blob_t* table(hb_face_t*, hb_tag_t tag, void* user) {
  const Span<const uint8_t>& layout = static_cast<KeptLayout*>(user)->bytes;
  for (size_t at = kept::kTables; at < kept::kSources; at += 12) {
    const size_t begin = number_at(layout, at + 4, 4);
    const size_t size = number_at(layout, at + 8, 4);
    if (number_at(layout, at, 4) == tag && begin <= layout.size &&
        size <= layout.size - begin) {
      return hb_blob_create(reinterpret_cast<const char*>(layout.data + begin),
                            static_cast<unsigned>(size),
                            HB_MEMORY_MODE_READONLY, nullptr, nullptr);
    }
  }
  return hb_blob_get_empty();
}

hb_bool_t glyph_of(hb_font_t*,
                   void* data,
                   hb_codepoint_t code_point,
                   hb_codepoint_t* glyph,
                   void*) {
  const auto& own = *static_cast<KeptLayout*>(data);
  uint16_t id = 0;
  const bool is_found = own.font->glyph_of(code_point, id) == Status::ok;
  *glyph = is_found ? source_of(own, id) : 0;
  return is_found;
}

hb_position_t advance_of(hb_font_t*, void* data, hb_codepoint_t glyph, void*) {
  const auto& own = *static_cast<KeptLayout*>(data);
  return own.font->advance(static_cast<uint16_t>(id_of(own, glyph)));
}

}  // namespace

HarfBuzzShaper::HarfBuzzShaper(Span<TextGlyph> room) noexcept
    : WordShaper(open_font,
                 shape_part,
                 room.size < kMostCharacters ? static_cast<uint32_t>(room.size)
                                             : kMostCharacters),
      room_(room),
      buffer_(hb_buffer_create()) {}

HarfBuzzShaper::~HarfBuzzShaper() {
  hb_font_destroy(font_);
  hb_buffer_destroy(buffer_);
}

void HarfBuzzShaper::set_language(const char* tag) noexcept {
  language_ =
      tag == nullptr ? HB_LANGUAGE_INVALID : hb_language_from_string(tag, -1);
  forget();
}

bool HarfBuzzShaper::open_font(WordShaper& shaper, const Font& font) noexcept {
  auto& own = static_cast<HarfBuzzShaper&>(shaper);
  const Span<const uint8_t> section =
      font.section(format::section::kKeptLayout);
  if (own.kept_.font == &font && own.kept_.bytes.data == section.data) {
    return section.data != nullptr;
  }
  hb_font_destroy(own.font_);
  own.font_ = nullptr;
  own.kept_ = {section, &font};
  if (section.data == nullptr) {
    return false;
  }
  hb_face_t* face = hb_face_create_for_tables(table, &own.kept_, nullptr);
  hb_face_set_upem(face, font.units_per_em());
  hb_face_set_glyph_count(face, 65535);
  own.font_ = hb_font_create(face);
  hb_face_destroy(face);
  hb_font_funcs_t* functions = hb_font_funcs_create();
  hb_font_funcs_set_nominal_glyph_func(functions, glyph_of, nullptr, nullptr);
  hb_font_funcs_set_glyph_h_advance_func(functions, advance_of, nullptr,
                                         nullptr);
  hb_font_set_funcs(own.font_, functions, &own.kept_, nullptr);
  hb_font_funcs_destroy(functions);
  return true;
}

// Takes what HarfBuzz has shaped; false: the room is too small.
bool HarfBuzzShaper::fill(uint32_t begin) noexcept {
  unsigned count = 0;
  const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer_, &count);
  const hb_glyph_position_t* places =
      hb_buffer_get_glyph_positions(buffer_, &count);
  if (count > room_.size) {
    return false;
  }
  for (unsigned i = 0; i < count; ++i) {
    TextGlyph& glyph = room_.data[i];
    glyph = TextGlyph();
    glyph.glyph = static_cast<uint16_t>(id_of(kept_, infos[i].codepoint));
    glyph.cluster = static_cast<uint16_t>(infos[i].cluster - begin);
    glyph.advance = static_cast<int16_t>(places[i].x_advance);
    glyph.x = static_cast<int16_t>(places[i].x_offset);
    glyph.y = static_cast<int16_t>(places[i].y_offset);
  }
  glyphs = {room_.data, count};
  return true;
}

uint32_t HarfBuzzShaper::shape_part(WordShaper& shaper,
                                    const Text& text,
                                    uint32_t begin,
                                    uint32_t end,
                                    bool is_right_to_left) noexcept {
  auto& own = static_cast<HarfBuzzShaper&>(shaper);
  hb_script_t script;
  end = script_end(text, begin, end, script);
  own.joins = script == HB_SCRIPT_ARABIC || script == HB_SCRIPT_SYRIAC ||
              script == HB_SCRIPT_NKO || script == HB_SCRIPT_MONGOLIAN;
  own.glyphs = {};
  for (;;) {
    hb_buffer_reset(own.buffer_);
    hb_buffer_add_utf8(own.buffer_, text.data, static_cast<int>(text.size),
                       begin, static_cast<int>(end - begin));
    hb_buffer_set_direction(
        own.buffer_, is_right_to_left ? HB_DIRECTION_RTL : HB_DIRECTION_LTR);
    hb_buffer_set_script(own.buffer_, script);
    hb_buffer_set_language(own.buffer_, own.language_);
    hb_shape(own.font_, own.buffer_, nullptr, 0);
    if (own.fill(begin)) {
      return end;
    }
    const Text half = cut({text.data + begin, end - begin}, (end - begin) / 2);
    if (half.size == 0) {
      return end;
    }
    end = begin + static_cast<uint32_t>(half.size);
  }
}

}  // namespace inkcell
