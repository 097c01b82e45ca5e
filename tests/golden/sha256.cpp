#include "sha256.hpp"

namespace golden {
namespace {

constexpr uint32_t kRound[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1,
    0x923f82a4, 0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3,
    0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786,
    0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147,
    0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13,
    0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
    0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a,
    0x5b9cca4f, 0x682e6ff3, 0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208,
    0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

uint32_t turn(uint32_t value, int bits) {
  return value >> bits | value << (32 - bits);
}

}  // namespace

void Hash::to_hex(char (&out)[65]) const {
  char* at = out;
  for (const uint8_t byte : bytes) {
    *at++ = "0123456789abcdef"[byte >> 4];
    *at++ = "0123456789abcdef"[byte & 15];
  }
  *at = '\0';
}

void Sha256::add(inkcell::Span<const uint8_t> bytes) {
  for (const uint8_t byte : bytes) {
    add_byte(byte);
  }
}

void Sha256::add_byte(uint8_t byte) {
  block_[size_ % 64] = byte;
  if (++size_ % 64 == 0) {
    compress();
  }
}

Hash Sha256::finish() {
  const uint64_t bits = size_ * 8;
  add_byte(0x80);
  while (size_ % 64 != 56) {
    add_byte(0);
  }
  for (int shift = 56; shift >= 0; shift -= 8) {
    add_byte(static_cast<uint8_t>(bits >> shift));
  }
  Hash hash;
  for (int i = 0; i < 32; ++i) {
    hash.bytes[i] = static_cast<uint8_t>(state_[i / 4] >> (24 - i % 4 * 8));
  }
  return hash;
}

void Sha256::compress() {
  uint32_t w[16];
  for (int i = 0; i < 16; ++i) {
    const uint8_t* at = block_ + 4 * i;
    w[i] = uint32_t{at[0]} << 24 | uint32_t{at[1]} << 16 |
           uint32_t{at[2]} << 8 | at[3];
  }
  uint32_t s[8];
  for (int i = 0; i < 8; ++i) {
    s[i] = state_[i];
  }
  for (int i = 0; i < 64; ++i) {
    if (i >= 16) {
      const uint32_t a = w[(i - 15) & 15];
      const uint32_t b = w[(i - 2) & 15];
      w[i & 15] += (turn(a, 7) ^ turn(a, 18) ^ a >> 3) + w[(i - 7) & 15] +
                   (turn(b, 17) ^ turn(b, 19) ^ b >> 10);
    }
    const uint32_t first =
        s[7] + (turn(s[4], 6) ^ turn(s[4], 11) ^ turn(s[4], 25)) +
        ((s[4] & s[5]) ^ (~s[4] & s[6])) + kRound[i] + w[i & 15];
    const uint32_t second = (turn(s[0], 2) ^ turn(s[0], 13) ^ turn(s[0], 22)) +
                            ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
    for (int j = 7; j > 0; --j) {
      s[j] = s[j - 1];
    }
    s[4] += first;
    s[0] = first + second;
  }
  for (int i = 0; i < 8; ++i) {
    state_[i] += s[i];
  }
}

}  // namespace golden
