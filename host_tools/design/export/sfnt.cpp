#include "export/sfnt.hpp"

namespace inkcell::design {
namespace {

constexpr size_t kAdjustmentInHead = 8;
constexpr uint32_t kMagicSum = 0xb1b0afba;

uint32_t sum_of(const BigEndian& table) {
  uint32_t sum = 0;
  const std::vector<uint8_t>& bytes = table.bytes();
  for (size_t i = 0; i < bytes.size(); ++i) {
    sum += static_cast<uint32_t>(bytes[i]) << (24 - 8 * (i % 4));
  }
  return sum;
}

}  // namespace

std::vector<uint8_t> write_sfnt(
    const std::map<std::string, BigEndian>& tables) {
  BigEndian font;
  font.u32(0x00010000);
  font.u16(static_cast<unsigned>(tables.size()));
  font.search(tables.size(), 16);
  size_t at = 12 + 16 * tables.size();
  size_t head = 0;
  for (const auto& [tag, table] : tables) {
    font.text(tag);
    font.u32(sum_of(table));
    font.u32(static_cast<uint32_t>(at));
    font.u32(static_cast<uint32_t>(table.size()));
    head = tag == "head" ? at : head;
    at += (table.size() + 3) / 4 * 4;
  }
  for (const auto& [tag, table] : tables) {
    font.append(table);
    font.align(4);
  }
  font.set_u32(head + kAdjustmentInHead, kMagicSum - sum_of(font));
  return font.bytes();
}

}  // namespace inkcell::design
