#include "inkcell/shaping/shaping.hpp"

#include "shaper.hpp"

namespace inkcell {

namespace shap = format::shaping;

namespace {
constexpr uint32_t kEmojiStyle = 0xfe0f;
constexpr uint32_t kKeycap = 0x20e3;
}  // namespace

Status Shaping::open(const Font& font, Shaping& out) noexcept {
  const Span<const uint8_t> section = font.section(format::section::kShaping);
  if (section.data == nullptr) {
    return Status::unsupported;
  }
  detail::ShapeTables tables;
  if (!tables.open(section)) {
    return Status::corrupt;
  }
  out.font_ = &font;
  out.tables_ = tables;
  return Status::ok;
}

// The first program of the script of a character; kNoProgram: it has none.
uint32_t Shaping::program_of(uint32_t code_point) const noexcept {
  detail::ShapeReader reader(tables_);
  for (uint32_t i = 0; i < reader.header(shap::kScripts); ++i) {
    reader.seek(detail::kScriptTable, i);
    const uint32_t place = code_point - reader.take(shap::kCodeBits);
    if (place <= reader.take(shap::kCodeBits)) {
      return reader.take(8);
    }
  }
  return ScriptRun::kNoProgram;
}

bool Shaping::parts_at_spaces() const noexcept {
  detail::ShapeReader reader(tables_);
  return reader.program(0).has(shap::kSpaceIsFree);
}

bool Shaping::joins(const ScriptRun& run) const noexcept {
  detail::ShapeReader reader(tables_);
  return run.program < reader.header(shap::kPrograms) &&
         reader.program(run.program).has(shap::kJoins);
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
  size_t base = begin;  // of a digit that a key encloses
  while (rest.size != 0) {
    const size_t at = end - rest.size;
    const uint32_t code = next_code_point(rest);
    const uint32_t program =
        code == kEmojiStyle ? ScriptRun::kNoProgram : program_of(code);
    if (code != kEmojiStyle && code != kKeycap) {
      base = at;
    }
    if (program != ScriptRun::kNoProgram) {
      if (run.program == ScriptRun::kNoProgram) {
        run.program = static_cast<uint8_t>(program);
      } else if (run.program != program) {
        run.end = code == kKeycap && base != begin ? base : run.end;
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
                      Span<TextGlyph>& glyphs) const noexcept {
  const Span<TextGlyph> room = glyphs;
  glyphs.size = 0;
  if (font_ == nullptr || run.begin > run.end || run.end > text.size) {
    return Status::bad_argument;
  }
  detail::ShapeReader reader(tables_);
  uint32_t program = run.program;
  // Those of a script follow each other, from the one without a language on.
  for (uint32_t i = program + 1;
       language_ != 0 && i < reader.header(shap::kPrograms); ++i) {
    reader.seek(detail::kProgramTable, i);
    reader.at_ += 32;
    uint32_t tag = reader.take(16);
    tag |= reader.take(16) << 16;
    if (tag == language_) {
      program = i;
    }
    if (tag == language_ || tag == 0) {
      break;
    }
  }
  detail::Shaper shaper(*font_, tables_, syllables_, room);
  INKCELL_TRY(shaper.shape(text, run, program));
  glyphs.size = shaper.count();
  return Status::ok;
}

}  // namespace inkcell
