// Bytes as text, by RFC 4648.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace inkcell::design {

/// Skips characters that are no digits of Base64.
std::vector<uint8_t> decode_base64(const std::string& text);
std::string encode_base64(const std::vector<uint8_t>& bytes);

}  // namespace inkcell::design
