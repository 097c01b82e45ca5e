// ROM fonts as files: loaded, opened, and what their cmap lists.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "inkcell/font.hpp"
#include "inkcell/status.hpp"

namespace inkcell::tools {

/// Name of a status, as it stands in status.hpp.
std::string_view status_name(Status status);

/// What the font is made of, as the generator's --coding says it: "outline",
/// or "field".
std::string_view coding_name(const Font& font);

/// A font and the bytes that it reads.
class RomFile {
 public:
  /// Opens `bytes`; `name` is for messages.
  ///
  /// Throws std::runtime_error if the device would refuse them.
  RomFile(std::vector<uint8_t> bytes, const std::string& name);

  RomFile(const RomFile&) = delete;
  RomFile& operator=(const RomFile&) = delete;
  RomFile(RomFile&&) = default;  // the bytes stay where they are
  RomFile& operator=(RomFile&&) = default;

  const Font& font() const { return font_; }

 private:
  std::vector<uint8_t> bytes_;  // from new: aligned to more than 4
  Font font_;
};

/// The bytes of a file. Throws std::runtime_error that names it.
std::vector<uint8_t> read_file(const std::filesystem::path& file);

/// Whether the bytes claim to be a ROM font.
bool is_rom_font(const std::vector<uint8_t>& bytes);

/// Throws std::runtime_error that names the file if Font::verify finds fault
/// with it.
void require_sound(const RomFile& rom, const std::filesystem::path& file);

/// read_file, open and require_sound.
RomFile load_rom(const std::filesystem::path& file);

/// A code point and its glyph.
struct Mapping {
  char32_t code_point = 0;
  uint16_t glyph = 0;
};

/// All that the font's cmap says, in ascending order of code points.
std::vector<Mapping> mappings(const Font& font);

/// UTF-8 of one code point.
std::string to_utf8(char32_t code_point);

/// The code points of UTF-8 text, as the device reads them.
std::vector<char32_t> from_utf8(std::string_view text);

}  // namespace inkcell::tools
