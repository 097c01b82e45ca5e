// Writes the parts of section SHAP.
#pragma once

#include <hb-ot.h>

#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "base/bit_table_writer.hpp"
#include "inkcell/format/rom.hpp"
#include "shaping/layout_table.hpp"
#include "shaping/shape_tables.hpp"

namespace inkcell::gen {

namespace shaping = format::shaping;

/// Bits that are written later than what they are counted for.
class SectionBits {
 public:
  void put(uint32_t value, unsigned width) {
    parts_.emplace_back(value, width);
    size_ += width;
  }
  void put_i16(int value) { put(static_cast<uint16_t>(value), 16); }
  void append(const SectionBits& other) {
    parts_.insert(parts_.end(), other.parts_.begin(), other.parts_.end());
    size_ += other.size_;
  }
  uint32_t size() const { return size_; }
  void write(BitTableWriter& out) const {
    for (const auto& [value, width] : parts_) {
      out.put(value, width);
    }
  }
  bool operator<(const SectionBits& other) const {
    return parts_ < other.parts_;
  }

 private:
  std::vector<std::pair<uint32_t, unsigned>> parts_;
  uint32_t size_ = 0;
};

/// What is said of a character.
struct ShapeTraits {
  unsigned joining = 0;
  unsigned rank = 0;
  unsigned mark = 0;

  auto key() const { return std::tie(joining, rank, mark); }
  bool operator<(const ShapeTraits& other) const { return key() < other.key(); }
  bool is_plain() const { return joining + rank + mark == 0; }
};

/// The whole section, from first to last.
class SectionWriter {
 public:
  explicit SectionWriter(const ShapeSource& source)
      : source_(source),
        gsub_(source.file, HB_OT_TAG_GSUB, source.glyphs),
        gpos_(source.file, HB_OT_TAG_GPOS, source.glyphs),
        classes_(read_classes(source.file, source.glyphs, source.characters)),
        glyph_bits_(width_of(static_cast<uint32_t>(source.glyph_count - 1))) {
    for (const auto* characters : {&source.characters, &source.drawings}) {
      for (const auto& [c, glyph] : *characters) {
        if (is_emoji(c)) {
          emoji_.insert(glyph);
        }
      }
    }
  }

  Bytes write();

 private:
  using Key = std::pair<bool, unsigned>;  // GPOS, number in the file

  struct Entry {
    unsigned lookup = 0;
    unsigned mask = 0;
    bool manual_zwj = false;
  };
  struct Program {
    const ShapePlan* plan;
    size_t first = 0;
    size_t substitutions = 0;
    size_t positions = 0;
  };

  // Stands for the lookup of drawings of several characters; numbers of lookups
  // that no file has follow.
  static constexpr unsigned kSequences = 0xffff;
  static constexpr unsigned kFirstOwn = 0x10000;
  static constexpr unsigned kUseSet = 16;  // a flag: mark_set counts

  LayoutLookup read_lookup(const Key& key) const;
  bool is_skipped(const LayoutLookup& lookup, uint16_t glyph) const;
  void drop_skipped(LayoutLookup& lookup) const;
  unsigned number_of(const Key& key, unsigned depth);
  unsigned set_of(const GlyphIds& ids);
  void add_programs();
  void add_reverse(unsigned number);
  void add_nested();
  void find_compositions();
  void find_spans();
  ShapeTraits traits_of(char32_t c) const;
  struct ScriptRange {
    char32_t first;
    char32_t last;
    unsigned program;
  };
  std::vector<ScriptRange> find_scripts() const;
  std::vector<std::pair<char32_t, char32_t>> find_mirrors() const;
  void find_sets();
  uint32_t put_data(const LayoutLookup& lookup, bool is_gpos, SectionBits& out);
  uint32_t put_single(const LayoutLookup& lookup, SectionBits& out) const;
  uint32_t put_multiple(const LayoutLookup& lookup, SectionBits& out) const;
  uint32_t put_ligatures(const LayoutLookup& lookup, SectionBits& out) const;
  uint32_t put_rules(const LayoutLookup& lookup,
                     bool is_gpos,
                     SectionBits& out);
  uint32_t put_adjustments(const LayoutLookup& lookup, SectionBits& out) const;
  uint32_t put_pairs(const LayoutLookup& lookup, SectionBits& out) const;
  uint32_t put_anchors(const LayoutLookup& lookup, SectionBits& out) const;
  unsigned filter_of(const LayoutLookup& lookup);
  void find_rows();
  bool looks_at_space() const;
  void put_set(const GlyphIds& ids, SectionBits& out) const;
  void check(size_t count, size_t most, const char* what) const;

  const ShapeSource& source_;
  LayoutTable gsub_;
  LayoutTable gpos_;
  GlyphClasses classes_;
  unsigned glyph_bits_;
  GlyphIds emoji_;

  std::map<Key, unsigned> numbers_;
  std::vector<Key> keys_;
  std::vector<LayoutLookup> lookups_;
  size_t top_ = 0;
  std::vector<Entry> entries_;
  std::vector<Program> programs_;
  std::map<GlyphIds, unsigned> set_numbers_;
  std::vector<GlyphIds> sets_;
  struct Composition {
    unsigned mark;
    char32_t letter;
    char32_t composed;
  };
  std::vector<Composition> compositions_;
  std::vector<char32_t> marks_;
  unsigned rank_bits_ = 0;
  unsigned mark_bits_ = 0;
  unsigned letter_bits_ = 0;
  std::map<unsigned, unsigned> ranks_;
  struct Span {
    char32_t first;
    std::vector<unsigned> properties;
  };
  std::vector<Span> spans_;
  std::vector<ShapeTraits> properties_;
  std::vector<unsigned> glyph_rows_;
  std::vector<std::vector<bool>> rows_;
  unsigned set_bits_ = 0;
  unsigned lookup_bits_ = 0;
};

}  // namespace inkcell::gen
