#include "pipeline/layers.hpp"

#include <cmath>
#include <map>

#include "inkcell/format/rom.hpp"
#include "parallel.hpp"
#include "shape/mono_form.hpp"

namespace inkcell::gen {
namespace {

// Outlines that are equal to 1/64 u are one.
using LayerKey = std::vector<int64_t>;

LayerKey key_of(const Outline& outline) {
  LayerKey key;
  for (const Contour& contour : outline.contours) {
    key.push_back(static_cast<int64_t>(contour.segments.size()));
    for (const Segment& segment : contour.segments) {
      for (int i = 0; i <= degree_of(segment); ++i) {
        key.push_back(std::llround(64 * segment.p[i].x));
        key.push_back(std::llround(64 * segment.p[i].y));
      }
    }
  }
  return key;
}

// The colours of a font, in the order in which they are met.
class ColourList {
 public:
  size_t number_of(const Paint& paint) {
    const auto [found, is_new] = numbers_.emplace(paint, colours_.size());
    if (is_new) {
      colours_.push_back(paint);
    }
    return found->second;
  }
  const std::vector<Paint>& colours() const { return colours_; }

 private:
  std::map<Paint, size_t> numbers_;
  std::vector<Paint> colours_;
};

void set_forms(SourceGlyph& glyph) {
  glyph.outline = mono_form(glyph.painted);
  Box& box = glyph.layers_box;
  box = kNoBox;
  for (const PaintedOutline& part : glyph.painted) {
    const Box part_box = Shape(part.outline).box();
    box.add({part_box.x0, part_box.y0});
    box.add({part_box.x1, part_box.y1});
  }
}

// Runs `work` on a glyph; what it throws names the glyph.
template <typename Work>
void with_name(const SourceGlyph& glyph, const Work& work) {
  try {
    work();
  } catch (const GeometryError& error) {
    throw Error(glyph.file_name + ": " + glyph.name() + ": " + error.what() +
                "; " + glyph.remedy("repair the drawing"));
  }
}

}  // namespace

void make_layers(SourceFont& font, int threads) {
  constexpr size_t kMost = format::layers::kMaxLayers;
  parallel_for(font.glyphs.size(), threads,
               [&](size_t i) {
                 SourceGlyph& glyph = font.glyphs[i];
                 if (!glyph.painted.empty()) {
                   with_name(glyph, [&] { set_forms(glyph); });
                 }
               },
               {});
  ColourList colours;
  std::map<LayerKey, size_t> known;
  std::vector<SourceGlyph> layers;
  for (SourceGlyph& glyph : font.glyphs) {
    if (glyph.painted.size() > kMost) {
      throw Error(glyph.file_name + ": " + glyph.name() + ": has " +
                  std::to_string(glyph.painted.size()) + " layers, at most " +
                  std::to_string(kMost) + " are possible; " +
                  glyph.remedy("join parts of one colour"));
    }
    for (PaintedOutline& part : glyph.painted) {
      const auto [found, is_new] =
          known.emplace(key_of(part.outline), layers.size());
      if (is_new) {
        layers.emplace_back();
        layers.back().layer_of = glyph.name();
        layers.back().file_name = glyph.file_name;
        layers.back().outline = std::move(part.outline);
      }
      const Paint& paint = part.paint;
      // Behind the colours: see below.
      const size_t colour = paint.is_ink ? SIZE_MAX - 255u + paint.opacity
                                         : colours.number_of(paint);
      glyph.layers.push_back({found->second, colour});
    }
    glyph.painted.clear();
  }
  if (layers.empty()) {
    return;
  }
  if (font.glyphs.size() + layers.size() > kMostGlyphs) {
    throw Error(font.file_name + ": with " + std::to_string(layers.size()) +
                " layers the font has more than " +
                std::to_string(kMostGlyphs) +
                " glyphs; ask for fewer characters");
  }
  // The text's own colour follows the others, less opaque from one to the next.
  for (SourceGlyph& glyph : font.glyphs) {
    for (LayerReference& layer : glyph.layers) {
      if (layer.colour >= SIZE_MAX - 255) {
        layer.colour = colours.colours().size() + (SIZE_MAX - layer.colour);
      }
    }
  }
  font.palettes = {colours.colours()};
  font.layer_count = layers.size();
  for (SourceGlyph& layer : layers) {
    font.glyphs.push_back(std::move(layer));
  }
  font.components.resize(font.glyphs.size());
  font.kerning.left_class.resize(font.glyphs.size());
  font.kerning.right_class.resize(font.glyphs.size());
}

RomLayers rom_layers(const SourceFont& font) {
  RomLayers rom;
  rom.palettes = font.palettes;
  const size_t first = font.glyphs.size() - font.layer_count;
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    if (font.glyphs[i].layers.empty()) {
      continue;
    }
    rom.glyphs.push_back({i, {}});
    for (const LayerReference& layer : font.glyphs[i].layers) {
      rom.glyphs.back().layers.push_back({first + layer.layer, layer.colour});
    }
  }
  return rom;
}

}  // namespace inkcell::gen
