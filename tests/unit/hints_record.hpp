// Makes the section HINT for tests: one list of edges that all glyphs share.
#pragma once

#include <stdint.h>

#include "inkcell/format.hpp"
#include "inkcell/span.hpp"

class HintsRecord {
 public:
  static constexpr uint32_t kRoom = 160;

  int32_t stem_base_u = 0;
  uint8_t stem_width_u = 90;
  uint32_t stem = 0;  // [steps], 0: none
  uint32_t gap = 0;
  bool has_third = false;

  // Zones are numbered from 1; a level of zone 0 belongs to none.
  void level(int32_t height_u, uint32_t zone) {
    levels_[level_count_++] =
        static_cast<uint16_t>((static_cast<uint32_t>(height_u) & 0xfff) |
                              zone << inkcell::format::hints::kZoneShift);
  }
  void zone(uint32_t of_level, bool is_bottom) {
    zones_[zone_count_++] = static_cast<uint8_t>(
        of_level | (is_bottom ? inkcell::format::hints::kBottomZone : 0));
  }
  void edge(uint32_t of_level, bool is_bar) {
    edges_[edge_count_++] = static_cast<uint8_t>(
        of_level | (is_bar ? inkcell::format::hints::kBar : 0));
  }

  // A baseline with an overshoot, a free bar, a bar under a zone, and stems.
  void make_usual() {
    level(-14, 1);
    level(0, 1);
    level(200, 0);
    level(270, 0);
    level(440, 0);
    level(512, 2);
    zone(1, true);
    zone(5, false);
    edge(0, false);
    edge(1, false);
    edge(2, true);
    edge(3, false);
    edge(4, true);
    edge(5, false);
    stem = 30;
    gap = 60;
    has_third = true;
  }

  // Valid as long as the record.
  inkcell::Span<const uint8_t> write(uint32_t glyphs) {
    size_ = 0;
    const uint32_t header[] = {level_count_,
                               zone_count_,
                               0,
                               4,
                               8,
                               8,
                               static_cast<uint32_t>(stem_base_u) & 0xff,
                               static_cast<uint32_t>(stem_base_u) >> 8 & 0xff,
                               stem_width_u,
                               0};
    for (const uint32_t byte : header) {
      put(byte);
    }
    for (uint32_t i = 0; i < level_count_; ++i) {
      put(levels_[i] & 0xffu);
      put(levels_[i] >> 8);
    }
    for (uint32_t i = 0; i < zone_count_; ++i) {
      put(zones_[i]);
    }
    uint64_t bits = 0;
    uint32_t count = 0;
    const uint64_t row = edge_count_ | stem << 4 | uint64_t{gap} << 12 |
                         uint64_t{has_third ? 1u : 0u} << 20;
    for (uint32_t glyph = 0; glyph < glyphs; ++glyph) {
      bits |= row << count;
      for (count += 21; count >= 8; count -= 8, bits >>= 8) {
        put(bits & 0xff);
      }
    }
    if (count != 0) {
      put(bits & 0xff);
    }
    for (uint32_t i = 0; i < edge_count_; ++i) {
      put(edges_[i]);
    }
    return {bytes_, size_};
  }

 private:
  void put(uint64_t byte) { bytes_[size_++] = static_cast<uint8_t>(byte); }

  uint16_t levels_[16] = {};
  uint8_t zones_[4] = {};
  uint8_t edges_[12] = {};
  uint8_t bytes_[kRoom] = {};
  uint32_t level_count_ = 0;
  uint32_t zone_count_ = 0;
  uint32_t edge_count_ = 0;
  uint32_t size_ = 0;
};
