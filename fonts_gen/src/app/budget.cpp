#include "app/budget.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

// Glyphs that the error names.
constexpr size_t kListedGlyphs = 5;

std::string bytes_of(size_t bytes) {
  return std::to_string(bytes) + " bytes";
}

std::string dearest_glyphs(const FontReport& report) {
  std::vector<const GlyphReport*> order;
  for (const GlyphReport& glyph : report.glyphs) {
    order.push_back(&glyph);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](auto* a, auto* b) { return a->bytes > b->bytes; });
  std::string text;
  for (size_t i = 0; i < std::min(kListedGlyphs, order.size()); ++i) {
    text += (i == 0 ? "" : ", ") + order[i]->name + " " +
            std::to_string(order[i]->bytes);
  }
  return text;
}

}  // namespace

size_t parse_bytes(const std::string& text) {
  size_t value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  const std::string unit(at, end);
  const size_t factor = unit.empty()  ? 1
                        : unit == "K" ? size_t{1} << 10
                        : unit == "M" ? size_t{1} << 20
                                      : 0;
  if (error != std::errc() || value == 0 || factor == 0 ||
      value > (uint64_t{1} << 32) / factor) {
    throw Error("--budget: '" + text +
                "' is no number of bytes; write 24576, 24K or 1M");
  }
  return value * factor;
}

RomFont generate_within(GenerateRequest request,
                        size_t budget,
                        const std::function<void(const std::string&)>& tell) {
  const auto told = [&](double tolerance, const std::string& what) {
    tell("tolerance " + std::to_string(static_cast<int>(tolerance)) +
         "/255: " + what);
  };
  request.target.tolerance = kCoarsest;
  request.tolerance_is_limit = false;
  RomFont best = generate(request);
  told(kCoarsest, bytes_of(best.bytes.size()));
  if (best.bytes.size() > budget) {
    throw Error("--budget " + std::to_string(budget) + ": the font takes " +
                bytes_of(best.bytes.size()) + " at the coarsest tolerance, " +
                std::to_string(kCoarsest) +
                "/255; leave out characters, or use --hints off. Most bytes: " +
                dearest_glyphs(best.report));
  }
  int fits = kCoarsest;
  for (int beyond = kFinest - 1; fits - beyond > 1;) {
    const int middle = (fits + beyond) / 2;
    request.target.tolerance = middle;
    request.tolerance_is_limit = middle < Target().tolerance;
    std::optional<RomFont> font;
    try {
      font = generate(request);
    } catch (const Error&) {
      told(middle, "cannot be held");
      beyond = middle;
      continue;
    }
    const bool is_within = font->bytes.size() <= budget;
    told(middle,
         bytes_of(font->bytes.size()) + (is_within ? "" : ", too many"));
    if (is_within) {
      best = *std::move(font);
      fits = middle;
    } else {
      beyond = middle;
    }
  }
  return best;
}

}  // namespace inkcell::gen
