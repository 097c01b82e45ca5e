// What FatFs, littlefs and a flash chip do, as far as fonts are read from them:
// their functions by their names, over bytes that are computed.
#pragma once

#include <stdint.h>

// A file of so many bytes; broken: nothing can be read.
inline constexpr uint32_t kModelBytes = 5000;
inline bool model_is_broken = false;

inline uint8_t model_byte(uint32_t at) {
  return static_cast<uint8_t>(at * 7 ^ at >> 8);
}

// How many of `count` bytes there are.
inline uint32_t model_read(uint32_t at, uint8_t* bytes, uint32_t count) {
  uint32_t done = 0;
  for (; done < count && at + done < kModelBytes; ++done) {
    bytes[done] = model_byte(at + done);
  }
  return done;
}

// FatFs.
using UINT = unsigned;
enum FRESULT { FR_OK, FR_DISK_ERR };
struct FIL {
  uint32_t at = 0;
};
inline FRESULT f_lseek(FIL* file, uint32_t at) {
  file->at = at;
  return FR_OK;
}
inline FRESULT f_read(FIL* file, void* bytes, UINT count, UINT* done) {
  *done = model_read(file->at, static_cast<uint8_t*>(bytes), count);
  return model_is_broken ? FR_DISK_ERR : FR_OK;
}

// littlefs.
using lfs_soff_t = int32_t;
using lfs_ssize_t = int32_t;
using lfs_size_t = uint32_t;
struct lfs_t {};
struct lfs_file_t {
  uint32_t at = 0;
};
enum { LFS_SEEK_SET };
inline lfs_soff_t lfs_file_seek(lfs_t*, lfs_file_t* file, lfs_soff_t at, int) {
  file->at = static_cast<uint32_t>(at);
  return model_is_broken ? -5 : at;
}
inline lfs_ssize_t lfs_file_read(lfs_t*,
                                 lfs_file_t* file,
                                 void* bytes,
                                 lfs_size_t count) {
  return static_cast<lfs_ssize_t>(
      model_read(file->at, static_cast<uint8_t*>(bytes), count));
}

// SPI, with a chip that takes READ DATA.
inline uint32_t model_address = 0;
inline bool spi_select() {
  return !model_is_broken;
}
inline bool spi_release() {
  return true;
}
inline bool spi_write(const uint8_t* command, uint32_t count) {
  model_address =
      uint32_t{command[1]} << 16 | uint32_t{command[2]} << 8 | command[3];
  return count == 4 && command[0] == 0x03;
}
inline bool spi_read(uint8_t* bytes, uint32_t count) {
  return model_read(model_address, bytes, count) == count;
}
