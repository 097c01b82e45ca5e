#include "pipeline/built_glyphs.hpp"

#include <utility>

namespace inkcell::gen {
namespace {

std::vector<double> conditions_of(const Target& target,
                                  const RefitOptions& refit) {
  return {static_cast<double>(target.coding),
          target.min_px,
          target.max_px,
          target.tolerance,
          static_cast<double>(target.predicate),
          target.band_px,
          static_cast<double>(target.effort),
          static_cast<double>(refit.units_per_em),
          static_cast<double>(refit.grid_shift),
          refit.tolerance_u};
}

}  // namespace

void BuiltGlyphs::begin(const Target& target, const RefitOptions& refit) {
  Key conditions = conditions_of(target, refit);
  if (conditions != conditions_) {
    glyphs_.clear();
    conditions_ = std::move(conditions);
  }
}

const BuiltGlyph* BuiltGlyphs::find(const Outline& outline) const {
  const auto found = glyphs_.find(key_of(outline));
  return found == glyphs_.end() ? nullptr : &found->second;
}

void BuiltGlyphs::keep(const std::vector<SourceGlyph>& sources,
                       const std::vector<RomGlyph>& glyphs,
                       const std::vector<LoopResult>& errors) {
  std::map<Key, BuiltGlyph> kept;
  reused_ = 0;
  for (size_t i = 0; i < sources.size(); ++i) {
    Key key = key_of(sources[i].outline);
    if (auto old = glyphs_.extract(key)) {
      kept.insert(std::move(old));
      ++reused_;
    } else {
      kept.try_emplace(std::move(key), BuiltGlyph{glyphs[i], errors[i]});
    }
  }
  glyphs_ = std::move(kept);
}

// Contours with their number of segments, segments with their kind: no two
// outlines have one key.
BuiltGlyphs::Key BuiltGlyphs::key_of(const Outline& outline) {
  Key key;
  for (const Contour& contour : outline.contours) {
    key.push_back(static_cast<double>(contour.segments.size()));
    for (const Segment& segment : contour.segments) {
      key.push_back(static_cast<double>(segment.kind));
      const size_t last = 1 + static_cast<size_t>(segment.kind);
      for (size_t i = 0; i <= last; ++i) {
        key.push_back(segment.p[i].x);
        key.push_back(segment.p[i].y);
      }
    }
  }
  return key;
}

}  // namespace inkcell::gen
