// Opens ROM fonts with the device's reader, and explains errors.
#include "rom_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "bytes.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/strike/outline_strike.hpp"
#include "inkcell/strike/strike.hpp"
#include "inkcell/text.hpp"

namespace inkcell::tools {
namespace {

std::string remedy(Status status) {
  switch (status) {
    case Status::bad_magic:
      return "it is not an Inkcell font; make one with inkcell-fontgen";
    case Status::bad_version:
      return "its format is not the one of this version; regenerate it";
    case Status::corrupt:
      return "an offset, a length or the header's checksum does not fit; "
             "regenerate it";
    case Status::unsupported:
      return "it has a coding or a section that this version cannot read";
    default:
      return "it cannot be opened";
  }
}

}  // namespace

std::string_view status_name(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::bad_magic:
      return "bad_magic";
    case Status::bad_version:
      return "bad_version";
    case Status::corrupt:
      return "corrupt";
    case Status::no_glyph:
      return "no_glyph";
    case Status::buffer_small:
      return "buffer_small";
    case Status::misaligned:
      return "misaligned";
    case Status::unsupported:
      return "unsupported";
    case Status::bad_argument:
      return "bad_argument";
    case Status::beyond_band:
      return "beyond_band";
    case Status::read_failed:
      return "read_failed";
    case Status::cut:
      return "cut";
    case Status::needs_shaping:
      return "needs_shaping";
  }
  return "?";
}

std::string_view coding_name(const Font& font) {
  const auto coding =
      static_cast<format::Coding>(font.rom().data[format::header::kCoding]);
  return coding == format::Coding::outline  ? "outline"
         : coding == format::Coding::strike ? "strike"
                                            : "field";
}

RomFile::RomFile(std::vector<uint8_t> bytes, const std::string& name)
    : bytes_(std::move(bytes)) {
  if (is_rom_font(bytes_) && bytes_.size() >= format::header::kBytes &&
      bytes_[format::header::kCoding] ==
          static_cast<uint8_t>(format::Coding::edges)) {
    throw std::runtime_error(
        name +
        ": it is a font of edges, which this version cannot read; make "
        "it again by inkcell-fontgen --coding outline (unsupported)");
  }
  const Span<const uint8_t> rom = {bytes_.data(), bytes_.size()};
  Status status = open_any_font(rom, font_);
  for (const Coding* coding : {&kOutlineStrikeCoding, &kStrikeCoding}) {
    Font font;
    if (Font::open(rom, *coding, font) == Status::ok) {
      font_ = font;
      status = Status::ok;
    }
  }
  if (status != Status::ok) {
    throw std::runtime_error(name + ": " + remedy(status) + " (" +
                             std::string(status_name(status)) + ")");
  }
}

std::vector<uint8_t> read_file(const std::filesystem::path& file) {
  std::error_code ignored;  // opening reports it better
  if (std::filesystem::is_directory(file, ignored)) {
    throw std::runtime_error(file.string() +
                             ": is a folder; name a file in it");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw std::runtime_error(file.string() + ": " + std::strerror(errno));
  }
  try {
    return {std::istreambuf_iterator<char>(in), {}};
  } catch (const std::ios_base::failure&) {
    throw std::runtime_error(file.string() + ": cannot be read to its end");
  }
}

bool is_rom_font(const std::vector<uint8_t>& bytes) {
  return bytes.size() >= 4 && read_u32(bytes.data()) == format::kMagic;
}

void require_sound(const RomFile& rom, const std::filesystem::path& file) {
  if (verify_fields(rom.font()) != Status::ok) {
    throw std::runtime_error(
        file.string() +
        ": it is damaged; regenerate it (inkcell-inspect looks into it)");
  }
}

RomFile load_rom(const std::filesystem::path& file) {
  RomFile rom(read_file(file), file.string());
  require_sound(rom, file);
  return rom;
}

std::vector<Mapping> mappings(const Font& font) {
  namespace cmap = format::cmap;
  std::vector<Mapping> result;
  const Span<const uint8_t> section = font.section(format::section::kCmap);
  for (size_t at = 0; at + cmap::kBytes <= section.size; at += cmap::kBytes) {
    const uint8_t* entry = section.data + at;
    const uint32_t first = read_u32(entry + cmap::kFirst);
    const uint32_t extra = read_u16(entry + cmap::kExtra);
    const uint32_t glyph = read_u16(entry + cmap::kFirstGlyph);
    for (uint32_t i = 0; i <= extra; ++i) {
      result.push_back(
          {static_cast<char32_t>(first + i), static_cast<uint16_t>(glyph + i)});
    }
  }
  namespace pages = format::code_pages;
  const Span<const uint8_t> paged = font.section(format::section::kCodePages);
  const uint32_t count =
      paged.size < pages::kBytes ? 0 : read_u16(paged.data + pages::kPages);
  if (pages::kBytes + 2 * (count + 1) > paged.size) {
    return result;
  }
  const uint32_t first = read_u16(paged.data + pages::kFirstPage);
  const uint32_t base = read_u16(paged.data + pages::kGlyphBase);
  for (uint32_t page = 0; page < count; ++page) {
    const uint8_t* starts = paged.data + pages::kBytes + 2 * page;
    const uint32_t end = std::min<uint32_t>(read_u16(starts + 2),
                                            static_cast<uint32_t>(paged.size));
    for (uint32_t at = read_u16(starts); at < end; ++at) {
      result.push_back({static_cast<char32_t>((first + page) << 8 | paged[at]),
                        static_cast<uint16_t>(base + at)});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const Mapping& a, const Mapping& b) {
              return a.code_point < b.code_point;
            });
  return result;
}

std::string to_utf8(char32_t code_point) {
  const uint32_t c = code_point;
  const auto tail = [c](int shift) {
    return static_cast<char>(0x80 | ((c >> shift) & 0x3f));
  };
  if (c < 0x80) {
    return {static_cast<char>(c)};
  }
  if (c < 0x800) {
    return {static_cast<char>(0xc0 | c >> 6), tail(0)};
  }
  if (c < 0x10000) {
    return {static_cast<char>(0xe0 | c >> 12), tail(6), tail(0)};
  }
  return {static_cast<char>(0xf0 | c >> 18), tail(12), tail(6), tail(0)};
}

std::vector<char32_t> from_utf8(std::string_view text) {
  std::vector<char32_t> result;
  Text rest(text.data(), text.size());
  while (rest.size > 0) {
    result.push_back(static_cast<char32_t>(next_code_point(rest)));
  }
  return result;
}

}  // namespace inkcell::tools
