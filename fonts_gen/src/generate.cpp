#include "generate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "char_set.hpp"
#include "font_source.hpp"
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
  if (adf.effort < 0 || adf.effort > 9) {
    throw Error("--effort is a whole number within 0..9");
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

RomGlyph build_glyph(const SourceFont& font,
                     const SourceGlyph& glyph,
                     const AdfOptions& options) {
  const auto refuse = [&](const std::string& why) {
    throw Error(font.file_name + ": " + glyph.name() + ": " + why);
  };
  RomGlyph built;
  try {
    const Shape shape(glyph.outline);
    if (!shape.empty()) {
      built.metrics = box_in_font_units(shape.box(), font.metrics.units_per_em);
      built.field = build_adf(shape, options);
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
  built.metrics.advance = glyph.advance;
  return built;
}

RomContent build_content(SourceFont& font, const GenerateRequest& request) {
  RomContent content;
  content.name = font.name;
  content.metrics = font.metrics;
  content.options = request.adf;
  content.kerning = std::move(font.kerning);
  const size_t count = font.glyphs.size();
  content.glyphs.resize(count);
  std::function<void(size_t)> done;
  if (request.progress) {
    done = [&](size_t finished) { request.progress(finished, count); };
  }
  parallel_for(
      count, request.jobs,
      [&](size_t i) {
        content.glyphs[i] = build_glyph(font, font.glyphs[i], request.adf);
      },
      done);
  for (size_t i = 0; i < count; ++i) {
    for (const char32_t c : font.glyphs[i].code_points) {
      content.glyph_of[c] = static_cast<uint16_t>(i);
    }
  }
  return content;
}

GlyphReport report_glyph(const SourceGlyph& source, const AdfGlyph& field) {
  GlyphReport glyph;
  glyph.name = source.name();
  glyph.key = source.code_points.empty() ? ".notdef"
                                         : to_utf8(source.code_points.front());
  glyph.cells = field.cells.size();
  glyph.nodes = static_cast<size_t>(field.node_count());
  glyph.bytes = record_bytes(field);
  glyph.worst_error = field.worst_error;
  glyph.mean_error = field.mean_error;
  glyph.within_tolerance = field.within_tolerance;
  return glyph;
}

FontReport make_report(const SourceFont& font, const RomContent& content) {
  FontReport report;
  report.file_name = font.file_name;
  report.name = font.name;
  report.options = content.options;
  report.missing = font.missing;
  report.characters = content.glyph_of.size();
  report.left_classes = content.kerning.left_classes;
  report.right_classes = content.kerning.right_classes;
  size_t with_ink = 0;
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    const AdfGlyph& field = content.glyphs[i].field;
    GlyphReport glyph = report_glyph(font.glyphs[i], field);
    report.cells += glyph.cells;
    report.nodes += glyph.nodes;
    report.worst_error = std::max(report.worst_error, glyph.worst_error);
    if (field.tiles_x != 0) {
      report.mean_error += glyph.mean_error;
      ++with_ink;
    }
    report.glyphs.push_back(std::move(glyph));
  }
  if (with_ink != 0) {
    report.mean_error /= static_cast<double>(with_ink);
  }
  return report;
}

void warn_of_errors(const FontReport& report, Warnings& warnings) {
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
                     " the tolerance in cells of the smallest "
                     "size: ";
  for (size_t i = 0; i < std::min(missed.size(), kListedGlyphs); ++i) {
    char error[32];
    std::snprintf(error, sizeof error, " %.1f", missed[i]->worst_error);
    text += (i == 0 ? "" : ", ") + missed[i]->name + error + unit;
  }
  text += missed.size() > kListedGlyphs ? ", ..." : "";
  text += fixed ? "; this is expected of the paper's predicate at corners"
                : "; lower --max-px or raise --tolerance";
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
  SourceFont font = load_font(wanted, request.jobs, rom.warnings);
  const RomContent content = build_content(font, request);
  PartBytes parts;
  rom.bytes = write_rom_font(content, parts);
  check_rom_font(rom.bytes, content);
  rom.report = make_report(font, content);
  rom.report.bytes = parts;
  warn_of_errors(rom.report, rom.warnings);
  rom.report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  return rom;
}

}  // namespace inkcell::gen
