// Spacing of fitted text in figures, for spacing.py.
//
//   spacing FONT FIRST_PX LAST_PX FILE_OF_LINES [LETTERS]
//
// Prints a line a mode and size:
//
//   mode px advances pairs closed least most mean
//
//   advances  how many different advances the characters of ASCII have [px],
//   and
//             the digits, with a comma between them
//   pairs     of letters and digits whose ink is half a pixel apart or more
//             unfitted; closed: so many of them touch, fitted, in a line of
//             both
//   least, most, mean   how much longer lines are than unfitted [1/1000], mean
//             of the magnitudes
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "inkcell/bilevel.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/painter.hpp"

namespace {

using namespace inkcell;

// Whose pairs are drawn.
std::string letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";

// A page of coverage whose origin is in the middle.
struct Page {
  explicit Page(int32_t reach) : half(reach) {
    ink.assign(static_cast<size_t>(4 * reach * reach), 0);
  }

  uint8_t& at(int32_t x, int32_t y) {
    return ink[static_cast<size_t>((y + half) * 2 * half + x + half)];
  }
  uint8_t get(int32_t x, int32_t y) const {
    return std::abs(x) < half && std::abs(y) < half
               ? const_cast<Page*>(this)->at(x, y)
               : 0;
  }
  Sink sink() {
    Sink sink;
    sink.window = {-half, -half, half, half};
    sink.context = this;
    sink.coverage = [](void* context, int32_t x, int32_t y, const uint8_t* row,
                       int32_t count) noexcept {
      Page& page = *static_cast<Page*>(context);
      for (int32_t i = 0; i < count; ++i) {
        page.at(x + i, y) = row[i];
      }
    };
    sink.solid = [](void* context, int32_t x, int32_t y,
                    int32_t count) noexcept {
      Page& page = *static_cast<Page*>(context);
      for (int32_t i = 0; i < count; ++i) {
        page.at(x + i, y) = 255;
      }
    };
    return sink;
  }

  int32_t half;
  std::vector<uint8_t> ink;
};

Page draw(const Font& font, const Style& style, char letter) {
  const int32_t px = style.size().raw >> 6;
  Page page(2 * px + 2);
  Painter(page.sink()).text(font, style, {}, Text(&letter, 1));
  return page;
}

// Where each glyph of a text stands. [px]
std::vector<double> places(const Font& font,
                           const Style& style,
                           const std::string& text) {
  std::vector<double> places;
  TextCursor cursor(font, Text(text.data(), text.size()), style);
  PositionedGlyph at;
  while (cursor.next(at)) {
    places.push_back(to_px(font, style, at.x).raw / 64.0);
  }
  places.push_back(to_px(font, style, cursor.advance()).raw / 64.0);
  return places;
}

// The distance of the ink of all pairs, in em; of those farther apart at least
// 1/2.
class Distances {
 public:
  explicit Distances(const Font& font) : font_(font) {
    const Style style(Q26_6::from_int(kPx));
    for (const char c : letters) {
      const Page page = draw(font, style, c);
      auto& rows = rows_[c];
      for (int32_t y = 1 - page.half; y < page.half; ++y) {
        Row row{1 << 20, -(1 << 20)};
        for (int32_t x = 1 - page.half; x < page.half; ++x) {
          if (page.get(x, y) >= 128) {
            row.first = std::min(row.first, x);
            row.last = std::max(row.last, x + 1);
          }
        }
        rows.push_back(row);
      }
    }
  }

  double em(char left, char right) const {
    const std::string pair{left, right};
    const Style style(Q26_6::from_int(kPx));
    const double shift = places(font_, style, pair)[1];
    const auto& a = rows_.at(left);
    const auto& b = rows_.at(right);
    double least = kPx;
    const int32_t reach = kPx / 12;
    for (size_t y = 0; y < a.size(); ++y) {
      if (a[y].last < a[y].first) {
        continue;
      }
      const size_t from = y < size_t(reach) ? 0 : y - size_t(reach);
      for (size_t v = from; v < b.size() && v <= y + size_t(reach); ++v) {
        if (b[v].last < b[v].first) {
          continue;
        }
        const double dx = std::max(0.0, shift + b[v].first - a[y].last);
        const double dy = std::max(0.0, std::abs(double(v) - double(y)) - 1);
        least = std::min(least, std::hypot(dx, dy));
      }
    }
    return least / kPx;
  }

 private:
  struct Row {
    int32_t first;
    int32_t last;
  };
  static constexpr int32_t kPx = 125;
  const Font& font_;
  std::map<char, std::vector<Row>> rows_;
};

bool touch(const Page& a, const Page& b, int32_t shift) {
  const int32_t from = std::max(-a.half, shift - b.half);
  for (int32_t y = 1 - a.half; y < a.half - 1; ++y) {
    for (int32_t x = from; x < a.half; ++x) {
      if (a.get(x, y) >= 128 &&
          (b.get(x - shift, y) >= 128 || b.get(x + 1 - shift, y) >= 128 ||
           b.get(x - 1 - shift, y) >= 128 || b.get(x - shift, y + 1) >= 128 ||
           b.get(x - shift, y - 1) >= 128)) {
        return true;
      }
    }
  }
  return false;
}

struct Mode {
  const char* name;
  Style style;
};

void judge(const Font& font,
           const Mode& mode,
           int32_t px,
           const std::map<std::pair<char, char>, double>& distances,
           const std::vector<std::string>& lines) {
  const Style& style = mode.style;
  std::set<int32_t> advances[2];
  for (char c = ' '; c < 127; ++c) {
    const std::string text(20, c);
    // Behind a letter: the pen's state must not matter.
    const auto at = places(font, style, "x" + text);
    for (size_t i = 1; i + 1 < at.size(); ++i) {
      const auto advance = static_cast<int32_t>(std::lround(at[i + 1] - at[i]));
      advances[0].insert(advance);
      if (c >= '0' && c <= '9') {
        advances[1].insert(advance);
      }
    }
  }
  std::map<char, Page> pages;
  for (const char c : letters) {
    pages.emplace(c, draw(font, style, c));
  }
  int32_t pairs = 0;
  int32_t closed = 0;
  std::string which;
  for (const auto& [pair, em] : distances) {
    if (em * px < 0.5) {
      continue;
    }
    ++pairs;
    std::string text;
    for (int i = 0; i < 4; ++i) {
      text += {pair.first, pair.second, ' '};
      text += std::string("nem").substr(0, static_cast<size_t>(i));
    }
    const auto at = places(font, style, text);
    bool is_closed = false;
    for (size_t i = 0; i + 1 < text.size(); ++i) {
      if (text[i] == pair.first && text[i + 1] == pair.second) {
        const auto shift = static_cast<int32_t>(std::lround(at[i + 1] - at[i]));
        is_closed = is_closed ||
                    touch(pages.at(pair.first), pages.at(pair.second), shift);
      }
    }
    closed += is_closed ? 1 : 0;
    if (is_closed && which.size() < 60) {
      which += {' ', pair.first, pair.second};
    }
  }
  double least = 1e9;
  double most = -1e9;
  double sum = 0;
  const Style free(style.size());
  for (const std::string& line : lines) {
    const double drift = 1000 * (places(font, style, line).back() /
                                     places(font, free, line).back() -
                                 1);
    least = std::min(least, drift);
    most = std::max(most, drift);
    sum += std::abs(drift);
  }
  std::printf("%s %d %d,%d %d %d %.0f %.0f %.1f%s\n", mode.name, px,
              static_cast<int>(advances[0].size()),
              static_cast<int>(advances[1].size()), pairs, closed, least, most,
              sum / static_cast<double>(lines.size()),
              std::getenv("PAIRS") != nullptr ? which.c_str() : "");
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) {
    return 2;
  }
  if (count > 5) {
    letters = arguments[5];
  }
  std::ifstream file(arguments[1], std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  static std::vector<uint64_t> rom((bytes.size() + 7) / 8);
  std::memcpy(rom.data(), bytes.data(), bytes.size());
  Font font;
  if (Font::open({reinterpret_cast<const uint8_t*>(rom.data()), bytes.size()},
                 font) != Status::ok) {
    return 2;
  }
  std::vector<std::string> lines;
  std::ifstream text(arguments[4]);
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  const Distances all(font);
  std::map<std::pair<char, char>, double> distances;
  for (const char a : letters) {
    for (const char b : letters) {
      distances[{a, b}] = all.em(a, b);
    }
  }
  for (int32_t px = std::atoi(arguments[2]); px <= std::atoi(arguments[3]);
       ++px) {
    const Q26_6 size = Q26_6::from_int(px);
    const auto fitted = [&](uint8_t levels, Fit& fit) {
      Style style(size);
      if (Fit::make(font, style, {true, levels, FitOptions::kAll}, fit) ==
          Status::ok) {
        style.set_fit(fit);
      }
      return style;
    };
    static Fit grey;
    static Fit two;
    static Fit four;
    Mode modes[] = {{"grey", fitted(0, grey)},
                    {"two_fit", fitted(2, two)},
                    {"four_fit", fitted(4, four)},
                    {"two", two_level_style(size)},
                    {"four", four_level_style(size)}};
    static Bilevel bilevel(2);
    static Bilevel quad(4);
    bilevel = Bilevel(2, two.bilevel_weight());
    modes[1].style.set_effect(bilevel);
    modes[2].style.set_effect(quad);
    for (const Mode& mode : modes) {
      judge(font, mode, px, distances, lines);
    }
  }
  return 0;
}
