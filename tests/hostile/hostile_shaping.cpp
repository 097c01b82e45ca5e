// Shapes texts by fonts whose section SHAP has wrong bytes: with sanitizers,
// into rooms that are exactly as long as they say.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/shaping.hpp"

namespace {

using namespace inkcell;

constexpr int kRounds = 3000;

struct Counts {
  int opened = 0;
  int shaped = 0;
  int refused = 0;
};

// Letters, marks, joiners and bytes that are no characters.
std::string random_text(std::mt19937& random, const std::u32string& letters) {
  std::string text;
  const size_t length = random() % 40;
  while (text.size() < length) {
    const char32_t c = random() % 8 != 0
                           ? letters[random() % letters.size()]
                           : static_cast<char32_t>(random() % 0x3000);
    if (c < 0x80) {
      text += static_cast<char>(c);
    } else if (c < 0x800) {
      text += static_cast<char>(0xc0 | c >> 6);
      text += static_cast<char>(0x80 | (c & 63));
    } else {
      text += static_cast<char>(0xe0 | c >> 12);
      text += static_cast<char>(0x80 | (c >> 6 & 63));
      text += static_cast<char>(0x80 | (c & 63));
    }
  }
  return text;
}

// False: more glyphs than there was room for.
bool shape_all(const Shaping& shaping,
               const std::string& bytes,
               size_t room_size,
               uint8_t program,
               Counts& counts) {
  const auto copy = std::make_unique<char[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), copy.get());
  const Text text(copy.get(), bytes.size());
  const auto room = std::make_unique<RunGlyph[]>(room_size);
  ScriptRun run = shaping.first_run(text, 0, text.size);
  do {
    run.program = program != ScriptRun::kNoProgram ? program : run.program;
    Span<RunGlyph> glyphs(room.get(), room_size);
    const Status status = shaping.shape(text, run, glyphs);
    ++(status == Status::ok ? counts.shaped : counts.refused);
    if (glyphs.size > room_size || (status != Status::ok && glyphs.size != 0)) {
      return false;
    }
  } while (run.end > run.begin && shaping.next_run(text, text.size, run));
  return true;
}

bool test(const char* file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<uint8_t> good((std::istreambuf_iterator<char>(in)),
                                  std::istreambuf_iterator<char>());
  Font font;
  if (Font::open({good.data(), good.size()}, font) != Status::ok) {
    std::printf("%s: not a font\n", file);
    return false;
  }
  const Span<const uint8_t> section = font.section(format::section::kShaping);
  std::u32string letters = U" \u200c\u200d\u0301\u0323\u0654\u0e33";
  for (char32_t c = 1; c < 0x2000; ++c) {
    uint16_t glyph = 0;
    if (font.glyph_of(c, glyph) == Status::ok) {
      letters += c;
    }
  }
  std::mt19937 random(1);
  Counts counts;
  for (int round = 0; round < kRounds; ++round) {
    const auto copy = std::make_unique<uint8_t[]>(good.size());
    std::copy(good.begin(), good.end(), copy.get());
    uint8_t* const tables = copy.get() + (section.data - good.data());
    for (size_t wrong = random() % 6; wrong > 0; --wrong) {
      // The header's bytes more often.
      const size_t at = random() % (random() % 2 != 0 ? 33 : section.size);
      tables[at] = static_cast<uint8_t>(
          random() % 2 != 0 ? random() : tables[at] ^ 1u << random() % 8);
    }
    Shaping shaping;
    if (Font::open({copy.get(), good.size()}, font) != Status::ok ||
        Shaping::open(font, shaping) != Status::ok) {
      continue;
    }
    ++counts.opened;
    for (int text = 0; text < 8; ++text) {
      // Bytes that change after they were opened.
      tables[random() % section.size] ^=
          static_cast<uint8_t>(text >= 4 ? 1u << random() % 8 : 0u);
      const uint8_t program = static_cast<uint8_t>(
          random() % 4 == 0 ? random() % 4 : ScriptRun::kNoProgram);
      if (!shape_all(shaping, random_text(random, letters), random() % 64,
                     program, counts)) {
        std::printf("%s: round %d: glyphs outside of the room\n", file, round);
        return false;
      }
    }
  }
  std::printf("%s: %d of %d opened, %d runs shaped, %d refused\n", file,
              counts.opened, kRounds, counts.shaped, counts.refused);
  return counts.opened > kRounds / 4 && counts.shaped > kRounds &&
         counts.refused > 0;
}

}  // namespace

int main(int count, char** files) {
  bool is_good = count > 1;
  for (int i = 1; i < count; ++i) {
    is_good = test(files[i]) && is_good;
  }
  return is_good ? 0 : 1;
}
