// Unicode's conformance test of line breaking, rule by rule.
//
// Usage: check_line_break LineBreakTest.txt
#include <cstdio>
#include <map>
#include <set>

#include "inkcell/layout/line_break.hpp"
#include "ucd.hpp"

namespace {

// Code points that the library treats as letters.
bool is_left_out(uint32_t code_point) {
  return code_point >= 0x10000 && code_point < 0x1f000;
}

struct Count {
  size_t passed = 0;
  size_t failed = 0;
};

struct Totals {
  std::map<std::string, Count> rules;
  Count lines;
  Count left_out;
};

// A line is code points between signs, a division sign where a line may end;
// the comment names the rule in brackets after each sign.
void check(const std::string& line,
           const std::string& comment,
           Totals& totals) {
  std::string text;
  std::vector<size_t> offsets;
  std::set<size_t> expected;
  bool has_left_out = false;
  for (const std::string& word : ucd::words(line)) {
    if (word == "\xc3\xb7") {
      expected.insert(text.size());
    } else if (word != "\xc3\x97") {
      offsets.push_back(text.size());
      has_left_out |= is_left_out(ucd::hex(word));
      ucd::append(text, ucd::hex(word));
    }
  }
  std::vector<std::string> rules;
  for (size_t at = comment.find('['); at != std::string::npos;
       at = comment.find('[', at + 1)) {
    rules.push_back(comment.substr(at + 1, comment.find(']', at) - at - 1));
  }
  std::set<size_t> found;
  inkcell::LineBreaker breaker({text.data(), text.size()});
  inkcell::LineBreak place;
  while (breaker.next(place)) {
    found.insert(place.offset);
  }
  offsets.push_back(text.size());
  bool is_right = true;
  for (size_t i = 0; i != offsets.size(); ++i) {
    const bool same = found.count(offsets[i]) == expected.count(offsets[i]);
    is_right &= same;
    Count& rule = totals.rules[i < rules.size() ? rules[i] : "?"];
    ++(same ? rule.passed : rule.failed);
  }
  Count& count = has_left_out ? totals.left_out : totals.lines;
  ++(is_right ? count.passed : count.failed);
  if (!is_right && !has_left_out && totals.lines.failed < 20) {
    std::printf("%s #%s\n", line.c_str(), comment.c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: check_line_break LineBreakTest.txt\n");
    return 2;
  }
  Totals totals;
  ucd::for_each_line(
      argv[1], [&totals](const std::string& line, const std::string& comment) {
        check(line, comment, totals);
      });
  for (const auto& [rule, count] : totals.rules) {
    std::printf("rule %-7s %6zu passed, %zu failed\n", rule.c_str(),
                count.passed, count.failed);
  }
  std::printf("with U+10000 to U+1EFFF: %zu passed, %zu failed\n",
              totals.left_out.passed, totals.left_out.failed);
  std::printf("%zu passed, %zu failed\n", totals.lines.passed,
              totals.lines.failed);
  return totals.lines.failed == 0 && totals.lines.passed > 7000 ? 0 : 1;
}
