// inkcell-paper-table: the paper's section 3 measured on a font: cells of three
// quadtrees at equal accuracy, and bytes of the leaf list.
#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "field/paper_counts.hpp"
#include "field/sample_tree.hpp"
#include "files.hpp"
#include "image.hpp"
#include "leaf_list.hpp"
#include "parallel.hpp"
#include "program.hpp"
#include "rom_file.hpp"
#include "shape/shape.hpp"
#include "source/font_source.hpp"

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
  int threads = 0;
  std::string report;
};

// What "accurate" may mean; the paper compares the two ADFs under conditions
// between the first and the second.
struct Condition {
  const char* key;
  const char* text;
};
constexpr std::array<Condition, 3> kConditions = {{
    {"edge", "distance, cells at the edge"},
    {"band", "distance, within 96/1024 em"},
    {"intensity", "pixels, 8 to 64 px, 16/255"},
}};

// Cells of one glyph, or the mean of many.
struct Counts {
  double three_colour_edge = 0;
  double three_colour_all = 0;
  std::array<double, kConditions.size()> bilinear{};
  std::array<double, kConditions.size()> biquadratic{};
  double device_cells = 0;  // edge, quantised as in ROM
  double leaf_bytes = 0;    // of those
  double zlib_bytes = 0;

  void add(const Counts& other, double weight) {
    three_colour_edge += weight * other.three_colour_edge;
    three_colour_all += weight * other.three_colour_all;
    for (size_t i = 0; i < kConditions.size(); ++i) {
      bilinear[i] += weight * other.bilinear[i];
      biquadratic[i] += weight * other.biquadratic[i];
    }
    device_cells += weight * other.device_cells;
    leaf_bytes += weight * other.leaf_bytes;
    zlib_bytes += weight * other.zlib_bytes;
  }
};

struct GlyphRow {
  std::string name;
  Counts counts;
  std::vector<uint8_t> leaves;
};

void count(const gen::Shape& shape,
           const gen::Target& options,
           gen::Scope scope,
           size_t condition,
           Counts& counts) {
  counts.bilinear[condition] = static_cast<double>(
      gen::count_cells_bilinear(shape, options, scope).varying);
  counts.biquadratic[condition] = static_cast<double>(
      gen::count_cells_biquadratic(shape, options, scope).varying);
}

GlyphRow measure(const gen::SourceGlyph& glyph) {
  const gen::Shape shape(glyph.outline);
  gen::Target fixed;
  fixed.predicate = gen::Predicate::fixed;
  GlyphRow row;
  row.name = to_utf8(glyph.code_points.front());
  if (shape.empty()) {
    return row;
  }
  Counts& counts = row.counts;
  const gen::LeafCounts colours =
      gen::count_cells_three_colour(shape, kResolution);
  counts.three_colour_edge = static_cast<double>(colours.varying);
  counts.three_colour_all = static_cast<double>(colours.all);
  count(shape, fixed, gen::Scope::edge, 0, counts);
  count(shape, fixed, gen::Scope::band, 1, counts);
  count(shape, gen::Target{}, gen::Scope::band, 2, counts);
  const gen::SampleTree field = gen::build_sample_tree(shape, fixed);
  row.leaves = leaf_list(field);
  counts.device_cells = static_cast<double>(field.cells.size());
  counts.leaf_bytes = static_cast<double>(row.leaves.size());
  counts.zlib_bytes = static_cast<double>(compressed_bytes(row.leaves));
  return row;
}

std::vector<GlyphRow> measure_all(const Arguments& arguments) {
  gen::FontRequest request;
  request.file = arguments.font;
  gen::add_ranges(arguments.chars, request.characters);
  gen::Warnings warnings;
  const gen::SourceFont font =
      gen::load_font(request, arguments.threads, warnings);
  std::vector<GlyphRow> rows(font.glyphs.size() - 1);  // without .notdef
  parallel_for(rows.size(), arguments.threads,
               [&](size_t i) { rows[i] = measure(font.glyphs[i + 1]); });
  return rows;
}

nlohmann::json to_json(const Counts& c) {
  nlohmann::json json = {{"three_colour_edge", c.three_colour_edge},
                         {"three_colour_all", c.three_colour_all},
                         {"cells", c.device_cells},
                         {"leaf_list_bytes", c.leaf_bytes},
                         {"zlib_bytes", c.zlib_bytes}};
  for (size_t i = 0; i < kConditions.size(); ++i) {
    json[kConditions[i].key] = {{"bilinear", c.bilinear[i]},
                                {"biquadratic", c.biquadratic[i]}};
  }
  return json;
}

std::string whole(double value) {
  return std::to_string(std::lround(value));
}

struct NamedCounts {
  std::string name;
  Counts counts;
};

void print_cells(const std::vector<NamedCounts>& rows) {
  std::printf("| cells |");
  for (const NamedCounts& row : rows) {
    std::printf(" %s |", row.name.c_str());
  }
  std::string dashes;
  for (size_t i = 0; i < rows.size(); ++i) {
    dashes += "---|";
  }
  std::printf("\n|---|%s\n", dashes.c_str());
  const auto print = [&](const std::string& what, const auto& text) {
    std::printf("| %s |", what.c_str());
    for (const NamedCounts& row : rows) {
      std::printf(" %s |", text(row.counts).c_str());
    }
    std::printf("\n");
  };
  print("3-colour quadtree, 1/512 em: edge cells (all)", [](const Counts& c) {
    return whole(c.three_colour_edge) + " (" + whole(c.three_colour_all) + ")";
  });
  for (size_t i = 0; i < kConditions.size(); ++i) {
    print(std::string("bi-linear : bi-quadratic; ") + kConditions[i].text,
          [i](const Counts& c) {
            char ratio[32];
            std::snprintf(ratio, sizeof ratio, " = %.1f",
                          c.bilinear[i] / c.biquadratic[i]);
            return whole(c.bilinear[i]) + " : " + whole(c.biquadratic[i]) +
                   ratio;
          });
  }
  print("cells in ROM with --predicate fixed",
        [](const Counts& c) { return whole(c.device_cells); });
  print("leaf list, 15 bytes each",
        [](const Counts& c) { return whole(c.leaf_bytes) + " bytes"; });
  print("the same after zlib", [](const Counts& c) {
    return whole(c.zlib_bytes) + " bytes, " +
           whole(100 * (1 - c.zlib_bytes / c.leaf_bytes)) + " % off";
  });
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
      "The paper, Times New Roman: a 457 cells, 3-colour 17393; D 399, 20813;\n"
      "bi-linear 5 to 20 times bi-quadratic, most where distances away from "
      "the "
      "edge count;\n500 to 1000 leaves a glyph; compression takes 35 to 50 %% "
      "off.\n");
}

void write_json(const Arguments& arguments, const nlohmann::json& json) {
  std::ofstream out(arguments.report);
  out << json.dump(2) << '\n';
  out.close();
  if (!out) {
    throw std::runtime_error(arguments.report + ": cannot be written");
  }
}

void run(const Arguments& arguments) {
  check_apart({arguments.report}, {arguments.font});
  check_folder_of(arguments.report);
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
  std::vector<NamedCounts> shown;
  for (const GlyphRow& row : rows) {
    mean.add(row.counts, 1.0 / static_cast<double>(inked));
    if (row.name == "a" || row.name == "D") {
      shown.push_back({row.name, row.counts});
    }
  }
  shown.push_back({"mean of " + std::to_string(inked), mean});
  std::printf("%s; distances within 1/1024 em, smallest cell 1/512 em\n\n",
              std::filesystem::path(arguments.font).filename().c_str());
  print_cells(shown);
  const size_t zlib = compressed_bytes(leaves);
  print_typeface(leaves, zlib);
  print_paper();
  if (!arguments.report.empty()) {
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
  app.add_option("--font", arguments.font, "Font file")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_option("--chars", arguments.chars, "Characters to average over")
      ->type_name("LIST")
      ->capture_default_str();
  app.add_option("--threads", arguments.threads, "Threads [all cores]")
      ->check(CLI::Range(0, 1024).description(""))
      ->type_name("INT");
  app.add_option("--report", arguments.report, "Write all glyphs as JSON")
      ->type_name("FILE");
  return inkcell::tools::run_program(app, argc, argv, [&] {
    inkcell::tools::run(arguments);
    return 0;
  });
}
