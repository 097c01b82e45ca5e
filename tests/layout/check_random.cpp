// Random texts in random boxes: checks the invariants of layout.
//
// Usage: check_random FONT CJK_FONT [COUNT [FIRST]]
//
// A text depends only on its number, so `COUNT 1, FIRST n` repeats text n.
// Drawing is compared for one text in a hundred.
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "inkcell/fit.hpp"
#include "inkcell/layout/label.hpp"
#include "inkcell/layout/text_box.hpp"
#include "inkcell/port/a8.hpp"
#include "line_cursor.hpp"
#include "random.hpp"
#include "rom_file.hpp"
#include "text/blank.hpp"
#include "ucd.hpp"

namespace {

using namespace inkcell;

// Layout and drawing must not allocate.
size_t allocations = 0;

// Pieces of texts, by kind.
// clang-format off
constexpr const char* kPieces[] = {
    // words
    "a", "to", "word", "Affinity", "WAVE", "longer-hyphened", "x",
    // signs and numbers
    ".", ",", "(", ")", "[", "]", "\"", "/", "12", "3.14", "$9", "100%", "-",
    // blanks and line ends
    " ", " ", " ", " ", " ", "  ", "\t", "\n", "\r\n",
    // marks and what shows nothing
    "\u00a0", "\u00ad", "co\u00adop", "\u200b", "\u2060", "\u200d", "\ufe0f",
    "e\u0301", "\u0301", "\u2026",
    // from right to left, and controls
    "\u05d0\u05d1\u05d2", "\u05e9\u05b8\u05dc", "\u05d0", "\u0627\u0644",
    "\u0661\u0662", "\u200f", "\u202b", "\u202c", "\u2067", "\u2069",
    // of the East, emoji
    "\u4e00", "\u6f22\u5b57", "\u3002", "\u300c", "\u300d", "\u30fc", "\u3000",
    "\ud55c", "\U0001f600", "\U0001f1e9\U0001f1ea",
    // no UTF-8, and line ends that few know
    "\xff", "\xe2\x80", "\xc3", "\x80", "\u2028", "\x0b",
};
// clang-format on

// One layout, made from a number.
struct Trial {
  Random random;
  std::string text;
  Style styles[2];
  Fit fits[2];
  Face fallback[1];
  uint16_t cells[4096] = {};
  Bidi bidi;
  Q26_6 stops[2];
  TextBox box;
  int32_t width = 0;

  Trial(uint32_t id, const Font& font, const Font& cjk)
      : random(id * 2654435761u + 1), bidi(cells) {
    static_cast<void>(random.next());
    const uint32_t pieces = random.below(24);
    const uint32_t kinds = std::size(kPieces);
    for (uint32_t i = 0; i != pieces; ++i) {
      text += kPieces[random.below(kinds)];
    }
    make_styles(font, cjk);
    make_style();
  }

  bool has(uint32_t one_in) { return random.below(one_in) == 0; }

  void make_styles(const Font& font, const Font& cjk) {
    const Font* const fonts[] = {&font, &cjk};
    const bool is_fitted = has(3);
    const auto size = Q26_6::from_raw(random.between(8 * 64, 30 * 64));
    for (int i = 0; i != 2; ++i) {
      const auto own = has(2) ? size : Q26_6::from_raw(size.raw * 3 / 4 + 64);
      styles[i] = Style(i == 0 ? size : own, kFilterText);
      if (is_fitted) {
        FitOptions options;
        options.across = true;
        if (Fit::make(*fonts[i], styles[i], options, fits[i]) != Status::ok) {
          std::exit(2);
        }
        styles[i].set_fit(fits[i]);
      }
    }
    width = random.between(1, 300);
    const int32_t x = random.between(-20, 40);
    const int32_t y = random.between(-20, 40);
    box =
        TextBox(font, styles[0], {x, y, x + width, y + random.between(1, 120)},
                static_cast<Align>(random.below(5)));
    fallback[0] = {&cjk, &styles[1]};
  }

  void make_style() {
    LayoutOptions& options = box.options;
    box.vertical = static_cast<VerticalAlign>(random.below(4));
    options.wraps = !has(4);
    options.ellipsis = static_cast<Ellipsis>(random.below(3));
    options.tabular_digits = has(3);
    options.direction = static_cast<BaseDirection>(random.below(3));
    if (has(2)) {
      options.fallback = fallback;
    }
    if (has(3)) {
      options.letter_spacing = Q26_6::from_raw(random.between(-64, 200));
    }
    if (has(4)) {
      options.line_height = Q26_6::from_raw(random.between(64, 40 * 64));
    }
    if (has(3)) {
      stops[0] = Q26_6::from_raw(random.between(0, 80 * 64));
      stops[1] = Q26_6::from_raw(random.between(80 * 64, 160 * 64));
      options.tab_stops = stops;
      options.tab_width = Q26_6::from_raw(random.between(0, 50 * 64));
    }
    if (!has(3)) {
      options.set_bidi(bidi);
    }
  }

  Text view() const { return {text.data(), text.size()}; }
  Q26_6 room() const { return Q26_6::from_int(width); }
};

// The first failed check of a trial.
const char* wrong = nullptr;
int reports = 0;

bool check(bool condition, const char* what) {
  if (!condition && wrong == nullptr) {
    wrong = what;
  }
  return condition;
}

// Places where lines may end, and the starts of characters.
std::set<size_t> places(Text text) {
  std::set<size_t> found;
  LineBreaker breaker(text);
  LineBreak place;
  while (breaker.next(place)) {
    found.insert(place.offset);
  }
  return found;
}

std::vector<size_t> offsets(Text text) {
  std::vector<size_t> found;
  Text rest = text;
  while (rest.size != 0) {
    found.push_back(text.size - rest.size);
    static_cast<void>(next_code_point(rest));
  }
  found.push_back(text.size);
  return found;
}

// The visible characters of a line, without marks.
size_t letters(Text text, const TextLine& line) {
  size_t count = 0;
  Text rest(text.data + line.begin, line.length);
  while (rest.size != 0) {
    const size_t at = line.length - rest.size;
    const uint32_t code_point = next_code_point(rest);
    const bool is_skipped =
        at >= line.skip_at && at < size_t{line.skip_at} + line.skip_length;
    count += is_skipped || detail::is_mark(code_point) ||
                     detail::shown_as(code_point) == detail::Shown::nothing
                 ? 0u
                 : 1u;
  }
  return count;
}

// The start of the first of them.
size_t first_letter(Text text, const TextLine& line) {
  Text rest(text.data + line.begin, line.length);
  size_t at = line.begin;
  while (rest.size != 0 &&
         detail::shown_as(next_code_point(rest)) != detail::Shown::glyph) {
    at = line.end() - rest.size;
  }
  return at;
}

void check_cells(const Trial& trial, const TextLine& line) {
  const Text text = trial.view();
  const Painter painter;
  const detail::Setting setting = {trial.box.options, painter};
  detail::LineCursor cursor(setting, text, line);
  cursor.align(trial.room());
  detail::LineCell cell;
  std::set<uint32_t> seen;
  int32_t digit_width = -1;
  while (cursor.next(cell)) {
    if (cell.is_added) {
      continue;
    }
    check(seen.insert(cell.begin).second, "a character stands twice");
    Text rest(trial.text.data() + cell.begin, trial.text.size() - cell.begin);
    const uint32_t code_point = next_code_point(rest);
    const detail::Shown shown = detail::shown_as(code_point);
    if (trial.box.options.tabular_digits && code_point >= '0' &&
        code_point <= '9') {
      const int32_t width = cell.x_end - cell.x;
      check(digit_width < 0 || width == digit_width, "a digit is not as wide");
      check(width > 0, "a digit has no width");
      digit_width = width;
    }
    check(!cell.has_ink || shown == detail::Shown::glyph, "a blank is drawn");
    check(cell.x_end == cell.x || shown != detail::Shown::nothing,
          "a character of no width has one");
  }
  size_t shown = 0;
  for (const size_t at : offsets(trial.view())) {
    const size_t skip = line.begin + size_t{line.skip_at};
    shown += at >= line.begin && at < line.end() &&
             !(at >= skip && at < skip + line.skip_length);
  }
  check(seen.size() == shown, "a character is missing");
  check(cursor.pen().at() == cursor.right(), "the line is not as wide");
}

// Lines are in the order of the text, without gaps; none is too wide; none ends
// where it must not.
void check_lines(const Trial& trial) {
  const LayoutOptions& options = trial.box.options;
  const Text text = trial.view();
  const std::set<size_t> allowed = places(text);
  const Painter painter;
  const detail::Setting setting = {options, painter};
  const detail::Pen pen(setting, detail::Pen::logical);
  const int32_t room = pen.from_px(trial.room());
  TextLine line;
  size_t next = 0;
  bool is_last = false;
  while (next_line(options, {}, text, trial.room(), line)) {
    check(!is_last, "a line follows the last");
    check(line.begin == next, "lines leave a gap");
    check(line.end() <= line.next, "a line ends after the start of the next");
    check(line.next > line.begin || line.is_last, "a line is no further");
    const int32_t width = pen.from_units(line.width);
    const bool is_bound = options.wraps || line.has_ellipsis;
    check(!is_bound || width <= room ||
              letters(text, line) <= (line.has_ellipsis ? 0u : 1u),
          "a line is too wide");
    if (options.wraps && line.length != 0 && allowed.count(line.next) == 0) {
      const auto first = allowed.upper_bound(first_letter(text, line));
      // A hyphen may need room that its word did not.
      check(first == allowed.end() || *first > line.next ||
                static_cast<uint8_t>(text.data[*first - 1]) == 0xad,
            "a line ends within a word");
    }
    check_cells(trial, line);
    next = line.next;
    is_last = line.is_last;
  }
  check(is_last && next == text.size, "lines do not reach the end");
}

void check_carets(const Trial& trial) {
  const Text text = trial.view();
  for (const size_t offset : offsets(text)) {
    const Rect caret = trial.box.caret(text, {}, {offset, false});
    const TextPlace place = trial.box.hit(text, {}, caret.x0, caret.y0);
    const Rect again = trial.box.caret(text, {}, place);
    const bool is_same =
        caret.x0 == again.x0 && caret.y0 == again.y0 && caret.y1 == again.y1;
    if (!check(is_same, "a hit leads to another caret") && reports < 20) {
      std::printf("offset %zu: %d, %d to %d; hit %zu: %d, %d to %d\n", offset,
                  caret.x0, caret.y0, caret.y1, place.offset, again.x0,
                  again.y0, again.y1);
    }
    check(place.offset <= text.size, "a hit after the text");
  }
}

constexpr int32_t kSide = 160;
using Picture = std::vector<uint8_t>;

// Draws strips of some rows, with lines that are laid out each time or once.
Picture draw(const Trial& trial, int32_t rows, Span<const TextLine> lines) {
  Picture picture(kSide * kSide);
  const size_t before = allocations;
  for (int32_t y = 0; y < kSide; y += rows) {
    const int32_t height = y + rows < kSide ? rows : kSide - y;
    Strip strip;
    strip.pixels = {picture.data() + y * kSide,
                    static_cast<size_t>(height * kSide)};
    strip.y0 = y;
    strip.width = kSide;
    strip.height = height;
    strip.stride = kSide;
    const port::A8Canvas canvas(strip);
    check(canvas.status() == Status::ok, "no canvas");
    trial.box.draw(trial.view(), canvas, lines);
  }
  check(allocations == before, "drawing allocates");
  return picture;
}

bool is_outside(const Picture& picture, const Rect& rect) {
  for (int32_t y = 0; y != kSide; ++y) {
    for (int32_t x = 0; x != kSide; ++x) {
      const bool is_in =
          x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
      if (!is_in && picture[static_cast<size_t>(y * kSide + x)] != 0) {
        return true;
      }
    }
  }
  return false;
}

size_t inked = 0;

void check_drawing(const Trial& trial) {
  const Picture whole = draw(trial, kSide, {});
  for (const uint8_t pixel : whole) {
    inked += pixel != 0 ? 1 : 0;
  }
  check(!is_outside(whole, trial.box.box(trial.view(), {})),
        "ink outside of what box() tells");
  check(!is_outside(whole, trial.box.clip), "ink outside the clip");
  check(draw(trial, 7, {}) == whole, "strips differ");
  std::vector<TextLine> room(trial.text.size() + 1);
  Span<const TextLine> lines;
  check(trial.box.lay_out(trial.view(), {}, {room.data(), room.size()},
                          lines) == Status::ok,
        "lines do not fit");
  check(draw(trial, 16, lines) == whole, "kept lines differ");
}

// Prints a text as a literal, and its settings.
void print(const Trial& trial) {
  for (const char c : trial.text) {
    const auto byte = static_cast<unsigned>(static_cast<uint8_t>(c));
    std::printf(byte < 0x20 || byte > 0x7e ? "\\x%02x" : "%c", byte);
  }
  const LayoutOptions& options = trial.box.options;
  std::printf(
      "\n  %d px, align %d, ellipsis %d, wraps %d, tabular %d, bidi %d, "
      "fallback %zu, spacing %d, fitted %d\n",
      trial.width, static_cast<int>(options.align),
      static_cast<int>(options.ellipsis), options.wraps, options.tabular_digits,
      options.bidi() != nullptr, options.fallback.size,
      options.letter_spacing.raw, trial.styles[0].has_whole_advances());
  TextLine line;
  while (next_line(options, {}, trial.view(), trial.room(), line)) {
    std::printf("  [%u, %u) next %u, skip %u + %u, width %d, level %d%s\n",
                line.begin, line.end(), line.next, line.skip_at,
                line.skip_length, line.width, line.base_level,
                line.has_hyphen ? ", hyphen" : "");
  }
}

// A letter with more marks than a line may hold must not stop layout.
bool try_endless_marks(const Font& font) {
  std::string text = "a";
  for (size_t i = 0; i != 40000; ++i) {
    text += "\xcc\x81";
  }
  const Style style(12_px, kFilterText);
  const LayoutOptions options(font, style);
  TextLine line;
  size_t lines = 0;
  while (lines < 10 && next_line(options, {}, {text.data(), text.size()},
                                 Q26_6::from_int(100), line)) {
    ++lines;
  }
  const bool is_ok = line.is_last && line.next == text.size() && lines >= 2;
  if (!is_ok) {
    std::printf("a letter with 40,000 marks: %zu lines\n", lines);
  }
  return is_ok;
}

bool try_one(uint32_t id, const Font& font, const Font& cjk) {
  wrong = nullptr;
  const Trial trial(id, font, cjk);
  const size_t before = allocations;
  static_cast<void>(trial.box.measure(trial.view(), {}));
  check(allocations == before, "measuring allocates");
  check_lines(trial);
  check_carets(trial);
  if (id % 100 == 0) {
    check_drawing(trial);
  }
  if (wrong != nullptr && reports < 20) {
    ++reports;
    std::printf("text %u: %s\n  ", id, wrong);
    print(trial);
  }
  return wrong == nullptr;
}

}  // namespace

void* operator new(size_t size) {
  ++allocations;
  void* const memory = std::malloc(size);
  if (memory == nullptr) {
    std::abort();
  }
  return memory;
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}

int main(int argc, char** argv) {
  if (argc < 3 || argc > 5) {
    std::fprintf(stderr, "usage: check_random FONT CJK_FONT [COUNT [FIRST]]\n");
    return 2;
  }
  const RomFile font_file(argv[1]);
  const RomFile cjk_file(argv[2]);
  const Font& font = font_file.font();
  const Font& cjk = cjk_file.font();
  const auto count =
      static_cast<uint32_t>(argc > 3 ? std::atoi(argv[3]) : 10000);
  const auto first = static_cast<uint32_t>(argc > 4 ? std::atoi(argv[4]) : 0);
  size_t failed = try_endless_marks(font) ? 0 : 1;
  for (uint32_t id = first; id != first + count; ++id) {
    failed += try_one(id, font, cjk) ? 0u : 1u;
  }
  std::printf("%zu pixels of ink\n%zu passed, %zu failed\n", inked,
              count + 1 - failed, failed);
  return failed == 0 && (count < 1000 || inked > 10000) ? 0 : 1;
}
