#include "shaping/layout_table.hpp"

#include <hb-ot.h>

#include <algorithm>

#include "base/error.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace shaping = format::shaping;

constexpr unsigned kGposExtension = 9;
constexpr unsigned kGsubExtension = 7;

unsigned bits_in(unsigned format) {
  unsigned count = 0;
  for (; format != 0; format &= format - 1) {
    ++count;
  }
  return count;
}

}  // namespace

GlyphIds LayoutLookup::covered() const {
  GlyphIds ids;
  const auto add = [&ids](const auto& map) {
    for (const auto& entry : map) {
      ids.insert(entry.first);
    }
  };
  add(replaced);
  add(ligatures);
  add(adjusted);
  for (const auto& pair : kerned) {
    ids.insert(pair.first.first);
  }
  for (const LayoutRule& rule : rules) {
    if (!rule.input.empty()) {
      ids.insert(rule.input.front().begin(), rule.input.front().end());
    }
  }
  for (const LayoutAnchors& subtable : anchors) {
    add(subtable.marks);
  }
  return ids;
}

LayoutTable::LayoutTable(const FontFile& file,
                         hb_tag_t tag,
                         const GlyphMap& glyphs)
    : file_(file),
      is_gpos_(tag == HB_OT_TAG_GPOS),
      glyphs_(glyphs),
      bytes_(file.table(tag)) {}

void LayoutTable::refuse(const std::string& what) const {
  file_.refuse(std::string(is_gpos_ ? "GPOS" : "GSUB") + " lookup " +
               std::to_string(reading_) + " " + what +
               ", which --shape cannot do; choose another face, or shape text "
               "that is known at build time with --strings");
}

// 0 outside of the table.
unsigned LayoutTable::u16(At at) const {
  return at + 2 <= bytes_.size()
             ? static_cast<unsigned>(bytes_[at] << 8 | bytes_[at + 1])
             : 0;
}

// 0: there is nothing.
LayoutTable::At LayoutTable::offset(At from, At at) const {
  const unsigned distance = u16(at);
  return distance == 0 ? 0 : from + distance;
}

std::optional<uint16_t> LayoutTable::id(uint32_t glyph) const {
  const auto found = glyphs_.find(glyph);
  return found == glyphs_.end() ? std::nullopt
                                : std::optional<uint16_t>(found->second);
}

// Glyphs of the file by their coverage index.
std::vector<uint32_t> LayoutTable::coverage(At at) const {
  std::vector<uint32_t> out;
  const unsigned count = at == 0 ? 0 : u16(at + 2);
  for (unsigned i = 0; i < count; ++i) {
    if (u16(at) == 1) {
      out.push_back(u16(at + 4 + 2 * i));
    } else if (u16(at) == 2) {
      const At range = at + 4 + 6 * i;
      for (unsigned g = u16(range); g <= u16(range + 2) && g < 65535; ++g) {
        out.push_back(g);
      }
    }
  }
  return out;
}

std::map<uint32_t, unsigned> LayoutTable::classes(At at) const {
  std::map<uint32_t, unsigned> out;
  if (at == 0) {
    return out;
  }
  if (u16(at) == 1) {
    for (unsigned i = 0; i < u16(at + 4); ++i) {
      out[u16(at + 2) + i] = u16(at + 6 + 2 * i);
    }
  } else if (u16(at) == 2) {
    for (unsigned i = 0; i < u16(at + 2); ++i) {
      const At range = at + 4 + 6 * i;
      for (unsigned g = u16(range); g <= u16(range + 2) && g < 65535; ++g) {
        out[g] = u16(range + 4);
      }
    }
  }
  return out;
}

GlyphIds LayoutTable::covered_ids(At at) const {
  GlyphIds ids;
  for (const uint32_t glyph : coverage(at)) {
    if (const auto own = id(glyph)) {
      ids.insert(*own);
    }
  }
  return ids;
}

// Class 0 are all glyphs without another.
GlyphIds LayoutTable::class_ids(const std::map<uint32_t, unsigned>& classes,
                                unsigned kind) const {
  GlyphIds ids;
  for (const auto& [glyph, own] : glyphs_) {
    const auto found = classes.find(glyph);
    if ((found == classes.end() ? 0 : found->second) == kind) {
      ids.insert(own);
    }
  }
  return ids;
}

std::optional<LayoutAnchor> LayoutTable::anchor(At from, At at) const {
  const At found = offset(from, at);
  return found == 0
             ? std::nullopt
             : std::optional<LayoutAnchor>({i16(found + 2), i16(found + 4)});
}

// x, y and advance of a value record. Advances down are of no use.
std::array<int, 3> LayoutTable::value(At at, unsigned format) const {
  std::array<int, 3> out = {};
  for (unsigned bit = 0; bit < 3; ++bit) {
    if ((format >> bit & 1) != 0) {
      out[bit] = i16(at);
      at += 2;
    }
  }
  return out;
}

LayoutLookup LayoutTable::lookup(unsigned number) const {
  reading_ = number;
  LayoutLookup out;
  const At list = offset(0, 8);
  const At at = list == 0 ? 0 : offset(list, list + 2 + 2 * At{number});
  if (at == 0 || number >= u16(list)) {
    return out;
  }
  out.flags = u16(at + 2);
  const unsigned count = u16(at + 4);
  out.mark_set = u16(at + 6 + 2 * At{count});
  for (unsigned i = 0; i < count; ++i) {
    unsigned type = u16(at);
    At subtable = offset(at, at + 6 + 2 * At{i});
    if (type == (is_gpos_ ? kGposExtension : kGsubExtension)) {
      type = u16(subtable + 2);
      subtable += At{u16(subtable + 4)} << 16 | u16(subtable + 6);
    }
    read_subtable(subtable, type, out);
  }
  return out;
}

void LayoutTable::read_subtable(At at, unsigned type, LayoutLookup& out) const {
  static constexpr unsigned kGsub[] = {0,
                                       shaping::kSingle,
                                       shaping::kMultiple,
                                       shaping::kSingle,
                                       shaping::kLigatures,
                                       shaping::kContext,
                                       shaping::kContext,
                                       0,
                                       shaping::kReverse};
  static constexpr unsigned kGpos[] = {0,
                                       shaping::kAdjust,
                                       shaping::kPairs,
                                       shaping::kCursive,
                                       shaping::kMarkToBase,
                                       shaping::kMarkToLigature,
                                       shaping::kMarkToMark,
                                       shaping::kPositionContext,
                                       shaping::kPositionContext};
  out.type = type > 8 ? 0 : is_gpos_ ? kGpos[type] : kGsub[type];
  const bool is_chained = type == (is_gpos_ ? 8 : 6);
  switch (out.type) {
    case shaping::kSingle:
      return type == 1 ? read_single(at, out) : read_sequences(at, true, out);
    case shaping::kMultiple:
      return read_sequences(at, false, out);
    case shaping::kLigatures:
      return read_ligatures(at, out);
    case shaping::kContext:
    case shaping::kPositionContext:
      return read_context(at, is_chained, out);
    case shaping::kReverse:
      return read_reverse(at, out);
    case shaping::kAdjust:
      return read_adjustments(at, out);
    case shaping::kPairs:
      return read_pairs(at, out);
    case shaping::kCursive:
      return read_cursive(at, out);
    case shaping::kMarkToBase:
    case shaping::kMarkToMark:
      return read_anchors(at, false, out);
    case shaping::kMarkToLigature:
      return read_anchors(at, true, out);
    default:
      refuse("has type " + std::to_string(type));
  }
}

void LayoutTable::read_single(At at, LayoutLookup& out) const {
  const std::vector<uint32_t> from = coverage(offset(at, at + 2));
  for (size_t i = 0; i < from.size(); ++i) {
    const unsigned to =
        u16(at) == 1 ? (from[i] + u16(at + 4)) & 0xffff : u16(at + 6 + 2 * i);
    if (const auto own = id(from[i]); own && id(to)) {
      out.replaced.emplace(*own, std::vector<uint16_t>{*id(to)});
    }
  }
}

// Several glyphs for one, or the first of those that may be chosen.
void LayoutTable::read_sequences(At at,
                                 bool is_choice,
                                 LayoutLookup& out) const {
  const std::vector<uint32_t> from = coverage(offset(at, at + 2));
  for (size_t i = 0; i < from.size() && i < u16(at + 4); ++i) {
    const At sequence = offset(at, at + 6 + 2 * i);
    const unsigned count = u16(sequence);
    std::vector<uint16_t> to;
    for (unsigned k = 0; k < (is_choice ? std::min(count, 1u) : count); ++k) {
      if (const auto own = id(u16(sequence + 2 + 2 * At{k}))) {
        to.push_back(*own);
      }
    }
    const bool is_whole = to.size() == (is_choice ? 1 : count);
    if (to.size() > shaping::kMaxInput) {
      refuse("makes " + std::to_string(to.size()) + " glyphs of one");
    }
    if (const auto own = id(from[i]); own && is_whole) {
      out.replaced.emplace(*own, to);
    }
  }
}

void LayoutTable::read_ligatures(At at, LayoutLookup& out) const {
  const std::vector<uint32_t> from = coverage(offset(at, at + 2));
  for (size_t i = 0; i < from.size() && i < u16(at + 4); ++i) {
    const auto first = id(from[i]);
    const At set = offset(at, at + 6 + 2 * i);
    for (unsigned k = 0; first && k < u16(set); ++k) {
      const At entry = offset(set, set + 2 + 2 * At{k});
      LayoutLookup::Ligature ligature;
      bool is_whole = id(u16(entry)).has_value();
      for (unsigned n = 1; n < u16(entry + 2); ++n) {
        const auto own = id(u16(entry + 2 + 2 * At{n}));
        is_whole = is_whole && own;
        ligature.rest.push_back(own.value_or(0));
      }
      if (is_whole) {
        if (ligature.rest.size() > shaping::kMaxInput) {
          refuse("joins more than 16 glyphs");
        }
        ligature.glyph = *id(u16(entry));
        out.ligatures[*first].push_back(ligature);
      }
    }
  }
}

void LayoutTable::read_adjustments(At at, LayoutLookup& out) const {
  const std::vector<uint32_t> from = coverage(offset(at, at + 2));
  const unsigned format = u16(at + 4);
  for (size_t i = 0; i < from.size(); ++i) {
    const At values = u16(at) == 1 ? at + 6 : at + 8 + 2 * i * bits_in(format);
    if (const auto own = id(from[i])) {
      out.adjusted.emplace(*own, value(values, format));
    }
  }
}

void LayoutTable::add_pair(uint16_t left,
                           uint32_t right,
                           At at,
                           unsigned first_format,
                           unsigned second_format,
                           LayoutLookup& out) const {
  const auto own = id(right);
  if (!own) {
    return;
  }
  const std::array<int, 3> first = value(at, first_format);
  const std::array<int, 3> second =
      value(at + 2 * bits_in(first_format), second_format);
  if (first[1] != 0 || second != std::array<int, 3>{}) {
    refuse("moves both glyphs of a pair, or one up or down");
  }
  out.kerned.emplace(std::pair(left, *own), std::pair(first[0], first[2]));
}

void LayoutTable::read_pairs(At at, LayoutLookup& out) const {
  const std::vector<uint32_t> lefts = coverage(offset(at, at + 2));
  const unsigned first = u16(at + 4);
  const unsigned second = u16(at + 6);
  const At value_bytes = 2 * (bits_in(first) + bits_in(second));
  if (u16(at) == 1) {
    for (size_t i = 0; i < lefts.size() && i < u16(at + 8); ++i) {
      const auto left = id(lefts[i]);
      const At set = offset(at, at + 10 + 2 * i);
      for (unsigned k = 0; left && k < u16(set); ++k) {
        const At pair = set + 2 + k * (2 + value_bytes);
        add_pair(*left, u16(pair), pair + 2, first, second, out);
      }
    }
    return;
  }
  const std::map<uint32_t, unsigned> left_kinds = classes(offset(at, at + 8));
  const std::map<uint32_t, unsigned> right_kinds = classes(offset(at, at + 10));
  const unsigned columns = u16(at + 14);
  const auto kind_of = [](const std::map<uint32_t, unsigned>& kinds,
                          uint32_t glyph) {
    const auto found = kinds.find(glyph);
    return found == kinds.end() ? 0u : found->second;
  };
  for (const uint32_t glyph : lefts) {
    const auto left = id(glyph);
    if (!left) {
      continue;
    }
    const At row = at + 16 + value_bytes * columns * kind_of(left_kinds, glyph);
    for (const auto& [right, own] : glyphs_) {
      const unsigned column = kind_of(right_kinds, right);
      if (column < columns) {
        add_pair(*left, right, row + value_bytes * column, first, second, out);
      }
    }
  }
}

void LayoutTable::read_cursive(At at, LayoutLookup& out) const {
  const std::vector<uint32_t> from = coverage(offset(at, at + 2));
  LayoutAnchors found;
  for (size_t i = 0; i < from.size() && i < u16(at + 4); ++i) {
    const auto own = id(from[i]);
    const auto entry = anchor(at, at + 6 + 4 * i);
    const auto exit = anchor(at, at + 8 + 4 * i);
    if (own && entry) {
      found.marks.emplace(*own, LayoutAnchors::Mark{0, *entry});
    }
    if (own && exit) {
      found.bases[*own] = {{{0, *exit}}};
    }
  }
  out.anchors.push_back(std::move(found));
}

void LayoutTable::read_anchors(At at,
                               bool is_ligature,
                               LayoutLookup& out) const {
  const std::vector<uint32_t> marks = coverage(offset(at, at + 2));
  const std::vector<uint32_t> bases = coverage(offset(at, at + 4));
  const unsigned kinds = u16(at + 6);
  const At mark_array = offset(at, at + 8);
  const At base_array = offset(at, at + 10);
  LayoutAnchors found;
  for (size_t i = 0; i < marks.size() && i < u16(mark_array); ++i) {
    const At entry = mark_array + 2 + 4 * i;
    const auto place = anchor(mark_array, entry + 2);
    if (const auto own = id(marks[i]); own && place && u16(entry) < kinds) {
      found.marks.emplace(*own, LayoutAnchors::Mark{u16(entry), *place});
    }
  }
  const auto read_row = [&](At from, At row) {
    std::map<unsigned, LayoutAnchor> anchors;
    for (unsigned kind = 0; kind < kinds; ++kind) {
      if (const auto place = anchor(from, row + 2 * At{kind})) {
        anchors.emplace(kind, *place);
      }
    }
    return anchors;
  };
  for (size_t i = 0; i < bases.size() && i < u16(base_array); ++i) {
    const auto own = id(bases[i]);
    if (!own) {
      continue;
    }
    auto& rows = found.bases[*own];
    if (is_ligature) {
      const At ligature = offset(base_array, base_array + 2 + 2 * i);
      for (unsigned k = 0; k < u16(ligature); ++k) {
        rows.push_back(read_row(ligature, ligature + 2 + 2 * At{k} * kinds));
      }
    } else {
      rows.push_back(read_row(base_array, base_array + 2 + 2 * i * kinds));
    }
  }
  out.anchors.push_back(std::move(found));
}

GlyphClasses read_classes(const FontFile& file,
                          const GlyphMap& glyphs,
                          const std::map<char32_t, uint16_t>& characters) {
  GlyphClasses out;
  hb_face_t* face = file.hb_face();
  if (hb_ot_layout_has_glyph_classes(face) != 0) {
    for (const auto& [glyph, own] : glyphs) {
      const auto kind = hb_ot_layout_get_glyph_class(face, glyph);
      if (kind >= HB_OT_LAYOUT_GLYPH_CLASS_BASE_GLYPH &&
          kind <= HB_OT_LAYOUT_GLYPH_CLASS_MARK) {
        out.kinds[own] = static_cast<unsigned>(kind);
      }
    }
  } else {
    for (const auto& [c, own] : characters) {
      const bool is_mark =
          hb_unicode_general_category(hb_unicode_funcs_get_default(), c) ==
          HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK;
      out.kinds[own] = is_mark ? 3 : 1;
    }
  }
  const LayoutTable gdef(file, HB_TAG('G', 'D', 'E', 'F'), glyphs);
  for (const auto& [glyph, kind] : gdef.classes(gdef.offset(0, 10))) {
    if (const auto own = gdef.id(glyph)) {
      out.mark_classes[*own] = kind;
    }
  }
  // Sets of marks, from version 1.2 on.
  const size_t sets = gdef.u16(2) >= 2 ? gdef.offset(0, 12) : 0;
  for (size_t i = 0; sets != 0 && i < gdef.u16(sets + 2); ++i) {
    out.mark_sets.push_back(
        gdef.covered_ids(sets + (size_t{gdef.u16(sets + 4 + 4 * i)} << 16 |
                                 gdef.u16(sets + 6 + 4 * i))));
  }
  return out;
}

}  // namespace inkcell::gen
