#include "inkcell/layout/bidi.hpp"

#include "bidi_levels.hpp"
#include "inkcell/layout/layout.hpp"

namespace inkcell {
namespace {

// Bidi_Class B.
bool ends_paragraph(uint32_t code_point) noexcept {
  return code_point == '\n' || code_point == '\r' ||
         (code_point >= 0x1c && code_point <= 0x1e) || code_point == 0x85 ||
         code_point == 0x2029;
}

// The bytes of the paragraph that `text` begins with, and whether it may hold
// anything but text from left to right.
__attribute__((noinline)) size_t paragraph_size(Text text,
                                                bool& is_mixed) noexcept {
  Text rest = text;
  is_mixed = false;
  while (rest.size != 0) {
    const uint32_t code_point = next_code_point(rest);
    constexpr uint32_t kFirstHebrew = 0x590;
    is_mixed = is_mixed || code_point >= kFirstHebrew;
    if (ends_paragraph(code_point)) {
      // A line feed belongs to the carriage return before it.
      if (code_point == '\r' && rest.size != 0 && rest.data[0] == '\n') {
        static_cast<void>(next_code_point(rest));
      }
      break;
    }
  }
  return text.size - rest.size;
}

// Levels of one line. Characters of more than one byte have their level in the
// first; the others are stepped over.
class LineLevels {
 public:
  LineLevels(const Bidi& bidi,
             Span<const uint16_t> cells,
             size_t begin,
             size_t end) noexcept
      : bidi_(bidi), cells_(cells), begin_(begin), end_(end) {}

  uint8_t level(size_t at) const noexcept { return bidi_.level(at); }

  size_t after(size_t at) const noexcept {
    do {
      ++at;
    } while (at < end_ && follows(at));
    return at;
  }
  size_t before(size_t at) const noexcept {
    do {
      --at;
    } while (at > begin_ && follows(at));
    return at;
  }

  // Extends [run.begin, run.end) to both sides over levels from run.level on,
  // up to `most`.
  void widen(BidiRun& run, uint8_t most = UINT8_MAX) const noexcept {
    const auto holds = [&](size_t at) noexcept {
      return level(at) >= run.level && level(at) <= most;
    };
    while (run.begin > begin_ && holds(before(run.begin))) {
      run.begin = before(run.begin);
    }
    while (run.end < end_ && holds(run.end)) {
      run.end = after(run.end);
    }
  }

  // Narrows a part that has at least its level, and begins (or ends, if that is
  // odd) as the levels do, to its leftmost run.
  void to_leftmost(BidiRun& part) const noexcept {
    for (;;) {
      // The character at the left end.
      const size_t at = part.is_right_to_left() ? before(part.end) : part.begin;
      const bool is_run = level(at) == part.level;
      part.begin = at;
      part.end = after(at);
      if (is_run) {
        widen(part, part.level);
        return;
      }
      ++part.level;
      widen(part);
    }
  }

  // Rule L2 as a tree: what has at least level k is read rightwards if k is
  // even, leftwards if it is odd, with the parts of higher levels in between.
  bool next(BidiRun& part) const noexcept {
    for (;;) {
      if (!part.is_right_to_left() && part.end < end_ &&
          level(part.end) >= part.level) {
        part.begin = part.end;
        part.end = after(part.end);
        break;
      }
      if (part.is_right_to_left() && part.begin > begin_ &&
          level(before(part.begin)) >= part.level) {
        part.end = part.begin;
        part.begin = before(part.begin);
        break;
      }
      if (part.level == 0) {
        return false;
      }
      widen(part);
      --part.level;
    }
    to_leftmost(part);
    return true;
  }

 private:
  bool follows(size_t at) const noexcept {
    const size_t cell = at - bidi_.begin();
    return cell < cells_.size &&
           (cells_[cell] & detail::BidiCell::kFollows) != 0;
  }

  const Bidi& bidi_;
  Span<const uint16_t> cells_;
  size_t begin_;
  size_t end_;
};

}  // namespace

void Bidi::resolve(const Text& text,
                   size_t begin,
                   BaseDirection direction) noexcept {
  constexpr size_t kMostCells = 65535;
  const char* const paragraph = text.data + begin;
  bool is_mixed = false;
  const size_t size = paragraph_size({paragraph, text.size - begin}, is_mixed);
  text_ = text.data;
  direction_ = direction;
  begin_ = begin;
  end_ = begin + size;
  count_ = 0;
  base_level_ = direction == BaseDirection::right_to_left ? 1 : 0;
  if (!is_mixed && base_level_ == 0) {
    return;
  }
  size_t count = size < cells_.size ? size : cells_.size;
  count = count < kMostCells ? count : kMostCells;
  detail::BidiLevels levels(paragraph, cells_.data,
                            static_cast<uint32_t>(count));
  count_ = levels.read();
  if (direction == BaseDirection::from_text) {
    base_level_ = levels.base_level();
  }
  levels.resolve(base_level_);
}

uint8_t Bidi::level(size_t offset) const noexcept {
  const size_t at = offset - begin_;
  return at < count_ ? detail::BidiCell::level(cells_[at]) : base_level_;
}

BidiRun Bidi::first_run(size_t begin, size_t end) const noexcept {
  BidiRun run = {begin, end, 0};
  LineLevels(*this, {cells_.data, count_}, begin, end).to_leftmost(run);
  return run;
}

bool Bidi::next_run(size_t begin, size_t end, BidiRun& run) const noexcept {
  return LineLevels(*this, {cells_.data, count_}, begin, end).next(run);
}

namespace detail {

const BidiOrder kBidiOrder = {
    [](const LayoutOptions& options, const Text& text, size_t begin) {
      options.bidi()->prepare(text, begin, options.direction);
      return options.bidi()->base_level();
    },
    [](const Bidi& bidi, size_t offset) { return bidi.level(offset); },
    [](const Bidi& bidi, size_t begin, size_t end) {
      return bidi.first_run(begin, end);
    },
    [](const Bidi& bidi, size_t begin, size_t end, BidiRun& run) {
      return bidi.next_run(begin, end, run);
    },
    [](uint32_t code_point) {
      const Mirror mirror = mirror_of(code_point);
      return mirror.kind == Mirror::none ? code_point : mirror.image;
    }};

}  // namespace detail
}  // namespace inkcell
