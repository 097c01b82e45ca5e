#include "web_fonts.hpp"

#include <zlib.h>

#include <algorithm>
#include <string>

namespace inkcell::gen::test {
namespace {

using Bytes = std::vector<uint8_t>;

struct PackedTable {
  std::string tag;
  Bytes bytes;
};

uint32_t read_u32(const Bytes& bytes, size_t at) {
  return uint32_t{bytes[at]} << 24 | uint32_t{bytes[at + 1]} << 16 |
         uint32_t{bytes[at + 2]} << 8 | bytes[at + 3];
}

void put_u16(Bytes& out, size_t value) {
  out.push_back(static_cast<uint8_t>(value >> 8));
  out.push_back(static_cast<uint8_t>(value));
}

void put_u32(Bytes& out, size_t value) {
  put_u16(out, value >> 16);
  put_u16(out, value);
}

void put_bytes(Bytes& out, const Bytes& bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void pad(Bytes& out) {
  out.resize((out.size() + 3) / 4 * 4);
}

std::vector<PackedTable> tables_of(const Bytes& font) {
  std::vector<PackedTable> tables;
  const size_t count = size_t{font[4]} << 8 | font[5];
  for (size_t i = 0; i < count; ++i) {
    const size_t entry = 12 + 16 * i;
    const auto at = [&](size_t offset) {
      return font.begin() + static_cast<ptrdiff_t>(offset);
    };
    const size_t begin = read_u32(font, entry + 8);
    const size_t size = read_u32(font, entry + 12);
    tables.push_back({std::string(at(entry), at(entry + 4)),
                      Bytes(at(begin), at(begin + size))});
  }
  return tables;
}

size_t unpacked_size(const std::vector<PackedTable>& tables) {
  size_t size = 12;
  for (const PackedTable& table : tables) {
    size += 16 + (table.bytes.size() + 3) / 4 * 4;
  }
  return size;
}

// The bytes compressed by zlib, or stored if that is not smaller.
Bytes deflated(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes out(size);
  compress(out.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()));
  out.resize(size);
  return out.size() < bytes.size() ? out : bytes;
}

void put_base_128(Bytes& out, size_t value) {
  for (int shift = 28; shift > 0; shift -= 7) {
    if (value >> shift != 0) {
      out.push_back(static_cast<uint8_t>(0x80 | (value >> shift & 0x7f)));
    }
  }
  out.push_back(static_cast<uint8_t>(value & 0x7f));
}

// RFC 7932: a window of 64 KB, an uncompressed block, an empty last one.
Bytes brotli_stream(const Bytes& bytes) {
  const size_t header = (bytes.size() - 1) << 4 | 1u << 20;
  Bytes out;
  for (int shift = 0; shift < 24; shift += 8) {
    out.push_back(static_cast<uint8_t>(header >> shift));
  }
  put_bytes(out, bytes);
  out.push_back(3);
  return out;
}

}  // namespace

Bytes pack_woff(const Bytes& font) {
  const std::vector<PackedTable> tables = tables_of(font);
  Bytes directory;
  Bytes body;
  for (const PackedTable& table : tables) {
    const Bytes packed = deflated(table.bytes);
    directory.insert(directory.end(), table.tag.begin(), table.tag.end());
    put_u32(directory, 44 + 20 * tables.size() + body.size());
    put_u32(directory, packed.size());
    put_u32(directory, table.bytes.size());
    put_u32(directory, 0);  // checksum, never checked
    put_bytes(body, packed);
    pad(body);
  }
  Bytes out = {'w', 'O', 'F', 'F', font[0], font[1], font[2], font[3]};
  put_u32(out, 44 + directory.size() + body.size());
  put_u16(out, tables.size());
  put_u16(out, 0);
  put_u32(out, unpacked_size(tables));
  out.resize(44);  // no version, no metadata
  put_bytes(out, directory);
  put_bytes(out, body);
  return out;
}

Bytes pack_woff2(const Bytes& font) {
  std::vector<PackedTable> tables = tables_of(font);
  // 'loca' follows 'glyf'.
  std::stable_sort(
      tables.begin(), tables.end(),
      [](const PackedTable& a, const PackedTable& b) {
        const auto rank = [](const PackedTable& table) {
          return table.tag == "glyf" ? 1 : table.tag == "loca" ? 2 : 0;
        };
        return rank(a) < rank(b);
      });
  Bytes directory;
  Bytes body;
  for (const PackedTable& table : tables) {
    const bool is_outline = table.tag == "glyf" || table.tag == "loca";
    directory.push_back(is_outline ? 0xff : 0x3f);  // not transformed
    directory.insert(directory.end(), table.tag.begin(), table.tag.end());
    put_base_128(directory, table.bytes.size());
    put_bytes(body, table.bytes);
  }
  const Bytes packed = brotli_stream(body);
  Bytes out = {'w', 'O', 'F', '2', font[0], font[1], font[2], font[3]};
  put_u32(out, (48 + directory.size() + packed.size() + 3) / 4 * 4);
  put_u16(out, tables.size());
  put_u16(out, 0);
  put_u32(out, unpacked_size(tables));
  put_u32(out, packed.size());
  out.resize(48);  // no version, no metadata
  put_bytes(out, directory);
  put_bytes(out, packed);
  pad(out);
  return out;
}

}  // namespace inkcell::gen::test
