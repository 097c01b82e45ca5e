// Lookups of GSUB and GPOS, and classes of GDEF, with the glyph ids of the font
// to be made.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "source/font_file.hpp"

namespace inkcell::gen {

using GlyphIds = std::set<uint16_t>;

/// Glyphs in the font of ids in the file; the others are not in it.
using GlyphMap = std::map<uint32_t, uint16_t>;

struct LayoutAnchor {
  int x = 0;
  int y = 0;
};

/// A rule of a context: sets of glyphs, and lookups at places of the input.
struct LayoutRule {
  std::vector<GlyphIds> before;  // the nearest first
  std::vector<GlyphIds> input;   // with the first
  std::vector<GlyphIds> behind;
  std::vector<std::pair<unsigned, unsigned>> actions;  // place, lookup
  std::map<uint16_t, uint16_t> pairs;                  // of reverse lookups
};

/// Anchors of one subtable.
struct LayoutAnchors {
  struct Mark {
    unsigned kind = 0;
    LayoutAnchor anchor;
  };
  std::map<uint16_t, Mark> marks;
  /// A row for each letter of a ligature, of anchors by kind of mark.
  std::map<uint16_t, std::vector<std::map<unsigned, LayoutAnchor>>> bases;
};

/// A lookup; of what follows it has what its type needs. If several subtables
/// name a glyph the first one counts.
struct LayoutLookup {
  unsigned type = 0;  // format::shaping
  unsigned flags = 0;
  unsigned mark_set = 0;
  std::map<uint16_t, std::vector<uint16_t>> replaced;
  struct Ligature {
    std::vector<uint16_t> rest;
    uint16_t glyph = 0;
  };
  std::map<uint16_t, std::vector<Ligature>> ligatures;
  std::vector<LayoutRule> rules;
  std::map<uint16_t, std::array<int, 3>> adjusted;  // x, y, advance
  /// x and advance.
  std::map<std::pair<uint16_t, uint16_t>, std::pair<int, int>> kerned;
  std::vector<LayoutAnchors> anchors;  // cursive: entries are marks, of kind 0

  /// Glyphs at which it may apply.
  GlyphIds covered() const;
  bool empty() const { return covered().empty(); }
};

/// What GDEF says of the font's glyphs; without it, what Unicode says of
/// characters.
struct GlyphClasses {
  std::map<uint16_t, unsigned> kinds;  // 1 base, 2 ligature, 3 mark
  std::map<uint16_t, unsigned> mark_classes;
  std::vector<GlyphIds> mark_sets;
};

/// A table of a face.
class LayoutTable {
 public:
  LayoutTable(const FontFile& file, hb_tag_t tag, const GlyphMap& glyphs);

  /// Throws Error for what the device cannot do.
  LayoutLookup lookup(unsigned number) const;

 private:
  friend GlyphClasses read_classes(
      const FontFile& file,
      const GlyphMap& glyphs,
      const std::map<char32_t, uint16_t>& characters);

  using At = size_t;

  unsigned u16(At at) const;
  int i16(At at) const { return static_cast<int16_t>(u16(at)); }
  At offset(At from, At at) const;
  std::vector<uint32_t> coverage(At at) const;
  std::map<uint32_t, unsigned> classes(At at) const;
  std::optional<uint16_t> id(uint32_t glyph) const;
  GlyphIds covered_ids(At at) const;
  GlyphIds class_ids(const std::map<uint32_t, unsigned>& classes,
                     unsigned kind) const;
  std::optional<LayoutAnchor> anchor(At from, At at) const;
  std::array<int, 3> value(At at, unsigned format) const;

  void read_subtable(At at, unsigned type, LayoutLookup& out) const;
  void read_single(At at, LayoutLookup& out) const;
  void read_sequences(At at, bool is_choice, LayoutLookup& out) const;
  void read_ligatures(At at, LayoutLookup& out) const;
  void read_context(At at, bool is_chained, LayoutLookup& out) const;
  void read_rule_sets(At at, bool is_chained, LayoutLookup& out) const;
  void read_actions(At at, unsigned count, LayoutRule& rule) const;
  void add_rule(LayoutRule rule, LayoutLookup& out) const;
  void read_reverse(At at, LayoutLookup& out) const;
  void read_adjustments(At at, LayoutLookup& out) const;
  void read_pairs(At at, LayoutLookup& out) const;
  void add_pair(uint16_t left,
                uint32_t right,
                At at,
                unsigned first_format,
                unsigned second_format,
                LayoutLookup& out) const;
  void read_cursive(At at, LayoutLookup& out) const;
  void read_anchors(At at, bool is_ligature, LayoutLookup& out) const;
  [[noreturn]] void refuse(const std::string& what) const;

  const FontFile& file_;
  bool is_gpos_;
  const GlyphMap& glyphs_;
  std::vector<uint8_t> bytes_;
  mutable unsigned reading_ = 0;  // number of a lookup, for errors
};

GlyphClasses read_classes(const FontFile& file,
                          const GlyphMap& glyphs,
                          const std::map<char32_t, uint16_t>& characters);

}  // namespace inkcell::gen
