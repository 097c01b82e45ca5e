#include "bidi_class.hpp"

namespace inkcell::detail {
namespace {

Mirror image_of(uint32_t image, bool is_first, uint32_t kind) noexcept {
  if (kind == MirrorBlock::no_brackets) {
    return {image, Mirror::plain};
  }
  const bool opens = is_first == (kind == MirrorBlock::first_opens);
  return {image, opens ? Mirror::opens : Mirror::closes};
}

}  // namespace

Mirror mirror_of(uint32_t code_point) noexcept {
  for (uint32_t i = 0; i != kMirrorBlockCount; ++i) {
    const MirrorBlock& block = kMirrorBlocks[i];
    const uint32_t distance = block.distance();
    const uint32_t count = block.count();
    const uint32_t step = code_point - block.first;  // wraps below it
    const bool is_row = distance == 1;
    if (step < (is_row ? 2 * count : count)) {
      const bool is_first = !is_row || step % 2 == 0;
      return image_of(is_first ? code_point + distance : code_point - 1,
                      is_first, block.kind());
    }
    if (!is_row && step - distance < count) {
      return image_of(code_point - distance, false, block.kind());
    }
  }
  return {};
}

}  // namespace inkcell::detail
