// Makes the section GRID for tests, and the hints of glyphs number by number:
// each table of code words has one word of no bits, for numbers of a fixed
// width.
#pragma once

#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "outline_record.hpp"

class GridRecord {
 public:
  static constexpr uint32_t kMaxGlyphs = 16;

  uint8_t stem_width_u = 90;
  uint8_t bar_width_u = 70;
  uint8_t x_zone = 1;
  uint8_t flags = 0;

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

  /// Begins the hints of the next glyph.
  void glyph(bool is_symmetric, uint32_t heights, uint32_t across) {
    const uint32_t begin = glyph_count_ == 0 ? 0 : next_byte();
    glyphs_[glyph_count_++] = {bytes_ + begin, 0};
    y_at_ = 0;
    x_at_ = 0;
    put((is_symmetric ? 0x100u : 0) | heights << 3 | across, kHeadBits);
  }
  void glyph_without_hints() { glyph(false, 0, 0); }
  void insets_glyph(uint32_t heights,
                    uint32_t across,
                    uint32_t left_u,
                    uint32_t right_u) {
    glyph(false, heights | 0x10, across);
    put(left_u / 2, 6);
    put(right_u / 2, 6);
  }

  /// A bar (0) or serif (1); width 0: the standard one.
  void stroke_in_zone(uint32_t kind,
                      bool is_top,
                      uint32_t zone,
                      uint32_t width_u = 0) {
    height(kind, is_top, zone + 1, false);
    put(width_u / 2, kWidthBits);
    const int32_t width =
        static_cast<int32_t>(width_u == 0 ? bar_width_u : width_u);
    y_at_ = position(zones_[zone].flat_u - (is_top ? width : 0));
  }
  void stroke(uint32_t kind, int32_t bottom_u, uint32_t width_u = 0) {
    height(kind, false, 0, false);
    gap(bottom_u, y_at_);
    put(width_u / 2, kWidthBits);
  }
  void edge(uint32_t zone, bool is_round) {
    height(2, false, zone + 1, is_round);
    if (zone < zone_count_) {
      y_at_ = position(zones_[zone].flat_u +
                       (is_round ? zones_[zone].overshoot_u : 0));
    }
  }
  void end(int32_t at_u, bool rises) {
    height(3, rises, 0, false);
    gap(at_u, y_at_);
  }
  void stem(int32_t left_u, uint32_t width_u = 0) {
    gap(left_u, x_at_);
    put(width_u / 2, kWidthBits);
    x_at_ = position(
        left_u + static_cast<int32_t>(width_u == 0 ? stem_width_u : width_u));
  }

  /// Valid as long as the record.
  outline_record::Hints write() {
    size_ = 0;
    const uint32_t header[] = {
        zone_count_, flags, stem_width_u, bar_width_u, x_zone, 0, 0, 0};
    for (const uint32_t byte : header) {
      byte_out(byte);
    }
    for (uint32_t i = 0; i < zone_count_; ++i) {
      byte_out(static_cast<uint32_t>(zones_[i].flat_u));
      byte_out(static_cast<uint32_t>(zones_[i].flat_u) >> 8);
      byte_out(static_cast<uint32_t>(zones_[i].overshoot_u));
      byte_out(zones_[i].is_top ? 1 : 0);
    }
    const uint32_t widths[] = {kHeadBits,  kHeightBits, kGapBits,
                               kWidthBits, kGapBits,    kWidthBits};
    for (const uint32_t width : widths) {
      byte_out(width << inkcell::format::grid::kExtraShift);
      byte_out(0);
    }
    return {{section_, size_}, {glyphs_, glyph_count_}};
  }

 private:
  static constexpr uint32_t kHeadBits = 9;
  static constexpr uint32_t kHeightBits = 8;
  static constexpr uint32_t kGapBits = 10;
  static constexpr uint32_t kWidthBits = 7;

  struct Zone {
    int32_t flat_u;
    int32_t overshoot_u;
    bool is_top;
  };

  // [u -> 2 u]
  static uint32_t position(int32_t at_u) {
    return static_cast<uint32_t>(at_u + 512) >> 1 & 1023;
  }
  uint32_t next_byte() const {
    const outline_record::HintBits& last = glyphs_[glyph_count_ - 1];
    return static_cast<uint32_t>(last.bytes - bytes_) + (last.count + 7) / 8;
  }
  void put(uint32_t value, uint32_t count) {
    outline_record::HintBits& to = glyphs_[glyph_count_ - 1];
    const auto begin = static_cast<uint32_t>(to.bytes - bytes_);
    for (uint32_t bit = 0; bit < count; ++bit, ++to.count) {
      bytes_[begin + to.count / 8] = static_cast<uint8_t>(
          bytes_[begin + to.count / 8] | (value >> bit & 1) << to.count % 8);
    }
  }
  void height(uint32_t kind, bool is_top, uint32_t zone, bool is_round) {
    put(kind << 6 | (is_top ? 0x20u : 0) | zone << 1 | (is_round ? 1u : 0),
        kHeightBits);
  }
  void gap(int32_t to_u, uint32_t& at) {
    put((position(to_u) - at) & 1023, kGapBits);
    at = position(to_u);
  }
  void byte_out(uint32_t byte) {
    section_[size_++] = static_cast<uint8_t>(byte);
  }

  Zone zones_[8] = {};
  outline_record::HintBits glyphs_[kMaxGlyphs] = {};
  uint8_t bytes_[192] = {};  // of all glyphs
  uint8_t section_[64] = {};
  uint32_t y_at_ = 0;  // [2 u]
  uint32_t x_at_ = 0;
  uint32_t zone_count_ = 0;
  uint32_t glyph_count_ = 0;
  uint32_t size_ = 0;
};
