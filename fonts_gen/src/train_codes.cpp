// inkcell-train-codes: makes core/include/inkcell/packed_codes.hpp of the
// symbols that typical fonts need.
//
//   inkcell-train-codes FONT... > core/include/inkcell/packed_codes.hpp
//
// Encodes printable ASCII of each font with the codes that are built in, counts
// the symbols, and prints the code lengths that are best for all of them
// together. Repeat until nothing changes. The format is what it prints: a new
// table makes old packed fonts unreadable.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "char_set.hpp"
#include "error.hpp"
#include "field_glyph.hpp"
#include "field_stream.hpp"
#include "font_source.hpp"
#include "work_pool.hpp"

namespace inkcell::gen {
namespace {

// Symbols that never occurred get codes too: they may in other fonts.
constexpr double kUnseen = 0.25;

// The kind of the second and third field of a group after a new one: reused
// fields come first, so that symbol 0 has no code.
bool is_possible(const char* table, size_t context, size_t symbol) {
  return std::string(table) != "Kind" || context % 2 == 0 || symbol != 0;
}

// The lengths of the best prefix code of at most `longest` bits: packages of
// symbols are merged level by level (Larmore and Hirschberg 1990).
std::vector<int> code_lengths(const std::vector<double>& counts, int longest) {
  using Package = std::pair<double, std::vector<size_t>>;
  std::vector<Package> symbols;
  for (size_t i = 0; i < counts.size(); ++i) {
    symbols.push_back({counts[i], {i}});
  }
  std::sort(symbols.begin(), symbols.end());
  std::vector<Package> merged;
  for (int level = 0; level < longest; ++level) {
    std::vector<Package> all = symbols;
    all.insert(all.end(), merged.begin(), merged.end());
    std::sort(all.begin(), all.end());
    merged.clear();
    for (size_t i = 0; i + 1 < all.size(); i += 2) {
      Package package = all[i];
      package.first += all[i + 1].first;
      package.second.insert(package.second.end(), all[i + 1].second.begin(),
                            all[i + 1].second.end());
      merged.push_back(std::move(package));
    }
  }
  std::vector<int> lengths(counts.size());
  for (size_t i = 0; i + 1 < counts.size(); ++i) {
    for (const size_t symbol : merged[i].second) {
      ++lengths[symbol];
    }
  }
  return lengths;
}

template <size_t kContexts, size_t kSymbols>
void print_table(const char* name,
                 const uint64_t (&counts)[kContexts][kSymbols],
                 uint32_t longest) {
  std::printf(
      "inline constexpr uint8_t k%sLengths[k%sContexts][k%sSymbols] = {", name,
      name, name);
  for (size_t context = 0; context < kContexts; ++context) {
    std::vector<double> seen;
    for (size_t symbol = 0; symbol < kSymbols; ++symbol) {
      if (is_possible(name, context, symbol)) {
        seen.push_back(
            std::max(static_cast<double>(counts[context][symbol]), kUnseen));
      }
    }
    const std::vector<int> lengths =
        code_lengths(seen, static_cast<int>(longest));
    std::printf("%s\n    {", context == 0 ? "" : ",");
    size_t next = 0;
    for (size_t symbol = 0; symbol < kSymbols; ++symbol) {
      std::printf("%s%d", symbol == 0 ? "" : ", ",
                  is_possible(name, context, symbol) ? lengths[next++] : 0);
    }
    std::printf("}");
  }
  std::printf("};\n\n");
}

void add(const SymbolCounts& from, SymbolCounts& to) {
  const auto add_table = [](const auto& source, auto& target) {
    for (size_t i = 0; i < std::size(source); ++i) {
      for (size_t j = 0; j < std::size(source[i]); ++j) {
        target[i][j] += source[i][j];
      }
    }
  };
  add_table(from.node, to.node);
  add_table(from.kind, to.kind);
  add_table(from.rank, to.rank);
}

void count_font(const std::string& file, SymbolCounts& counts) {
  FontRequest request;
  request.file = file;
  add_ranges(kDefaultChars, request.characters);
  Warnings warnings;
  const SourceFont font = load_font(request, 0, warnings);
  AdfOptions options;
  options.cells = CellKind::fields;
  LoopOptions loop;
  std::vector<SymbolCounts> of_glyphs(font.glyphs.size());
  parallel_for(
      font.glyphs.size(), 0,
      [&](size_t i) {
        const Shape shape(font.glyphs[i].outline);
        if (!shape.empty()) {
          packed_record(build_fields(shape, options, loop).tree, &of_glyphs[i]);
        }
      },
      nullptr);
  for (const SymbolCounts& glyph : of_glyphs) {
    add(glyph, counts);
  }
}

void print_header(const SymbolCounts& counts) {
  std::printf(
      "// Code lengths of the packed coding's prefix codes (docs/FORMAT.md, "
      "\"Glyph\n// record, type 3\"): the decoder and the generator build "
      "their tables from\n// these. Codes are canonical: ascending by length, "
      "then by symbol. Made by\n// inkcell-train-codes.\n#pragma once\n\n"
      "#include <stdint.h>\n\nnamespace inkcell {\nnamespace packed_codes "
      "{\n\n");
  const auto constants = [](const char* name, size_t contexts, size_t symbols,
                            uint32_t bits) {
    std::printf("inline constexpr uint32_t k%sContexts = %zu;\n", name,
                contexts);
    std::printf("inline constexpr uint32_t k%sSymbols = %zu;\n", name, symbols);
    std::printf("inline constexpr uint32_t k%sMaxBits = %u;\n", name, bits);
  };
  using namespace packed_codes;
  constants("Node", kNodeContexts, kNodeSymbols, kNodeMaxBits);
  constants("Kind", kKindContexts, kKindSymbols, kKindMaxBits);
  constants("Rank", kRankContexts, kRankSymbols, kRankMaxBits);
  std::printf("\n/// Bits of each symbol; 0: the symbol does not occur.\n");
  print_table("Node", counts.node, kNodeMaxBits);
  print_table("Kind", counts.kind, kKindMaxBits);
  print_table("Rank", counts.rank, kRankMaxBits);
  std::printf("}  // namespace packed_codes\n}  // namespace inkcell\n");
}

int train(int count, char** files) {
  if (count == 0) {
    std::fprintf(stderr, "usage: inkcell-train-codes FONT...\n");
    return 2;
  }
  SymbolCounts counts;
  for (int i = 0; i < count; ++i) {
    std::fprintf(stderr, "%s\n", files[i]);
    count_font(files[i], counts);
  }
  print_header(counts);
  return 0;
}

}  // namespace
}  // namespace inkcell::gen

int main(int argc, char** argv) {
  try {
    return inkcell::gen::train(argc - 1, argv + 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
