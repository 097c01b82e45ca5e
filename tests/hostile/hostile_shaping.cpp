// Shapes texts by fonts whose section SHAP has wrong bytes, or bytes that
// change as it is read: with sanitizers, into rooms that are exactly as long as
// they say.
//
//   hostile_shaping [changing] FONT.bin...
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

#if defined(__linux__) && defined(__x86_64__)
#  include "changing_bytes.hpp"
#endif
#include "inkcell/format/rom.hpp"
#include "inkcell/shaping/devanagari.hpp"
#include "inkcell/shaping/verify.hpp"

namespace {

using namespace inkcell;

constexpr int kRounds = 3000;

struct Counts {
  int opened = 0;
  int verified = 0;
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
  const auto room = std::make_unique<TextGlyph[]>(room_size);
  ScriptRun run = shaping.first_run(text, 0, text.size);
  do {
    run.program = program != ScriptRun::kNoProgram ? program : run.program;
    Span<TextGlyph> glyphs(room.get(), room_size);
    const Status status = shaping.shape(text, run, glyphs);
    ++(status == Status::ok ? counts.shaped : counts.refused);
    if (glyphs.size > room_size || (status != Status::ok && glyphs.size != 0)) {
      return false;
    }
  } while (run.end > run.begin && shaping.next_run(text, text.size, run));
  return true;
}

std::vector<uint8_t> read_file(const char* file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::u32string letters_of(const Font& font) {
  std::u32string letters = U" \u200c\u200d\u0301\u0323\u0654\u0e33";
  for (char32_t c = 1; c < 0x2000; ++c) {
    uint16_t glyph = 0;
    if (font.glyph_of(c, glyph) == Status::ok) {
      letters += c;
    }
  }
  return letters;
}

// Syllables are refused by a program that does not name their code.
bool needs_code(const Font& font) {
  const Text text("\u0915\u093f");
  uint16_t glyph = 0;
  const bool has_script = font.glyph_of(0x915, glyph) == Status::ok;
  for (const bool has_code : {false, true}) {
    Shaping shaping;
    const Status opened = has_code ? Shaping::open(font, kDevanagari, shaping)
                                   : Shaping::open(font, shaping);
    const ScriptRun run = shaping.first_run(text, 0, text.size);
    TextGlyph room[8];
    Span<TextGlyph> glyphs(room);
    const Status wanted =
        has_code || !has_script ? Status::ok : Status::unsupported;
    if (opened != Status::ok || shaping.shape(text, run, glyphs) != wanted) {
      return false;
    }
  }
  return true;
}

bool test(const char* file) {
  const std::vector<uint8_t> good = read_file(file);
  Font font;
  if (Font::open({good.data(), good.size()}, font) != Status::ok ||
      verify_shaping(font) != Status::ok || !needs_code(font)) {
    std::printf("%s: not a font, or not whole\n", file);
    return false;
  }
  const Span<const uint8_t> section = font.section(format::section::kShaping);
  const std::u32string letters = letters_of(font);
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
    const Status opened = Font::open({copy.get(), good.size()}, font);
    const Status verified = verify_shaping(font);
    if (opened != Status::ok ||
        Shaping::open(font, kDevanagari, shaping) != Status::ok) {
      if (verified == Status::ok) {
        std::printf("%s: round %d: verified, but closed\n", file, round);
        return false;
      }
      continue;
    }
    ++counts.opened;
    counts.verified += verified == Status::ok ? 1 : 0;
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
  std::printf("%s: %d of %d opened, %d verified, %d runs shaped, %d refused\n",
              file, counts.opened, kRounds, counts.verified, counts.shaped,
              counts.refused);
  return counts.opened > kRounds / 4 && counts.shaped > kRounds &&
         counts.refused > 0 && counts.verified > 0 &&
         counts.verified < counts.opened;
}

#if defined(__linux__) && defined(__x86_64__)
// The loads of a run by tables that change, each 4 bytes at most, keep to the
// steps of the format: a step is 17 rows of a search, each of 4 loads, at most,
// and 2 searches. What is not counted in steps: rows of the header's tables for
// each character, and a bit for each entry of a program.
constexpr int64_t kLoadsOfStep = 2 * 17 * 8;

bool test_changing(const char* file) {
  const std::vector<uint8_t> good = read_file(file);
  std::mt19937 random(2);
  Counts counts;
  int64_t most = 0;
  for (const uint32_t one_in : {3u, 40u, 400u}) {
    for (const bool is_at_end : {true, false}) {
      hostile::ChangingBytes memory({good.data(), good.size()}, is_at_end);
      Font font;
      Shaping shaping;
      if (Font::open(memory.bytes(), font) != Status::ok ||
          Shaping::open(font, kDevanagari, shaping) != Status::ok) {
        return false;
      }
      const Span<const uint8_t> section =
          font.section(format::section::kShaping);
      const auto u16 = [&](uint32_t at) {
        return static_cast<int64_t>(section.data[at] | section.data[at + 1]
                                                           << 8);
      };
      const int64_t rows = 512 + 8 * u16(format::shaping::kCompositions) +
                           8 * section.data[format::shaping::kSpans];
      const std::u32string letters = letters_of(font);
      for (uint32_t round = 1; round <= 3; ++round) {
        const std::string text = random_text(random, letters);
        const auto characters = static_cast<int64_t>(text.size()) + 1;
        const int64_t before = hostile::ChangingBytes::load_count();
        memory.start(round, one_in);
        const bool is_good =
            shape_all(shaping, text, 60, ScriptRun::kNoProgram, counts);
        counts.verified += verify_shaping(font) == Status::ok ? 1 : 0;
        memory.stop();
        const int64_t loads = hostile::ChangingBytes::load_count() - before;
        most = std::max(most, loads / characters);
        if (!is_good ||
            loads > characters * (format::shaping::kMaxSteps * kLoadsOfStep +
                                  rows * 8)) {
          std::printf("%s: %lld loads for %lld bytes of text\n", file,
                      static_cast<long long>(loads),
                      static_cast<long long>(characters));
          return false;
        }
      }
    }
  }
  std::printf("%s: %d runs shaped, %d refused, at most %lld loads a byte\n",
              file, counts.shaped, counts.refused,
              static_cast<long long>(most));
  return counts.shaped > 0 && hostile::ChangingBytes::change_count() > 1000;
}
#endif

}  // namespace

int main(int count, char** files) {
  bool is_good = count > 1;
#if defined(__linux__) && defined(__x86_64__)
  if (count > 2 && std::string(files[1]) == "changing") {
    for (int i = 2; i < count; ++i) {
      is_good = test_changing(files[i]) && is_good;
    }
    return is_good ? 0 : 1;
  }
#endif
  for (int i = 1; i < count; ++i) {
    is_good = test(files[i]) && is_good;
  }
  return is_good ? 0 : 1;
}
