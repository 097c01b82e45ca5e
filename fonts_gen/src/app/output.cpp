#include "app/output.hpp"

#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "files.hpp"
#include "inkcell/version.hpp"

namespace inkcell::gen {
namespace {

// Numbers of an array, in lines of at most 80 columns.
void append_array(std::string& out, const std::vector<uint8_t>& bytes) {
  constexpr size_t kColumns = 80;
  out.reserve(out.size() + 4 * bytes.size());
  size_t column = 0;
  for (const uint8_t byte : bytes) {
    const std::string text = std::to_string(byte) + ",";
    if (column + text.size() > kColumns) {
      out += '\n';
      column = 0;
    }
    out += text;
    column += text.size();
  }
  out += '\n';
}

// Keywords and other spellings of operators, of C up to C23 and C++ up to
// C++23. Sorted. Those that begin with _ and a capital are found by that.
constexpr std::string_view kKeywords[] = {"alignas",
                                          "alignof",
                                          "and",
                                          "and_eq",
                                          "asm",
                                          "auto",
                                          "bitand",
                                          "bitor",
                                          "bool",
                                          "break",
                                          "case",
                                          "catch",
                                          "char",
                                          "char16_t",
                                          "char32_t",
                                          "char8_t",
                                          "class",
                                          "co_await",
                                          "co_return",
                                          "co_yield",
                                          "compl",
                                          "concept",
                                          "const",
                                          "const_cast",
                                          "consteval",
                                          "constexpr",
                                          "constinit",
                                          "continue",
                                          "decltype",
                                          "default",
                                          "delete",
                                          "do",
                                          "double",
                                          "dynamic_cast",
                                          "else",
                                          "enum",
                                          "explicit",
                                          "export",
                                          "extern",
                                          "false",
                                          "float",
                                          "for",
                                          "friend",
                                          "goto",
                                          "if",
                                          "inline",
                                          "int",
                                          "long",
                                          "mutable",
                                          "namespace",
                                          "new",
                                          "noexcept",
                                          "not",
                                          "not_eq",
                                          "nullptr",
                                          "operator",
                                          "or",
                                          "or_eq",
                                          "private",
                                          "protected",
                                          "public",
                                          "register",
                                          "reinterpret_cast",
                                          "requires",
                                          "restrict",
                                          "return",
                                          "short",
                                          "signed",
                                          "sizeof",
                                          "static",
                                          "static_assert",
                                          "static_cast",
                                          "struct",
                                          "switch",
                                          "template",
                                          "this",
                                          "thread_local",
                                          "throw",
                                          "true",
                                          "try",
                                          "typedef",
                                          "typeid",
                                          "typename",
                                          "typeof",
                                          "typeof_unqual",
                                          "union",
                                          "unsigned",
                                          "using",
                                          "virtual",
                                          "void",
                                          "volatile",
                                          "wchar_t",
                                          "while",
                                          "xor",
                                          "xor_eq"};

bool is_keyword(const std::string& name) {
  const bool reserved =
      name.size() > 1 && name[0] == '_' && name[1] >= 'A' && name[1] <= 'Z';
  return reserved ||
         std::binary_search(std::begin(kKeywords), std::end(kKeywords), name);
}

// What the font is, for the first lines of a source file. File and family names
// come from outside: nothing in them may end the comment.
std::string provenance(const RomFont& font) {
  const FontReport& report = font.report;
  std::string text = report.name + " (" + report.file_name + "), " +
                     std::to_string(report.characters) + " characters, ";
  text += std::to_string(static_cast<int>(report.options.min_px)) + " to " +
          std::to_string(static_cast<int>(report.options.max_px)) + " px";
  std::string safe;
  for (const char c : text) {
    const bool printable = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    safe += printable && c != '\\' && c != '/' && c != '?' ? c : '_';
  }
  return safe;
}

std::string encode_hpp(const RomFont& font, const std::string& name) {
  std::string out = "// " + provenance(font) +
                    ".\n// Made by inkcell-fontgen: do not edit.\n"
                    "#pragma once\n\n#include <stdint.h>\n\n"
                    "#include \"inkcell/version.hpp\"\n\n";
  out += "static_assert(inkcell::reads_format(" + std::to_string(kFormatMajor) +
         ", " + std::to_string(kFormatMinor) +
         "),\n              \"regenerate with inkcell-fontgen\");\n\n";
  out += "namespace fonts {\n\nalignas(4) inline constexpr uint8_t " + name +
         "[" + std::to_string(font.bytes.size()) + "] = {\n";
  append_array(out, font.bytes);
  out += "};\n\n}  // namespace fonts\n";
  return out;
}

std::string encode_c(const RomFont& font, const std::string& name) {
  const std::string size = std::to_string(font.bytes.size());
  std::string out = "/* " + provenance(font) +
                    ".\n * Made by inkcell-fontgen for font format " +
                    std::to_string(kFormatMajor) + "." +
                    std::to_string(kFormatMinor) + ": do not edit. */\n";
  out += "#include <stdint.h>\n\n";
  out += "extern const uint8_t " + name + "[" + size + "];\n";
  out += "extern const uint32_t " + name + "_size;\n";
  out +=
      "\n#if defined(__GNUC__)\n__attribute__((aligned(4)))\n#else\n"
      "_Alignas(4)\n#endif\n";
  out += "const uint8_t " + name + "[" + size + "] = {\n";
  append_array(out, font.bytes);
  out += "};\n\nconst uint32_t " + name + "_size = " + size + ";\n";
  return out;
}

}  // namespace

void check_writable(const std::filesystem::path& target) {
  if (target == "-") {
    throw Error(
        "-: is not standard output here; name a file, ./- if it shall be "
        "called so");
  }
  const std::filesystem::path folder =
      tools::folder_of(tools::follow_links(target));
  std::error_code error;
  if (std::filesystem::is_directory(target, error)) {
    throw Error(target.string() + ": is a folder; name a file");
  }
  if (std::filesystem::exists(target, error) &&
      !std::filesystem::is_regular_file(target, error)) {
    throw Error(target.string() +
                ": is a device or a pipe, which would be replaced; name a "
                "file");
  }
  if (!std::filesystem::is_directory(folder, error)) {
    throw Error(target.string() + ": there is no folder " + folder.string() +
                "; make it first");
  }
  tools::refuse_among_fonts(target);
  if (access(folder.c_str(), W_OK) != 0) {
    throw Error(target.string() + ": the folder " + folder.string() +
                " cannot be written to; check its permissions");
  }
}

OutputFile::OutputFile(std::filesystem::path target)
    : target_(tools::follow_links(std::move(target))) {
  check_writable(target_);
  temporary_ = tools::folder_of(target_) / ("." + target_.filename().string() +
                                            ".part" + std::to_string(getpid()));
}

OutputFile::~OutputFile() {
  if (!committed_) {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
  }
}

void OutputFile::write(std::string_view content) {
  std::ofstream out(temporary_, std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) {
    throw Error(target_.string() + ": cannot be written; is the disk full?");
  }
}

void OutputFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error) {
    throw Error(target_.string() + ": cannot be replaced: " + error.message());
  }
  committed_ = true;
}

std::string encode(const RomFont& font,
                   OutputFormat format,
                   const std::string& name) {
  switch (format) {
    case OutputFormat::hpp:
      return encode_hpp(font, name);
    case OutputFormat::c:
      return encode_c(font, name);
    case OutputFormat::bin:
      break;
  }
  return {font.bytes.begin(), font.bytes.end()};
}

std::string encode_png(const Preview& preview) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(preview.width);
  header.height = static_cast<png_uint_32>(preview.height);
  header.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = 0;
  std::string png;
  // The first call says how much room the second one needs.
  for (int pass = 0; pass < 2; ++pass) {
    png.resize(size);
    if (png_image_write_to_memory(&header, pass == 0 ? nullptr : png.data(),
                                  &size, 0, preview.pixels.data(), 0,
                                  nullptr) == 0) {
      throw Error(std::string("the preview cannot be encoded: ") +
                  header.message);
    }
  }
  png.resize(size);
  return png;
}

void check_identifier(const std::string& name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const bool good = !name.empty() && is_letter(name[0]) &&
                    std::all_of(name.begin(), name.end(), [&](char c) {
                      return is_letter(c) || (c >= '0' && c <= '9');
                    });
  if (!good) {
    throw Error("--name: '" + name +
                "' is not an identifier; use letters, digits and _");
  }
  if (is_keyword(name)) {
    throw Error("--name: '" + name +
                "' belongs to C or C++; use another, such as font_" + name);
  }
}

std::string identifier_of(const std::filesystem::path& font) {
  std::string name = font.stem().string();
  for (char& c : name) {
    const bool keep = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      (c >= '0' && c <= '9');
    c = keep ? c : '_';
  }
  const bool begins_well = !name.empty() && !(name[0] >= '0' && name[0] <= '9');
  return begins_well && !is_keyword(name) ? name : "font_" + name;
}

}  // namespace inkcell::gen
