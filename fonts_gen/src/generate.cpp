#include "generate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "char_set.hpp"
#include "field_glyph.hpp"
#include "font_source.hpp"
#include "hints/font_hints.hpp"
#include "hints/hint_trial.hpp"
#include "outlines/outline_font.hpp"
#include "outlines/outline_glyph.hpp"
#include "shape.hpp"
#include "work_pool.hpp"

namespace inkcell::gen {
namespace {

constexpr double kLeastPx = 4;
constexpr double kMostPx = 1024;

// Glyphs named by a warning.
constexpr size_t kListedGlyphs = 10;

bool is_whole_within(double value, double least, double most) {
  return value >= least && value <= most && value == std::floor(value);
}

void check_request(const GenerateRequest& request) {
  const AdfOptions& adf = request.adf;
  if (!is_whole_within(adf.min_px, kLeastPx, kMostPx) ||
      !is_whole_within(adf.max_px, kLeastPx, kMostPx) ||
      adf.min_px > adf.max_px) {
    throw Error(
        "--min-px and --max-px are whole numbers within 4..1024, the first "
        "not above the second");
  }
  if (!is_whole_within(adf.tolerance, 1, 255)) {
    throw Error("--tolerance is a whole number within 1..255, such as 16/255");
  }
  if (adf.band_px != 0) {
    AdfOptions usual = adf;
    usual.band_px = 0;
    if (adf.predicate == Predicate::fixed || !(adf.band_px > 0) ||
        band_u(adf) < band_u(usual) || band_u(adf) > kMostBand_u) {
      throw Error(
          "--band-px is at least 0.5 with --coding edges, 0.75 with samples, "
          "and at most 3/16 em at --min-px; the fixed predicate has its own");
    }
  }
  if (adf.effort < 0 || adf.effort > 9) {
    throw Error("--effort is a whole number within 0..9");
  }
  if (adf.coding != Coding::samples && adf.predicate == Predicate::fixed) {
    throw Error(
        "--predicate fixed is the paper's, for its cells; use --coding "
        "samples");
  }
}

CharSet characters_of(const GenerateRequest& request) {
  CharSet characters;
  for (const std::string& list : request.chars) {
    add_ranges(list, characters);
  }
  for (const std::filesystem::path& file : request.text_files) {
    add_text_file(file, characters);
  }
  add_text(request.symbols, "--symbols", characters);
  const bool asked = !request.chars.empty() || !request.text_files.empty() ||
                     !request.symbols.empty();
  if (!asked) {
    add_ranges(kDefaultChars, characters);
  }
  if (characters.empty()) {
    throw Error(
        "no characters asked for: the texts hold nothing printable; check "
        "--text and --symbols");
  }
  return characters;
}

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

LoopOptions loop_options(const AdfOptions& options) {
  LoopOptions loop;
  loop.min_px = static_cast<int>(options.min_px);
  loop.max_px = static_cast<int>(options.max_px);
  loop.tolerance = options.tolerance;
  return loop;
}

void build_samples(const Shape& shape,
                   const AdfOptions& options,
                   Built& built) {
  AdfOptions of_samples = options;
  of_samples.coding = Coding::samples;
  built.glyph.fields = FieldTree();
  built.glyph.samples = build_adf(shape, of_samples);
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

// Cells of fields, or of samples where fields cannot hold the tolerance.
void build_cells(const Shape& shape, const AdfOptions& options, Built& built) {
  if (options.coding == Coding::samples) {
    build_samples(shape, options, built);
    return;
  }
  FieldGlyph glyph;
  try {
    glyph = build_fields(shape, options, loop_options(options));
  } catch (const GeometryError&) {
    build_samples(shape, options, built);
    return;
  }
  if (glyph.tree.failures != 0 || glyph.errors.worst > options.tolerance) {
    build_samples(shape, options, built);
    if (built.errors.worst < glyph.errors.worst) {
      return;
    }
    built.glyph.samples = AdfGlyph();
  }
  built.glyph.fields = std::move(glyph.tree);
  built.errors = std::move(glyph.errors);
}

void build_outline(const Outline& source,
                   const Shape& shape,
                   int units_per_em,
                   const AdfOptions& options,
                   Built& built) {
  RefittedGlyph glyph =
      refit_glyph(source, shape, built.glyph.metrics,
                  refit_options(options, units_per_em), loop_options(options));
  built.glyph.outline = std::move(glyph.outline);
  built.errors = std::move(glyph.errors);
}

Built build_glyph(const SourceFont& font,
                  const SourceGlyph& glyph,
                  const AdfOptions& options) {
  const auto refuse = [&](const std::string& why) {
    throw Error(font.file_name + ": " + glyph.name() + ": " + why);
  };
  Built built;
  try {
    const Shape shape(glyph.outline);
    if (!shape.empty()) {
      built.glyph.metrics =
          box_in_font_units(shape.box(), font.metrics.units_per_em);
      if (options.coding == Coding::outline) {
        build_outline(glyph.outline, shape, font.metrics.units_per_em, options,
                      built);
      } else {
        build_cells(shape, options, built);
      }
    }
  } catch (const GeometryError& error) {
    const bool complex = error.kind() == GeometryError::Kind::too_complex;
    const bool fixed = options.predicate == Predicate::fixed;
    if (complex && !fixed) {
      throw TooComplex(
          font.file_name + ": " + glyph.name() + ": " + error.what(),
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
    return glyph == 0 || !font.glyphs[glyph].code_points.empty();
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

RomContent build_content(SourceFont& font,
                         const GenerateRequest& request,
                         std::vector<LoopResult>& errors) {
  RomContent content;
  content.name = font.name;
  content.metrics = font.metrics;
  content.options = request.adf;
  content.kerning = std::move(font.kerning);
  const size_t count = font.glyphs.size();
  content.glyphs.resize(count);
  errors.resize(count);
  std::function<void(size_t)> done;
  if (request.progress) {
    done = [&](size_t finished) { request.progress(finished, count); };
  }
  parallel_for(
      count, request.jobs,
      [&](size_t i) {
        Built built = build_glyph(font, font.glyphs[i], request.adf);
        content.glyphs[i] = std::move(built.glyph);
        errors[i] = std::move(built.errors);
      },
      done);
  if (request.adf.coding == Coding::outline) {
    content.outlines.grid_shift =
        refit_options(request.adf, font.metrics.units_per_em).grid_shift;
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
  if (request.hints && request.adf.coding == Coding::outline) {
    content.hints = find_hints(content, request.jobs);
    drop_harmful_hints(content, request.jobs);
  }
  return content;
}

void count_cells(const RomGlyph& glyph, CellCounts& kinds) {
  kinds.samples += glyph.samples.cells.size();
  for (const TreeNode& node : glyph.fields.nodes) {
    if (node.kind == TreeNode::Kind::leaf) {
      const int count = field_count(node.join);
      ++(count == 1 ? kinds.single : count == 2 ? kinds.pairs : kinds.triples);
    }
  }
}

GlyphReport report_glyph(const SourceGlyph& source,
                         const RomGlyph& built,
                         const LoopResult& errors,
                         const AdfOptions& options) {
  GlyphReport glyph;
  glyph.name = source.name();
  glyph.key = source.code_points.empty() ? source.name()
                                         : to_utf8(source.code_points.front());
  glyph.cells = built.samples.cells.size();
  glyph.nodes = static_cast<size_t>(built.samples.node_count());
  for (const TreeNode& node : built.fields.nodes) {
    glyph.cells += node.kind == TreeNode::Kind::leaf ? 1 : 0;
    glyph.nodes += node.kind == TreeNode::Kind::split ? 1 : 0;
  }
  glyph.fields = built.fields.fields.size();
  for (const MinimalContour& contour : built.outline.contours) {
    glyph.points += contour.points.size();
  }
  glyph.components = built.references.size();
  glyph.bytes = glyph_record(built).size();
  if (options.predicate == Predicate::fixed) {
    glyph.worst_error = built.samples.worst_error;
    glyph.mean_error = built.samples.mean_error;
    glyph.within_tolerance = built.samples.within_tolerance;
    return glyph;
  }
  glyph.worst_error = errors.worst;
  glyph.mean_error = errors.worst_mean;
  glyph.within_tolerance = errors.worst <= options.tolerance;
  for (const SizeError& size : errors.sizes) {
    if (size.worst == errors.worst) {
      glyph.worst_px = size.px;
    }
  }
  return glyph;
}

// The errors of all glyphs, size by size.
std::vector<SizeError> sum_of_sizes(const std::vector<LoopResult>& glyphs) {
  std::vector<SizeError> sum;
  size_t count = 0;
  for (const LoopResult& glyph : glyphs) {
    if (glyph.sizes.empty()) {
      continue;
    }
    ++count;
    if (sum.empty()) {
      sum = glyph.sizes;
      continue;
    }
    for (size_t i = 0; i < sum.size(); ++i) {
      sum[i].worst = std::max(sum[i].worst, glyph.sizes[i].worst);
      sum[i].mean += glyph.sizes[i].mean;
    }
  }
  for (SizeError& size : sum) {
    size.mean /= static_cast<double>(count);
  }
  return sum;
}

FontReport make_report(const SourceFont& font,
                       const RomContent& content,
                       const std::vector<LoopResult>& errors) {
  FontReport report;
  report.file_name = font.file_name;
  report.name = font.name;
  report.options = content.options;
  report.missing = font.missing;
  report.characters = content.glyph_of.size();
  report.left_classes = content.kerning.left_classes;
  report.right_classes = content.kerning.right_classes;
  report.sizes = sum_of_sizes(errors);
  size_t with_ink = 0;
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    const RomGlyph& built = content.glyphs[i];
    GlyphReport glyph =
        report_glyph(font.glyphs[i], built, errors[i], content.options);
    count_cells(built, report.kinds);
    report.cells += glyph.cells;
    report.nodes += glyph.nodes;
    report.fields += glyph.fields;
    report.points += built.references.empty() ? glyph.points : 0;
    report.composites += built.references.empty() ? 0u : 1u;
    report.worst_error = std::max(report.worst_error, glyph.worst_error);
    if (built.has_ink()) {
      report.mean_error += glyph.mean_error;
      ++with_ink;
    }
    report.glyphs.push_back(std::move(glyph));
  }
  if (with_ink != 0) {
    report.mean_error /= static_cast<double>(with_ink);
  }
  if (!report.sizes.empty()) {
    report.mean_error = 0;
    for (const SizeError& size : report.sizes) {
      report.mean_error = std::max(report.mean_error, size.mean);
    }
  }
  return report;
}

// Outlines keep the tolerance, or there is no font; of cells people are told.
void tell_of_errors(const FontReport& report, Warnings& warnings) {
  std::vector<const GlyphReport*> missed;
  for (const GlyphReport& glyph : report.glyphs) {
    if (!glyph.within_tolerance) {
      missed.push_back(&glyph);
    }
  }
  if (missed.empty()) {
    return;
  }
  std::stable_sort(missed.begin(), missed.end(), [](auto* a, auto* b) {
    return a->worst_error > b->worst_error;
  });
  const bool fixed = report.options.predicate == Predicate::fixed;
  const char* unit = fixed ? "/1024 em" : "/255";
  std::string text = report.file_name + ": " + std::to_string(missed.size()) +
                     (missed.size() == 1 ? " glyph misses" : " glyphs miss") +
                     " the tolerance: ";
  for (size_t i = 0; i < std::min(missed.size(), kListedGlyphs); ++i) {
    char error[32];
    std::snprintf(error, sizeof error, " %.1f", missed[i]->worst_error);
    text += (i == 0 ? "" : ", ") + missed[i]->name + error + unit;
  }
  text += missed.size() > kListedGlyphs ? ", ..." : "";
  text += fixed ? "; this is expected of the paper's predicate at corners"
                : "; lower --max-px or raise --tolerance";
  if (report.options.coding == Coding::outline) {
    throw Error(text);
  }
  warnings.push_back({Warning::Kind::tolerance_missed, text});
}

}  // namespace

RomFont generate(const GenerateRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  check_request(request);
  RomFont rom;
  FontRequest wanted;
  wanted.file = request.font;
  wanted.face = request.face;
  wanted.axes = request.axes;
  wanted.characters = characters_of(request);
  wanted.with_components = request.adf.coding == Coding::outline;
  SourceFont font = load_font(wanted, request.jobs, rom.warnings);
  std::vector<LoopResult> errors;
  const RomContent content = build_content(font, request, errors);
  PartBytes parts;
  rom.bytes = write_rom_font(content, parts);
  check_rom_font(rom.bytes, content);
  rom.report = make_report(font, content, errors);
  rom.report.bytes = parts;
  tell_of_errors(rom.report, rom.warnings);
  rom.report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  return rom;
}

}  // namespace inkcell::gen
