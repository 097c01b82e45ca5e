#include "hints/face.hpp"

#include <algorithm>
#include <cmath>

#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace grid = format::grid;

// Edges this far from both heights of a zone belong to it. [u]
constexpr double kReach = 6;

// Zones on one side lie farther apart. [u]
constexpr double kZoneSpread = 4;

// Round edges reach no farther beyond flat ones. [u]
constexpr double kMostOvershoot = 32;

// Zones lie within this of the baseline. [u]
constexpr double kMostHeight = 4096;

// A height is shared if at least so many glyphs have it, within so much. [u]
constexpr size_t kLeastSharing = 4;
constexpr double kLeastShare = 0.1;  // of all glyphs with ink
constexpr double kSameHeight = 3;

// Standard widths are this near to the median.
constexpr double kNearMedian = 0.12;

// Bars this much thinner than stems: a face with contrast.
constexpr double kContrast = 0.75;
constexpr double kFewBars = 1.1;  // a glyph

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Letters whose extremes show a zone.
struct ZoneLetters {
  const char32_t* flat;
  const char32_t* round;
  bool is_top;
  bool is_lower_case;  // the x-height
};

constexpr ZoneLetters kZoneLetters[] = {
    {U"HEFTLIxzhmnikr", U"oO", false, false},
    {U"xzvw", U"oec", true, true},
    {U"HEIT", U"OCG", true, false},
    {U"bdhkl", U"f", true, false},
    {U"pq", U"gy", false, false},
    {U"17", U"0", true, false},
    {U"12", U"0", false, false},
    {U"НПТГнптгк", U"оО", false, false},
    {U"нптгкви", U"осе", true, true},
    {U"НПТГЕ", U"ОС", true, false},
    {U"р", U"у", false, false},
    {U"ΗΠΓΙπηικν", U"οΟ", false, false},
    {U"κνχυμ", U"οες", true, true},
    {U"ΗΠΓΕ", U"ΟΘ", true, false},
};

class ZoneFinder {
 public:
  ZoneFinder(const std::vector<GlyphFeatures>& glyphs,
             const std::map<char32_t, uint16_t>& glyph_of,
             FaceHints& face)
      : glyphs_(glyphs), glyph_of_(glyph_of), face_(face) {}

  void find() {
    for (const ZoneLetters& letters : kZoneLetters) {
      add_letters(letters);
    }
    while (face_.zones.size() < grid::kMaxZones && add_shared()) {
    }
  }

 private:
  struct Extreme {
    double y;
    bool is_top;
    bool is_round;
  };

  static double extreme_of(const GlyphFeatures& glyph, bool is_top) {
    return is_top ? glyph.box.y1 : glyph.box.y0;
  }

  std::vector<double> extremes_of(const char32_t* letters, bool is_top) const {
    std::vector<double> found;
    for (; *letters != 0; ++letters) {
      const auto glyph = glyph_of_.find(*letters);
      if (glyph != glyph_of_.end() && glyphs_[glyph->second].has_ink) {
        found.push_back(extreme_of(glyphs_[glyph->second], is_top));
      }
    }
    return found;
  }

  void add_letters(const ZoneLetters& letters) {
    const std::vector<double> flat = extremes_of(letters.flat, letters.is_top);
    const std::vector<double> round =
        extremes_of(letters.round, letters.is_top);
    if (flat.empty() && round.empty()) {
      return;
    }
    const double height = median(flat.empty() ? round : flat);
    const double round_height = round.empty() ? height : round.front();
    const std::optional<size_t> zone =
        add(height, round_height, letters.is_top);
    if (letters.is_lower_case && !face_.x_zone) {
      face_.x_zone = zone;
    }
  }

  // The zone at that height, new if there is none. None if the format cannot
  // hold it.
  std::optional<size_t> add(double flat, double round, bool is_top) {
    for (size_t i = 0; i < face_.zones.size(); ++i) {
      if (face_.zones[i].is_top == is_top &&
          std::abs(face_.zones[i].flat_u - flat) <= kZoneSpread) {
        return i;
      }
    }
    if (face_.zones.size() == grid::kMaxZones || std::abs(flat) > kMostHeight) {
      return {};
    }
    double overshoot = is_top ? round - flat : flat - round;
    overshoot = overshoot > kMostOvershoot ? 0 : std::max(overshoot, 0.0);
    HintZone zone;
    zone.flat_u = static_cast<int>(std::lround(flat));
    zone.overshoot_u =
        static_cast<int>(std::lround(is_top ? overshoot : -overshoot));
    zone.is_top = is_top;
    face_.zones.push_back(zone);
    return face_.zones.size() - 1;
  }

  // Adds the most common height outside of all zones.
  bool add_shared() {
    std::vector<Extreme> free;
    size_t with_ink = 0;
    for (const GlyphFeatures& glyph : glyphs_) {
      with_ink += glyph.has_ink ? 1 : 0;
      for (const bool is_top : {false, true}) {
        const double y = extreme_of(glyph, is_top);
        if (glyph.has_ink && !zone_of(face_, y, is_top) &&
            std::abs(y) <= kMostHeight) {
          free.push_back({y, is_top, ends_round(glyph, y)});
        }
      }
    }
    const auto needed = std::max(
        kLeastSharing,
        static_cast<size_t>(kLeastShare * static_cast<double>(with_ink)));
    const Extreme* best = nullptr;
    size_t most = 0;
    for (const Extreme& extreme : free) {
      const size_t count = sharing(free, extreme);
      // Flat edges first: round ones lie beyond them.
      if (count > most ||
          (count == most && best->is_round && !extreme.is_round)) {
        best = &extreme;
        most = count;
      }
    }
    return most >= needed &&
           add(best->y, round_beyond(free, *best), best->is_top);
  }

  static bool ends_round(const GlyphFeatures& glyph, double y) {
    const auto is_here = [y](double edge) {
      return std::abs(edge - y) < kSameHeight;
    };
    for (const Stroke& bar : glyph.bars) {
      if (is_here(bar.low) || is_here(bar.high)) {
        return bar.is_round;
      }
    }
    return std::any_of(glyph.lone_edges.begin(), glyph.lone_edges.end(),
                       [&](const StrokeEdge& edge) {
                         return is_here(edge.position) && edge.is_round;
                       });
  }

  static size_t sharing(const std::vector<Extreme>& extremes,
                        const Extreme& with) {
    return static_cast<size_t>(std::count_if(
        extremes.begin(), extremes.end(), [&with](const Extreme& other) {
          return other.is_top == with.is_top &&
                 std::abs(other.y - with.y) < kSameHeight;
        }));
  }

  // The median of round extremes a little beyond `flat`.
  static double round_beyond(const std::vector<Extreme>& extremes,
                             const Extreme& flat) {
    std::vector<double> round;
    for (const Extreme& extreme : extremes) {
      const double beyond =
          flat.is_top ? extreme.y - flat.y : flat.y - extreme.y;
      if (extreme.is_top == flat.is_top && extreme.is_round &&
          beyond >= kSameHeight && beyond <= kMostOvershoot) {
        round.push_back(extreme.y);
      }
    }
    return round.empty() ? flat.y : median(std::move(round));
  }

  const std::vector<GlyphFeatures>& glyphs_;
  const std::map<char32_t, uint16_t>& glyph_of_;
  FaceHints& face_;
};

// Letters that show the widths of strokes.
constexpr char32_t kStemLetters[] = U"nhmuidlrpq";
constexpr char32_t kBarLetters[] = U"acefgostzbdpqABDEFHOPRST";

void add_widths(const std::vector<Stroke>& strokes,
                std::vector<double>& widths) {
  for (const Stroke& stroke : strokes) {
    if (stroke.kind == Stroke::Kind::plain) {
      widths.push_back(stroke.width());
    }
  }
}

// The most common width near the median: of straight stems rather than bowls.
int usual_width(const std::vector<double>& widths) {
  const double middle = median(widths);
  // Counts strokes of about that width, weighted by how close they are.
  const auto sharing = [&widths](int width) {
    double sum = 0;
    for (const double other : widths) {
      sum += std::max(0.0, kSameWidth - std::abs(other - width));
    }
    return sum;
  };
  int best = static_cast<int>(std::lround(middle));
  for (int width = static_cast<int>(std::ceil((1 - kNearMedian) * middle));
       width <= (1 + kNearMedian) * middle; ++width) {
    if (sharing(width) > sharing(best)) {
      best = width;
    }
  }
  return best;
}

// The standard width of `letters`, or of all glyphs if the font has none of
// them.
int standard_width(const std::vector<GlyphFeatures>& glyphs,
                   const std::map<char32_t, uint16_t>& glyph_of,
                   const char32_t* letters,
                   std::vector<Stroke> GlyphFeatures::*strokes) {
  std::vector<double> widths;
  for (; *letters != 0; ++letters) {
    const auto glyph = glyph_of.find(*letters);
    if (glyph != glyph_of.end()) {
      add_widths(glyphs[glyph->second].*strokes, widths);
    }
  }
  if (widths.empty()) {
    for (const GlyphFeatures& glyph : glyphs) {
      add_widths(glyph.*strokes, widths);
    }
  }
  return widths.empty() ? 0 : usual_width(widths);
}

bool has_few_bars(const std::vector<GlyphFeatures>& glyphs) {
  size_t bars = 0;
  size_t with_ink = 0;
  for (const GlyphFeatures& glyph : glyphs) {
    bars += glyph.bars.size();
    with_ink += glyph.has_ink ? 1 : 0;
  }
  return static_cast<double>(bars) < kFewBars * static_cast<double>(with_ink);
}

}  // namespace

FaceHints find_face(const std::vector<GlyphFeatures>& glyphs,
                    const std::map<char32_t, uint16_t>& glyph_of) {
  FaceHints face;
  ZoneFinder(glyphs, glyph_of, face).find();
  face.stem_width_u =
      standard_width(glyphs, glyph_of, kStemLetters, &GlyphFeatures::stems);
  face.bar_width_u =
      standard_width(glyphs, glyph_of, kBarLetters, &GlyphFeatures::bars);
  face.has_contrast = face.bar_width_u < kContrast * face.stem_width_u;
  face.has_few_bars = has_few_bars(glyphs);
  return face;
}

std::optional<ZoneEdge> zone_of(const FaceHints& face, double y, bool is_top) {
  std::optional<ZoneEdge> best;
  double nearest = 0;
  for (size_t i = 0; i < face.zones.size(); ++i) {
    const HintZone& zone = face.zones[i];
    const int round_u = zone.flat_u + zone.overshoot_u;
    if (zone.is_top != is_top || y < std::min(zone.flat_u, round_u) - kReach ||
        y > std::max(zone.flat_u, round_u) + kReach) {
      continue;
    }
    const double from_flat = std::abs(y - zone.flat_u);
    const double from_round = std::abs(y - round_u);
    const double distance = std::min(from_flat, from_round);
    if (!best || distance < nearest) {
      best = {i, from_round < from_flat};
      nearest = distance;
    }
  }
  return best;
}

}  // namespace inkcell::gen
