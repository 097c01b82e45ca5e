// A small font of simple shapes for tests of layout.
#pragma once

#include "font_builder.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"

namespace layout_font {

/// Glyphs of 1000 units to the em: .notdef, a disc for A and a ring for B (750
/// wide), bars for C, - and . (600), a ring for U+05D0 (750), a bar for U+05D1
/// (600); a space (500). Ascender 800, descender 200.
inline constexpr size_t kBytes = 12288;

inline inkcell::Font open(inkcell::Span<uint8_t> rom) {
  using font_builder::bar;
  using font_builder::disc;
  using font_builder::ring;
  static const font_builder::CmapEntry kCmap[] = {
      {' ', 0, 1}, {'-', 1, 5}, {'A', 2, 2}, {0x5d0, 1, 7}};
  static const font_builder::GlyphSpec kGlyphs[] = {
      {600, {195, 0, 430, 625}, bar, nullptr},
      {500, {0, 0, 0, 0}, nullptr, nullptr},
      {750, {82, 82, 668, 668}, disc, nullptr},
      {750, {121, 121, 629, 629}, ring, nullptr},
      {600, {195, 0, 430, 625}, bar, nullptr},
      {600, {195, 0, 430, 625}, bar, nullptr},
      {600, {195, 0, 430, 625}, bar, nullptr},
      {750, {121, 121, 629, 629}, ring, nullptr},
      {600, {195, 0, 430, 625}, bar, nullptr}};
  font_builder::FontSpec spec;
  spec.cmap = {kCmap, 4};
  spec.glyphs = {kGlyphs, 9};
  spec.name = "layout";
  inkcell::Font font;
  const size_t size = font_builder::build_font(spec, rom);
  CHECK_OK(inkcell::open_any_font({rom.data, size}, font));
  return font;
}

}  // namespace layout_font
