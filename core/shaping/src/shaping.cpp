#include "inkcell/shaping/shaping.hpp"

#include "shaper.hpp"

namespace inkcell {

namespace shap = format::shaping;

Status Shaping::open(const Font& font, Shaping& out) noexcept {
  const Span<const uint8_t> section = font.section(format::section::kShaping);
  if (section.data == nullptr) {
    return Status::unsupported;
  }
  Shaping shaping;
  shaping.font_ = &font;
  if (!shaping.tables_.open(section)) {
    return Status::corrupt;
  }
  out = shaping;
  return Status::ok;
}

// The first program of the script of a character; kNoProgram: it has none.
uint32_t Shaping::program_of(uint32_t code_point) const noexcept {
  const detail::ShapeReader reader(tables_);
  const uint32_t scripts = reader.u8(shap::kScripts);
  for (uint32_t i = 0; i < scripts; ++i) {
    uint32_t bit = tables_.scripts + i * shap::kScriptRow;
    const uint32_t place = code_point - reader.take(bit, shap::kCodeBits);
    if (place <= reader.take(bit, shap::kCodeBits)) {
      const uint32_t program = reader.get(bit, 8);
      return program < reader.u8(shap::kPrograms) ? program
                                                  : ScriptRun::kNoProgram;
    }
  }
  return ScriptRun::kNoProgram;
}

ScriptRun Shaping::first_run(const Text& text,
                             size_t begin,
                             size_t end) const noexcept {
  ScriptRun run;
  run.begin = begin;
  run.end = begin;
  if (end > text.size || begin >= end) {
    return run;
  }
  Text rest(text.data + begin, end - begin);
  while (rest.size != 0) {
    const uint32_t program = program_of(next_code_point(rest));
    if (program != ScriptRun::kNoProgram) {
      if (run.program == ScriptRun::kNoProgram) {
        run.program = static_cast<uint8_t>(program);
      } else if (run.program != program) {
        break;
      }
    }
    run.end = end - rest.size;
  }
  run.is_right_to_left =
      run.program != ScriptRun::kNoProgram &&
      detail::ShapeReader(tables_).program(run.program).has(shap::kRightToLeft);
  return run;
}

bool Shaping::next_run(const Text& text,
                       size_t end,
                       ScriptRun& run) const noexcept {
  if (run.end >= end) {
    return false;
  }
  run = first_run(text, run.end, end);
  return true;
}

Status Shaping::shape(const Text& text,
                      const ScriptRun& run,
                      Span<RunGlyph>& glyphs) const noexcept {
  const Span<RunGlyph> room = glyphs;
  glyphs.size = 0;
  if (font_ == nullptr || run.begin > run.end || run.end > text.size) {
    return Status::bad_argument;
  }
  const detail::ShapeReader reader(tables_);
  const uint32_t programs = reader.u8(shap::kPrograms);
  uint32_t program = run.program;
  if (program < programs && language_ != 0) {
    // Those of a script follow each other, the default first.
    const auto word = [&](uint32_t number, uint32_t place) {
      const uint32_t bit =
          tables_.programs + number * shap::kProgramRow + 32 * place;
      return reader.get(bit, 16) | reader.get(bit + 16, 16) << 16;
    };
    const uint32_t script = word(program, 0);
    for (uint32_t i = program; i < programs && word(i, 0) == script; ++i) {
      if (word(i, 1) == language_) {
        program = i;
        break;
      }
    }
  }
  detail::Shaper shaper(*font_, tables_, room);
  INKCELL_TRY(shaper.shape(text, run, program));
  glyphs.size = shaper.count();
  return Status::ok;
}

}  // namespace inkcell
