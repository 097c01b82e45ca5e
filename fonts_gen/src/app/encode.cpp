#include "app/encode.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <vector>

#include "inkcell/stored/paged.hpp"
#include "inkcell/version.hpp"

namespace inkcell::gen {
namespace {

// The elements of an array, in lines of at most 80 columns.
class ElementWriter {
 public:
  explicit ElementWriter(std::string& out) : out_(out) {}
  ~ElementWriter() { out_ += '\n'; }
  ElementWriter(const ElementWriter&) = delete;
  ElementWriter& operator=(const ElementWriter&) = delete;

  void put(const std::string& element) {
    constexpr size_t kColumns = 80;
    if (column_ + element.size() + 1 > kColumns) {
      out_ += '\n';
      column_ = 0;
    }
    out_ += element + ",";
    column_ += element.size() + 1;
  }

 private:
  std::string& out_;
  size_t column_ = 0;
};

void append_bytes(std::string& out, const std::vector<uint8_t>& bytes) {
  out.reserve(out.size() + 4 * bytes.size());
  ElementWriter elements(out);
  for (const uint8_t byte : bytes) {
    elements.put(std::to_string(byte));
  }
}

void append_glyphs(std::string& out, const std::vector<ShapedGlyph>& glyphs) {
  ElementWriter elements(out);
  for (const ShapedGlyph& at : glyphs) {
    elements.put("{" + std::to_string(at.glyph) + "," + std::to_string(at.x) +
                 "," + std::to_string(at.y) + "}");
  }
}

// Makes foreign text safe in a comment: it must not end the comment or change
// the direction of what follows.
std::string for_comment(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    const bool printable = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    safe += printable && c != '\\' && c != '/' && c != '?' ? c : '_';
  }
  for (const char32_t c :
       U"\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066"
       U"\u2067\u2068\u2069\u2028\u2029\u061c") {
    const std::string bytes = to_utf8(c);
    size_t at = c == 0 ? std::string::npos : safe.find(bytes);
    for (; at != std::string::npos; at = safe.find(bytes)) {
      safe.replace(at, bytes.size(), "_");
    }
  }
  return safe;
}

// The origin of the font, for the first lines of a source file.
std::string provenance(const RomFont& font) {
  const FontReport& report = font.report;
  std::string text = report.name + " (" + report.file_name + "), " +
                     std::to_string(report.characters) + " characters, ";
  text += std::to_string(static_cast<int>(report.options.min_px)) + " to " +
          std::to_string(static_cast<int>(report.options.max_px)) + " px";
  return for_comment(text);
}

// Glyph arrays are separate from the runs, so that the linker can drop unused
// runs, and cannot clash with names of strings.
std::string hpp_strings(const RomFont& font, const std::string& name) {
  std::string out = "\nnamespace " + name + "_glyphs {\n\n";
  for (const RomString& string : font.strings) {
    if (!string.glyphs.empty()) {
      out += "inline constexpr inkcell::ShapedGlyph " + string.name + "[" +
             std::to_string(string.glyphs.size()) + "] = {\n";
      append_glyphs(out, string.glyphs);
      out += "};\n";
    }
  }
  out += "\n}  // namespace " + name + "_glyphs\n\nnamespace " + name +
         "_strings {\n\n";
  for (const RomString& string : font.strings) {
    out += "// " + for_comment(string.text) + "\n";
    out += "inline constexpr inkcell::ShapedRun " + string.name + " = {\n    " +
           (string.glyphs.empty() ? "{}" : name + "_glyphs::" + string.name) +
           ", " + std::to_string(string.advance) + "};\n";
  }
  return out + "\n}  // namespace " + name + "_strings\n";
}

// The UTF-8 of a code point as a string literal.
std::string literal(char32_t code_point) {
  std::string text;
  for (const char c : to_utf8(code_point)) {
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02X", static_cast<uint8_t>(c));
    text += code;
  }
  return '"' + text + '"';
}

// A comment for the constant of an icon: "U+E001, wifi.svg".
std::string origin(const IconFile& icon) {
  char code[16];
  std::snprintf(code, sizeof code, "U+%04X",
                static_cast<unsigned>(icon.code_point));
  return std::string(code) + ", " + for_comment(icon.file.filename().string());
}

std::string hpp_icons(const RomFont& font, const std::string& name) {
  std::string out = "\n// Icons, as UTF-8.\nnamespace " + name + "_icons {\n";
  for (const IconFile& icon : font.report.icons) {
    out += "inline constexpr char k" + icon.name +
           "[] = " + literal(icon.code_point) + ";  // " + origin(icon) + "\n";
  }
  return out + "}  // namespace " + name + "_icons\n";
}

// What includes headers of the library, or the one that it has as two files.
std::string library_includes(std::initializer_list<std::string> headers,
                             const std::string& only) {
  std::string lines, last;
  for (const std::string& header : headers) {
    lines += header.empty() ? "" : "#include \"" + header + "\"\n";
    last = header;
  }
  return "#if __has_include(\"" + last + "\")\n" + lines +
         "#else  /* the library is two files */\n#include \"" + only +
         "\"\n#endif\n";
}

// The header of the library with the coding of a font of strikes; else nothing.
std::string strike_header(const FontReport& report) {
  return report.strikes.empty() ? ""
         : report.options.coding == Coding::strike
             ? "inkcell/strike/strike.hpp"
             : "inkcell/strike/outline_strike.hpp";
}

// The coding that opens a font of strikes, as code: of bits alone, if it has no
// others.
std::string hpp_coding(const FontReport& report, const std::string& name) {
  const bool is_bits =
      std::all_of(report.strikes.begin(), report.strikes.end(),
                  [](const StrikeTarget& strike) { return strike.bits == 1; });
  return "// What opens the font.\ninline constexpr const inkcell::Coding& " +
         name + "_coding =\n    inkcell::k" +
         (report.options.coding == Coding::strike ? "" : "Outline") +
         (is_bits ? "Bit" : "") + "StrikeCoding;\n";
}

// The head of a header of C++, with the includes that it needs.
std::string hpp_head(const RomFont& font, const std::string& c_remedy) {
  std::string out = "// " + provenance(font) +
                    ".\n// Made by inkcell-fontgen: do not edit.\n"
                    "#pragma once\n\n#ifndef __cplusplus\n#error \"this font "
                    "is for C++" +
                    c_remedy + "\"\n#endif\n\n#include <stdint.h>\n\n";
  out += library_includes({font.strings.empty() ? "" : "inkcell/shaped_run.hpp",
                           strike_header(font.report), "inkcell/version.hpp"},
                          "inkcell.hpp") +
         "\n";
  return out + "static_assert(inkcell::reads_format(" +
         std::to_string(kFormatMajor) + ", " + std::to_string(kFormatMinor) +
         "),\n              \"regenerate with inkcell-fontgen\");\n\n"
         "namespace fonts {\n\n";
}

std::string encode_hpp(const RomFont& font,
                       const std::string& name,
                       const std::string& section) {
  std::string out = hpp_head(font, "; for C make it with --out " + name +
                                       ".c --header " + name + ".h");
  out +=
      section.empty() ? "" : "__attribute__((section(\"" + section + "\")))\n";
  out += "alignas(4) inline constexpr uint8_t " + name + "[" +
         std::to_string(font.bytes.size()) + "] = {\n";
  append_bytes(out, font.bytes);
  out += "};\n";
  out += font.report.strikes.empty() ? "" : hpp_coding(font.report, name);
  out += font.strings.empty() ? "" : hpp_strings(font, name);
  out += font.report.icons.empty() ? "" : hpp_icons(font, name);
  out += "\n}  // namespace fonts\n";
  return out;
}

// The head of both C files: the origin of the font, and the includes after the
// lines `guard`.
std::string c_head(const RomFont& font, const std::string& guard) {
  std::string out = "/* " + provenance(font) +
                    ".\n * Made by inkcell-fontgen for font format " +
                    std::to_string(kFormatMajor) + "." +
                    std::to_string(kFormatMinor) + ": do not edit. */\n";
  return out + guard + "#include <stdint.h>\n" +
         (font.strings.empty()
              ? std::string()
              : "\n" +
                    library_includes({"inkcell/c/shaped_run.h"}, "inkcell.h")) +
         "\n";
}

std::string c_declarations(const RomFont& font, const std::string& name) {
  std::string out = "extern const uint8_t " + name + "[" +
                    std::to_string(font.bytes.size()) + "];\n";
  out += "extern const uint32_t " + name + "_size;\n";
  for (const RomString& string : font.strings) {
    out += "extern const inkcell_shaped_run_t " + name + "_strings_" +
           string.name + "; /* " + for_comment(string.text) + " */\n";
  }
  for (const IconFile& icon : font.report.icons) {
    out += "#define " + name + "_icons_" + icon.name + " " +
           literal(icon.code_point) + " /* " + origin(icon) + " */\n";
  }
  return out;
}

std::string c_strings(const RomFont& font, const std::string& name) {
  std::string out;
  for (const RomString& string : font.strings) {
    const std::string run = name + "_strings_" + string.name;
    const std::string glyphs = name + "_glyphs_" + string.name;
    if (!string.glyphs.empty()) {
      out += "\nstatic const inkcell_shaped_glyph_t " + glyphs + "[] = {\n";
      append_glyphs(out, string.glyphs);
      out += "};";
    }
    out += "\nconst inkcell_shaped_run_t " + run + " = {\n    " +
           (string.glyphs.empty() ? "0" : glyphs) + ", " +
           std::to_string(string.glyphs.size()) + ", " +
           std::to_string(string.advance) + "};\n";
  }
  return out;
}

std::string encode_c(const RomFont& font,
                     const std::string& name,
                     const std::string& section) {
  const std::string size = std::to_string(font.bytes.size());
  std::string out = c_head(font, "") + c_declarations(font, name);
  out += "\n#if defined(__GNUC__)\n__attribute__((aligned(4)" +
         (section.empty() ? "" : ", section(\"" + section + "\")") + "))\n";
  out += section.empty()
             ? "#else\n_Alignas(4)\n#endif\n"
             : "#else\n#error \"sections need GCC, Clang or armclang; "
               "make the font without --section\"\n#endif\n";
  out += "const uint8_t " + name + "[" + size + "] = {\n";
  append_bytes(out, font.bytes);
  out += "};\n\nconst uint32_t " + name + "_size = " + size + ";\n";
  return out + c_strings(font, name);
}

}  // namespace

std::string encode(const RomFont& font,
                   OutputFormat format,
                   const std::string& name,
                   const std::string& section) {
  switch (format) {
    case OutputFormat::hpp:
      return encode_hpp(font, name, section);
    case OutputFormat::c:
      return encode_c(font, name, section);
    case OutputFormat::bin:
      break;
  }
  return {font.bytes.begin(), font.bytes.end()};
}

std::string encode_stored_header(const RomFont& font, const std::string& name) {
  namespace paged = format::paged;
  const auto u16 = [&font](uint32_t at) {
    return font.bytes[at] | uint32_t{font.bytes[at + 1]} << 8;
  };
  const auto line = [](const char* id, uint32_t value, const char* meaning) {
    return std::string("inline constexpr uint32_t ") + id + " = " +
           std::to_string(value) + ";  // " + meaning + "\n";
  };
  const auto bytes = static_cast<uint32_t>(font.bytes.size());
  const uint32_t block = u16(paged::kBlockBytes);
  const uint32_t pairs = u16(paged::kKernEnd) != 0 ? 1 : 0;
  const uint32_t pages = u16(paged::kPages);
  const auto layers = static_cast<uint32_t>(font.report.bytes.layers) / block;
  const uint32_t all = bytes / block - 1 - pages - pairs - layers;
  const uint32_t fan_out = block / paged::entry::kBytes;
  const uint32_t index = all == 0 ? 0 : (pages + fan_out - 1) / fan_out;
  std::string out = hpp_head(font, ": C has no StoredFont");
  out += "// A font in storage, for inkcell::StoredFont.\nnamespace " + name;
  out += " {\n\n" + line("kFileBytes", bytes, "in storage");
  out += line("kBlockBytes", block, "for StoredFont::ram_bytes()");
  out += line("kIndexBlocks", index, "one of them finds a glyph");
  out += line("kIndexRoots", all - index, "one of them finds a block of those");
  out += line("kPairBlocks", pairs, "0: no pair kerns");
  out +=
      "\n// Blocks in RAM with which a line of so many glyphs is read "
      "once.\nconstexpr uint32_t blocks_of_line(uint32_t glyphs) {\n"
      "  return glyphs + kPairBlocks";
  out += index == 0
             ? ""
             : " + kIndexRoots +\n         (glyphs < kIndexBlocks ? glyphs : "
               "kIndexBlocks)";
  out += ";\n}\n\n}  // namespace " + name + "\n";
  out +=
      font.report.strikes.empty() ? "" : "\n" + hpp_coding(font.report, name);
  out += font.report.icons.empty() ? "" : hpp_icons(font, name);
  return out + "\n}  // namespace fonts\n";
}

std::string encode_c_header(const RomFont& font, const std::string& name) {
  return c_head(font, "#pragma once\n\n") +
         "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n" +
         c_declarations(font, name) + "\n#ifdef __cplusplus\n}\n#endif\n";
}

}  // namespace inkcell::gen
