// Shapes one run in RAM that the caller lends.
#pragma once

#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/shaping.hpp"
#include "tables.hpp"

namespace inkcell::detail {

// RunGlyph::flags.
inline constexpr uint8_t kIgnorable = 1;  // shows nothing, and is looked over
inline constexpr uint8_t kZwj = 2;
inline constexpr uint8_t kZwnj = 4;
inline constexpr uint8_t kMultiplied = 8;
inline constexpr uint8_t kLigated = 16;
inline constexpr uint8_t kCursiveLink = 32;
inline constexpr uint8_t kAboveBase = 64;  // of Thai, while characters are read

/// A lookup's head.
struct ShapeLookup {
  uint32_t type = 0;
  uint32_t skip = 0;    // classes 1 to 3 that it looks over
  uint32_t filter = 0;  // of marks: a set's number plus 1; 0: none
  uint32_t count = 0;
  uint32_t at = 0;  // its data [bit]
};

class Shaper : ShapeReader {
 public:
  Shaper(const Font& font,
         const ShapeTables& tables,
         Span<RunGlyph> room) noexcept
      : ShapeReader(tables),
        font_(font),
        g_(room.data),
        room_(static_cast<int32_t>(room.size < 65535 ? room.size : 65535)) {}

  Status shape(const Text& text,
               const ScriptRun& run,
               uint32_t program) noexcept;
  uint32_t count() const noexcept { return static_cast<uint32_t>(n_); }

 private:
  static constexpr int32_t kNo = -1;

  // Which glyphs a search accepts.
  enum class Want : uint8_t { any, set };

  // characters.cpp
  void read(const Text& text, const ScriptRun& run) noexcept;
  void add_character(uint32_t code, uint32_t cluster) noexcept;
  void split_sara_am(uint32_t code, uint32_t cluster) noexcept;
  void order_marks() noexcept;
  void order_hebrew(int32_t begin, int32_t end) noexcept;
  void part_letters() noexcept;
  void compose() noexcept;
  void join(const Text& text, const ScriptRun& run) noexcept;
  void find_glyphs() noexcept;
  void advance_all() noexcept;
  uint32_t code_of(const RunGlyph& glyph) const noexcept {
    return glyph.glyph | static_cast<uint32_t>(glyph.component) << 16;
  }
  void set_code(RunGlyph& glyph, uint32_t code) noexcept {
    glyph.glyph = static_cast<uint16_t>(code);
    glyph.component = static_cast<uint8_t>(code >> 16);
  }
  void set_traits(RunGlyph& glyph, uint32_t code) noexcept;

  // shaper.cpp
  void run_entries(uint32_t first, uint32_t count) noexcept;
  void run_backwards(const ShapeLookup& lookup, uint32_t mask) noexcept;
  void load(uint32_t number, ShapeLookup& out) const noexcept;
  bool spend(uint32_t steps = 1) noexcept;
  bool skips(const ShapeLookup& lookup, const RunGlyph& glyph) const noexcept;
  bool may_skip(const ShapeLookup& lookup,
                const RunGlyph& glyph,
                bool is_context) const noexcept;
  int32_t find_next(const ShapeLookup& lookup,
                    int32_t from,
                    int32_t step,
                    Want want,
                    uint32_t set,
                    bool is_context) noexcept;
  bool find_row(uint32_t begin,
                uint32_t row_bits,
                uint32_t count,
                uint32_t glyph,
                uint32_t& at) const noexcept;
  int32_t apply(uint32_t number, int32_t i, uint32_t depth) noexcept;
  void set_glyph(RunGlyph& glyph, uint32_t id) noexcept;
  bool insert(int32_t at, int32_t count) noexcept;
  void erase(int32_t at) noexcept;
  void merge(int32_t begin, int32_t end) noexcept;
  void finish(bool is_right_to_left) noexcept;
  void settle(int32_t i, bool is_right_to_left) noexcept;
  void hide_ignorables() noexcept;
  uint32_t class_of(const RunGlyph& glyph) const noexcept {
    return glyph.kind & 3u;
  }
  bool is_mark(const RunGlyph& glyph) const noexcept {
    return class_of(glyph) == 3;
  }
  // Of a mark that belongs to a ligature.
  static uint32_t component_of(const RunGlyph& glyph) noexcept {
    return (glyph.flags & kLigated) != 0 ? 0u : glyph.component;
  }
  static uint32_t components_of(const RunGlyph& glyph) noexcept {
    return (glyph.flags & kLigated) != 0 ? glyph.component : 1u;
  }

  // substitutions.cpp
  int32_t replace_one(const ShapeLookup& lookup, int32_t i) noexcept;
  int32_t replace_by_many(const ShapeLookup& lookup, int32_t i) noexcept;
  int32_t ligate(const ShapeLookup& lookup, int32_t i) noexcept;
  void join_components(const uint16_t* places,
                       int32_t count,
                       uint32_t ligature) noexcept;
  int32_t apply_context(const ShapeLookup& lookup,
                        int32_t i,
                        uint32_t depth) noexcept;
  int32_t match_input(const ShapeLookup& lookup,
                      uint32_t sets,
                      int32_t count,
                      uint16_t* places) noexcept;
  bool match_around(const ShapeLookup& lookup,
                    uint32_t sets,
                    int32_t count,
                    int32_t from,
                    int32_t step) noexcept;
  int32_t apply_rule(uint32_t actions,
                     int32_t count,
                     uint16_t* places,
                     int32_t inputs,
                     uint32_t depth) noexcept;
  bool replace_backwards(const ShapeLookup& lookup, int32_t i) noexcept;

  // positions.cpp
  int32_t adjust(const ShapeLookup& lookup, int32_t i) noexcept;
  int32_t kern(const ShapeLookup& lookup, int32_t i) noexcept;
  int32_t link_cursive(const ShapeLookup& lookup, int32_t i) noexcept;
  void turn_cursive(int32_t i, int32_t parent) noexcept;
  int32_t attach(const ShapeLookup& lookup, int32_t i) noexcept;
  int32_t find_base(const ShapeLookup& lookup, int32_t i) noexcept;
  bool anchor(const ShapeLookup& lookup,
              int32_t i,
              int32_t base,
              uint32_t component) noexcept;
  void set_link(RunGlyph& glyph, int32_t link, bool is_cursive) noexcept;

  const Font& font_;
  RunGlyph* g_;
  int32_t room_;
  int32_t n_ = 0;
  uint32_t steps_ = 0;  // that are left
  ShapeProgram program_;
  uint32_t mask_ = 0;  // of the entry that runs
  bool manual_zwj_ = false;
  uint8_t ligatures_ = 0;
  Status status_ = Status::ok;
};

}  // namespace inkcell::detail
