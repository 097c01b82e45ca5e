// Packs fonts as WOFF and WOFF2 files.
#pragma once

#include <cstdint>
#include <vector>

namespace inkcell::gen::test {

/// A TTF or OTF as a WOFF file, its tables compressed by zlib.
std::vector<uint8_t> pack_woff(const std::vector<uint8_t>& font);

/// The same as a WOFF2 file: a Brotli stream of uncompressed blocks, without
/// transformed tables. The font has at most 64 KB.
std::vector<uint8_t> pack_woff2(const std::vector<uint8_t>& font);

}  // namespace inkcell::gen::test
