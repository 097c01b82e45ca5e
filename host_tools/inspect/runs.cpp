#include "runs.hpp"

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "inkcell/shaping/devanagari.hpp"

namespace inkcell::tools {
namespace {

// Glyphs of a byte of text, more than any face makes of it.
constexpr size_t kGlyphsOfByte = 8;

void print_line(const Shaping& shaping,
                const std::string& line,
                const std::string& place) {
  const Text text(line.data(), line.size());
  ScriptRun run = shaping.first_run(text, 0, text.size);
  run.end = text.size;
  std::vector<TextGlyph> room(kGlyphsOfByte * line.size() + 1);
  Span<TextGlyph> glyphs(room.data(), room.size());
  const Status status = shaping.shape(text, run, glyphs);
  if (status != Status::ok) {
    throw std::runtime_error(place + ": cannot be shaped, status " +
                             std::to_string(static_cast<int>(status)));
  }
  std::printf("[");
  for (size_t i = 0; i < glyphs.size; ++i) {
    const TextGlyph& glyph = glyphs[i];
    std::printf(
        "%s{\"glyph\":%d,\"cluster\":%d,\"x\":%d,\"y\":%d,\"advance\":%d}",
        i == 0 ? "" : ",", glyph.glyph, glyph.cluster, glyph.x, glyph.y,
        glyph.advance);
  }
  std::printf("]\n");
}

}  // namespace

void print_runs(const Font& font, const std::string& file) {
  Shaping shaping;
  const Status status = Shaping::open(font, kDevanagari, shaping);
  if (status != Status::ok) {
    throw std::runtime_error(
        status == Status::unsupported
            ? "the font shapes no script; generate it with --shape"
            : "section SHAP is damaged; regenerate the font");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw std::runtime_error(file + ": cannot be read");
  }
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (!line.empty() && line.back() == '\r') {
      line.pop_back();
    }
    print_line(shaping, line, file + ":" + std::to_string(number));
  }
}

}  // namespace inkcell::tools
