// Files that appear whole or not at all, and the forms that a font takes there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "generate.hpp"

namespace inkcell::gen {

/// A file that is written beside its place and moved there by `commit`. Without
/// commit nothing is left behind, and what was there before stays.
class OutputFile {
 public:
  /// Throws Error if the folder cannot be written to.
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

/// Throws Error unless a file can be made at `target`: before work begins.
void check_writable(const std::filesystem::path& target);

enum class OutputFormat { bin, hpp, c };

/// The content of a font file in the given form. `name` is the identifier of
/// the array in hpp and c; the array of hpp is fonts::<name>.
std::string encode(const RomFont& font,
                   OutputFormat format,
                   const std::string& name);

/// Throws Error unless `name` is an identifier that C and C++ accept.
void check_identifier(const std::string& name);

/// An identifier made of a font file's name: DejaVuSans-Bold.ttf gives
/// DejaVuSans_Bold.
std::string identifier_of(const std::filesystem::path& font);

}  // namespace inkcell::gen
