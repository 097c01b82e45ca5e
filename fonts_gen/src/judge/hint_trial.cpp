#include "judge/hint_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include "inkcell/bilevel.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/font.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "parallel.hpp"
#include "rom/rom_font.hpp"
#include "shape/pixel_regions.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {
namespace {

constexpr int kLargePx = 128;
constexpr int kLeastPx = 8;
constexpr int kMostPx = 12;

// Fewer hints must be better by so much over all pictures, and at most 3/4 as
// bad; none at all by more, and half as bad: glyphs beside fitted ones look
// best if they are fitted, too.
constexpr int kLeastGain = 3;
constexpr int kLeastGainOfNone = 5;

// Covered pixels, of 255: thin grey strokes are strokes.
constexpr int kInk = 96;

constexpr FitOptions kLooks[] = {{false, 0}, {true, 0}, {true, 2}};

// What is dropped, the least first.
using Reduction = void (*)(GlyphHints&);

void drop_heights(HeightHint::Kind kind, GlyphHints& hints) {
  hints.heights.erase(std::remove_if(hints.heights.begin(), hints.heights.end(),
                                     [kind](const HeightHint& hint) {
                                       return hint.kind == kind;
                                     }),
                      hints.heights.end());
}

void drop_ends(GlyphHints& hints) {
  drop_heights(HeightHint::Kind::free_end, hints);
}

constexpr Reduction kReductions[] = {
    [](GlyphHints&) {},
    drop_ends,
    [](GlyphHints& hints) { drop_heights(HeightHint::Kind::serif, hints); },
    [](GlyphHints& hints) { hints.stems.clear(); },
    [](GlyphHints& hints) {
      drop_ends(hints);
      hints.stems.clear();
    },
    [](GlyphHints& hints) { hints = GlyphHints(); },
};
constexpr size_t kReductionCount = std::size(kReductions);

std::vector<GlyphHints> reduced(const std::vector<GlyphHints>& hints,
                                Reduction reduction) {
  std::vector<GlyphHints> fewer = hints;
  for (GlyphHints& glyph : fewer) {
    reduction(glyph);
  }
  return fewer;
}

// A font in memory, which the device reads in place.
class TrialFont {
 public:
  explicit TrialFont(const RomContent& content) {
    PartBytes parts;
    bytes_ = write_rom_font(content, parts);
    require(Font::open({bytes_.data(), bytes_.size()}, font_));
  }

  TrialFont(const TrialFont&) = delete;
  TrialFont& operator=(const TrialFont&) = delete;

  Topology unfitted(uint16_t glyph, int px) const {
    return draw(glyph, px, make_style(px));
  }

  Topology fitted(uint16_t glyph, int px, const FitOptions& look) const {
    Style style = make_style(px);
    Fit fit;
    require(Fit::make(font_, style, look, fit));
    style.set_fit(fit);
    const Bilevel bilevel(2, fit.bilevel_weight());
    if (look.levels == 2) {
      style.set_effect(bilevel);
    }
    return draw(glyph, px, style);
  }

 private:
  static void require(Status status) {
    if (status != Status::ok) {
      throw Error("the device cannot read the font that hints are tried in");
    }
  }

  static Style make_style(int px) {
    return Style(Q26_6::from_int(px), kFilterText);
  }

  // The box of the ink with room for what fitting moves.
  Topology draw(uint16_t glyph, int px, const Style& style) const {
    GlyphMetrics metrics;
    require(font_.glyph_metrics(glyph, metrics));
    const double scale = static_cast<double>(px) / font_.units_per_em();
    const auto pixels = [scale](int units) {
      return static_cast<int>(std::floor(units * scale));
    };
    const int room_x = 4 + (pixels(metrics.x_max - metrics.x_min) / 2);
    const int room_y = 4 + (pixels(metrics.y_max - metrics.y_min) / 2);
    Canvas canvas(
        {pixels(metrics.x_min) - room_x, pixels(-metrics.y_max) - room_y,
         pixels(metrics.x_max) + room_x, pixels(-metrics.y_min) + room_y});
    Painter(canvas.sink()).glyph(font_, style, {}, glyph);
    return topology_of(canvas);
  }

  std::vector<uint8_t> bytes_;
  Font font_;
};

int difference(const Topology& a, const Topology& b) {
  return std::abs(a.parts - b.parts) + std::abs(a.counters - b.counters);
}

// By how much small pictures of a glyph differ from what it is.
int harm(const TrialFont& font, uint16_t glyph, const Topology& wanted) {
  int sum = 0;
  for (const FitOptions& look : kLooks) {
    for (int px = kLeastPx; px <= kMostPx; ++px) {
      sum += difference(font.fitted(glyph, px, look), wanted);
    }
  }
  return sum;
}

}  // namespace

Topology topology_of(const Canvas& canvas) {
  const Rect& area = canvas.area();
  // A pixel of background around the glyph joins what surrounds it to one
  // region, and around that is a pixel of none.
  constexpr int kAround = 2;
  const int width = area.x1 - area.x0 + 2 * kAround;
  const int height = area.y1 - area.y0 + 2 * kAround;
  std::vector<uint8_t> ink(static_cast<size_t>(width * height));
  std::vector<uint8_t> background = ink;
  for (int y = 1; y < height - 1; ++y) {
    std::fill_n(background.begin() + y * width + 1, width - 2, uint8_t{1});
  }
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      if (canvas.at(x, y) >= kInk) {
        const auto at = static_cast<size_t>((y - area.y0 + kAround) * width +
                                            x - area.x0 + kAround);
        ink[at] = 1;
        background[at] = 0;
      }
    }
  }
  const auto count = [width](std::vector<uint8_t>& mask, bool by_corners) {
    return static_cast<int>(
        pixel_regions(std::move(mask), width, by_corners).size());
  };
  return {count(ink, true), count(background, false) - 1};
}

void drop_harmful_hints(RomContent& content, int jobs) {
  const std::vector<GlyphHints> all = content.hints.glyphs;
  std::vector<std::array<int, kReductionCount>> harms(all.size());
  std::vector<Topology> wanted(all.size());
  for (size_t k = 0; k < kReductionCount; ++k) {
    content.hints.glyphs = reduced(all, kReductions[k]);
    const TrialFont font(content);
    parallel_for(all.size(), jobs, [&](size_t i) {
      const auto glyph = static_cast<uint16_t>(i);
      if (k == 0) {
        wanted[i] = font.unfitted(glyph, kLargePx);
      }
      harms[i][k] = harm(font, glyph, wanted[i]);
    });
  }
  content.hints.glyphs = all;
  for (size_t i = 0; i < all.size(); ++i) {
    const auto is_worth_it = [&harm = harms[i]](size_t k) {
      const bool is_none = k + 1 == kReductionCount;
      return harm[k] + (is_none ? kLeastGainOfNone : kLeastGain) <= harm[0] &&
             4 * harm[k] <= (is_none ? 2 : 3) * harm[0];
    };
    size_t best = 0;
    for (size_t k = 1; k < kReductionCount; ++k) {
      if (harms[i][k] < harms[i][best] && is_worth_it(k)) {
        best = k;
      }
    }
    kReductions[best](content.hints.glyphs[i]);
  }
}

}  // namespace inkcell::gen
