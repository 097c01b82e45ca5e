// Makes the section GRID for tests: zones, and records of hints bit by bit.
#pragma once

#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "outline_record.hpp"

class GridRecord {
 public:
  static constexpr uint32_t kRoom = 256;
  static constexpr uint32_t kMaxGlyphs = 16;
  static constexpr uint32_t kOffsetBits = 8;

  uint8_t stem_width_u = 90;
  uint8_t bar_width_u = 70;
  uint8_t x_zone = 1;
  uint8_t flags = 0;

  GridRecord() : bits_({records_, sizeof records_}) {}

  void zone(int32_t flat_u, int32_t overshoot_u, bool is_top) {
    zones_[zone_count_++] = {flat_u, overshoot_u, is_top};
  }
  /// A baseline, an x-height of half an em, and a cap height.
  void usual_zones() {
    zone(0, -14, false);
    zone(512, 14, true);
    zone(720, 14, true);
  }

  /// These, and for each of the glyphs a bar in a zone, a free one, an end
  /// between them and two stems.
  void make_usual(uint32_t glyphs) {
    usual_zones();
    for (uint32_t i = 0; i < glyphs; ++i) {
      glyph(i % 2 == 0, 4, 2);
      stroke_in_zone(0, false, 0);
      stroke(0, 200, 40);
      end(320, i % 2 == 0);
      stroke_in_zone(1, true, 1, 30);
      stem(60);
      stem(450, 70);
    }
  }

  /// Begins the record of the next glyph, ends the one before.
  void glyph(bool is_symmetric, uint32_t heights, uint32_t across) {
    end_glyph();
    is_open_ = true;
    put(is_symmetric ? 1 : 0, 1);
    put(0, 1);
    put(heights, 4);
    put(across, 3);
  }
  void glyph_without_hints() {
    end_glyph();
    is_open_ = true;
  }
  void insets_glyph(uint32_t heights,
                    uint32_t across,
                    uint32_t left_u,
                    uint32_t right_u) {
    end_glyph();
    is_open_ = true;
    put(1, 2);
    put(heights, 4);
    put(across, 3);
    put(left_u / 2, 6);
    put(right_u / 2, 6);
  }

  /// A bar (0) or serif (1); width 0: the standard one.
  void stroke_in_zone(uint32_t kind,
                      bool is_top,
                      uint32_t zone,
                      uint32_t width_u = 0) {
    put(kind, 2);
    put(is_top ? 1 : 0, 1);
    put(1, 1);
    put(zone, 3);
    put(0, 1);
    width(width_u);
  }
  void stroke(uint32_t kind, int32_t bottom_u, uint32_t width_u = 0) {
    put(kind, 2);
    put(0, 2);
    position(bottom_u);
    width(width_u);
  }
  void edge(uint32_t zone, bool is_round) {
    put(2, 2);
    put(zone, 3);
    put(is_round ? 1 : 0, 1);
  }
  void end(int32_t at_u, bool rises) {
    put(3, 2);
    put(rises ? 1 : 0, 1);
    position(at_u);
  }
  void stem(int32_t left_u, uint32_t width_u = 0) {
    put(0, 1);
    position(left_u);
    width(width_u);
  }
  void foot(int32_t at_u) {
    put(1, 1);
    position(at_u);
  }

  /// Valid as long as the record.
  inkcell::Span<const uint8_t> write() {
    end_glyph();
    size_ = 0;
    const uint32_t header[] = {zone_count_, flags,  stem_width_u,
                               bar_width_u, x_zone, kOffsetBits,
                               0,           0};
    for (const uint32_t byte : header) {
      byte_out(byte);
    }
    for (uint32_t i = 0; i < zone_count_; ++i) {
      byte_out(static_cast<uint32_t>(zones_[i].flat_u));
      byte_out(static_cast<uint32_t>(zones_[i].flat_u) >> 8);
      byte_out(static_cast<uint32_t>(zones_[i].overshoot_u));
      byte_out(zones_[i].is_top ? 1 : 0);
    }
    byte_out(0);
    for (uint32_t i = 0; i < glyph_count_; ++i) {
      byte_out(ends_[i]);
    }
    for (uint32_t i = 0; i < bits_.bytes(); ++i) {
      byte_out(records_[i]);
    }
    return {bytes_, size_};
  }

 private:
  struct Zone {
    int32_t flat_u;
    int32_t overshoot_u;
    bool is_top;
  };

  void put(uint32_t value, uint32_t count) {
    bits_.put(value, count);
    bit_ += count;
  }
  void position(int32_t at_u) {
    put(static_cast<uint32_t>(at_u + 512) / 2, 10);
  }
  void width(uint32_t width_u) {
    put(width_u == 0 ? 1 : 0, 1);
    if (width_u != 0) {
      put(width_u / 2, 7);
    }
  }
  void end_glyph() {
    if (is_open_) {
      put(0, (8 - bit_ % 8) % 8);
      ends_[glyph_count_++] = static_cast<uint8_t>(bit_ / 8);
    }
  }
  void byte_out(uint32_t byte) { bytes_[size_++] = static_cast<uint8_t>(byte); }

  Zone zones_[8] = {};
  uint8_t ends_[kMaxGlyphs] = {};
  uint8_t records_[128] = {};
  uint8_t bytes_[kRoom] = {};
  outline_record::BitWriter bits_;
  uint32_t bit_ = 0;
  uint32_t zone_count_ = 0;
  uint32_t glyph_count_ = 0;
  uint32_t size_ = 0;
  bool is_open_ = false;
};
