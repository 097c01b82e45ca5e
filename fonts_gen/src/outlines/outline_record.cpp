#include "outlines/outline_record.hpp"

#include <algorithm>
#include <string>

#include "base/bit_writer.hpp"
#include "shape/outline.hpp"

namespace inkcell::gen {
namespace {

constexpr int kTypeComposite = 3;

const CodeWord& word_of(const OutlineStep& step,
                        const OutlineCode& code,
                        size_t table) {
  const CodeWord* word = code.find(step, table);
  if (word == nullptr) {
    throw GeometryError(GeometryError::Kind::too_large,
                        "no code word holds the step " +
                            std::to_string(step.dx) + ", " +
                            std::to_string(step.dy) + " of the outline");
  }
  return *word;
}

int offset_bits(const OutlineReference& reference) {
  return std::max(step_bits(reference.dx), step_bits(reference.dy));
}

bool is_mirrored(const OutlineReference& reference) {
  const auto& [xx, xy, yx, yy] = reference.matrix_q14;
  return int64_t{xx} * yy <= int64_t{xy} * yx;
}

bool fits_record(const OutlineReference& reference) {
  return reference.glyph <= 0xffff && !is_mirrored(reference) &&
         offset_bits(reference) <= kMostStepBits &&
         std::all_of(reference.matrix_q14.begin(), reference.matrix_q14.end(),
                     [](int value) { return step_bits(value) <= 16; });
}

}  // namespace

std::vector<uint8_t> outline_record(const std::vector<OutlineStep>& steps,
                                    const OutlineCode& code) {
  BitWriter bits;
  bits.put(1, 1);
  size_t table = 0;
  for (size_t i = 0; i < steps.size(); ++i) {
    const CodeWord& word = word_of(steps[i], code, table);
    const int shared = word.shares_bit ? 1 : 0;
    bits.put(word.word >> shared, word.length - shared);
    bits.put(steps[i].dx, word.symbol.x_bits);
    bits.put(steps[i].dy, word.symbol.y_bits);
    if (steps[i].kind == WordKind::end) {
      bits.put(i + 1 < steps.size() ? 1 : 0, 1);
    }
    table = word.next_table;
  }
  return bits.take();
}

size_t outline_bits(const std::vector<OutlineStep>& steps,
                    const OutlineCode& code) {
  int bits = 1;
  size_t table = 0;
  for (const OutlineStep& step : steps) {
    const CodeWord& word = word_of(step, code, table);
    bits += word.total_bits();
    bits += step.kind == WordKind::end ? 1 : 0;
    table = word.next_table;
  }
  return static_cast<size_t>(bits);
}

bool fits_record(const OutlineReferences& references) {
  return std::all_of(
      references.begin(), references.end(),
      [](const OutlineReference& reference) { return fits_record(reference); });
}

std::vector<uint8_t> composite_record(const OutlineReferences& references) {
  BitWriter bits;
  bits.put(kTypeComposite, 8);
  for (size_t i = 0; i < references.size(); ++i) {
    const OutlineReference& reference = references[i];
    const int width = offset_bits(reference);
    bits.put(static_cast<int>(reference.glyph), 16);
    bits.put(reference.has_matrix() ? 1 : 0, 1);
    bits.put(width, 4);
    bits.put(reference.dx, width);
    bits.put(reference.dy, width);
    if (reference.has_matrix()) {
      for (const int value : reference.matrix_q14) {
        bits.put(value, 16);
      }
    }
    bits.put(i + 1 < references.size() ? 1 : 0, 1);
  }
  return bits.take();
}

size_t composite_bits(const OutlineReferences& references) {
  int bits = 8;
  for (const OutlineReference& reference : references) {
    bits += 16 + 1 + 4 + 2 * offset_bits(reference) + 1;
    bits += reference.has_matrix() ? 4 * 16 : 0;
  }
  return static_cast<size_t>(bits);
}

}  // namespace inkcell::gen
