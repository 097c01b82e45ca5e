// Says what a build of the library can draw: for a record of cells, and for
// each font that is named, a status and what drawing made of it; of a font that
// INKCELL_OWN_FONT has inkcell_add_font() make, likewise; and the status of
// what else needs cells.
#include <stdint.h>
#include <stdio.h>

#include <vector>

#include "inkcell/format/cell.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/runtime_field.hpp"
#include "inkcell/splat.hpp"
#include "inkcell/supersample.hpp"
#include "inkcell/text.hpp"

#ifdef INKCELL_OWN_FONT
#  include <fonts/own.hpp>
#endif

namespace {

using namespace inkcell;

constexpr int32_t kSide = 128;

// FNV-1a of all pixels.
uint32_t hash_of(const std::vector<uint8_t>& pixels) {
  uint32_t hash = 2166136261u;
  for (const uint8_t pixel : pixels) {
    hash = (hash ^ pixel) * 16777619u;
  }
  return hash;
}

// A word in both orders, turned, and with the effect that has cells of its
// own.
bool draw(const Font& font, Sink& sink) {
  std::vector<uint32_t> sums(kSide * 64);
  Splats splats;
  TextStyle small;
  TextStyle large;
  TextStyle turned;
  const Direction leftwards = {Fixed<int32_t, 30>::from_raw(0),
                               Fixed<int32_t, 30>::from_raw(1 << 30)};
  if (make_splats({sums.data(), sums.size()}, kSplatRadius, splats) !=
          Status::ok ||
      TextStyle::make(Q26_6::from_int(12), kFilterText, small) != Status::ok ||
      TextStyle::make(Q26_6::from_int(64), kFilterText, large) != Status::ok ||
      TextStyle::make(Q26_6::from_int(24), kFilterText, leftwards, turned) !=
          Status::ok) {
    return false;
  }
  TextStyle splatted = small;
  splatted.set_effect(splat_effect(splats));
  int32_t y = 0;
  for (const TextStyle* style : {&small, &splatted, &large, &turned}) {
    y += style->size().floor() + 4;
    draw_text(font, "AB", *style, {Q26_6::from_int(30), Q26_6::from_int(y)},
              sink);
  }
  return true;
}

bool show(Span<const uint8_t> rom) {
  Font font;
  const Status status = Font::open(rom, font);
  std::vector<uint8_t> pixels(kSide * kSide);
  port::A8Target target;
  target.strip.pixels = {pixels.data(), pixels.size()};
  target.strip.width = kSide;
  target.strip.height = kSide;
  target.strip.stride = kSide;
  Sink sink;
  if (make_sink(target, sink) != Status::ok || !draw(font, sink)) {
    return false;
  }
  size_t inked = 0;
  for (const uint8_t pixel : pixels) {
    inked += pixel != 0 ? 1 : 0;
  }
  printf("%d %08x %d\n", static_cast<int>(status), hash_of(pixels),
         inked > 100 ? 1 : 0);
  // What takes a field.
  const uint16_t glyph = font.glyph_or_notdef('A');
  alignas(4) static uint8_t ram[32768];
  GlyphField field;
  TextStyle style;
  if (TextStyle::make(Q26_6::from_int(12), kFilterText, style) != Status::ok) {
    return false;
  }
  const Supersampling samples =
      make_supersampling(kFilterText, kPaperRadius, SampleRule::paper);
  style.set_effect(supersample_effect(samples));
  printf("%d %d %d\n",
         static_cast<int>(generate_field(font, glyph, {}, ram, field)),
         static_cast<int>(open_field(font, glyph, {}, ram, field)),
         static_cast<int>(check_effect(font, style)));
  return true;
}

bool show_file(const char* path) {
  FILE* file = fopen(path, "rb");
  if (file == nullptr) {
    return false;
  }
  std::vector<uint32_t> words(1 << 14);
  const size_t size = fread(words.data(), 1, words.size() * 4, file);
  fclose(file);
  return show({reinterpret_cast<const uint8_t*>(words.data()), size});
}

}  // namespace

int main(int argc, char** argv) {
  // One tile that is all inside.
  alignas(2)
      const uint8_t record[] = {1, 8, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0};
  GlyphField field;
  const Status status = GlyphField::open(record, field);
  // A program that asks a field keeps what answers.
  const bool inside =
      detail::kHasCells && status == Status::ok && locate(field, 9, 9).inside;
  printf("%d %d\n", static_cast<int>(status), inside ? 1 : 0);
  for (int i = 1; i < argc; ++i) {
    if (!show_file(argv[i])) {
      return 1;
    }
  }
#ifdef INKCELL_OWN_FONT
  if (!show(fonts::own)) {
    return 1;
  }
#endif
  return 0;
}
