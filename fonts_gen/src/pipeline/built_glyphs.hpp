// Built glyphs, kept for the next font that has the same outlines.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "judge/closed_loop.hpp"
#include "outlines/refit.hpp"
#include "rom/rom_content.hpp"
#include "source/font_source.hpp"
#include "target/target.hpp"

namespace inkcell::gen {

/// One glyph, and how it looks.
struct BuiltGlyph {
  RomGlyph glyph;      // but for its advance, which is no part of the work
  GlyphErrors errors;  // size_aware
};

/// The glyphs of the last font that was built with it, by their outlines. For
/// programs that build a font again after each change of a glyph. Not for two
/// fonts at a time. Fonts of fields are built whole.
class BuiltGlyphs {
 public:
  /// Begins a font of this target and refit, on which its glyphs depend beside
  /// their outlines. Drops what was built for others.
  void begin(const Target& target, const RefitOptions& refit);

  /// The glyph of this outline, valid until keep(); null: it must be built.
  /// Threads may call it.
  const BuiltGlyph* find(const Outline& outline) const;

  /// Ends the font: keeps its glyphs and no others. `glyphs[i]`, with
  /// `errors[i]`, is the one of `sources[i]`.
  void keep(const std::vector<SourceGlyph>& sources,
            const std::vector<RomGlyph>& glyphs,
            const std::vector<GlyphErrors>& errors);

  /// Its glyphs as bytes, for add() of this version on the same kind of
  /// machine: processes may share the work of one font.
  std::string bytes() const;

  /// Adds what bytes() gave. Glyphs of other conditions replace all. Throws
  /// Error, which begins with `name`, for other bytes.
  void add(std::string_view bytes, const std::string& name);

  /// Outlines of the last font that did not need to be built.
  size_t reused() const { return reused_; }

 private:
  using Key = std::vector<double>;

  static Key key_of(const Outline& outline);

  Key conditions_;
  std::map<Key, BuiltGlyph> glyphs_;
  size_t reused_ = 0;
};

}  // namespace inkcell::gen
