// Text and tables of shaping from a fuzzer: bytes in, and the promises of
// shaping.hpp checked.
//
// The last 64 bytes of an input choose how text is shaped, and are the text.
// The rest is a font, repaired. The seeds are fonts of few letters:
//
//   inkcell-fontgen --font FACE --symbols LETTERS --shape SCRIPT --min-px 16
//     --max-px 16 --hints off
#include <algorithm>
#include <memory>
#include <vector>

#include "exercise.hpp"
#include "front_ends.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/devanagari.hpp"
#include "inkcell/shaping/verify.hpp"
#include "repair_font.hpp"

namespace {

using namespace inkcell;

constexpr size_t kChoiceBytes = 64;
constexpr size_t kTextAt = 8;

// Shapes all runs, with a program of their own or a chosen one.
void shape_all(const Shaping& shaping,
               const Text& text,
               const uint8_t* choice) {
  const size_t room_size = choice[1];
  const auto room = std::make_unique<TextGlyph[]>(room_size);
  size_t end = 0;
  ScriptRun run = shaping.first_run(text, 0, text.size);
  do {
    hostile::require(run.begin == end && run.end <= text.size,
                     "runs follow each other");
    end = run.end;
    if ((choice[2] & 1) != 0) {
      run.program = choice[3];
      run.is_right_to_left = (choice[2] & 2) != 0;
    }
    Span<TextGlyph> glyphs(room.get(), room_size);
    const Status status = shaping.shape(text, run, glyphs);
    hostile::require(glyphs.size <= room_size, "glyphs fit the room");
    hostile::require(status == Status::ok || glyphs.size == 0,
                     "nothing is left of what failed");
    for (const TextGlyph& glyph : glyphs) {
      hostile::require(glyph.cluster <= run.end - run.begin,
                       "a cluster is a character of the run");
    }
  } while (run.end > run.begin && shaping.next_run(text, text.size, run));
  hostile::require(end == text.size, "runs are the whole text");
}

}  // namespace

void run(const uint8_t* data, size_t size) {
  if (size <= kChoiceBytes) {
    return;
  }
  const uint8_t* const choice = data + size - kChoiceBytes;
  // In a block of its size.
  const size_t bytes = size - kChoiceBytes;
  const auto block = std::make_unique<uint8_t[]>(bytes);
  std::copy(data, data + bytes, block.get());
  repair_font({block.get(), bytes});
  Font font;
  if (Font::open({block.get(), bytes}, font) != Status::ok) {
    return;
  }
  const bool is_whole = verify_shaping(font) == Status::ok;
  Shaping shaping;
  const Status opened = Shaping::open(font, kDevanagari, shaping);
  hostile::require(!is_whole || opened != Status::corrupt,
                   "what is verified opens");
  if (opened != Status::ok) {
    return;
  }
  if ((choice[0] & 1) != 0) {
    shaping.set_language(format::tag('U', 'R', 'D', ' '));
  }
  const auto copy = std::make_unique<char[]>(kChoiceBytes - kTextAt);
  std::copy(choice + kTextAt, choice + kChoiceBytes, copy.get());
  const Text text(copy.get(), kChoiceBytes - kTextAt);
  shape_all(shaping, text, choice);
  // Bytes that changed after they were opened.
  const Span<const uint8_t> section = font.section(format::section::kShaping);
  const size_t at = (choice[4] | choice[5] << 8) % section.size;
  block[static_cast<size_t>(section.data - block.get()) + at] ^= choice[6];
  shape_all(shaping, text, choice);
}
