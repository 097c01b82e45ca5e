// Tells ROM fonts from others, which go through the generator.
#include "convert.hpp"

#include <cstdio>
#include <utility>

#include "progress.hpp"

namespace inkcell::tools {

RomFile load_font_file(const std::filesystem::path& file,
                       gen::GenerateRequest request,
                       const std::string& text) {
  std::vector<uint8_t> bytes = read_file(file);
  if (is_rom_font(bytes)) {
    return RomFile(std::move(bytes), file.string());
  }
  request.font = file;
  request.symbols += text;
  gen::Progress progress(false);
  request.progress = [&progress](size_t done, size_t count) {
    progress.update(done, count);
  };
  gen::RomFont font = gen::generate(request);
  progress.finish();
  for (const gen::Warning& warning : font.warnings) {
    std::fprintf(stderr, "warning: %s\n", warning.text.c_str());
  }
  return RomFile(std::move(font.bytes), file.string());
}

}  // namespace inkcell::tools
