#include "pipeline/build.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/work_pool.hpp"
#include "judge/edge_glyph.hpp"
#include "judge/hint_trial.hpp"
#include "judge/outline_glyph.hpp"
#include "pipeline/font_hints.hpp"
#include "rom/outline_font.hpp"
#include "rom/rom_font.hpp"
#include "samples/sample_tree.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

namespace {

// The ink box in font units, rounded outwards. Chords and the union move the
// border by up to 1/128 u, which must not cost a unit.
GlyphMetrics box_in_font_units(const Box& box, int units_per_em) {
  const double scale = units_per_em / 1024.0;
  const double slack = scale / 128;
  const auto clamp = [](double value) {
    return static_cast<int16_t>(std::clamp(value, -32768.0, 32767.0));
  };
  GlyphMetrics m;
  m.x_min = clamp(std::floor(box.x0 * scale + slack));
  m.y_min = clamp(std::floor(box.y0 * scale + slack));
  m.x_max = clamp(std::ceil(box.x1 * scale - slack));
  m.y_max = clamp(std::ceil(box.y1 * scale - slack));
  return m;
}

// One glyph, and how it looks.
struct Built {
  RomGlyph glyph;
  LoopResult errors;  // size_aware
};

LoopOptions loop_options(const Target& options) {
  LoopOptions loop;
  loop.min_px = static_cast<int>(options.min_px);
  loop.max_px = static_cast<int>(options.max_px);
  loop.tolerance = options.tolerance;
  return loop;
}

void build_samples(const Shape& shape, const Target& options, Built& built) {
  Target of_samples = options;
  of_samples.coding = Coding::samples;
  built.glyph.fields = EdgeTree();
  built.glyph.samples = build_sample_tree(shape, of_samples);
  if (options.predicate == Predicate::fixed) {
    return;
  }
  const std::vector<uint8_t> record = glyph_record(built.glyph);
  GlyphField field;
  if (GlyphField::open({record.data(), record.size()}, field) == Status::ok) {
    built.errors =
        ClosedLoop(shape, loop_options(options)).draw_and_compare(field);
  }
}

// Cells of primitives, or of samples where fields cannot hold the tolerance.
void build_cells(const Shape& shape, const Target& options, Built& built) {
  if (options.coding == Coding::samples) {
    build_samples(shape, options, built);
    return;
  }
  EdgeGlyph glyph;
  try {
    glyph = build_edges(shape, options, loop_options(options));
  } catch (const GeometryError&) {
    build_samples(shape, options, built);
    return;
  }
  if (glyph.tree.failures != 0 || glyph.errors.worst > options.tolerance) {
    build_samples(shape, options, built);
    if (built.errors.worst < glyph.errors.worst) {
      return;
    }
    built.glyph.samples = SampleTree();
  }
  built.glyph.fields = std::move(glyph.tree);
  built.errors = std::move(glyph.errors);
}

void build_outline(const Outline& source,
                   const Shape& shape,
                   const RefitOptions& refit,
                   const Target& options,
                   Built& built) {
  RefittedGlyph glyph = refit_glyph(source, shape, built.glyph.metrics, refit,
                                    loop_options(options));
  built.glyph.outline = std::move(glyph.outline);
  built.errors = std::move(glyph.errors);
}

// The width of the widest glyph or the height of the highest one. [u]
double largest_side(const SourceFont& font) {
  double largest = 0;
  for (const SourceGlyph& glyph : font.glyphs) {
    Point low = {HUGE_VAL, HUGE_VAL};
    Point high = {-HUGE_VAL, -HUGE_VAL};
    for (const Contour& contour : glyph.outline.contours) {
      for (const Segment& segment : contour.segments) {
        const size_t last = 1 + static_cast<size_t>(segment.kind);
        for (size_t i = 0; i <= last; ++i) {
          low = {std::min(low.x, segment.p[i].x),
                 std::min(low.y, segment.p[i].y)};
          high = {std::max(high.x, segment.p[i].x),
                  std::max(high.y, segment.p[i].y)};
        }
      }
    }
    largest = std::max({largest, high.x - low.x, high.y - low.y});
  }
  return largest;
}

Built build_glyph(const SourceFont& font,
                  const SourceGlyph& glyph,
                  const RefitOptions& refit,
                  const Target& options) {
  const auto refuse = [&](const std::string& why) {
    throw Error(glyph.file_name + ": " + glyph.name() + ": " + why);
  };
  Built built;
  try {
    const Shape shape(glyph.outline);
    if (!shape.empty()) {
      built.glyph.metrics =
          box_in_font_units(shape.box(), font.metrics.units_per_em);
      if (options.coding == Coding::outline) {
        build_outline(glyph.outline, shape, refit, options, built);
      } else {
        build_cells(shape, options, built);
      }
    }
  } catch (const GeometryError& error) {
    const bool complex = error.kind() == GeometryError::Kind::too_complex;
    const bool fixed = options.predicate == Predicate::fixed;
    if (complex && !fixed) {
      throw TooComplex(
          glyph.file_name + ": " + glyph.name() + ": " + error.what(),
          glyph.remedy("lower --max-px, raise --tolerance"));
    }
    refuse(
        std::string(error.what()) + "; " +
        glyph.remedy(complex ? "use --predicate size" : "repair the outline"));
  }
  built.glyph.metrics.advance = glyph.advance;
  return built;
}

// Leaves out the last glyphs, from which no other one is made.
void drop_unused_components(SourceFont& font,
                            RomContent& content,
                            std::vector<LoopResult>& errors) {
  const std::vector<size_t> kept = used_glyphs(content, [&](size_t glyph) {
    const SourceGlyph& source = font.glyphs[glyph];
    return glyph == 0 || !source.code_points.empty() || source.is_of_line;
  });
  const auto keep = [&kept](auto& list) {
    for (size_t i = 0; i < kept.size(); ++i) {
      if (kept[i] != i) {
        list[i] = std::move(list[kept[i]]);
      }
    }
    list.resize(kept.size());
  };
  keep(font.glyphs);
  keep(content.glyphs);
  keep(errors);
}

}  // namespace

RomContent build_content(SourceFont& font,
                         const GenerateRequest& request,
                         std::vector<LoopResult>& errors) {
  RomContent content;
  content.name = font.name;
  content.metrics = font.metrics;
  content.options = request.target;
  content.kerning = std::move(font.kerning);
  const size_t count = font.glyphs.size();
  content.glyphs.resize(count);
  errors.resize(count);
  const RefitOptions refit = refit_options(
      request.target, font.metrics.units_per_em, largest_side(font));
  std::function<void(size_t)> done;
  if (request.progress) {
    done = [&](size_t finished) { request.progress(finished, count); };
  }
  parallel_for(
      count, request.threads,
      [&](size_t i) {
        Built built = build_glyph(font, font.glyphs[i], refit, request.target);
        content.glyphs[i] = std::move(built.glyph);
        errors[i] = std::move(built.errors);
      },
      done);
  if (request.target.coding == Coding::outline) {
    content.outlines.grid_shift = refit.grid_shift;
    encode_outlines(content);
    find_references(font.components, content);
    drop_unused_components(font, content, errors);
    encode_outlines(content);
  }
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    for (const char32_t c : font.glyphs[i].code_points) {
      content.glyph_of[c] = static_cast<uint16_t>(i);
    }
  }
  if (request.hints && request.target.coding == Coding::outline) {
    content.hints = find_hints(content, request.threads);
    drop_harmful_hints(content, request.threads);
  }
  return content;
}

}  // namespace inkcell::gen
