// inkcell-design roundtrip: outline to field to curves, and the errors.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/options.hpp"
#include "app/output.hpp"
#include "model/error.hpp"
#include "parallel.hpp"
#include "program.hpp"
#include "program/commands.hpp"
#include "progress.hpp"
#include "source/font_source.hpp"
#include "trace/corner_census.hpp"
#include "trace/field_outline.hpp"
#include "work_time.hpp"

namespace inkcell::design {
namespace {

struct RoundtripArguments {
  gen::GenerateRequest request;
  FieldOutlineOptions fit;
  std::string report;
  bool no_extremes = false;
  bool quiet = false;
};

struct GlyphResult {
  std::string name;
  EdgeError error;  // of the curves against the source
  EdgeError field;  // of a second round against the first
  size_t segments = 0;
  size_t source_segments = 0;
  CornerCensus corners;
  double milliseconds = 0;  // field to curves
};

constexpr double kStep_u = 1;  // between points where edges are compared

GlyphResult round_trip(const gen::SourceGlyph& glyph,
                       const RoundtripArguments& arguments) {
  GlyphResult result;
  result.name = glyph.name();
  const gen::Shape source(glyph.outline);
  if (source.empty()) {
    return result;
  }
  const ShapeField first(source, arguments.request.target);
  const double begin = tools::work_done_ms();
  const gen::Outline curves = outline_of(first.field(), arguments.fit);
  result.milliseconds = tools::work_done_ms() - begin;
  const gen::Shape traced(curves);
  result.error = edge_error(source, traced, kStep_u);
  result.segments = segment_count(curves);
  result.source_segments = segment_count(glyph.outline);
  result.corners = count_corners(glyph.outline, curves);
  const ShapeField second(traced, arguments.request.target);
  const gen::Shape again(outline_of(second.field(), arguments.fit));
  result.field = edge_error(traced, again, kStep_u);
  return result;
}

nlohmann::json report_of(const std::vector<GlyphResult>& results,
                         const GlyphResult& all) {
  nlohmann::json report;
  for (const GlyphResult& r : results) {
    if (r.segments != 0) {
      report["glyphs"][r.name] = {{"worst_u", r.error.worst},
                                  {"rms_u", r.error.rms()},
                                  {"segments", r.segments},
                                  {"source_segments", r.source_segments},
                                  {"corners", r.corners.source},
                                  {"corners_found", r.corners.found},
                                  {"corners_false", r.corners.false_ones},
                                  {"second_round_u", r.field.worst},
                                  {"milliseconds", r.milliseconds}};
    }
  }
  report["worst_u"] = all.error.worst;
  report["rms_u"] = all.error.rms();
  report["segments"] = all.segments;
  report["source_segments"] = all.source_segments;
  report["corners"] = all.corners.source;
  report["corners_found"] = all.corners.found;
  report["corners_false"] = all.corners.false_ones;
  report["second_round_u"] = all.field.worst;
  report["milliseconds_mean"] =
      all.milliseconds /
      static_cast<double>(std::max<size_t>(1, report["glyphs"].size()));
  return report;
}

void print(const char* name, const GlyphResult& r) {
  std::printf("%-22s %7.3f %7.3f %9zu %7zu %7zu %6zu %6zu %9.3f\n", name,
              r.error.worst, r.error.rms(), r.segments, r.source_segments,
              r.corners.source, r.corners.found, r.corners.false_ones,
              r.field.worst);
}

void run(RoundtripArguments& arguments) {
  arguments.fit.extremes = !arguments.no_extremes;
  if (!arguments.report.empty()) {
    gen::check_writable(arguments.report);
  }
  gen::FontRequest wanted;
  wanted.file = arguments.request.font;
  wanted.face = arguments.request.face;
  wanted.axes = arguments.request.axes;
  for (const std::string& list : arguments.request.chars) {
    gen::add_ranges(list, wanted.characters);
  }
  gen::add_text(arguments.request.symbols, "--symbols", wanted.characters);
  if (wanted.characters.empty()) {
    gen::add_ranges(gen::kDefaultChars, wanted.characters);
  }
  gen::Warnings warnings;
  gen::SourceFont font = gen::load_font(wanted, 1, warnings);
  font.glyphs.erase(font.glyphs.begin());  // .notdef
  std::vector<GlyphResult> results(font.glyphs.size());
  std::optional<tools::Progress> progress(arguments.quiet);
  parallel_for(
      results.size(), arguments.request.threads,
      [&](size_t i) {
        try {
          results[i] = round_trip(font.glyphs[i], arguments);
        } catch (const gen::GeometryError& error) {
          throw Error(font.file_name + ": " + font.glyphs[i].name() + ": " +
                      error.what() + "; leave the character out");
        }
      },
      [&](size_t done) { progress->update(done, results.size()); });
  progress.reset();
  GlyphResult all;
  for (const GlyphResult& r : results) {
    all.error.add(r.error);
    all.field.add(r.field);
    all.segments += r.segments;
    all.source_segments += r.source_segments;
    all.corners.add(r.corners);
    all.milliseconds += r.milliseconds;
  }
  const nlohmann::json report = report_of(results, all);
  if (!arguments.quiet) {
    std::printf(
        "                       worst u  RMS u   segments  source corners  "
        "found  false 2nd round\n");
    for (const GlyphResult& r : results) {
      if (r.segments != 0) {
        print(r.name.c_str(), r);
      }
    }
  }
  print(font.name.c_str(), all);
  std::printf("field to curves: %.1f ms a glyph\n",
              report["milliseconds_mean"].get<double>());
  if (!arguments.report.empty()) {
    gen::OutputFile file(arguments.report);
    file.write(report.dump(2) + "\n");
    file.commit();
  }
}

void add_options(CLI::App& command, RoundtripArguments& arguments) {
  gen::GenerateRequest& request = arguments.request;
  request.target.coding = gen::Coding::field;
  request.target.tolerance = 4;
  tools::take_one(command.add_option(
                      "--chars", request.chars,
                      "Characters: 0x20-0x7E,U+B0,A-Z; repeatable [0x20-0x7E]"))
      ->type_name("LIST");
  command.add_option("--symbols", request.symbols, "Characters, as themselves")
      ->type_name("STRING");
  command
      .add_option_function<std::string>(
          "--tolerance",
          [&request](const std::string& text) {
            request.target.tolerance = gen::parse_tolerance(text);
          },
          "Largest error of a pixel of the field from 8 to 64 px/em")
      ->type_name("N/255")
      ->default_str("4/255");
}

}  // namespace

void add_roundtrip(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<RoundtripArguments>();
  CLI::App* command = app.add_subcommand(
      "roundtrip",
      "Turn the glyphs of a font into fields and these back into curves; "
      "compare both edges, and the edge after a second round");
  command->add_option("--font", arguments->request.font, "TTF or OTF")
      ->required()
      ->type_name("FILE");
  add_options(*command, *arguments);
  command
      ->add_option("--fit", arguments->fit.tolerance_u,
                   "Bound on the distance of curves from the field's edge "
                   "[1/1024 em]")
      ->check(CLI::Range(0.05, 16.0))
      ->capture_default_str();
  command->add_flag("--no-extremes", arguments->no_extremes,
                    "Do not insist on points at extremes");
  command->add_option("--report", arguments->report, "Write the report as JSON")
      ->type_name("FILE");
  command
      ->add_option("--threads", arguments->request.threads,
                   "Threads [all cores]")
      ->check(CLI::Range(0, 1024));
  command->add_flag("--quiet", arguments->quiet, "The sum only, no progress");
  command->callback(
      [arguments, &work] { work = [arguments] { run(*arguments); }; });
}

}  // namespace inkcell::design
