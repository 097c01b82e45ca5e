#include "app/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "inkcell/version.hpp"

namespace inkcell::gen {
namespace {

// Glyphs in each list of the worst ones.
constexpr size_t kWorst = 5;

#ifndef __MINGW_PRINTF_FORMAT  // Windows has two kinds of printf()
#  define __MINGW_PRINTF_FORMAT printf
#endif
__attribute__((format(__MINGW_PRINTF_FORMAT, 1, 2))) std::string format(
    const char* pattern, ...) {
  char line[256];
  va_list values;
  va_start(values, pattern);
  std::vsnprintf(line, sizeof line, pattern, values);
  va_end(values);
  return line;
}

const char* error_unit(const FontReport& report) {
  return report.options.predicate == Predicate::fixed ? "1/1024 em" : "1/255";
}

// The glyph's character, or its number if that is invisible.
std::string shown(const GlyphReport& glyph) {
  const bool is_visible = glyph.name.find('\'') != std::string::npos;
  return is_visible ? glyph.key : glyph.name;
}

// The size of the worst pixel, " at 17 px"; nothing if there is none.
std::string at_size(const GlyphReport& glyph) {
  return glyph.worst_px == 0 ? "" : format(" at %d px", glyph.worst_px);
}

// A line of the worst glyphs by the measure `of`, printed by `show`.
template <typename Measure, typename Show>
std::string worst_line(const FontReport& report,
                       const char* title,
                       Measure of,
                       Show show) {
  std::vector<const GlyphReport*> order;
  for (const GlyphReport& glyph : report.glyphs) {
    order.push_back(&glyph);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](const GlyphReport* a, const GlyphReport* b) {
                     return of(*a) > of(*b);
                   });
  std::string line = format("  %-16s", title);
  for (size_t i = 0; i < std::min(kWorst, order.size()); ++i) {
    line += (i == 0 ? "" : ", ") + shown(*order[i]) + " " + show(*order[i]);
  }
  return line + "\n";
}

double rounded(double value) {
  return std::round(value * 1000) / 1000;
}

const char* coding_name(const Target& options) {
  return options.coding == Coding::outline ? "outline"
         : options.coding == Coding::field ? "field"
                                           : "strike";
}

std::string outlines_line(const FontReport& report) {
  return format("  %-16s%zu\n", "points", report.points) +
         format(
             "  %-16s%zu glyphs refer to others in %zu bytes; as outlines "
             "%zu\n",
             "composites", report.composites, report.composite_bytes,
             report.simple_bytes);
}

std::string cells_line(const FontReport& report) {
  return format("  %-16s%zu, %zu inner nodes; as a leaf list %zu bytes\n",
                "cells", report.cells, report.nodes, report.leaf_list_bytes());
}

// The smallest, the largest, and some sizes between.
std::string sizes_lines(const FontReport& report) {
  constexpr size_t kColumns = 8;
  const std::vector<SizeError>& sizes = report.sizes;
  if (sizes.empty()) {
    return "";
  }
  std::string px = format("  %-16s", "size, px");
  std::string worst = format("  %-16s", "worst, 1/255");
  std::string mean = format("  %-16s", "mean, 1/255");
  const size_t columns = std::min(kColumns, sizes.size());
  for (size_t i = 0; i < columns; ++i) {
    const SizeError& size =
        sizes[columns == 1 ? 0 : i * (sizes.size() - 1) / (columns - 1)];
    px += format("%7d", size.px);
    worst += format("%7.1f", size.worst);
    mean += format("%7.2f", size.mean);
  }
  return px + "\n" + worst + "\n" + mean + "\n";
}

std::string to_text(const CharSet& characters) {
  std::string text;
  for (const char32_t c : characters) {
    text += to_utf8(c);
  }
  return text;
}

nlohmann::ordered_json face_as_json(const SourceFace& face) {
  nlohmann::ordered_json json;
  json["file"] = face.file_name;
  if (!face.variation.axes.empty()) {
    json["instance"] = face.variation.instance();
    for (const FontAxis& axis : face.variation.axes) {
      json["axes"][axis.tag] = {{"min", axis.least},
                                {"default", axis.usual},
                                {"max", axis.most},
                                {"value", axis.value}};
    }
  }
  json["scale"] = rounded(face.scale);
  json["shift_em"] = rounded(face.shift_em);
  return json;
}

}  // namespace

std::string report_for_people(const FontReport& report) {
  const Target& options = report.options;
  const PartBytes& bytes = report.bytes;
  std::string text = report.name + " (" + report.file_name + ")\n";
  text += format("  %-16s%zu, for %zu characters\n", "glyphs",
                 report.glyphs.size(), report.characters);
  if (report.masters != 0) {
    text += format("  %-16s%zu glyphs, %zu bytes\n", "second masters",
                   report.masters, report.master_bytes);
  }
  if (options.predicate == Predicate::fixed) {
    text +=
        format("  %-16s1/1024 em, cells of 1/512 em and more\n", "tolerance");
  } else {
    text += format("  %-16s%.0f/255 from %.0f to %.0f px\n", "tolerance",
                   options.tolerance, options.min_px, options.max_px);
  }
  if (options.band_px > 0) {
    text +=
        format("  %-16s%.2f px at %.0f px, %.0f/1024 em", "band",
               options.band_px, options.min_px, std::floor(band_u(options)));
    text += report.band_bytes
                ? format(", for %+lld bytes\n",
                         static_cast<long long>(*report.band_bytes))
                : "\n";
  }
  if (!report.added.empty()) {
    text += format("  %-16s", "for layout");
    for (const char32_t c : report.added) {
      text += describe(c) + ", ";
    }
    text += format("%zu bytes of glyphs\n", report.added_bytes);
  }
  for (const LanguageReport& language : report.languages) {
    text += format("  %-16s", "language") + language.language +
            format(": %zu characters, %zu bytes of glyphs, %zu for it alone",
                   language.characters.size(), language.bytes,
                   language.bytes_alone);
    text += language.missing == 0 ? "\n"
                                  : format("; %zu missing\n", language.missing);
  }
  for (const SourceFace& face : report.faces) {
    if (!face.variation.axes.empty()) {
      text += format("  %-16s", "instance") + face.file_name + ": " +
              face.variation.place() + "\n";
    }
    if (face.scale != 1 || face.shift_em != 0) {
      text += format("  %-16s", "placed") + face.file_name +
              format(": scaled by %.3f, moved by %+.3f em\n", face.scale,
                     face.shift_em);
    }
  }
  for (const StrikeTarget& strike : report.strikes) {
    text += format("  %-16s%d px, %d bits\n", "strike", strike.px, strike.bits);
  }
  if (report.layer_lists != 0) {
    text +=
        format("  %-16s%zu, of %zu outlines in %zu colours\n", "colour glyphs",
               report.layer_lists, report.layer_outlines, report.colours);
  }
  for (const IconFile& icon : report.icons) {
    text += format("  %-16sU+%04X k", "icon",
                   static_cast<unsigned>(icon.code_point)) +
            icon.name + ", " + icon.file.filename().string() + "\n";
  }
  const auto part = [&](const char* name, size_t size) {
    text += format(
        "  %-16s%9zu bytes  %5.1f %%\n", name, size,
        100.0 * static_cast<double>(size) / static_cast<double>(bytes.total()));
  };
  part("header", bytes.header);
  part("cmap", bytes.cmap);
  part("metrics", bytes.metrics);
  part("kerning", bytes.kerning);
  part("hints", bytes.hints);
  if (bytes.shaping != 0) {
    part("shaping", bytes.shaping);
  }
  if (bytes.morphs != 0) {
    part("morphs", bytes.morphs);
  }
  if (bytes.strikes != 0) {
    part("strikes", bytes.strikes);
  }
  if (bytes.layers != 0) {
    part("layers", bytes.layers);
  }
  part("glyphs", bytes.glyphs);
  part("name", bytes.name);
  part("total", bytes.total());
  text += options.coding == Coding::outline ? outlines_line(report)
                                            : cells_line(report);
  text += format("  %-16s%d left, %d right\n", "kerning classes",
                 report.left_classes, report.right_classes);
  text += format("  %-16s%.1f worst, %.2f mean, in %s\n", "error",
                 report.worst_error, report.mean_error, error_unit(report));
  if (options.coding == Coding::outline) {
    text += format("  %-16s%.1f worst, %.2f mean, with the filter text\n",
                   "by distance", report.distance_error, report.distance_mean);
  }
  text += sizes_lines(report);
  text += worst_line(
      report, "most bytes", [](const GlyphReport& g) { return g.bytes; },
      [](const GlyphReport& g) { return std::to_string(g.bytes); });
  text += worst_line(
      report, "worst error", [](const GlyphReport& g) { return g.worst_error; },
      [](const GlyphReport& g) {
        return format("%.1f", g.worst_error) + at_size(g);
      });
  return text + format("  %-16s%.2f s\n", "time", report.seconds);
}

std::string report_as_json(const FontReport& report) {
  using Json = nlohmann::ordered_json;
  const Target& options = report.options;
  const PartBytes& bytes = report.bytes;
  const bool fixed = options.predicate == Predicate::fixed;
  Json json;
  json["font"] = report.name;
  json["file"] = report.file_name;
  json["glyphs"] = report.glyphs.size();
  json["characters"] = report.characters;
  json["master_count"] = report.masters;
  json["master_bytes"] = report.master_bytes;
  json["missing"] = report.missing.size();
  if (!report.added.empty()) {
    const CharSet added(report.added.begin(), report.added.end());
    json["added"] = {{"characters", to_text(added)},
                     {"bytes", report.added_bytes}};
  }
  for (const LanguageReport& language : report.languages) {
    json["languages"][language.language] = {
        {"characters", to_text(language.characters)},
        {"missing", language.missing},
        {"bytes", language.bytes},
        {"bytes_alone", language.bytes_alone}};
  }
  for (const SourceFace& face : report.faces) {
    json["faces"].push_back(face_as_json(face));
  }
  for (const StrikeTarget& strike : report.strikes) {
    json["strikes"].push_back({{"px", strike.px},
                               {"bits", strike.bits},
                               {"fit", static_cast<int>(strike.fit)}});
  }
  if (report.layer_lists != 0) {
    json["layers"] = {{"glyphs", report.layer_lists},
                      {"outlines", report.layer_outlines},
                      {"colours", report.colours}};
  }
  if (!report.icons.empty()) {
    Json icons = Json::object();
    for (const IconFile& icon : report.icons) {
      icons[icon.name] = static_cast<uint32_t>(icon.code_point);
    }
    json["icons"] = std::move(icons);
  }
  json["coding"] = coding_name(options);
  json["predicate"] = fixed ? "fixed" : "size";
  json["min_px"] = static_cast<int>(options.min_px);
  json["max_px"] = static_cast<int>(options.max_px);
  json["tolerance"] = fixed ? 0 : static_cast<int>(options.tolerance);
  json["band_u"] = static_cast<int>(band_u(options));
  if (report.band_bytes) {
    json["band_bytes"] = *report.band_bytes;
  }
  if (options.coding != Coding::outline) {
    json["effort"] = options.effort;
  }
  json["bytes"] = {{"total", bytes.total()},   {"header", bytes.header},
                   {"cmap", bytes.cmap},       {"metrics", bytes.metrics},
                   {"kerning", bytes.kerning}, {"hints", bytes.hints},
                   {"morphs", bytes.morphs},   {"shaping", bytes.shaping},
                   {"strikes", bytes.strikes}, {"layers", bytes.layers},
                   {"glyphs", bytes.glyphs},   {"name", bytes.name}};
  json["point_count"] = report.points;
  json["composite_count"] = report.composites;
  json["composite_bytes"] = report.composite_bytes;
  json["composite_simple_bytes"] = report.simple_bytes;
  json["leaf_list_bytes"] = report.leaf_list_bytes();
  json["cell_count"] = report.cells;
  json["node_count"] = report.nodes;
  Json per_glyph = Json::object();
  Json points = Json::object();
  Json glyph_bytes = Json::object();
  Json glyph_error = Json::object();
  Json worst_pixel = Json::object();
  Json missed = Json::array();
  for (const GlyphReport& glyph : report.glyphs) {
    per_glyph[glyph.key] = glyph.cells;
    points[glyph.key] = glyph.points;
    glyph_bytes[glyph.key] = glyph.bytes;
    glyph_error[glyph.key] = rounded(glyph.worst_error);
    if (glyph.worst_px != 0) {
      worst_pixel[glyph.key] = {{"px", glyph.worst_px},
                                {"x_u", rounded(glyph.worst_x_u)},
                                {"y_u", rounded(glyph.worst_y_u)}};
    }
    if (!glyph.within_tolerance) {
      missed.push_back({{"glyph", glyph.key},
                        {"file", glyph.file_name},
                        {"px", glyph.worst_px},
                        {"error", rounded(glyph.worst_error)}});
    }
  }
  json["cells_per_glyph"] = std::move(per_glyph);
  json["points_per_glyph"] = std::move(points);
  json["bytes_per_glyph"] = std::move(glyph_bytes);
  json["error_per_glyph"] = std::move(glyph_error);
  json["worst_pixel_per_glyph"] = std::move(worst_pixel);
  json["missed"] = std::move(missed);
  json["error"] = {{"max", rounded(report.worst_error)},
                   {"mean", rounded(report.mean_error)},
                   {"unit", error_unit(report)}};
  if (!fixed) {
    json["distance_error"] = {{"max", rounded(report.distance_error)},
                              {"mean", rounded(report.distance_mean)}};
  }
  Json by_size = Json::array();
  for (const SizeError& size : report.sizes) {
    by_size.push_back({{"px", size.px},
                       {"worst", rounded(size.worst)},
                       {"mean", rounded(size.mean)}});
  }
  json["error_by_size"] = std::move(by_size);
  json["kerning_classes"] = {{"left", report.left_classes},
                             {"right", report.right_classes}};
  json["format"] =
      std::to_string(kFormatMajor) + "." + std::to_string(kFormatMinor);
  json["seconds"] = rounded(report.seconds);
  return json.dump(2) + "\n";
}

}  // namespace inkcell::gen
