// Output files that appear whole or not at all, previews, and identifiers.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pipeline/preview.hpp"

namespace inkcell::gen {

/// A file that is written beside its target and moved there by `commit`.
/// Without commit nothing changes. If the target is a symbolic link, the file
/// that it points to is replaced, not the link.
class OutputFile {
 public:
  /// Throws what check_writable() throws.
  explicit OutputFile(std::filesystem::path target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes the whole content. Throws Error.
  void write(std::string_view content);
  /// Moves the file to its place. Throws Error.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

/// Throws std::runtime_error, before work begins, unless a file can be made or
/// replaced at `target`. Refuses folders, devices, pipes, and '-', which many
/// take for standard output.
void check_writable(const std::filesystem::path& target);

/// A preview as the content of a PNG file. Throws std::runtime_error.
std::string encode_png(const Preview& preview);

/// Throws Error unless `name` is an identifier in C and C++ and no keyword.
void check_identifier(const std::string& name);

/// Throws Error unless `name` can be the section of an array.
void check_section(const std::string& name);

/// An identifier from a font's file name: DejaVuSans-Bold.ttf gives
/// DejaVuSans_Bold, new.ttf gives font_new.
std::string identifier_of(const std::filesystem::path& font);

}  // namespace inkcell::gen
