// Unicode's conformance tests of bidirectional order.
//
// Usage: check_bidi BidiTest.txt BidiCharacterTest.txt
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "inkcell/layout/bidi.hpp"
#include "ucd.hpp"

namespace {

using inkcell::BaseDirection;
using inkcell::Bidi;
using inkcell::BidiRun;

// A character of each class.
const std::map<std::string, uint32_t> kSamples = {
    {"L", 'a'},      {"R", 0x5d0},    {"AL", 0x627},   {"EN", '0'},
    {"ES", '+'},     {"ET", '$'},     {"AN", 0x661},   {"CS", ','},
    {"NSM", 0x300},  {"BN", 0xad},    {"B", 0x2029},   {"S", '\t'},
    {"WS", ' '},     {"ON", '!'},     {"LRE", 0x202a}, {"LRO", 0x202d},
    {"RLE", 0x202b}, {"RLO", 0x202e}, {"PDF", 0x202c}, {"LRI", 0x2066},
    {"RLI", 0x2067}, {"FSI", 0x2068}, {"PDI", 0x2069}};

// The expected result of a line.
struct Expected {
  std::vector<std::string> levels;  // x: any
  std::vector<size_t> order;        // visual, without those
  int base_level = -1;              // any
};

struct Count {
  size_t passed = 0;
  size_t failed = 0;
};

// Characters by their visual position, from runs.
std::vector<size_t> order_of(const Bidi& bidi,
                             const std::string& text,
                             const std::vector<size_t>& offsets) {
  std::vector<size_t> order;
  BidiRun run = bidi.first_run(0, text.size());
  do {
    std::vector<size_t> inside;
    for (size_t i = 0; i != offsets.size(); ++i) {
      if (offsets[i] >= run.begin && offsets[i] < run.end) {
        inside.push_back(i);
      }
    }
    if (run.is_right_to_left()) {
      inside = {inside.rbegin(), inside.rend()};
    }
    order.insert(order.end(), inside.begin(), inside.end());
  } while (order.size() < offsets.size() && bidi.next_run(0, text.size(), run));
  return order;
}

bool is_right(const std::vector<uint32_t>& line,
              BaseDirection direction,
              const Expected& expected) {
  std::string text;
  std::vector<size_t> offsets;
  for (const uint32_t code_point : line) {
    offsets.push_back(text.size());
    ucd::append(text, code_point);
  }
  std::vector<uint16_t> cells(text.size());
  Bidi bidi({cells.data(), cells.size()});
  bidi.resolve({text.data(), text.size()}, 0, direction);
  if (expected.base_level >= 0 && bidi.base_level() != expected.base_level) {
    return false;
  }
  for (size_t i = 0; i != offsets.size(); ++i) {
    if (expected.levels[i] != "x" &&
        std::to_string(bidi.level(offsets[i])) != expected.levels[i]) {
      return false;
    }
  }
  std::vector<size_t> kept;
  for (const size_t at : order_of(bidi, text, offsets)) {
    if (expected.levels[at] != "x") {
      kept.push_back(at);
    }
  }
  return kept == expected.order;
}

void report(const std::string& line, Count& count, bool is_passed) {
  ++(is_passed ? count.passed : count.failed);
  if (!is_passed && count.failed <= 10) {
    std::printf("%s\n", line.c_str());
  }
}

std::vector<size_t> numbers(const std::string& text) {
  std::vector<size_t> found;
  for (const std::string& word : ucd::words(text)) {
    found.push_back(std::stoul(word));
  }
  return found;
}

// Lines of classes. A bit set gives the directions: from the text, left to
// right, right to left.
Count check_classes(const std::string& file) {
  constexpr BaseDirection kDirections[] = {BaseDirection::from_text,
                                           BaseDirection::left_to_right,
                                           BaseDirection::right_to_left};
  Count count;
  Expected expected;
  ucd::for_each_line(file, [&](const std::string& line, const std::string&) {
    if (line.rfind("@Levels:", 0) == 0) {
      expected.levels = ucd::words(line.substr(8));
    } else if (line.rfind("@Reorder:", 0) == 0) {
      expected.order = numbers(line.substr(9));
    } else {
      const std::vector<std::string> fields = ucd::split(line, ';');
      std::vector<uint32_t> text;
      for (const std::string& name : ucd::words(fields[0])) {
        text.push_back(kSamples.at(name));
      }
      const uint32_t set = ucd::hex(fields[1]);
      for (uint32_t i = 0; i != 3; ++i) {
        if ((set >> i & 1) != 0) {
          report(line, count, is_right(text, kDirections[i], expected));
        }
      }
    }
  });
  return count;
}

// Lines of code points; direction, level of the paragraph, levels, order.
Count check_characters(const std::string& file) {
  Count count;
  ucd::for_each_line(file, [&](const std::string& line, const std::string&) {
    const std::vector<std::string> fields = ucd::split(line, ';');
    std::vector<uint32_t> text;
    for (const std::string& word : ucd::words(fields[0])) {
      text.push_back(ucd::hex(word));
    }
    const BaseDirection direction =
        fields[1] == "0"   ? BaseDirection::left_to_right
        : fields[1] == "1" ? BaseDirection::right_to_left
                           : BaseDirection::from_text;
    report(line, count,
           is_right(text, direction,
                    {ucd::words(fields[3]), numbers(fields[4]),
                     std::stoi(fields[2])}));
  });
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr,
                 "usage: check_bidi BidiTest.txt BidiCharacterTest.txt\n");
    return 2;
  }
  const Count classes = check_classes(argv[1]);
  std::printf("classes: %zu passed, %zu failed\n", classes.passed,
              classes.failed);
  const Count characters = check_characters(argv[2]);
  std::printf("%zu passed, %zu failed\n", classes.passed + characters.passed,
              classes.failed + characters.failed);
  const bool all = classes.passed > 700000 && characters.passed > 90000;
  return all && classes.failed + characters.failed == 0 ? 0 : 1;
}
