// Bitmap masters against the outlines they were drawn from: the exact distance
// transform beside edges walked and curves fitted.
//
// Usage: inkcell_master_figures FONT.ttf SYMBOLS PX_PER_EM bilevel|grey
//          [WORST_U RMS_U]
//        inkcell_master_figures FONT.ttf SYMBOLS PX_PER_EM potrace
//
// The second prints a table: potrace beside our curves for the same masters of
// ink and none, at several tolerances each.
//
// Errors in u: of the transform at pixels within 32 u of the edge, of the
// curves at their edge, both beyond 3 u from corners. Fails if the curves are
// worse than the limits, or no truer than the transform.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bitmap/distance_transform.hpp"
#include "bitmap/edge_walk.hpp"
#include "folders.hpp"
#include "import/svg_import.hpp"
#include "master_oracle.hpp"
#include "shape/shape.hpp"
#include "source/font_source.hpp"
#include "trace/field_outline.hpp"
#include "work_time.hpp"

namespace inkcell::design::test {
namespace {

constexpr double kNear_u = 32;

struct Row {
  Errors transform;
  Errors curves;
  Errors with_corners;
  double transform_s = 0;
  double curves_s = 0;
  size_t segments = 0;
};

void measure(const gen::SourceGlyph& glyph,
             double px_per_em,
             bool is_grey,
             Row& row) {
  const gen::Shape truth(glyph.outline);
  const std::vector<Point> corners = corners_of(glyph.outline);
  MasterOptions options;
  const Bitmap bitmap = draw_master(truth, px_per_em, is_grey, options.place);
  double begin = tools::work_done_ms();
  const std::vector<float> distances = signed_distances(bitmap);
  row.transform_s =
      std::max(row.transform_s, (tools::work_done_ms() - begin) / 1e3);
  begin = tools::work_done_ms();
  const gen::Outline curves = outline_of(bitmap, options);
  row.curves_s = std::max(row.curves_s, (tools::work_done_ms() - begin) / 1e3);
  row.segments += segment_count(curves);
  const gen::Shape traced(curves);
  compare_edges(traced, truth, corners, row.curves, row.with_corners);
  compare_edges(truth, traced, corners, row.curves, row.with_corners);
  const double px = 1024 / px_per_em;
  // A sample of the pixels, spread evenly.
  for (size_t i = 0; i < distances.size(); i += 97) {
    const double d = static_cast<double>(distances[i]) * px;
    if (std::fabs(d) > kNear_u) {
      continue;
    }
    const int x = static_cast<int>(i) % bitmap.width;
    const int y = static_cast<int>(i) / bitmap.width;
    const Point p = {(x + 0.5 - options.place.origin_x) * px,
                     (options.place.origin_y - y - 0.5) * px};
    if (!is_near_any(p, corners)) {
      row.transform.note(d - truth.distance(p.x, p.y));
    }
  }
}

// The results of one tracer for all masters.
struct Tracer {
  bool is_potrace = false;
  double tolerance = 0;  // potrace's -O, or ours in u
  Errors off_corners;
  Errors all;
  size_t segments = 0;
};

void write_pbm(const Bitmap& bitmap, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  out << "P4\n" << bitmap.width << " " << bitmap.height << "\n";
  for (int y = 0; y < bitmap.height; ++y) {
    for (int x = 0; x < bitmap.width; x += 8) {
      int byte = 0;
      for (int i = 0; i < 8; ++i) {
        byte = byte << 1 | (bitmap.at(x + i, y) != 0 ? 1 : 0);
      }
      out.put(static_cast<char>(byte));
    }
  }
}

// potrace writes hundredths of a pixel.
gen::Outline by_potrace(const std::filesystem::path& folder,
                        double tolerance,
                        const MasterPlace& place) {
  const std::string command = "potrace --svg --unit 100 --opttolerance " +
                              std::to_string(tolerance) + " --output '" +
                              (folder / "m.svg").string() + "' '" +
                              (folder / "m.pbm").string() + "'";
  if (std::system(command.c_str()) != 0) {
    std::fprintf(stderr,
                 "potrace failed; on Debian: apt-get install potrace\n");
    std::exit(2);
  }
  DrawingPlace drawing;
  drawing.px_per_em = place.px_per_em;
  drawing.origin = {place.origin_x, place.origin_y};
  return read_svg(folder / "m.svg", drawing);
}

void trace(const gen::SourceGlyph& glyph,
           double px_per_em,
           const std::filesystem::path& folder,
           std::vector<Tracer>& tracers) {
  const gen::Shape truth(glyph.outline);
  const std::vector<Point> corners = corners_of(glyph.outline);
  MasterOptions options;
  const Bitmap bitmap = draw_master(truth, px_per_em, false, options.place);
  write_pbm(bitmap, folder / "m.pbm");
  for (Tracer& tracer : tracers) {
    options.tolerance_u = tracer.tolerance;
    const gen::Outline curves =
        tracer.is_potrace ? by_potrace(folder, tracer.tolerance, options.place)
                          : outline_of(bitmap, options);
    tracer.segments += segment_count(curves);
    const gen::Shape traced(curves);
    compare_edges(traced, truth, corners, tracer.off_corners, tracer.all);
    compare_edges(truth, traced, corners, tracer.off_corners, tracer.all);
  }
}

int compare_tracers(const gen::SourceFont& font, double px_per_em) {
  std::vector<Tracer> tracers;
  for (const double tolerance : {0.2, 0.5, 1.0, 2.0}) {
    tracers.push_back({true, tolerance, {}, {}, 0});
  }
  for (const double tolerance : {0.1, 0.2, 0.4, 0.8}) {
    tracers.push_back({false, tolerance, {}, {}, 0});
  }
  const TemporaryFolder folder;
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    trace(font.glyphs[i], px_per_em, folder.path(), tracers);
  }
  std::printf("%g px/em      worst u  at corners  RMS u   segments\n",
              px_per_em);
  for (const Tracer& tracer : tracers) {
    std::printf("%s %-5g %8.3f %10.3f %8.4f %8zu\n",
                tracer.is_potrace ? "potrace -O" : "ours --fit",
                tracer.tolerance, tracer.off_corners.worst, tracer.all.worst,
                tracer.off_corners.rms(), tracer.segments);
  }
  return 0;
}

int run(char** arguments, bool has_limits) {
  gen::FontRequest request;
  request.file = arguments[1];
  gen::add_text(arguments[2], "SYMBOLS", request.characters);
  gen::Warnings warnings;
  gen::SourceFont font = gen::load_font(request, 1, warnings);
  if (std::string(arguments[4]) == "potrace") {
    return compare_tracers(font, std::atof(arguments[3]));
  }
  const double px_per_em = std::atof(arguments[3]);
  const bool is_grey = std::string(arguments[4]) == "grey";
  Row row;
  for (size_t i = 1; i < font.glyphs.size(); ++i) {
    measure(font.glyphs[i], px_per_em, is_grey, row);
  }
  std::printf(
      "%g px/em %s: distance transform %.3f u worst, %.4f RMS, %.2f s; curves "
      "%.3f u worst (%.3f at corners), %.4f RMS, %zu segments, %.2f s a glyph "
      "at most\n",
      px_per_em, arguments[4], row.transform.worst, row.transform.rms(),
      row.transform_s, row.curves.worst, row.with_corners.worst,
      row.curves.rms(), row.segments, row.curves_s);
  if (!has_limits) {
    return 0;
  }
  const bool is_good = row.curves.worst <= std::atof(arguments[5]) &&
                       row.curves.rms() <= std::atof(arguments[6]) &&
                       row.curves.rms() < row.transform.rms();
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace inkcell::design::test

int main(int argc, char** argv) {
  if (argc != 5 && argc != 7) {
    std::fprintf(stderr,
                 "usage: inkcell_master_figures FONT.ttf SYMBOLS PX_PER_EM "
                 "bilevel|grey|potrace [WORST_U RMS_U]\n");
    return 2;
  }
  return inkcell::design::test::run(argv, argc == 7);
}
