// Levels, zones and lists of a whole font, and their bytes.
#include <algorithm>
#include <climits>
#include <cmath>
#include <map>
#include <string>

#include "alignment.hpp"
#include "bit_table.hpp"
#include "inkcell/format.hpp"

namespace inkcell::gen {
namespace {

// What overshoots reach beyond a zone, and how far flat edges lie before it.
// [u]
constexpr double kOvershoot = 26;
constexpr double kUndershoot = 6;

// Edges this near to each other are one level, unless there are too many.
constexpr double kLevelSpread = 3;

// Edges beyond are left out. The format's heights have 12 bits.
constexpr double kFarthest = 2000;

// Zones lie at least as far apart.
constexpr double kZoneSpread = 6;

struct Zone {
  double y;
  bool is_bottom;
};

// The flat edge of a glyph that ends it, or any edge if there is none.
const FlatEdge* outermost(const GlyphEdges& glyph, bool is_bottom) {
  const FlatEdge* best = nullptr;
  for (const FlatEdge& edge : glyph.edges) {
    if (edge.is_top == is_bottom) {
      continue;
    }
    const bool is_farther =
        best == nullptr || (is_bottom ? edge.y < best->y : edge.y > best->y);
    best = is_farther ? &edge : best;
  }
  return best;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

class Finder {
 public:
  Finder(const SourceFont& font, const std::vector<GlyphEdges>& found)
      : font_(font), found_(found) {
    for (size_t i = 0; i < font.glyphs.size(); ++i) {
      for (const char32_t c : font.glyphs[i].code_points) {
        glyph_of_[c] = i;
      }
    }
  }

  std::vector<Zone> zones() {
    add(U"HEFTLIxznhmir", true, 0);
    add(U"pq", true, 0);
    const double u = 1024.0 / font_.metrics.units_per_em;
    add(U"xzuvw", false, font_.metrics.x_height * u);
    add(U"HEFTIZ", false, font_.metrics.cap_height * u);
    add(U"lbdhk", false, 0);
    add(U"1457", false, 0);
    return zones_;
  }

 private:
  // The zone that `letters` show; `otherwise` if the font has none of them, 0:
  // no zone.
  void add(const char32_t* letters, bool is_bottom, double otherwise) {
    std::vector<double> heights;
    for (; *letters != 0; ++letters) {
      const auto glyph = glyph_of_.find(*letters);
      const FlatEdge* edge = glyph == glyph_of_.end()
                                 ? nullptr
                                 : outermost(found_[glyph->second], is_bottom);
      if (edge != nullptr && edge->is_flat) {
        heights.push_back(edge->y);
      }
    }
    const bool is_baseline = is_bottom && zones_.empty();
    if (heights.empty() && otherwise == 0 && !is_baseline) {
      return;
    }
    const Zone zone = {heights.empty() ? otherwise : median(heights),
                       is_bottom};
    if (std::abs(zone.y) > kFarthest) {
      return;
    }
    for (const Zone& other : zones_) {
      if (other.is_bottom == is_bottom &&
          std::abs(other.y - zone.y) < kZoneSpread) {
        return;
      }
    }
    zones_.push_back(zone);
  }

  const SourceFont& font_;
  const std::vector<GlyphEdges>& found_;
  std::map<char32_t, size_t> glyph_of_;
  std::vector<Zone> zones_;
};

// An edge that will be in a list.
struct Wanted {
  double y = 0;
  int zone = -1;
  bool is_bar = false;
};

int zone_of(double y, bool is_bottom, const std::vector<Zone>& zones) {
  int best = -1;
  double nearest = 0;
  for (size_t i = 0; i < zones.size(); ++i) {
    const double beyond = is_bottom ? zones[i].y - y : y - zones[i].y;
    if (zones[i].is_bottom == is_bottom && beyond <= kOvershoot &&
        beyond >= -kUndershoot && (best < 0 || std::abs(beyond) < nearest)) {
      best = static_cast<int>(i);
      nearest = std::abs(beyond);
    }
  }
  return best;
}

// The edges of a glyph that are worth a byte: bars, and what lies in zones.
std::vector<Wanted> wanted_edges(const GlyphEdges& glyph,
                                 const std::vector<Zone>& zones) {
  std::vector<Stroke> bars;
  for (const Stroke& bar : glyph.bars) {
    if (bar.low > -kFarthest && bar.high < kFarthest) {
      bars.push_back(bar);
    }
  }
  while (bars.size() > format::hints::kMaxCount / 2) {
    bars.erase(std::min_element(
        bars.begin(), bars.end(),
        [](const auto& a, const auto& b) { return a.length < b.length; }));
  }
  std::vector<Wanted> wanted;
  for (const Stroke& bar : bars) {
    wanted.push_back({bar.low, zone_of(bar.low, true, zones), true});
    wanted.push_back({bar.high, zone_of(bar.high, false, zones), false});
  }
  for (const FlatEdge& edge : glyph.edges) {
    const int zone = zone_of(edge.y, !edge.is_top, zones);
    if (zone < 0 || std::abs(edge.y) > kFarthest ||
        wanted.size() >= format::hints::kMaxCount) {
      continue;
    }
    const bool is_known =
        std::any_of(wanted.begin(), wanted.end(), [&](const Wanted& other) {
          return std::abs(other.y - edge.y) < kLevelSpread;
        });
    // Within a bar there are edges of its own zones only.
    const bool is_inside =
        std::any_of(bars.begin(), bars.end(), [&](const Stroke& bar) {
          return edge.y > bar.low && edge.y < bar.high &&
                 zone != zone_of(bar.low, true, zones) &&
                 zone != zone_of(bar.high, false, zones);
        });
    if (!is_known && !is_inside) {
      wanted.push_back({edge.y, zone, false});
    }
  }
  std::sort(wanted.begin(), wanted.end(),
            [](const Wanted& a, const Wanted& b) { return a.y < b.y; });
  return wanted;
}

// Heights that differ by less than `spread` in one zone, or in none, become
// one.
std::vector<AlignmentLevel> join_levels(std::vector<Wanted> edges,
                                        double spread) {
  std::sort(edges.begin(), edges.end(), [](const Wanted& a, const Wanted& b) {
    return a.zone != b.zone ? a.zone < b.zone : a.y < b.y;
  });
  std::vector<AlignmentLevel> levels;
  for (size_t i = 0; i < edges.size();) {
    size_t end = i;
    double sum = 0;
    while (end < edges.size() && edges[end].zone == edges[i].zone &&
           edges[end].y - edges[i].y <= spread) {
      sum += edges[end].y;
      ++end;
    }
    const double mean = sum / static_cast<double>(end - i);
    levels.push_back({static_cast<int>(std::lround(mean)), edges[i].zone});
    i = end;
  }
  std::stable_sort(levels.begin(), levels.end(),
                   [](const auto& a, const auto& b) { return a.y_u < b.y_u; });
  return levels;
}

int level_of(double y, int zone, const std::vector<AlignmentLevel>& levels) {
  int best = 0;
  double nearest = 1e9;
  for (size_t i = 0; i < levels.size(); ++i) {
    const double way = std::abs(levels[i].y_u - y);
    if (levels[i].zone == zone && way < nearest) {
      best = static_cast<int>(i);
      nearest = way;
    }
  }
  return best;
}

void take_stems(const std::vector<Stroke>& stems, GlyphAlignment& glyph) {
  const auto middle = [&](size_t i) {
    return (stems[i].low + stems[i].high) / 2;
  };
  // The format holds no more.
  constexpr double kFarthestStem = 8000;
  if (stems.empty() || middle(0) < -kFarthestStem ||
      middle(stems.size() - 1) > kFarthestStem) {
    return;
  }
  glyph.stem_u = static_cast<int>(std::lround(middle(0)));
  glyph.stems = 1;
  if (stems.size() > 1) {
    const double gap = middle(1) - middle(0);
    glyph.gap_u = static_cast<int>(std::lround(gap));
    // A row of pixels sees a third of a px at 24 px.
    const bool is_even =
        stems.size() > 2 && std::abs(middle(2) - middle(1) - gap) < 14;
    glyph.stems = is_even ? 3 : 2;
  }
}

}  // namespace

Alignment align(const SourceFont& font, const std::vector<GlyphEdges>& found) {
  const std::vector<Zone> zones = Finder(font, found).zones();
  std::vector<std::vector<Wanted>> wanted;
  std::vector<Wanted> all;
  std::vector<double> widths;
  for (size_t i = 0; i < zones.size(); ++i) {
    all.push_back({zones[i].y, static_cast<int>(i), false});
  }
  for (const GlyphEdges& glyph : found) {
    wanted.push_back(wanted_edges(glyph, zones));
    all.insert(all.end(), wanted.back().begin(), wanted.back().end());
    for (const Stroke& stem : glyph.stems) {
      widths.push_back(stem.high - stem.low);
    }
  }
  Alignment alignment;
  for (double spread = kLevelSpread;; spread *= 1.25) {
    alignment.levels = join_levels(all, spread);
    if (alignment.levels.size() <= format::hints::kMaxLevels) {
      break;
    }
  }
  for (size_t i = 0; i < zones.size(); ++i) {
    alignment.zones.push_back(
        {level_of(zones[i].y, static_cast<int>(i), alignment.levels),
         zones[i].is_bottom});
  }
  for (size_t i = 0; i < found.size(); ++i) {
    GlyphAlignment glyph;
    int last_u = INT_MIN;
    for (const Wanted& edge : wanted[i]) {
      const int level = level_of(edge.y, edge.zone, alignment.levels);
      const int height_u = alignment.levels[static_cast<size_t>(level)].y_u;
      if (height_u > last_u) {
        glyph.edges.push_back({level, edge.is_bar});
        last_u = height_u;
      }
    }
    take_stems(found[i].stems, glyph);
    alignment.glyphs.push_back(std::move(glyph));
  }
  if (!widths.empty()) {
    alignment.stem_width_u =
        static_cast<int>(std::min(255.0, std::round(median(widths))));
  }
  return alignment;
}

namespace {

// Lists that are part of another are not written twice.
class Lists {
 public:
  size_t place_of(const std::vector<uint8_t>& list) {
    const auto known = places_.find(list);
    if (known != places_.end()) {
      return known->second;
    }
    // Large fonts have most lists twice as a whole.
    constexpr size_t kSearched = 4096;
    auto found = bytes_.end();
    if (bytes_.size() < kSearched) {
      found =
          std::search(bytes_.begin(), bytes_.end(), list.begin(), list.end());
    }
    const auto place = static_cast<size_t>(found - bytes_.begin());
    if (found == bytes_.end()) {
      bytes_.insert(bytes_.end(), list.begin(), list.end());
    }
    places_.emplace(list, place);
    return place;
  }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<uint8_t> bytes_;
  std::map<std::vector<uint8_t>, size_t> places_;
};

// A row of the table of glyphs.
struct Row {
  uint32_t start = 0;
  uint32_t count = 0;
  uint32_t stem = 0;
  uint32_t gap = 0;
  uint32_t third = 0;
};

std::vector<uint8_t> list_of(const GlyphAlignment& glyph) {
  std::vector<uint8_t> list;
  for (const AlignmentEdge& edge : glyph.edges) {
    list.push_back(
        static_cast<uint8_t>(static_cast<uint32_t>(edge.level) |
                             (edge.is_bar ? format::hints::kBar : 0)));
  }
  return list;
}

// Long lists first, so that short ones are found in them.
std::vector<Row> place_lists(const Alignment& alignment, Lists& lists) {
  std::vector<size_t> order(alignment.glyphs.size());
  for (size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return alignment.glyphs[a].edges.size() > alignment.glyphs[b].edges.size();
  });
  std::vector<Row> rows(order.size());
  for (const size_t i : order) {
    const std::vector<uint8_t> list = list_of(alignment.glyphs[i]);
    rows[i].count = static_cast<uint32_t>(list.size());
    rows[i].start =
        list.empty() ? 0 : static_cast<uint32_t>(lists.place_of(list));
  }
  return rows;
}

// The height of the stems' first step, below all of them.
int place_stems(const Alignment& alignment, std::vector<Row>& rows) {
  constexpr int kStep = static_cast<int>(format::hints::kStemStep);
  const auto steps = [](int u) { return (u + kStep / 2) / kStep; };
  int least = 0;
  for (const GlyphAlignment& glyph : alignment.glyphs) {
    least = glyph.stems == 0 ? least : std::min(least, glyph.stem_u);
  }
  const int base = least - kStep;
  for (size_t i = 0; i < rows.size(); ++i) {
    const GlyphAlignment& glyph = alignment.glyphs[i];
    if (glyph.stems != 0) {
      rows[i].stem = static_cast<uint32_t>(steps(glyph.stem_u - base));
      rows[i].gap = static_cast<uint32_t>(steps(glyph.gap_u));
      rows[i].third = glyph.stems == 3 ? 1 : 0;
    }
  }
  return base;
}

}  // namespace

std::vector<uint8_t> hint_section(const Alignment& alignment) {
  namespace hints = format::hints;
  std::vector<uint8_t> out;
  if (alignment.empty()) {
    return out;
  }
  Lists lists;
  std::vector<Row> rows = place_lists(alignment, lists);
  const int base = place_stems(alignment, rows);
  Row most;
  for (const Row& row : rows) {
    most.start = std::max(most.start, row.start);
    most.count = std::max(most.count, row.count);
    most.stem = std::max(most.stem, row.stem);
    most.gap = std::max(most.gap, row.gap);
  }
  const unsigned start_bits = width_of(most.start);
  const unsigned count_bits = width_of(most.count);
  const unsigned stem_bits = width_of(most.stem);
  const unsigned gap_bits = width_of(most.gap);
  const auto put = [&out](unsigned byte) {
    out.push_back(static_cast<uint8_t>(byte));
  };
  put(static_cast<unsigned>(alignment.levels.size()));
  put(static_cast<unsigned>(alignment.zones.size()));
  for (const unsigned bits : {start_bits, count_bits, stem_bits, gap_bits}) {
    put(bits);
  }
  put(static_cast<unsigned>(base) & 0xff);
  put(static_cast<unsigned>(base) >> 8 & 0xff);
  put(static_cast<unsigned>(alignment.stem_width_u));
  put(0);
  for (const AlignmentLevel& level : alignment.levels) {
    const unsigned bits = (static_cast<unsigned>(level.y_u) & 0xfff) |
                          static_cast<unsigned>(level.zone + 1)
                              << hints::kZoneShift;
    put(bits & 0xff);
    put(bits >> 8);
  }
  for (const AlignmentZone& zone : alignment.zones) {
    put(static_cast<unsigned>(zone.level) |
        (zone.is_bottom ? hints::kBottomZone : 0));
  }
  BitTable table(out);
  for (const Row& row : rows) {
    table.put(row.start, start_bits);
    table.put(row.count, count_bits);
    table.put(row.stem, stem_bits);
    table.put(row.gap, gap_bits);
    table.put(row.third, 1);
  }
  out.insert(out.end(), lists.bytes().begin(), lists.bytes().end());
  return out;
}

}  // namespace inkcell::gen
