// Fonts with morphs, made in memory.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "glyph_outlines.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "outline_reader.hpp"
#include "outlines/outline_steps.hpp"
#include "pipeline/generate.hpp"

namespace inkcell::gen::test {

inline std::vector<uint8_t> bytes_of(Span<const uint8_t> span) {
  return {span.begin(), span.end()};
}

/// A font in memory at a multiple of 4, and its outlines.
struct MorphFont {
  explicit MorphFont(const GenerateRequest& request) {
    const RomFont rom = generate(request);
    warnings = rom.warnings;
    words.resize(rom.bytes.size() / 4 + 1);
    auto* const bytes = reinterpret_cast<uint8_t*>(words.data());
    std::copy(rom.bytes.begin(), rom.bytes.end(), bytes);
    EXPECT_EQ(Font::open({bytes, rom.bytes.size()}, font), Status::ok);
  }

  MinimalOutline outline_of(int glyph) const {
    const auto id = static_cast<uint16_t>(glyph);
    GlyphMetrics metrics;
    EXPECT_EQ(font.glyph_metrics(id, metrics), Status::ok);
    std::vector<uint16_t> table;
    const Span<const uint8_t> code = font.section(format::section::kCode);
    for (size_t i = 0; i + 1 < code.size; i += 2) {
      table.push_back(static_cast<uint16_t>(code[i] | code[i + 1] << 8));
    }
    const auto grid_shift =
        static_cast<int8_t>(font.rom()[format::header::kGridShift]);
    return read_outline(
        bytes_of(font.record(id)), table, font.rom()[format::header::kCodeBits],
        record_start(metrics.x_min, metrics.y_min, grid_shift), 10000);
  }

  // A grid unit. [u]
  double grid_u() const {
    return std::ldexp(
        kUPerEm / font.units_per_em(),
        static_cast<int8_t>(font.rom()[format::header::kGridShift]));
  }

  bool is_composite(int glyph) const {
    const auto id = static_cast<uint16_t>(glyph);
    return font.record(id).data[0] == format::composite::kType;
  }

  std::vector<uint32_t> words;
  Font font;
  Warnings warnings;
};

/// Digits of a face and their pairs, made once: pairs take seconds.
inline const MorphFont& digits_of(const std::string& file,
                                  const std::string& morphs) {
  static std::map<std::string, MorphFont> made;
  const auto found = made.find(file + morphs);
  if (found != made.end()) {
    return found->second;
  }
  GenerateRequest request;
  request.font = file;
  request.chars = {"0-9"};
  request.target.max_px = 96;
  request.morphs = {morphs};
  return made.emplace(file + morphs, request).first->second;
}

}  // namespace inkcell::gen::test
