#include "inkcell/stored/stored_font.hpp"

#include "stored_store.hpp"

namespace inkcell {
namespace {

constexpr Font kNoFont;

}  // namespace

Status StoredFont::open(const Storage& storage,
                        Span<uint8_t> ram,
                        const Coding& coding,
                        StoredFont& out) noexcept {
  using detail::StoredStore;
  static_assert(sizeof(StoredStore) <= kStoreBytes, "see ram_bytes()");
  static_assert(sizeof(StoredStore) % 4 == 0 && alignof(StoredStore) <= 8);
  if (reinterpret_cast<uintptr_t>(ram.data) % 8 != 0) {
    return Status::misaligned;
  }
  if (ram.size < sizeof(StoredStore) + format::paged::kMaxResidentBytes) {
    return Status::buffer_small;
  }
  auto* const store = reinterpret_cast<StoredStore*>(ram.data);
  INKCELL_TRY(store->open(storage, ram, coding));
  out.store_ = store;
  return Status::ok;
}

const Font& StoredFont::font() const noexcept {
  return store_ == nullptr ? kNoFont : store_->font();
}

Status StoredFont::status() const noexcept {
  return store_ == nullptr ? Status::ok : store_->status();
}

void StoredFont::clear() noexcept {
  if (store_ != nullptr) {
    store_->clear();
  }
}

StoredStats StoredFont::stats() const noexcept {
  return store_ == nullptr ? StoredStats{} : store_->stats();
}

Status StoredFont::verify() noexcept {
  return store_ == nullptr ? Status::ok : store_->verify();
}

}  // namespace inkcell
