#include "source/font_layers.hpp"

#include <hb-ot.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "shape/affine.hpp"
#include "shape/points.hpp"
#include "source/glyph_reader.hpp"

namespace inkcell::gen {
namespace {

constexpr unsigned kOfText = 0xffff;  // a colour that is that of the text

// Paints lie within each other; a circle of them has no end.
constexpr int kMostNested = 32;
constexpr int kMostPaints = 4096;  // of a glyph

// Paints by the number of their format. Those that move another one are even
// from kTransform to kSkewAbout; of odd numbers are those that vary.
enum PaintFormat : unsigned {
  kLayerList = 1,
  kSolid = 2,
  kLinearGradient = 4,
  kRadialGradient = 6,
  kSweepGradient = 8,
  kGlyph = 10,
  kOtherRoot = 11,
  kTransform = 12,
  kTranslate = 14,
  kScale = 16,
  kScaleAbout = 18,
  kScaleAlike = 20,
  kScaleAlikeAbout = 22,
  kRotate = 24,
  kRotateAbout = 26,
  kSkew = 28,
  kSkewAbout = 30,
  kComposite = 32,
};
constexpr unsigned kSourceOver = 3;  // a mode of composites

unsigned flat_layers(const FontFile& file, uint32_t glyph) {
  return hb_ot_color_glyph_get_layers(file.hb_face(), glyph, 0, nullptr,
                                      nullptr);
}

std::vector<hb_color_t> first_palette(hb_face_t* face) {
  unsigned count = hb_ot_color_palette_get_colors(face, 0, 0, nullptr, nullptr);
  std::vector<hb_color_t> colours(count);
  hb_ot_color_palette_get_colors(face, 0, 0, &count, colours.data());
  return colours;
}

// Table COLR of version 1. FreeType's own reader is left out by distributions.
class PaintTable {
 public:
  explicit PaintTable(const FontFile& file)
      : file_(file),
        blob_(
            hb_face_reference_table(file.hb_face(), HB_TAG('C', 'O', 'L', 'R')),
            hb_blob_destroy),
        bytes_(reinterpret_cast<const uint8_t*>(
            hb_blob_get_data(blob_.get(), &size_))) {}

  /// An unsigned number of 1 to 4 bytes.
  uint32_t number(size_t at, size_t size) const {
    if (at + size > size_) {
      file_.refuse("table COLR ends within a paint; repair it");
    }
    uint32_t value = 0;
    for (const size_t end = at + size; at != end; ++at) {
      value = value << 8 | bytes_[at];
    }
    return value;
  }
  double whole(size_t at) const { return static_cast<int16_t>(number(at, 2)); }
  double q2_14(size_t at) const { return whole(at) / 16384; }
  double q16_16(size_t at) const {
    return static_cast<int32_t>(number(at, 4)) / 65536.0;
  }

  /// The paint of a glyph; 0: it has none.
  size_t root(uint32_t glyph) const {
    const size_t list = list_at(14);
    const uint32_t count = list == 0 ? 0 : number(list, 4);
    for (uint32_t i = 0; i < count; ++i) {
      const size_t at = list + 4 + 6 * size_t{i};
      if (number(at, 2) >= glyph) {
        return number(at, 2) == glyph ? list + number(at + 2, 4) : 0;
      }
    }
    return 0;
  }
  size_t layer(size_t index) const {
    const size_t list = list_at(18);
    if (list == 0 || index >= number(list, 4)) {
      file_.refuse("table COLR has no layer " + std::to_string(index) +
                   "; repair it");
    }
    return list + number(list + 4 + 4 * index, 4);
  }

 private:
  // The list whose offset is there; 0: none.
  size_t list_at(size_t at) const {
    return size_ < 2 || number(0, 2) == 0 ? 0 : number(at, 4);
  }

  const FontFile& file_;
  const std::unique_ptr<hb_blob_t, void (*)(hb_blob_t*)> blob_;
  unsigned size_ = 0;
  const uint8_t* const bytes_;
};

// Takes the paints of a glyph apart into outlines of one colour each.
class LayerReader {
 public:
  LayerReader(const FontFile& file, SourceGlyph& glyph, Warnings& warnings)
      : file_(file),
        table_(file),
        glyph_(glyph),
        warnings_(warnings),
        colours_(first_palette(file.hb_face())),
        unit_(kUPerEm / file.units_per_em()) {}

  void read() {
    unsigned count = flat_layers(file_, glyph_.source);
    if (count == 0) {
      if (const size_t root = table_.root(glyph_.source); root != 0) {
        read(root, {}, 0);
      }
      return;
    }
    std::vector<hb_ot_color_layer_t> layers(count);
    hb_ot_color_glyph_get_layers(file_.hb_face(), glyph_.source, 0, &count,
                                 layers.data());
    for (const hb_ot_color_layer_t& layer : layers) {
      add(layer.glyph, {}, colour_of(layer.color_index, 1));
    }
  }

  size_t gradients() const { return gradients_; }

 private:
  [[noreturn]] void refuse(
      const std::string& what,
      const std::string& repair = "repair table COLR") const {
    file_.refuse(glyph_.name() + ": " + what + "; " + glyph_.remedy(repair));
  }

  // Reads what a paint draws within `place`. [u]
  void read(size_t paint, const Affine& place, int depth) {
    if (depth > kMostNested || ++paints_ > kMostPaints) {
      refuse("its paints lead in a circle, or are more than " +
             std::to_string(kMostPaints) + ", or " +
             std::to_string(kMostNested) + " within each other");
    }
    switch (format_of(paint)) {
      case kLayerList: {
        const size_t first = table_.number(paint + 2, 4);
        for (size_t i = 0; i < table_.number(paint + 1, 1); ++i) {
          read(table_.layer(first + i), place, depth + 1);
        }
        return;
      }
      case kGlyph:
        add(table_.number(paint + 4, 2), place, fill_of(inner(paint)));
        return;
      case kOtherRoot: {
        const uint32_t glyph = table_.number(paint + 1, 2);
        const size_t root = table_.root(glyph);
        if (root == 0) {
          refuse("it draws glyph " + std::to_string(glyph) +
                 ", which has no paint");
        }
        read(root, place, depth + 1);
        return;
      }
      case kComposite: {
        const unsigned mode = table_.number(paint + 4, 1);
        if (mode != kSourceOver) {
          refuse("it composes paints by mode " + std::to_string(mode) +
                 ", but layers lie over each other, mode " +
                 std::to_string(kSourceOver));
        }
        read(paint + table_.number(paint + 5, 3), place, depth + 1);
        read(inner(paint), place, depth + 1);
        return;
      }
      default:
        if (!moves(paint)) {
          refuse("a fill has no glyph that bounds it");
        }
        read(inner(paint), product(place, map_of(paint)), depth + 1);
    }
  }

  unsigned format_of(size_t paint) const {
    const unsigned format = table_.number(paint, 1);
    if (format > kSolid && format % 2 != 0 && format != kOtherRoot &&
        format < kComposite) {
      refuse("its paints vary along axes, which is not read",
             "make an instance of the font");
    }
    return format;
  }
  // The paint that another one moves, fills with, or draws over a third.
  size_t inner(size_t paint) const {
    return paint + table_.number(paint + 1, 3);
  }
  bool moves(size_t paint) const {
    const unsigned format = format_of(paint);
    return format >= kTransform && format <= kSkewAbout;
  }

  Affine map_of(size_t paint) const {
    const auto factor = [&](size_t i) {
      return table_.q2_14(paint + 4 + 2 * i);
    };
    const auto length = [&](size_t i) {
      return table_.whole(paint + 4 + 2 * i) * unit_;
    };
    const auto angle = [&](size_t i) { return factor(i) * kPi; };
    const unsigned format = format_of(paint);
    Affine map;
    size_t centre = 0;  // 0: there is none
    switch (format) {
      case kTransform: {
        const size_t at = paint + table_.number(paint + 4, 3);
        const auto entry = [&](size_t i) { return table_.q16_16(at + 4 * i); };
        map = {entry(0), entry(1),         entry(2),
               entry(3), entry(4) * unit_, entry(5) * unit_};
        break;
      }
      case kTranslate:
        map.dx = length(0);
        map.dy = length(1);
        break;
      case kScale:
      case kScaleAbout:
        map.xx = factor(0);
        map.yy = factor(1);
        centre = format == kScaleAbout ? 2 : 0;
        break;
      case kScaleAlike:
      case kScaleAlikeAbout:
        map.xx = map.yy = factor(0);
        centre = format == kScaleAlikeAbout ? 1 : 0;
        break;
      case kRotate:
      case kRotateAbout:
        map.xx = map.yy = std::cos(angle(0));
        map.xy = std::sin(angle(0));
        map.yx = -map.xy;
        centre = format == kRotateAbout ? 1 : 0;
        break;
      default:
        map.yx = -std::tan(angle(0));
        map.xy = std::tan(angle(1));
        centre = format == kSkewAbout ? 2 : 0;
    }
    if (centre != 0) {
      const double x = length(centre);
      const double y = length(centre + 1);
      const Point moved = map.map(x, y);
      map.dx = x - moved.x;
      map.dy = y - moved.y;
    }
    return map;
  }

  // What a glyph is filled with; where that is moved to does not matter.
  Paint fill_of(size_t paint) {
    for (int depth = 0; depth < kMostNested && moves(paint); ++depth) {
      paint = inner(paint);
    }
    switch (format_of(paint)) {
      case kSolid:
        return colour_at(paint + 1);
      case kLinearGradient:
      case kRadialGradient:
      case kSweepGradient:
        return mean_of(inner(paint));
      default:
        refuse("a glyph bounds more than a fill");
    }
  }

  // A number of a colour, and its opacity.
  Paint colour_at(size_t at) const {
    return colour_of(table_.number(at, 2), table_.q2_14(at + 2));
  }
  Paint colour_of(unsigned index, double opacity) const {
    if (index != kOfText && index >= colours_.size()) {
      refuse("a layer has colour " + std::to_string(index) +
             " of a palette of " + std::to_string(colours_.size()));
    }
    // Bytes, from the highest: blue, green, red, alpha.
    const hb_color_t colour = index == kOfText ? 255 : colours_[index];
    opacity = std::clamp(opacity, 0.0, 1.0) * (colour & 255);
    return {static_cast<uint8_t>(colour >> 8),
            static_cast<uint8_t>(colour >> 16),
            static_cast<uint8_t>(colour >> 24),
            static_cast<uint8_t>(std::lround(opacity)), index == kOfText};
  }

  // Of a line of colours from its first stop to its last.
  Paint mean_of(size_t line) {
    constexpr size_t kStopBytes = 6;
    const size_t stops = table_.number(line + 1, 2);
    double sums[4] = {};  // of channels times opacity, and of opacity
    double whole = 0;
    size_t inks = 0;
    for (size_t i = 0; i < stops; ++i) {
      const size_t at = line + 3 + kStopBytes * i;
      const size_t before = i == 0 ? at : at - kStopBytes;
      // Stops at one place have a share, too: there may be no others.
      const double share =
          std::max(table_.q2_14(at) - table_.q2_14(before), 1e-6);
      for (const size_t stop : {before, at}) {
        const Paint colour = colour_at(stop + 2);
        const double weight = share * colour.opacity;
        sums[0] += weight * colour.red;
        sums[1] += weight * colour.green;
        sums[2] += weight * colour.blue;
        sums[3] += weight;
        whole += share;
        inks += colour.is_ink ? 1 : 0;
      }
    }
    if (stops == 0 || (inks != 0 && inks != 2 * stops)) {
      refuse("a gradient has no colours, or that of the text among others");
    }
    ++gradients_;
    const auto channel = [&](int i) {
      return static_cast<uint8_t>(
          sums[3] == 0 ? 0 : std::lround(sums[i] / sums[3]));
    };
    return {channel(0), channel(1), channel(2),
            static_cast<uint8_t>(std::lround(sums[3] / whole)), inks != 0};
  }

  void add(uint32_t glyph, const Affine& place, const Paint& paint) {
    SourceGlyph part;
    part.file_name = glyph_.file_name;
    part.source = glyph;
    read_glyph(file_, part, warnings_);
    if (!part.outline.contours.empty()) {
      map(place, part.outline);
      glyph_.painted.push_back({std::move(part.outline), paint});
    }
  }

  const FontFile& file_;
  const PaintTable table_;
  SourceGlyph& glyph_;
  Warnings& warnings_;
  const std::vector<hb_color_t> colours_;
  const double unit_;  // [u]
  size_t gradients_ = 0;
  int paints_ = 0;
};

}  // namespace

bool has_layers(const FontFile& file, uint32_t glyph) {
  return flat_layers(file, glyph) != 0 || PaintTable(file).root(glyph) != 0;
}

size_t read_layers(const FontFile& file,
                   SourceGlyph& glyph,
                   Warnings& warnings) {
  LayerReader reader(file, glyph, warnings);
  reader.read();
  return reader.gradients();
}

}  // namespace inkcell::gen
