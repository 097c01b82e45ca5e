// inkcell-paper-table: the paper's section 3 measured on a font: cells of three
// quadtrees at equal accuracy, and bytes of the leaf list.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "adf.hpp"
#include "font_source.hpp"
#include "leaf_list.hpp"
#include "paper_counts.hpp"
#include "parallel.hpp"
#include "rom_file.hpp"
#include "shape.hpp"

namespace inkcell::tools {
namespace {

// "a resolution equivalent to a 512x512 image of distance values" (figure 2).
constexpr int kResolution = 512;

// Debian's package fonts-liberation: the metrics of Times New Roman.
constexpr const char* kTimesMetrics =
    "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf";

struct Arguments {
  std::string font = kTimesMetrics;
  std::string chars = std::string(gen::kDefaultChars);
  unsigned jobs = 0;
  std::string json;
};

/// Non-constant leaves of one glyph, or the mean of many.
struct Counts {
  double three_colour = 0;
  double bilinear = 0;  // edge cells: the fixed predicate
  double biquadratic = 0;
  double bilinear_band = 0;  // the whole band: the size-aware predicate
  double biquadratic_band = 0;
  double leaf_bytes = 0;  // of `biquadratic`
  double zlib_bytes = 0;

  void add(const Counts& other, double weight) {
    three_colour += weight * other.three_colour;
    bilinear += weight * other.bilinear;
    biquadratic += weight * other.biquadratic;
    bilinear_band += weight * other.bilinear_band;
    biquadratic_band += weight * other.biquadratic_band;
    leaf_bytes += weight * other.leaf_bytes;
    zlib_bytes += weight * other.zlib_bytes;
  }
};

struct GlyphRow {
  std::string name;
  Counts counts;
  std::vector<uint8_t> leaves;
};

GlyphRow measure(const gen::SourceGlyph& glyph) {
  const gen::Shape shape(glyph.outline);
  gen::AdfOptions edge;
  edge.predicate = gen::Predicate::fixed;
  const gen::AdfOptions band;  // 8 to 64 px, 16/255
  GlyphRow row;
  row.name = to_utf8(glyph.code_points.front());
  if (shape.empty()) {
    return row;
  }
  const auto varying = [](const gen::LeafCounts& counts) {
    return static_cast<double>(counts.varying);
  };
  row.counts.three_colour =
      varying(gen::count_cells_three_colour(shape, kResolution));
  row.counts.bilinear = varying(gen::count_cells_bilinear(shape, edge));
  row.counts.bilinear_band = varying(gen::count_cells_bilinear(shape, band));
  row.counts.biquadratic_band =
      varying(gen::count_cells_biquadratic(shape, band));
  const gen::AdfGlyph field = gen::build_adf(shape, edge);
  row.counts.biquadratic = static_cast<double>(field.cells.size());
  row.leaves = leaf_list(field);
  row.counts.leaf_bytes = static_cast<double>(row.leaves.size());
  row.counts.zlib_bytes = static_cast<double>(compressed_bytes(row.leaves));
  return row;
}

std::vector<GlyphRow> measure_all(const Arguments& arguments) {
  gen::FontRequest request;
  request.file = arguments.font;
  gen::add_ranges(arguments.chars, request.characters);
  gen::Warnings warnings;
  const gen::SourceFont font =
      gen::load_font(request, static_cast<int>(arguments.jobs), warnings);
  std::vector<GlyphRow> rows(font.glyphs.size() - 1);  // without .notdef
  parallel_for(rows.size(), arguments.jobs,
               [&](size_t i) { rows[i] = measure(font.glyphs[i + 1]); });
  return rows;
}

void print_row(const std::string& name, const Counts& c) {
  std::printf(
      "| %s | %.0f | %.0f | %.0f | %.1f | %.0f | %.0f | %.1f | %.0f | %.0f | "
      "%.0f %% |\n",
      name.c_str(), c.three_colour, c.bilinear, c.biquadratic,
      c.bilinear / c.biquadratic, c.bilinear_band, c.biquadratic_band,
      c.bilinear_band / c.biquadratic_band, c.leaf_bytes, c.zlib_bytes,
      100 * (1 - c.zlib_bytes / c.leaf_bytes));
}

nlohmann::json to_json(const Counts& c) {
  return {{"three_colour", c.three_colour},
          {"bilinear", c.bilinear},
          {"biquadratic", c.biquadratic},
          {"bilinear_band", c.bilinear_band},
          {"biquadratic_band", c.biquadratic_band},
          {"leaf_list_bytes", c.leaf_bytes},
          {"zlib_bytes", c.zlib_bytes}};
}

void print_head(const Arguments& arguments) {
  std::printf(
      "Leaves that are not constant, %s.\n"
      "edge: error of distance below 1/1024 em in cells that the edge crosses, "
      "smallest cell 1/%d em.\n"
      "band: error of a pixel below 16/255 at every size from 8 to 64 px, the "
      "field good 3/4 px from the edge.\n\n"
      "| glyph | 3-colour | bi-linear, edge | bi-quadratic, edge | ratio | "
      "bi-linear, band | bi-quadratic, band | ratio | leaf list, bytes | "
      "zlib, bytes | off |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
      std::filesystem::path(arguments.font).filename().c_str(), kResolution);
}

// One stream for the whole typeface, as the paper's "Winzip" had it.
void print_typeface(const std::vector<uint8_t>& leaves, size_t zlib) {
  std::printf(
      "\nThe typeface in one stream: %zu bytes, zlib %zu bytes, %.0f %% off.\n",
      leaves.size(), zlib,
      100 *
          (1 - static_cast<double>(zlib) / static_cast<double>(leaves.size())));
}

void print_paper() {
  std::printf(
      "The paper, Times New Roman: a 17393 3-colour, 457 bi-quadratic; D "
      "20813, "
      "399;\nbi-linear 5 to 20 times bi-quadratic; 500 to 1000 leaves a glyph; "
      "35 to 50 %% off.\n");
}

void write_json(const Arguments& arguments, const nlohmann::json& json) {
  std::ofstream out(arguments.json);
  out << json.dump(2) << '\n';
  out.close();
  if (!out) {
    throw std::runtime_error(arguments.json + ": cannot be written");
  }
}

void run(const Arguments& arguments) {
  const std::vector<GlyphRow> rows = measure_all(arguments);
  Counts mean;
  std::vector<uint8_t> leaves;
  nlohmann::json glyphs = nlohmann::json::object();
  size_t inked = 0;
  for (const GlyphRow& row : rows) {
    if (!row.leaves.empty()) {
      ++inked;
    }
    leaves.insert(leaves.end(), row.leaves.begin(), row.leaves.end());
    glyphs[row.name] = to_json(row.counts);
  }
  if (inked == 0) {
    throw std::runtime_error("no glyph of the font has ink");
  }
  print_head(arguments);
  for (const GlyphRow& row : rows) {
    mean.add(row.counts, 1.0 / static_cast<double>(inked));
    if (row.name == "a" || row.name == "D") {
      print_row(row.name, row.counts);
    }
  }
  print_row("mean of " + std::to_string(inked), mean);
  const size_t zlib = compressed_bytes(leaves);
  print_typeface(leaves, zlib);
  print_paper();
  if (!arguments.json.empty()) {
    write_json(arguments, {{"font", arguments.font},
                           {"mean", to_json(mean)},
                           {"typeface_bytes", leaves.size()},
                           {"typeface_zlib_bytes", zlib},
                           {"glyphs", glyphs}});
  }
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app(
      "Measures the claims of the paper's section 3 on a font with the metrics "
      "of Times.");
  inkcell::tools::Arguments arguments;
  app.add_option("--font", arguments.font, "Font file")->capture_default_str();
  app.add_option("--chars", arguments.chars, "Characters to average over")
      ->capture_default_str();
  app.add_option("--jobs", arguments.jobs, "Threads [all cores]");
  app.add_option("--json", arguments.json, "Write all glyphs as JSON");
  CLI11_PARSE(app, argc, argv);
  try {
    inkcell::tools::run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
  return 0;
}
