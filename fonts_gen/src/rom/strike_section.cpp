#include "rom/strike_section.hpp"

#include <algorithm>
#include <array>

#include "base/bit_table_writer.hpp"
#include "base/byte_writer.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace at = format::strike;
namespace head = format::strikes;

// Of four guesses, what a pixel shows where each is right.
using Guesses = std::array<unsigned, 4>;

constexpr unsigned kContexts = 16;

// Visits rows, with whether each is the row above, and the pixels of those that
// are not, with their context.
template <typename Visit, typename VisitRow>
void visit_pixels(const Picture& picture,
                  int bits,
                  const Visit& visit,
                  const VisitRow& visit_row) {
  for (int y = 0; y < picture.height; ++y) {
    const auto value = [&](int x, int row) {
      return x < 0 || row < 0 ? 0u : unsigned{picture.at(x, row)};
    };
    bool is_same = y != 0;
    for (int x = 0; x < picture.width && is_same; ++x) {
      is_same = value(x, y) == value(x, y - 1);
    }
    visit_row(y, is_same);
    for (int x = 0; x < picture.width && !is_same; ++x) {
      const unsigned left = value(x - 1, y);
      const unsigned up = value(x, y - 1);
      const unsigned shift = bits > 2 ? static_cast<unsigned>(bits) - 2 : 0;
      visit(value(x, y), 4 * (left >> shift) + (up >> shift),
            Guesses{0, (1u << bits) - 1, up, left});
    }
  }
}

// The guess of each context that is right most often; 0 with 1 bit.
uint32_t best_guesses(const RomStrike& strike) {
  if (strike.target.bits == 1) {
    return 0;
  }
  std::array<std::array<size_t, 4>, kContexts> hits = {};
  for (const Picture& picture : strike.pictures) {
    visit_pixels(
        picture, strike.target.bits,
        [&](unsigned value, unsigned context, const Guesses& guesses) {
          for (size_t i = 0; i < guesses.size(); ++i) {
            hits[context][i] += guesses[i] == value ? 1u : 0u;
          }
        },
        [](int, bool) {});
  }
  uint32_t best = 0;
  for (unsigned context = 0; context < kContexts; ++context) {
    const auto& of = hits[context];
    const auto guess = std::max_element(of.begin(), of.end()) - of.begin();
    best |= static_cast<uint32_t>(guess) << 2 * context;
  }
  return best;
}

void put_picture(const Picture& picture,
                 int bits,
                 uint32_t guesses,
                 Bytes& out) {
  BitTableWriter writer(out);
  const auto width = static_cast<unsigned>(bits);
  visit_pixels(
      picture, bits,
      [&](unsigned value, unsigned context, const Guesses& of) {
        const bool is_guess =
            width != 1 && of[guesses >> 2 * context & 3] == value;
        if (width != 1) {
          writer.put(is_guess ? 1 : 0, 1);
        }
        writer.put(value, is_guess ? 0 : width);
      },
      [&](int y, bool is_same) {
        writer.put(is_same ? 1 : 0, y != 0 ? 1 : 0);
      });
}

// A column of the rows of glyphs: numbers from the least on.
struct Column {
  int64_t least = 0;
  std::vector<int64_t> values;

  int64_t range() const {
    return *std::max_element(values.begin(), values.end()) - least;
  }
  unsigned width() const { return width_of(static_cast<uint32_t>(range())); }
};

// What `of` says of each picture, then 0. Nobody asks where an empty picture
// lies.
Column column_of(const RomStrike& strike, int Picture::*of, bool is_place) {
  Column column;
  for (const Picture& picture : strike.pictures) {
    if (is_place && !picture.empty()) {
      column.least = column.values.empty()
                         ? picture.*of
                         : std::min<int64_t>(column.least, picture.*of);
      column.values.push_back(picture.*of);
    }
  }
  column.values.clear();
  for (const Picture& picture : strike.pictures) {
    column.values.push_back(std::max<int64_t>(picture.*of, column.least));
  }
  column.values.push_back(column.least);
  return column;
}

// What offsets are above i steps.
Column above_steps(const std::vector<size_t>& offsets, size_t step) {
  Column column;
  for (size_t i = 0; i < offsets.size(); ++i) {
    column.values.push_back(static_cast<int64_t>(offsets[i]) -
                            static_cast<int64_t>(i * step >> 8));
  }
  column.least = *std::min_element(column.values.begin(), column.values.end());
  return column;
}

// The step that leaves the least range, which is convex but for roundings.
size_t best_step(const std::vector<size_t>& offsets) {
  size_t low = 0;
  size_t high = UINT16_MAX;
  while (high - low > 2) {
    const size_t third = (high - low) / 3;
    if (above_steps(offsets, low + third).range() <=
        above_steps(offsets, high - third).range()) {
      high -= third;
    } else {
      low += third;
    }
  }
  return low + 1;
}

void put_strike(const RomStrike& strike,
                bool is_alone,
                size_t entry,
                Bytes& out) {
  const StrikeTarget& target = strike.target;
  const uint32_t guesses = best_guesses(strike);
  Bytes pictures;
  std::vector<size_t> offsets = {0};
  for (const Picture& picture : strike.pictures) {
    put_picture(picture, target.bits, guesses, pictures);
    offsets.push_back(pictures.size());
  }
  const size_t step = best_step(offsets);
  const auto box = [&](int Picture::*of, bool is_place) {
    return is_alone ? Column{0, std::vector<int64_t>(offsets.size())}
                    : column_of(strike, of, is_place);
  };
  const Column columns[at::kColumns] = {
      box(&Picture::left, true), box(&Picture::top, true),
      box(&Picture::width, false), box(&Picture::height, false),
      above_steps(offsets, step)};
  set_u16(out, entry + at::kPx, static_cast<unsigned>(target.px));
  out[entry + at::kBits] = static_cast<uint8_t>(target.bits);
  out[entry + at::kFit] = static_cast<uint8_t>(target.fit);
  set_u16(out, entry + at::kGlyphs,
          static_cast<unsigned>(strike.pictures.size()));
  unsigned widths[at::kColumns];
  for (size_t i = 0; i < at::kColumns; ++i) {
    widths[i] = columns[i].width();
    out[entry + at::kColumnBits + i] = static_cast<uint8_t>(widths[i]);
  }
  out[entry + at::kLeftBase] = static_cast<uint8_t>(columns[0].least);
  out[entry + at::kTopBase] = static_cast<uint8_t>(columns[1].least);
  set_u16(out, entry + at::kStep, static_cast<unsigned>(step));
  set_u32(out, entry + at::kGuesses, guesses);
  set_u32(out, entry + at::kBoxes, static_cast<uint32_t>(out.size()));
  BitTableWriter table(out);
  for (size_t row = 0; row < offsets.size(); ++row) {
    for (size_t i = 0; i < at::kColumns; ++i) {
      table.put(
          static_cast<uint32_t>(columns[i].values[row] - columns[i].least),
          widths[i]);
    }
  }
  const int64_t base =
      static_cast<int64_t>(out.size()) + columns[at::kColumns - 1].least;
  set_u32(out, entry + at::kPictures, static_cast<uint32_t>(base));
  out.insert(out.end(), pictures.begin(), pictures.end());
}

}  // namespace

Bytes strikes_section(const std::vector<RomStrike>& strikes, bool is_alone) {
  Bytes out(head::kBytes + at::kBytes * strikes.size());
  set_u16(out, head::kCount, static_cast<unsigned>(strikes.size()));
  for (size_t i = 0; i < strikes.size(); ++i) {
    put_strike(strikes[i], is_alone, head::kBytes + at::kBytes * i, out);
  }
  return out;
}

}  // namespace inkcell::gen
