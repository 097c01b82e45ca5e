#include "pipeline/build.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "field/sample_tree.hpp"
#include "judge/hint_trial.hpp"
#include "judge/outline_glyph.hpp"
#include "parallel.hpp"
#include "pipeline/built_glyphs.hpp"
#include "pipeline/field_images.hpp"
#include "pipeline/font_hints.hpp"
#include "rom/outline_font.hpp"
#include "rom/rom_font.hpp"
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

// Forms of one colour are exact up to here: displays of few levels are small.
constexpr double kMostFormPx = 32;

void aim_at_form(RefitOptions& refit, Target& target) {
  const double most = std::max(target.min_px, kMostFormPx);
  if (target.max_px > most) {
    refit.tolerance_u *= target.max_px / most;
    target.max_px = most;
  }
}

LoopOptions loop_options(const Target& options) {
  LoopOptions loop;
  loop.min_px = static_cast<int>(options.min_px);
  loop.max_px = static_cast<int>(options.max_px);
  loop.tolerance = options.tolerance;
  return loop;
}

void judge_field(const Shape& shape, const Target& options, BuiltGlyph& built) {
  if (options.predicate == Predicate::fixed) {
    return;
  }
  const std::vector<uint8_t> record = glyph_record(built.glyph);
  GlyphField field;
  if (GlyphField::open({record.data(), record.size()}, field) == Status::ok) {
    built.errors.distance =
        ClosedLoop(shape, loop_options(options)).draw_and_compare(field);
    built.errors.promised = built.errors.distance;
  }
}

// An image's cells are there already. The device always rounds to the same
// side, so an image may miss a limit that its component holds.
void build_field(const Shape& shape, const Target& options, BuiltGlyph& built) {
  const bool is_image = built.glyph.field.tiles_x != 0;
  if (is_image) {
    judge_field(shape, options, built);
  }
  if (!is_image || built.errors.promised.worst > options.tolerance) {
    built.glyph.field = build_sample_tree(shape, options);
    judge_field(shape, options, built);
  }
}

void build_outline(const Outline& source,
                   const Shape& shape,
                   RefitOptions refit,
                   Target options,
                   bool is_form,
                   BuiltGlyph& built) {
  if (is_form) {
    aim_at_form(refit, options);
  }
  RefittedGlyph glyph = refit_glyph(source, shape, built.glyph.metrics, refit,
                                    loop_options(options));
  built.glyph.outline = std::move(glyph.outline);
  built.errors = std::move(glyph.errors);
}

// The width of the widest glyph or the height of the highest one. [u]
double largest_side(const SourceFont& font) {
  double largest = 0;
  for (const SourceGlyph& glyph : font.glyphs) {
    Box box = kNoBox;
    for (const Contour& contour : glyph.outline.contours) {
      for (const Segment& segment : contour.segments) {
        for (int i = 0; i <= degree_of(segment); ++i) {
          box.add(segment.p[i]);
        }
      }
    }
    largest = std::max({largest, box.x1 - box.x0, box.y1 - box.y0});
  }
  return largest;
}

// Whether nearly all points lie on whole or half font units, as a file has
// them; those of icons and of a variable font that was moved do not.
bool is_on_units(const SourceFont& font) {
  size_t on = 0;
  size_t all = 0;
  const double halves = 2 * font.metrics.units_per_em / kUPerEm;
  const auto is_whole = [](double value) {
    return std::abs(value - std::round(value)) < 1.0 / 64;
  };
  for (const SourceGlyph& glyph : font.glyphs) {
    for (const Contour& contour : glyph.outline.contours) {
      for (const Segment& segment : contour.segments) {
        const Point& end = end_of(segment);
        on += is_whole(end.x * halves) && is_whole(end.y * halves) ? 1u : 0u;
        ++all;
      }
    }
  }
  return 10 * on >= 9 * all;
}

// `image`: the cells of the glyph if they are known, else empty.
BuiltGlyph build_glyph(const SourceFont& font,
                       const SourceGlyph& glyph,
                       const RefitOptions& refit,
                       const Target& options,
                       const SampleTree& image) {
  const auto refuse = [&](const std::string& why) {
    throw Error(glyph.file_name + ": " + glyph.name() + ": " + why);
  };
  BuiltGlyph built;
  built.glyph.field = image;
  try {
    const Shape shape(glyph.outline);
    if (!shape.empty()) {
      built.glyph.metrics = box_in_font_units(
          glyph.layers.empty() ? shape.box() : glyph.layers_box,
          font.metrics.units_per_em);
      if (options.coding == Coding::outline) {
        build_outline(glyph.outline, shape, refit, options,
                      !glyph.layers.empty(), built);
      } else {
        build_field(shape, options, built);
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
  return built;
}

// Empty if the image leaves the grid: its outline is refused by name then.
SampleTree field_of(const FieldImage& image, const RomContent& content) {
  try {
    return permuted(content.glyphs[image.of].field, image.symmetry, image.dx_u,
                    image.dy_u);
  } catch (const GeometryError&) {
    return {};
  }
}

// A glyph, from those that were built before if its outline is among them.
BuiltGlyph find_or_build(const SourceFont& font,
                         const SourceGlyph& glyph,
                         const RefitOptions& refit,
                         const GenerateRequest& request,
                         const BuiltGlyphs* earlier,
                         const SampleTree& image) {
  const BuiltGlyph* known =
      earlier == nullptr ? nullptr : earlier->find(glyph.outline);
  return known != nullptr
             ? *known
             : build_glyph(font, glyph, refit, request.target, image);
}

// The glyphs of a part: the longest outlines first, each to the part that has
// the fewest segments so far.
std::vector<size_t> glyphs_of_part(const SourceFont& font, GlyphPart part) {
  std::vector<std::pair<size_t, size_t>> order;  // segments, glyph
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    size_t segments = 1;
    for (const Contour& contour : font.glyphs[i].outline.contours) {
      segments += contour.segments.size();
    }
    order.emplace_back(segments, i);
  }
  std::stable_sort(
      order.begin(), order.end(),
      [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<size_t> sums(part.count);
  std::vector<size_t> glyphs;
  for (const auto& [segments, glyph] : order) {
    const auto least = std::min_element(sums.begin(), sums.end());
    *least += segments;
    if (static_cast<size_t>(least - sums.begin()) == part.number) {
      glyphs.push_back(glyph);
    }
  }
  return glyphs;
}

RefitOptions refit_of(const SourceFont& font, const Target& target) {
  return refit_options(target, font.metrics.units_per_em, largest_side(font),
                       is_on_units(font));
}

// Every glyph of `content`, and its errors. In fonts of fields images come
// after what they are images of, and glyphs that nobody sees are left out.
void build_glyphs(const SourceFont& font,
                  const GenerateRequest& request,
                  const RefitOptions& refit,
                  RomContent& content,
                  std::vector<GlyphErrors>& errors) {
  content.glyphs.resize(font.glyphs.size());
  errors.resize(font.glyphs.size());
  const bool is_sampled = request.target.coding == Coding::field;
  const std::vector<FieldImage> images =
      is_sampled ? find_field_images(font) : std::vector<FieldImage>();
  std::vector<size_t> others;
  for (size_t i = 0, image = 0; i < font.glyphs.size(); ++i) {
    if (image < images.size() && images[image].glyph == i) {
      ++image;
    } else if (!is_sampled || font.is_shown(i)) {
      others.push_back(i);
    }
  }
  // An image depends on more than its outline.
  BuiltGlyphs* const earlier = is_sampled ? nullptr : request.built_glyphs;
  if (earlier != nullptr) {
    earlier->begin(request.target, refit);
  }
  const auto build = [&](size_t i, const SampleTree& image) {
    BuiltGlyph built =
        find_or_build(font, font.glyphs[i], refit, request, earlier, image);
    built.glyph.metrics.advance = font.glyphs[i].advance;
    content.glyphs[i] = std::move(built.glyph);
    errors[i] = std::move(built.errors);
  };
  const auto done_after = [&](size_t before) {
    return request.progress ? [&, before](size_t finished) {
      request.progress(before + finished, others.size() + images.size());
    } : std::function<void(size_t)>();
  };
  if (request.progress) {
    request.progress(0, others.size() + images.size());
  }
  parallel_for(
      others.size(), request.threads,
      [&](size_t i) { build(others[i], SampleTree()); }, done_after(0));
  parallel_for(
      images.size(), request.threads,
      [&](size_t i) {
        const FieldImage& image = images[i];
        build(image.glyph, field_of(image, content));
      },
      done_after(others.size()));
  if (earlier != nullptr) {
    earlier->keep(font.glyphs, content.glyphs, errors);
  }
}

// Leaves out the last glyphs, from which no other one is made.
void drop_unused_components(SourceFont& font,
                            RomContent& content,
                            std::vector<GlyphErrors>& errors) {
  const std::vector<size_t> kept =
      used_glyphs(content, [&](size_t glyph) { return font.is_shown(glyph); });
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

void build_part(const SourceFont& font,
                const GenerateRequest& request,
                GlyphPart part) {
  const RefitOptions refit = refit_of(font, request.target);
  BuiltGlyphs& built_glyphs = *request.built_glyphs;
  built_glyphs.begin(request.target, refit);
  std::vector<SourceGlyph> sources;
  for (const size_t glyph : glyphs_of_part(font, part)) {
    sources.push_back(font.glyphs[glyph]);
  }
  std::vector<RomGlyph> glyphs(sources.size());
  std::vector<GlyphErrors> errors(sources.size());
  std::function<void(size_t)> done;
  if (request.progress) {
    done = [&](size_t finished) { request.progress(finished, sources.size()); };
    done(0);
  }
  parallel_for(
      sources.size(), request.threads,
      [&](size_t i) {
        BuiltGlyph built = find_or_build(font, sources[i], refit, request,
                                         &built_glyphs, SampleTree());
        glyphs[i] = std::move(built.glyph);
        errors[i] = std::move(built.errors);
      },
      done);
  built_glyphs.keep(sources, glyphs, errors);
}

RomContent build_content(SourceFont& font,
                         const GenerateRequest& request,
                         std::vector<GlyphErrors>& errors) {
  RomContent content;
  content.name = font.name;
  content.metrics = font.metrics;
  content.options = request.target;
  content.kerning = std::move(font.kerning);
  const RefitOptions refit = refit_of(font, request.target);
  build_glyphs(font, request, refit, content, errors);
  if (request.target.coding == Coding::field) {
    drop_unused_components(font, content, errors);
  }
  if (request.target.coding == Coding::outline) {
    content.outlines.grid_shift = refit.grid_shift;
    if (request.paged != 0 && !request.strike_only) {
      // The resident part holds the code, and no record leaves its page.
      content.block_bytes = static_cast<size_t>(request.paged);
      content.outlines.most_entries = 64;
    } else {
      encode_outlines(content);
      find_references(font.components, content);
    }
    drop_unused_components(font, content, errors);
    encode_outlines(content);
  }
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    for (const char32_t c : font.glyphs[i].code_points) {
      content.glyph_of[c] = static_cast<uint16_t>(i);
    }
  }
  const bool has_outlines =
      std::any_of(font.glyphs.begin(), font.glyphs.end(),
                  [](const SourceGlyph& g) { return !g.picture.has_value(); });
  if (request.hints && request.target.coding == Coding::outline &&
      has_outlines) {
    content.hints = find_hints(content, request.threads);
    // Layers move together, so none of them is fitted.
    for (size_t i = 0; i < content.hints.glyphs.size(); ++i) {
      const SourceGlyph& glyph = font.glyphs[i];
      if (!glyph.layers.empty() || !glyph.layer_of.empty()) {
        content.hints.glyphs[i] = {};
      }
    }
    drop_harmful_hints(content, request.threads);
  }
  return content;
}

}  // namespace inkcell::gen
