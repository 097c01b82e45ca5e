#include "rom/character_runs.hpp"

#include "base/byte_writer.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::gen {
namespace {

namespace pages = format::code_pages;

constexpr uint32_t kMostExtra = 0xffff;
// Their last run may have as many code points as 8 bytes are worth.
constexpr uint32_t kMostOnPages = 0xe000;

uint32_t page_of(char32_t code_point) {
  return static_cast<uint32_t>(code_point) >> 8;
}

}  // namespace

CharacterRuns::CharacterRuns(const std::map<char32_t, uint16_t>& glyph_of) {
  for (const auto& [code_point, glyph] : glyph_of) {
    if (!runs_.empty()) {
      Run& last = runs_.back();
      const uint32_t step = last.extra + 1;
      if (code_point == last.first + step && glyph == last.glyph + step &&
          step <= kMostExtra) {
        last.extra = step;
        continue;
      }
    }
    runs_.push_back({code_point, 0, glyph});
  }
  find_pages();
}

// Finds the runs in a row that save most: an entry of CMAP each, for a byte a
// code point and a start a page.
void CharacterRuns::find_pages() {
  constexpr int64_t kOfAll = format::section::kBytes + pages::kBytes + 4;
  int64_t most = 0;
  int64_t saved = 0;
  size_t from = 0;
  for (size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    const auto starts_after = [&run](char32_t code_point) {
      return 2 * (int64_t{page_of(run.first + run.extra)} -
                  int64_t{page_of(code_point)});
    };
    const int64_t own = int64_t{format::cmap::kBytes} - int64_t{run.extra} - 1;
    const int64_t alone = own - kOfAll - starts_after(run.first);
    const bool follows =
        i != 0 && runs_[i - 1].glyph + runs_[i - 1].extra + 1 == run.glyph;
    if (follows) {
      saved += own - starts_after(runs_[i - 1].first + runs_[i - 1].extra);
    }
    if (!follows || saved <= alone) {
      saved = alone;
      from = i;
    }
    // Places of a section are u16.
    const bool has_room = run.glyph - runs_[from].glyph < kMostOnPages;
    if (saved > most && has_room) {
      most = saved;
      paged_from_ = from;
      paged_to_ = i + 1;
    }
  }
}

std::vector<uint8_t> CharacterRuns::entries(size_t without_from,
                                            size_t without_to) const {
  Bytes out;
  for (size_t i = 0; i < runs_.size(); ++i) {
    if (i < without_from || i >= without_to) {
      put_u32(out, static_cast<uint32_t>(runs_[i].first));
      put_u16(out, runs_[i].extra);
      put_u16(out, runs_[i].glyph);
    }
  }
  return out;
}

std::vector<uint8_t> CharacterRuns::cmap_section() const {
  return entries(paged_from_, paged_to_);
}

std::vector<uint8_t> CharacterRuns::cmap_of_all() const {
  return entries(0, 0);
}

std::vector<uint8_t> CharacterRuns::code_pages_section() const {
  Bytes out;
  if (paged_from_ == paged_to_) {
    return out;
  }
  const Run& last = runs_[paged_to_ - 1];
  const uint32_t first_page = page_of(runs_[paged_from_].first);
  const uint32_t count = page_of(last.first + last.extra) - first_page + 1;
  std::vector<unsigned> starts(count + 1);
  Bytes low;
  for (size_t i = paged_from_; i < paged_to_; ++i) {
    for (uint32_t step = 0; step <= runs_[i].extra; ++step) {
      const char32_t code_point = runs_[i].first + step;
      low.push_back(static_cast<uint8_t>(code_point & 0xff));
      starts[page_of(code_point) - first_page + 1] =
          static_cast<unsigned>(low.size());
    }
  }
  const auto header = static_cast<unsigned>(pages::kBytes + 2 * (count + 1));
  put_u16(out, first_page);
  put_u16(out, count);
  put_u16(out, (runs_[paged_from_].glyph - header) & 0xffff);
  unsigned start = 0;
  for (const unsigned end : starts) {
    start = end != 0 ? end : start;
    put_u16(out, header + start);
  }
  out.insert(out.end(), low.begin(), low.end());
  return out;
}

}  // namespace inkcell::gen
