#include "app/output.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <random>

#include "base/error.hpp"
#include "base/identifier.hpp"
#include "files.hpp"
#include "png.hpp"

namespace inkcell::gen {
namespace {

// A name beside a file that no other program has.
std::filesystem::path name_beside(const std::filesystem::path& target) {
  static const unsigned kNumber = std::random_device()();
  return tools::folder_of(target) /
         ("." + target.filename().string() + ".part" + std::to_string(kNumber));
}

// Whether a file can be made beside another.
bool can_be_made(const std::filesystem::path& target) {
  const std::filesystem::path probe = name_beside(target);
  const bool is_made = std::ofstream(probe).is_open();
  std::error_code ignored;
  std::filesystem::remove(probe, ignored);
  return is_made;
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
  if (!can_be_made(tools::follow_links(target))) {
    throw Error(target.string() + ": the folder " + folder.string() +
                " cannot be written to; check its permissions");
  }
}

OutputFile::OutputFile(std::filesystem::path target)
    : target_(tools::follow_links(std::move(target))) {
  check_writable(target_);
  temporary_ = name_beside(target_);
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

std::string encode_png(const Preview& preview) {
  return tools::encode_png(preview.width, preview.height, true, preview.pixels);
}

void check_identifier(const std::string& name) {
  if (!has_letters_of_identifier(name)) {
    throw Error("--name: '" + name +
                "' is not an identifier; use letters, digits and _");
  }
  if (is_keyword(name)) {
    throw Error("--name: '" + name +
                "' belongs to C or C++; use another, such as font_" + name);
  }
}

void check_section(const std::string& name) {
  const bool is_good = std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("._$-,").find(c) != std::string_view::npos;
  });
  if (!is_good || name.empty()) {
    throw Error("--section: '" + name +
                "' is no section; use letters, digits and . _ $ - , such as "
                ".ext_flash");
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
