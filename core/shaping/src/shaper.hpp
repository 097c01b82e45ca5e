// Shapes one run in RAM that the caller lends.
#pragma once

#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/shaping.hpp"
#include "tables.hpp"

namespace inkcell::detail {

// TextGlyph::flags.
inline constexpr uint8_t kIgnorable = 1;  // shows nothing, and is looked over
inline constexpr uint8_t kZwj = 2;
inline constexpr uint8_t kZwnj = 4;
inline constexpr uint8_t kMultiplied = 8;
inline constexpr uint8_t kCursiveLink = 16;

// TextGlyph::component: of a mark its letter of a ligature, from 1 on; of a
// ligature kComponents and how many it has.
inline constexpr uint8_t kComponents = 128;

/// A lookup: what its data begin with. A type has some of the bases, widths and
/// numbers (docs/FORMAT.md); one of no type has no rows.
struct ShapeLookup {
  uint8_t type;
  uint8_t skip;  // classes 1 to 3 that it looks over
  uint8_t widths[7];
  uint8_t row_bits;  // 0: rules follow
  int16_t bases[3];
  uint16_t filter;  // of marks: a set's number plus 1; 0: none
  uint16_t number;  // its own
  uint16_t count;   // of rows, which begin with a glyph,
  uint32_t rows;    // and where they begin [bit]
  uint32_t rest;    // where they end
  uint16_t numbers[2];
};

inline uint32_t class_of(const TextGlyph& glyph) noexcept {
  return glyph.kind & 3u;
}
inline bool is_mark(const TextGlyph& glyph) noexcept {
  return class_of(glyph) == 3;
}
// Of a mark that belongs to a ligature.
inline uint32_t component_of(const TextGlyph& glyph) noexcept {
  return glyph.component < kComponents ? glyph.component : 0u;
}

namespace devanagari {
class Order;
}

class Shaper : ShapeReader {
 public:
  Shaper(const Font& font,
         const ShapeTables& tables,
         const SyllableCode* syllables,
         Span<TextGlyph> room) noexcept
      : ShapeReader(tables),
        g_(room.data),
        room_(static_cast<int32_t>(room.size < 65535 ? room.size : 65535)),
        font_(font),
        syllables_(syllables) {}

  Status shape(const Text& text,
               const ScriptRun& run,
               uint32_t program) noexcept;
  uint32_t count() const noexcept { return static_cast<uint32_t>(n_); }

 private:
  friend class devanagari::Order;

  static constexpr int32_t kNo = -1;

  // What a search accepts, if not the glyphs of a set.
  static constexpr uint32_t kAnyGlyph = 0xffffffff;
  static constexpr uint32_t kBranch = 0xfffffffe;  // those of branch_

  // characters.cpp
  void read(const Text& text, const ScriptRun& run) noexcept;
  void add_character(uint32_t code, uint32_t cluster) noexcept;
  __attribute__((always_inline)) inline bool continues(
      const TextGlyph& glyph, uint32_t code) const noexcept;
  void split_sara_am(uint32_t code, uint32_t cluster) noexcept;
  void order_marks() noexcept;
  __attribute__((always_inline)) inline void order_hebrew(int32_t begin,
                                                          int32_t end) noexcept;
  void part_letters() noexcept;
  void compose() noexcept;
  uint32_t type_beside(const Text& text, size_t at, bool is_before) noexcept;
  void join(const Text& text, const ScriptRun& run) noexcept;
  void find_glyphs() noexcept;
  void advance_all() noexcept;
  uint32_t code_of(const TextGlyph& glyph) const noexcept {
    return glyph.glyph | static_cast<uint32_t>(glyph.component) << 16;
  }
  void set_code(TextGlyph& glyph, uint32_t code) noexcept {
    glyph.glyph = static_cast<uint16_t>(code);
    glyph.component = static_cast<uint8_t>(code >> 16);
  }
  void set_traits(TextGlyph& glyph, uint32_t code) noexcept;

  // shaper.cpp
  void run_entries(uint32_t first, uint32_t count) noexcept;
  void load(uint32_t number) noexcept;
  bool spend() noexcept;
  bool has_form(const TextGlyph& glyph) const noexcept {
    return (glyph.kind >> 2 & mask_) != 0;
  }
  bool may_skip(const TextGlyph& glyph, bool is_context) const noexcept;
  int32_t find_next(int32_t from,
                    int32_t step,
                    uint32_t set,
                    bool is_context) noexcept;
  bool find_row(uint32_t glyph) noexcept {
    at_ = lookup_.rows;
    return find(lookup_.row_bits, lookup_.count, glyph_bits(), glyph);
  }
  int32_t apply(int32_t i, uint32_t depth) noexcept;
  void set_glyph(TextGlyph& glyph, uint32_t id) noexcept;
  bool insert(int32_t at, int32_t count) noexcept;
  void erase(int32_t at) noexcept {
    --n_;
    move(at, n_);
  }
  void move(int32_t from, int32_t to) noexcept;
  void merge(int32_t begin, int32_t end) noexcept;
  void finish(bool is_right_to_left) noexcept;
  __attribute__((always_inline)) inline void settle(
      int32_t i, bool is_right_to_left) noexcept;
  __attribute__((always_inline)) inline void hide_ignorables() noexcept;

  // substitutions.cpp; what a lookup is applied to has a row, whose rest is
  // next.
  int32_t replace_one(int32_t i) noexcept {
    set_glyph(g_[i], take(glyph_bits()));
    return i + 1;
  }
  int32_t replace_by_many(int32_t i) noexcept;
  int32_t ligate(int32_t i) noexcept;
  __attribute__((always_inline)) inline void join_components(
      const uint16_t* places, int32_t count, uint32_t ligature) noexcept;
  int32_t apply_context(int32_t i, uint32_t depth) noexcept;
  int32_t match(uint32_t sets,
                uint32_t count,
                int32_t from,
                int32_t step,
                uint16_t* places) noexcept;
  __attribute__((always_inline)) inline int32_t apply_rule(
      uint32_t actions,
      uint32_t count,
      uint16_t* places,
      int32_t inputs,
      uint32_t depth) noexcept;

  // positions.cpp
  int32_t take_value(uint32_t column) noexcept;
  int32_t adjust(int32_t i) noexcept;
  int32_t kern(int32_t i) noexcept;
  int32_t attach(int32_t i) noexcept;
  struct Anchor;
  __attribute__((always_inline)) inline bool find_anchor(const TextGlyph& mark,
                                                         uint32_t mark_row,
                                                         uint32_t base,
                                                         uint32_t component,
                                                         Anchor& out) noexcept;
  __attribute__((always_inline)) inline void link_cursive(
      int32_t i, int32_t j, const Anchor& anchor) noexcept;
  __attribute__((always_inline)) inline void turn_cursive(
      int32_t i, int32_t parent) noexcept;
  void set_link(TextGlyph& glyph, int32_t link, bool is_cursive) noexcept;

  // In this order code for Cortex-M0 reaches each by one instruction.
  Status status_ = Status::ok;
  uint8_t ligatures_ = 0;
  bool manual_zwj_ = false;
  ShapeLookup lookup_;  // that is applied
  TextGlyph* g_;
  int32_t n_ = 0;
  int32_t room_;
  uint32_t mask_ = 0;   // of the entry that runs
  uint32_t steps_ = 0;  // that are left
  const Font& font_;
  const SyllableCode* syllables_;
  ShapeProgram program_;
  uint32_t branch_ = 0;    // rows of ligatures [bit],
  uint32_t branches_ = 0;  // and how many
};

}  // namespace inkcell::detail
