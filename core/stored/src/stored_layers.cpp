#include "stored_layers.hpp"

#include "stored_store.hpp"

namespace inkcell {

uint32_t detail::StoredStore::layers_word(const Font& font,
                                          uint32_t at) noexcept {
  StoredStore& self = store_of(*font.pages_);
  uint32_t block = at / self.block_bytes_;
  uint32_t place = at - block * self.block_bytes_;
  block += self.before_layers() + 1;
  const uint8_t* bytes = self.load_index(block);
  uint32_t word = 0;
  for (uint32_t shift = 0; bytes != nullptr && shift != 32; shift += 8) {
    word |= uint32_t{bytes[place]} << shift;
    if (++place == self.block_bytes_ && shift != 24) {
      place = 0;
      bytes = self.load_index(block + 1);
    }
  }
  return bytes == nullptr ? 0 : word;
}

StoredLayers StoredFont::layers() const noexcept {
  return {&font(), store_ == nullptr ? 0 : store_->layers_bytes(),
          detail::StoredStore::layers_word};
}

}  // namespace inkcell
