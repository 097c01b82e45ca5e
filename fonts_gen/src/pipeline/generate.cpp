#include "pipeline/generate.hpp"

#include <chrono>

#include "judge/closed_loop.hpp"
#include "judge/rom_check.hpp"
#include "pipeline/build.hpp"
#include "rom/rom_font.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

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
