// A font in the editor: immutable glyphs, and the current version of each.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/glyph.hpp"
#include "model/value.hpp"

namespace inkcell::design {

using GlyphPointer = std::shared_ptr<const Glyph>;

/// The pictures behind glyphs by file name in the folder images of UFO 3. Their
/// PNG bytes are immutable.
using ImageBytes = std::shared_ptr<const std::vector<uint8_t>>;
using Images = std::map<std::string, ImageBytes>;

/// A font without its glyphs: fontinfo, groups, kerning and lib of UFO 3, and
/// the pictures that its glyphs use.
struct FontData {
  Value info = Value::object();
  Value groups = Value::object();
  Value kerning = Value::object();
  Value lib = Value::object();
  std::string features;
  Images images;
};

bool operator==(const FontData& a, const FontData& b);

using FontDataPointer = std::shared_ptr<const FontData>;

struct Layer {
  std::string name;
  std::string folder;
  Value info = Value::object();  // layerinfo.plist
  std::map<std::string, GlyphPointer> glyphs;
};

/// A glyph of a layer before and after a command; null: it does not exist.
struct GlyphChange {
  size_t layer = 0;
  std::string name;
  GlyphPointer before;
  GlyphPointer after;
};

/// The change of one command. `before` and `after` of the font are null if it
/// does not change.
struct Change {
  std::vector<GlyphChange> glyphs;
  FontDataPointer font_before;
  FontDataPointer font_after;
};

class Project {
 public:
  Project();

  /// The first is the default layer.
  std::vector<Layer> layers;
  FontDataPointer font;

  const Layer& front() const { return layers.front(); }
  Layer& front() { return layers.front(); }

  /// Null if there is none.
  GlyphPointer find(const std::string& glyph, size_t layer = 0) const;
  /// Throws Error that names the glyph.
  GlyphPointer glyph(const std::string& name, size_t layer = 0) const;

  /// fontinfo's unitsPerEm, by default 1000.
  double units_per_em() const;

  void apply(const Change& change);
  void revert(const Change& change);
};

/// The pictures that glyphs use, in all layers.
std::set<std::string> image_names(const Project& project);

/// Names of the default layer's glyphs in the order of lib's public.glyphOrder;
/// the others follow, sorted by name.
std::vector<std::string> glyph_order(const Project& project);

}  // namespace inkcell::design
