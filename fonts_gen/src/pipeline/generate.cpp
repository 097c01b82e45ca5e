#include "pipeline/generate.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "judge/closed_loop.hpp"
#include "judge/rom_check.hpp"
#include "pipeline/build.hpp"
#include "rom/rom_font.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {
namespace {

// What was asked for, or what was reached where that is worse. [1/255]
double promised_tolerance(const Target& asked,
                          const std::vector<LoopResult>& errors) {
  double tolerance = asked.tolerance;
  for (const LoopResult& glyph : errors) {
    tolerance = std::max(tolerance, std::ceil(glyph.worst));
  }
  return std::min(tolerance, 255.0);
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
  wanted.with_components = request.target.coding == Coding::outline;
  SourceFont font = load_font(wanted, request.threads, rom.warnings);
  std::vector<LoopResult> errors;
  RomContent content = build_content(font, request, errors);
  // A font promises what it holds.
  content.options.tolerance = promised_tolerance(request.target, errors);
  PartBytes parts;
  rom.bytes = write_rom_font(content, parts);
  check_rom_font(rom.bytes, content);
  content.options.tolerance = request.target.tolerance;
  rom.report = make_report(font, content, errors);
  rom.report.bytes = parts;
  tell_of_errors(rom.report, request.best_effort, rom.warnings);
  rom.report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  return rom;
}

}  // namespace inkcell::gen
