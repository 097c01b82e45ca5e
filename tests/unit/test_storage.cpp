// The reads of docs/BUILD.md, over models of FatFs, littlefs and a flash
// chip.
#include "check.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "storage_models.hpp"

namespace {

using namespace inkcell;

// FatFs: context is an open FIL.
bool read_fat(void* context, uint32_t offset, uint8_t* bytes, uint32_t count) {
  auto* const file = static_cast<FIL*>(context);
  UINT done = 0;
  return f_lseek(file, offset) == FR_OK &&
         f_read(file, bytes, count, &done) == FR_OK && done == count;
}

// littlefs: context is a file system and an open file.
struct LittleFile {
  lfs_t* system;
  lfs_file_t* file;
};
bool read_lfs(void* context, uint32_t offset, uint8_t* bytes, uint32_t count) {
  const auto& from = *static_cast<LittleFile*>(context);
  const auto at = static_cast<lfs_soff_t>(offset);
  return lfs_file_seek(from.system, from.file, at, LFS_SEEK_SET) == at &&
         lfs_file_read(from.system, from.file, bytes, count) ==
             static_cast<lfs_ssize_t>(count);
}

// A flash chip on SPI: context is where the font begins.
bool read_chip(void* context, uint32_t offset, uint8_t* bytes, uint32_t count) {
  const uint32_t at = *static_cast<uint32_t*>(context) + offset;
  const uint8_t command[] = {0x03, static_cast<uint8_t>(at >> 16),
                             static_cast<uint8_t>(at >> 8),
                             static_cast<uint8_t>(at)};
  return spi_select() && spi_write(command, 4) && spi_read(bytes, count) &&
         spi_release();
}

constexpr uint32_t kCount = 512;
uint8_t bytes[kCount];

void check_read(const Storage& storage, bool& is_broken) {
  for (uint32_t offset = 0; offset < 4 * kCount; offset += kCount) {
    CHECK(storage.read(storage.context, offset, bytes, kCount));
    for (uint32_t i = 0; i < kCount; ++i) {
      CHECK_EQ(bytes[i], model_byte(offset + i));
    }
  }
  // Behind the end, where less comes, and where nothing does.
  CHECK(!storage.read(storage.context, kModelBytes - 100, bytes, kCount));
  is_broken = true;
  CHECK(!storage.read(storage.context, 0, bytes, kCount));
  is_broken = false;
}

}  // namespace

TEST(fatfs_reads) {
  FIL file;
  check_read({read_fat, &file}, model_is_broken);
}

TEST(littlefs_reads) {
  lfs_t system;
  lfs_file_t file;
  LittleFile context = {&system, &file};
  check_read({read_lfs, &context}, model_is_broken);
}

TEST(a_chip_reads) {
  uint32_t begin = 0;
  check_read({read_chip, &begin}, model_is_broken);
}
