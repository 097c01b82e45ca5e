// Lists what the device reads from fonts, for test_decoder.py: metrics,
// characters, kerning, hints, and the cells of each glyph.
//
//   dump_cells FONT [--distances]
//
// --distances adds to every cell that is not saturated the distance in its
// middle. [u, Q10]
//
// Ends with 3 if the font is refused.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "inkcell/field/cell.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/font.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/grid_hints.hpp"

namespace {

using namespace inkcell;

constexpr int kRefused = 3;

int i16_at(const uint8_t* at) {
  return static_cast<int16_t>(at[0] | at[1] << 8);
}

void print_samples(const Cell& cell) {
  std::printf("samples %d", i16_at(cell.samples + format::samples::kCentre));
  for (uint32_t i = 0; i < 8; ++i) {
    std::printf(" %d", static_cast<int8_t>(
                           cell.samples[format::samples::kOffsets + i]));
  }
}

void print_content(const Cell& cell) {
  if (cell.samples != nullptr) {
    print_samples(cell);
  } else {
    std::printf(cell.inside ? "inside" : "outside");
  }
}

// The cells of a square, found by asking for its corner.
void print_square(const GlyphField& field,
                  int32_t x_u,
                  int32_t y_u,
                  int32_t size_u,
                  bool distances) {
  const Cell cell = locate(field, x_u, y_u);
  if (1 << cell.size_log2 != size_u) {
    const int32_t half = size_u / 2;
    print_square(field, x_u, y_u, half, distances);
    print_square(field, x_u + half, y_u, half, distances);
    print_square(field, x_u, y_u + half, half, distances);
    print_square(field, x_u + half, y_u + half, half, distances);
    return;
  }
  std::printf("%d %d %d ", cell.x0_u, cell.y0_u, size_u);
  print_content(cell);
  if (distances && !cell.is_saturated()) {
    const Q16_16 x = Q16_16::from_raw(x_u * (1 << 16) + size_u * (1 << 15));
    const Q16_16 y = Q16_16::from_raw(y_u * (1 << 16) + size_u * (1 << 15));
    std::printf(" at %d", distance_at(field, x, y).raw);
  }
  std::printf("\n");
}

void print_cells(const GlyphField& field, bool distances) {
  const int32_t size_u = 1 << field.tile_log2;
  for (int32_t y = field.y0_u; y < field.y1_u(); y += size_u) {
    for (int32_t x = field.x0_u; x < field.x1_u(); x += size_u) {
      print_square(field, x, y, size_u, distances);
    }
  }
}

void print_characters(const Font& font) {
  for (uint32_t code_point = 0; code_point <= 0x10ffff; ++code_point) {
    uint16_t glyph = 0;
    if (font.glyph_of(code_point, glyph) == Status::ok) {
      std::printf("code point %x %d\n", code_point, glyph);
    }
  }
}

void print_kerning(const Font& font) {
  const auto count = static_cast<uint16_t>(font.glyph_count());
  for (uint16_t left = 0; left < count; ++left) {
    for (uint16_t right = 0; right < count; ++right) {
      const int32_t value = font.kerning(left, right);
      if (value != 0) {
        std::printf("kerning %d %d %d\n", left, right, value);
      }
    }
  }
}

void print_height(const YHint& hint) {
  constexpr const char* kNames[] = {"bar", "serif", "edge", "end"};
  std::printf("  %s ", kNames[hint.kind]);
  if (hint.kind <= YHint::serif) {
    std::printf("%d to %d", hint.low_u, hint.high_u);
  } else {
    std::printf("at %d", hint.low_u);
  }
  if (hint.kind == YHint::end) {
    std::printf(hint.is_top ? " rises" : " hangs");
  }
  if (hint.zone != YHint::kNoZone) {
    std::printf(" zone %d %s", hint.zone, hint.is_round ? "round" : "flat");
  }
  std::printf("\n");
}

void print_hints(const Font& font) {
  GridHints hints;
  if (GridHints::open(font, hints) != Status::ok || hints.empty()) {
    return;
  }
  std::printf("grid flags %d stems %d bars %d x-height %u\n",
              (hints.has_contrast() ? 1 : 0) | (hints.has_few_bars() ? 2 : 0),
              hints.stem_width_u(), hints.bar_width_u(), hints.x_zone());
  for (uint32_t i = 0; i < hints.zone_count(); ++i) {
    const GridZone zone = hints.zone(i);
    std::printf("zone %d %d %s\n", zone.flat_u, zone.overshoot_u,
                zone.is_top ? "top" : "bottom");
  }
  for (uint32_t i = 0; i < font.glyph_count(); ++i) {
    GlyphHints glyph(hints, font.record(static_cast<uint16_t>(i)));
    std::printf("hints %u symmetric %d insets %d %d\n", i,
                glyph.is_symmetric() ? 1 : 0, glyph.left_inset_u(),
                glyph.right_inset_u());
    for (uint32_t k = 0; k < glyph.y_count(); ++k) {
      print_height(glyph.next_y());
    }
    for (uint32_t k = 0; k < glyph.x_count(); ++k) {
      const XHint hint = glyph.next_x();
      std::printf("  stem %d to %d\n", hint.left_u, hint.right_u);
    }
  }
}

int print_font(Span<const uint8_t> bytes, bool distances) {
  Font font;
  if (open_any_font(bytes, font) != Status::ok) {
    return kRefused;
  }
  if (verify_fields(font) != Status::ok) {
    return kRefused;
  }
  const Span<const char> name = font.name();
  std::printf("name ");
  std::fwrite(name.data, 1, name.size, stdout);
  std::printf("\n");
  print_characters(font);
  print_kerning(font);
  print_hints(font);
  for (uint32_t i = 0; i < font.glyph_count(); ++i) {
    const auto id = static_cast<uint16_t>(i);
    GlyphMetrics metrics;
    if (font.glyph_metrics(id, metrics) != Status::ok) {
      return 1;
    }
    std::printf("glyph %d %d %d %d %d %d\n", id, metrics.advance, metrics.x_min,
                metrics.y_min, metrics.x_max, metrics.y_max);
    GlyphField field;
    if (read_field(font, id, field) != Status::ok) {
      return 1;
    }
    print_cells(field, distances);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const bool distances = argc > 2 && std::strcmp(argv[2], "--distances") == 0;
  std::ifstream file(argc > 1 ? argv[1] : "", std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "usage: dump_cells FONT [--distances]\n");
    return 2;
  }
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
  // Words, for the alignment that fonts need.
  std::vector<uint32_t> words(bytes.size() / 4 + 1);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return print_font(
      {reinterpret_cast<const uint8_t*>(words.data()), bytes.size()},
      distances);
}
