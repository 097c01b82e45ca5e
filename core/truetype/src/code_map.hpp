// The glyphs of code points: `cmap` of formats 0, 4, 6 and 12.
#pragma once

#include "tables.hpp"

namespace inkcell::detail {

// Code points side by side whose glyphs are found alike.
struct CodeRun {
  uint32_t first;
  uint32_t last;
  uint32_t offset;  // what is added to a code point, or to what is at `array`
  uint32_t array;   // where the subtable has a glyph for each; 0: nowhere
};

// How well a subtable of cmap serves; 0: not at all.
inline uint32_t rank_of_map(uint32_t platform,
                            uint32_t encoding,
                            uint32_t format) noexcept {
  const bool is_unicode =
      platform == 0 || (platform == 3 && (encoding <= 1 || encoding == 10));
  if (format == 12) {
    return is_unicode ? 4 : 0;
  }
  if (format == 4) {
    return is_unicode ? 3 : 0;
  }
  // Of other encodings ASCII is the same.
  return format == 0 || format == 6 ? (is_unicode ? 2 : 1) : 0;
}

template <typename Face>
static void choose_map(const typename Face::AnyTable& cmap,
                       Face& face) noexcept {
  uint32_t best = 0;
  const uint32_t count = u16_at(cmap, 2);
  for (uint32_t at = 4; at < 4 + 8 * count && at < cmap.size; at += 8) {
    const typename Face::AnyTable found = part_of(cmap, u32_at(cmap, at + 4));
    const uint32_t format = u16_at(found, 0);
    const uint32_t rank =
        rank_of_map(u16_at(cmap, at), u16_at(cmap, at + 2), format);
    if (rank > best) {
      best = rank;
      face.cmap = found;
      face.cmap_format = static_cast<uint8_t>(format);
    }
  }
}

// Format 4: segments of 16 bits, in four arrays.
template <typename AnyTable>
static bool find_segment(const AnyTable& cmap,
                         uint32_t code,
                         CodeRun& run) noexcept {
  const uint32_t bytes = u16_at(cmap, 6) & ~1u;  // of an array
  uint32_t low = 0;
  uint32_t high = bytes;
  while (low < high) {
    const uint32_t middle = (low + high) >> 1 & ~1u;
    if (code > key_at(cmap, 14 + middle, high - low)) {
      low = middle + 2;
    } else {
      high = middle;
    }
  }
  const uint32_t at = 16 + bytes + low;
  run.first = u16_at(cmap, at);
  if (low >= bytes || code < run.first) {
    return false;
  }
  run.last = u16_at(cmap, 14 + low);
  run.offset = u16_at(cmap, at + bytes);
  const uint32_t from = u16_at(cmap, at + 2 * bytes);
  run.array = from == 0 ? 0 : at + 2 * bytes + from;
  return true;
}

// Finds the run of a code point; in it glyph_in() finds the glyph.
template <typename Face>
static bool find_run_of(const Face& face,
                        uint32_t code,
                        CodeRun& run) noexcept {
  const auto& cmap = face.cmap;
  const uint32_t format = face.cmap_format;
  if (format == 12) {
    const auto most = static_cast<uint32_t>(cmap.size / 12);
    const uint32_t said = u32_at(cmap, 12);
    const uint32_t at =
        find_record(cmap, {16, said < most ? said : most, 12, 4, true}, code);
    run = {u32_at(cmap, at), u32_at(cmap, at + 4), 0, 0};
    run.offset = u32_at(cmap, at + 8) - run.first;
    return at != 0;
  }
  if (format == 4) {
    return code < 0x10000 && find_segment(cmap, code, run);
  }
  uint32_t count = 256;
  run = {0, 0, 0, 6};
  if (format != 0) {
    run.first = u16_at(cmap, 6);
    run.array = 10;
    count = u16_at(cmap, 8);
  }
  run.last = run.first + count - 1;
  return code - run.first < count;
}

// The glyph of a code point of the run; 0: none.
template <typename Face>
static uint32_t glyph_in(const Face& face,
                         const CodeRun& run,
                         uint32_t code) noexcept {
  if (run.array != 0) {
    const uint32_t at = code - run.first;
    code = face.cmap_format == 0 ? u16_at(face.cmap, run.array + at - 1) & 255
                                 : u16_at(face.cmap, run.array + 2 * at);
    if (code == 0) {
      return 0;
    }
  }
  code += run.offset;
  return face.cmap_format == 4 ? code & 0xffff : code;
}

}  // namespace inkcell::detail
