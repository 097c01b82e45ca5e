// Kerning of a TrueType file: `kern` format 0, and pairs of GPOS.
#pragma once

#include "tables.hpp"

namespace inkcell::detail {

// Types of lookups.
inline constexpr uint32_t kPairLookup = 2;
inline constexpr uint32_t kExtensionLookup = 9;

// Lookups, and subtables of all of them, that a pair is looked for in.
inline constexpr uint32_t kMostLookups = 16;
inline constexpr uint32_t kMostSubtables = 64;

// Coverages and classes by ranges: 6 bytes, with a value.
template <typename AnyTable>
static uint32_t find_range(const AnyTable& table, uint32_t glyph) noexcept {
  return find_record(table, {4, u16_at(table, 2), 6, 2, false}, glyph);
}

// The number of a glyph in a coverage; kNoPlace: it has none.
inline constexpr uint32_t kNoPlace = 0xffff;
template <typename AnyTable>
static uint32_t place_in(const AnyTable& coverage, uint32_t glyph) noexcept {
  return found_in(coverage, glyph, [&coverage, glyph]() noexcept -> uint32_t {
    if (u16_at(coverage, 0) == 1) {
      const uint32_t at =
          find_record(coverage, {4, u16_at(coverage, 2), 2, 0, false}, glyph);
      return at == 0 ? kNoPlace : (at - 4) >> 1;
    }
    const uint32_t at = find_range(coverage, glyph);
    return at == 0 ? kNoPlace
                   : u16_at(coverage, at + 4) + glyph - u16_at(coverage, at);
  });
}

template <typename AnyTable>
static uint32_t glyph_class_of(const AnyTable& classes,
                               uint32_t glyph) noexcept {
  return found_in(classes, glyph, [&classes, glyph]() noexcept -> uint32_t {
    if (u16_at(classes, 0) == 1) {
      const uint32_t i = glyph - u16_at(classes, 2);
      return i < u16_at(classes, 4) ? u16_at(classes, 6 + 2 * i) : 0;
    }
    const uint32_t at = find_range(classes, glyph);
    return at == 0 ? 0 : u16_at(classes, at + 4);
  });
}

// Numbers of a value record, of 16 bits each.
__attribute__((noinline)) inline uint32_t count_numbers(
    uint32_t format) noexcept {
  uint32_t count = 0;
  for (; format != 0; format &= format - 1) {
    ++count;
  }
  return count;
}

// Whether a subtable says something about a pair; what is in `kern`.
template <typename AnyTable>
static bool look_up(const AnyTable& pairs,
                    uint32_t left,
                    uint32_t right,
                    int32_t& kern) noexcept {
  constexpr uint32_t kAdvance = 4;  // of a value's format; before it x and y
  const uint32_t place = place_in(part_of(pairs, u16_at(pairs, 2)), left);
  if (place == kNoPlace) {
    return false;
  }
  const uint32_t format = u16_at(pairs, 4) & 255;
  const uint32_t bytes =
      2 * (count_numbers(format) + count_numbers(u16_at(pairs, 6) & 255));
  uint32_t at = 0;  // of the value
  AnyTable values = pairs;
  if (u16_at(pairs, 0) == 1) {
    values = part_of(pairs, u16_at(pairs, 10 + 2 * place));
    at = find_record(
        values,
        {2, u16_at(values, 0), static_cast<uint8_t>(2 + bytes), 0, false},
        right);
    if (at == 0 || place >= u16_at(pairs, 8)) {
      return false;
    }
    at += 2;
  } else {
    const uint32_t row = glyph_class_of(part_of(pairs, u16_at(pairs, 8)), left);
    const uint32_t column =
        glyph_class_of(part_of(pairs, u16_at(pairs, 10)), right);
    const uint32_t columns = u16_at(pairs, 14);
    if (row >= u16_at(pairs, 12) || column >= columns) {
      return false;
    }
    at = 16 + (row * columns + column) * bytes;
  }
  kern = (format & kAdvance) == 0
             ? 0
             : i16_at(values, at + 2 * count_numbers(format & 3));
  return true;
}

// The sum over the lookups of the feature.
template <typename Face>
static int32_t kern_by_lookups(const Face& face,
                               uint32_t left,
                               uint32_t right) noexcept {
  using AnyTable = typename Face::AnyTable;
  const AnyTable lookups = part_of(face.gpos, u16_at(face.gpos, 8));
  const uint32_t said = u16_at(face.kern, 2);
  const uint32_t count = said < kMostLookups ? said : kMostLookups;
  uint32_t subtables = kMostSubtables;
  int32_t sum = 0;
  for (uint32_t i = 0; i != count; ++i) {
    const uint32_t number = u16_at(face.kern, 4 + 2 * i);
    const AnyTable lookup = part_of(lookups, u16_at(lookups, 2 + 2 * number));
    const uint32_t type = u16_at(lookup, 0);
    uint32_t left_over = u16_at(lookup, 4);
    for (uint32_t at = 6; left_over != 0 && subtables != 0; at += 2) {
      --left_over;
      --subtables;
      AnyTable pairs = part_of(lookup, u16_at(lookup, at));
      const bool is_extension = type == kExtensionLookup;
      if ((is_extension ? u16_at(pairs, 2) : type) != kPairLookup) {
        break;
      }
      if (is_extension) {
        pairs = part_of(pairs, u32_at(pairs, 4));
      }
      int32_t kern = 0;
      if (look_up(pairs, left, right, kern)) {
        sum += kern;
        break;
      }
    }
  }
  return sum;
}

// The table of feature `kern` of Latin, or of the default, or of the first
// script; empty if there is none.
template <typename AnyTable>
static AnyTable find_feature(const AnyTable& gpos) noexcept {
  constexpr uint32_t kLatinScript = 0x6c61746e;    // "latn"
  constexpr uint32_t kDefaultScript = 0x44464c54;  // "DFLT"
  constexpr uint32_t kKernFeature = 0x6b65726e;
  const AnyTable scripts = part_of(gpos, u16_at(gpos, 4));
  const AnyTable features = part_of(gpos, u16_at(gpos, 6));
  uint32_t chosen = 2;
  const uint32_t count = u16_at(scripts, 0);
  for (uint32_t at = 2; at != 2 + 6 * count; at += 6) {
    const uint32_t tag = u32_at(scripts, at);
    if (tag == kLatinScript || tag == kDefaultScript) {
      chosen = at;
    }
    if (tag == kLatinScript) {
      break;
    }
  }
  const AnyTable script = part_of(scripts, u16_at(scripts, chosen + 4));
  const AnyTable language = part_of(script, u16_at(script, 0));
  const uint32_t numbers = u16_at(language, 4);
  for (uint32_t i = 0; i != numbers; ++i) {
    const uint32_t at = 2 + 6 * u16_at(language, 6 + 2 * i);
    if (u32_at(features, at) == kKernFeature) {
      return part_of(features, u16_at(features, at + 4));
    }
  }
  return {};
}

// Finds what pair_kerning() reads: GPOS, if that kerns, else `kern`.
template <typename Face>
static void choose_kerning(const typename Face::AnyTable& kern,
                           const typename Face::AnyTable& gpos,
                           Face& face) noexcept {
  using AnyTable = typename Face::AnyTable;
  face.kern = gpos.size == 0 ? AnyTable() : find_feature(gpos);
  if (face.kern.size != 0) {
    face.gpos = gpos;
    return;
  }
  const uint32_t count = u16_at(kern, 0) == 0 ? u16_at(kern, 2) : 0;
  uint32_t at = 4;
  for (uint32_t i = 0; i != count; ++i) {
    const AnyTable found = part_of(kern, at);
    // Horizontal, and no minima; format 0.
    if ((u16_at(found, 4) & 0xff07) == 1) {
      face.kern = part_of(found, 6);
      return;
    }
    at += u16_at(found, 2);
  }
}

// What to add to the advance of `left`. [font units]
template <typename Face>
static int32_t pair_kerning(const Face& face,
                            uint32_t left,
                            uint32_t right) noexcept {
  if (face.gpos.size != 0) {
    return kern_by_lookups(face, left, right);
  }
  const uint32_t at = find_record(
      face.kern, {8, u16_at(face.kern, 0), 6, 0, true}, left << 16 | right);
  return at == 0 ? 0 : i16_at(face.kern, at + 4);
}

}  // namespace inkcell::detail
