// Tells ROM fonts from others, which go through the generator.
#include "convert.hpp"

#include <cmath>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

#include "app/face_options.hpp"
#include "app/options.hpp"
#include "inkcell/text.hpp"
#include "progress.hpp"
#include "source/char_set.hpp"
#include "source/shaping_need.hpp"

namespace inkcell::tools {
namespace {

constexpr const char* kConversion =
    "Options for a TTF or OTF, which is converted";

// Progress goes to the caller, or to standard error.
gen::RomFont generate(gen::GenerateRequest request, bool may_halve) {
  const auto tell = std::move(request.progress);
  while (true) {
    try {
      Progress progress(false);
      request.progress = [&](size_t done, size_t count) {
        if (tell) {
          tell(done, count);
        } else {
          progress.update(done, count);
        }
      };
      return gen::generate(request);
    } catch (const gen::TooComplex& error) {
      const double half = std::floor(request.target.max_px / 2);
      if (!may_halve || half < request.target.min_px) {
        throw;
      }
      std::fprintf(stderr,
                   "warning: %s at %g px; the font is converted for %g to %g "
                   "px; say --max-px to forbid that\n",
                   error.problem().c_str(), request.target.max_px,
                   request.target.min_px, half);
      request.target.max_px = half;
    }
  }
}

// What the generator says when it converts a font, about one that is there.
void warn_of_missing(const RomFile& rom,
                     const std::filesystem::path& file,
                     const std::string& text) {
  std::set<char32_t> missing;
  for (const char32_t c : from_utf8(text)) {
    uint16_t glyph = 0;
    if (needs_glyph(c) && rom.font().glyph_of(c, glyph) != Status::ok) {
      missing.insert(c);
    }
  }
  if (missing.empty()) {
    return;
  }
  std::fprintf(stderr, "warning: %s: not in the font, and drawn as .notdef:",
               file.filename().string().c_str());
  for (const char32_t c : missing) {
    std::fprintf(stderr, " %s", gen::describe(c).c_str());
  }
  std::fprintf(stderr, "\n");
}

void warn_of_unshaped(const std::string& text) {
  const std::vector<char32_t> points = from_utf8(text);
  const std::u32string_view characters(points.data(), points.size());
  for (const gen::UnshapedScript& script : gen::unshaped_scripts(characters)) {
    std::fprintf(stderr, "warning: %s\n",
                 gen::unshaped_message(script, characters).c_str());
  }
}

}  // namespace

void add_conversion_options(CLI::App& app, gen::GenerateRequest& request) {
  const size_t before = app.get_options().size();
  gen::add_generator_options(app, request);
  gen::add_face_options(app, request);
  const std::vector<CLI::Option*> options = app.get_options();
  for (size_t i = before; i < options.size(); ++i) {
    options[i]->group(kConversion);
  }
}

Conversion conversion_of(const CLI::App& app,
                         const gen::GenerateRequest& request) {
  const std::vector<const CLI::Option*> given =
      app.get_options([](const CLI::Option* option) {
        return option->get_group() == kConversion && option->count() > 0;
      });
  return {request, app.count("--max-px") == 0,
          given.empty() ? std::string() : given.front()->get_name()};
}

RomFile load_font_file(const std::filesystem::path& file,
                       const Conversion& conversion,
                       const std::string& text,
                       Damaged damaged) {
  std::vector<uint8_t> bytes = read_file(file);
  if (is_rom_font(bytes)) {
    if (!conversion.option.empty()) {
      throw std::runtime_error(
          file.string() + ": is a ROM font, which " + conversion.option +
          " cannot change; name the TTF or OTF it was made of");
    }
    RomFile rom(std::move(bytes), file.string());
    if (damaged == Damaged::refused) {
      require_sound(rom, file);
    }
    warn_of_missing(rom, file, text);
    warn_of_unshaped(text);
    return rom;
  }
  gen::GenerateRequest request = conversion.request;
  request.font = file;
  request.symbols += text;
  gen::RomFont font = generate(std::move(request), conversion.may_halve);
  for (const gen::Warning& warning : font.warnings) {
    std::fprintf(stderr, "%s\n", warning.message().c_str());
  }
  return RomFile(std::move(font.bytes), file.string());
}

}  // namespace inkcell::tools
