#include "pipeline/font_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace inkcell::gen {

namespace {

// Glyphs named by a warning.
constexpr size_t kListedGlyphs = 10;

GlyphReport report_glyph(const SourceGlyph& source,
                         const RomGlyph& built,
                         const GlyphErrors& errors,
                         const Target& options) {
  GlyphReport glyph;
  glyph.name = source.name();
  glyph.file_name = source.file_name;
  glyph.key = source.code_points.empty() ? source.name()
                                         : to_utf8(source.code_points.front());
  glyph.cells = built.field.cells.size();
  glyph.nodes = static_cast<size_t>(built.field.node_count());
  for (const MinimalContour& contour : built.outline.contours) {
    glyph.points += contour.points.size();
  }
  glyph.bytes = glyph_record(built).size();
  if (options.predicate == Predicate::fixed) {
    glyph.worst_error = built.field.worst_error;
    glyph.mean_error = built.field.mean_error;
    glyph.within_tolerance = built.field.within_tolerance;
    return glyph;
  }
  const LoopResult& promised = errors.promised;
  glyph.worst_error = promised.worst;
  glyph.mean_error = promised.worst_mean;
  glyph.within_tolerance = promised.worst <= options.tolerance;
  glyph.worst_px = promised.worst_pixel.px;
  glyph.worst_x_u = promised.worst_pixel.x_u;
  glyph.worst_y_u = promised.worst_pixel.y_u;
  glyph.distance_error = errors.distance.worst;
  return glyph;
}

// Whether the glyph is there for nothing but what was added.
bool has_only(const std::vector<char32_t>& code_points, const CharSet& added) {
  return !code_points.empty() &&
         std::all_of(code_points.begin(), code_points.end(),
                     [&added](char32_t c) { return added.count(c) != 0; });
}

// The errors of all glyphs, size by size. Forms of one colour are measured at
// the smaller ones alone.
std::vector<SizeError> sum_of_sizes(const std::vector<GlyphErrors>& glyphs,
                                    LoopResult GlyphErrors::*kind) {
  std::map<int, std::pair<SizeError, int>> sums;  // by px, and of how many
  for (const GlyphErrors& errors : glyphs) {
    for (const SizeError& size : (errors.*kind).sizes) {
      auto& [sum, count] = sums[size.px];
      sum.px = size.px;
      sum.worst = std::max(sum.worst, size.worst);
      sum.mean += size.mean;
      ++count;
    }
  }
  std::vector<SizeError> sizes;
  for (const auto& [px, sum] : sums) {
    sizes.push_back(sum.first);
    sizes.back().mean /= sum.second;
  }
  return sizes;
}

double largest_mean(const std::vector<SizeError>& sizes) {
  double mean = 0;
  for (const SizeError& size : sizes) {
    mean = std::max(mean, size.mean);
  }
  return mean;
}

std::string shown_255(double value) {
  return std::to_string(static_cast<int>(value)) + "/255";
}

// A glyph that misses the tolerance, with the file if the font has several.
std::string described(const GlyphReport& glyph, const FontReport& report) {
  const bool fixed = report.options.predicate == Predicate::fixed;
  char error[64];
  std::snprintf(error, sizeof error, fixed ? " %.1f/1024 em" : " %.1f/255 at ",
                glyph.worst_error);
  return (glyph.file_name == report.file_name ? "" : glyph.file_name + " ") +
         glyph.name + error +
         (fixed ? "" : std::to_string(glyph.worst_px) + " px");
}

}  // namespace

FontReport make_report(const SourceFont& font,
                       const RomContent& content,
                       const std::vector<GlyphErrors>& errors) {
  FontReport report;
  report.file_name = font.file_name;
  report.name = font.name;
  report.options = content.options;
  report.missing = font.missing;
  report.added.assign(font.added.begin(), font.added.end());
  report.icons = font.icons;
  report.faces = font.faces;
  report.layer_lists = content.layers.glyphs.size();
  report.layer_outlines = font.layer_count;
  report.colours = font.palettes.empty() ? 0 : font.palettes[0].size();
  for (const RomStrike& strike : content.strikes) {
    report.strikes.push_back(strike.target);
  }
  report.characters = content.glyph_of.size();
  report.left_classes = content.kerning.left_classes;
  report.right_classes = content.kerning.right_classes;
  report.sizes = sum_of_sizes(errors, &GlyphErrors::promised);
  size_t with_ink = 0;
  for (size_t i = 0; i < content.glyphs.size(); ++i) {
    const RomGlyph& built = content.glyphs[i];
    GlyphReport glyph =
        report_glyph(font.glyphs[i], built, errors[i], content.options);
    if (has_only(font.glyphs[i].code_points, font.added)) {
      report.added_bytes += glyph.bytes;
    }
    if (!font.glyphs[i].master.empty()) {
      ++report.masters;
      report.master_bytes += glyph.bytes;
    }
    report.cells += glyph.cells;
    report.nodes += glyph.nodes;
    report.points += built.references.empty() ? glyph.points : 0;
    if (!built.references.empty()) {
      ++report.composites;
      report.composite_bytes += built.outline_record.size();
      report.simple_bytes += built.simple_bytes;
    }
    report.worst_error = std::max(report.worst_error, glyph.worst_error);
    report.distance_error =
        std::max(report.distance_error, glyph.distance_error);
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
    report.mean_error = largest_mean(report.sizes);
    report.distance_mean =
        largest_mean(sum_of_sizes(errors, &GlyphErrors::distance));
  }
  return report;
}

std::vector<LanguageReport> report_languages(const SourceFont& font,
                                             const AskedCharacters& asked,
                                             const FontReport& report) {
  std::vector<LanguageReport> reports;
  for (const auto& [language, characters] : asked.languages) {
    reports.push_back({language, characters});
    for (const char32_t c : font.missing) {
      reports.back().missing += characters.count(c);
    }
  }
  for (size_t i = 0; i < font.glyphs.size(); ++i) {
    bool is_common = false;
    std::vector<LanguageReport*> users;
    for (const char32_t c : font.glyphs[i].code_points) {
      is_common =
          is_common || asked.common.count(c) != 0 || font.added.count(c) != 0;
      for (LanguageReport& language : reports) {
        const bool is_new =
            std::find(users.begin(), users.end(), &language) == users.end();
        if (is_new && language.characters.count(c) != 0) {
          users.push_back(&language);
        }
      }
    }
    for (LanguageReport* language : users) {
      const size_t bytes = report.glyphs[i].bytes;
      language->bytes += bytes;
      language->bytes_alone += is_common || users.size() > 1 ? 0 : bytes;
    }
  }
  return reports;
}

void tell_of_errors(const FontReport& report,
                    bool tolerance_is_limit,
                    Warnings& warnings) {
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
  const std::string tolerance =
      fixed ? "1/1024 em" : shown_255(report.options.tolerance);
  std::string text = report.file_name + ": " + std::to_string(missed.size()) +
                     (missed.size() == 1 ? " glyph misses" : " glyphs miss") +
                     " the tolerance of " + tolerance + ": ";
  for (size_t i = 0; i < std::min(missed.size(), kListedGlyphs); ++i) {
    text += (i == 0 ? "" : ", ") + described(*missed[i], report);
  }
  text += missed.size() > kListedGlyphs ? ", ..." : "";
  if (fixed) {
    text += "; this is expected of the paper's predicate at corners";
  } else if (tolerance_is_limit) {
    throw Error(text + "; give --tolerance " +
                shown_255(std::ceil(missed.front()->worst_error)) +
                ", or allow misses with --best-effort");
  } else {
    text += missed.size() == 1 ? "; it is" : "; they are";
    text += " drawn as well as possible";
  }
  warnings.push_back({Warning::Kind::tolerance_missed, text});
}

}  // namespace inkcell::gen
