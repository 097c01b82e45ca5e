// Records on disk, one a line, each whole or not there.
//
//   1c2f00a9 {"do":"set_advance","glyph":"a","width":500}
//
// The number is the CRC-32 of what follows the space. A line that a crash has
// cut is found by it, and everything before that line holds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/value.hpp"

namespace inkcell::design {

struct JournalRecords {
  std::vector<Value> records;
  /// Bytes of these records; what the file holds beyond them is damaged.
  size_t good_bytes = 0;
  size_t lost_bytes = 0;
};

/// The records of a journal up to the first damaged line. Throws Error if the
/// file cannot be read.
JournalRecords read_journal(const std::filesystem::path& file);

/// The commands of a script: a journal, or lines of JSON without checksums;
/// empty lines and lines that begin with # are skipped. Throws Error that names
/// file and line.
std::vector<Value> read_script(const std::filesystem::path& file);

/// A journal that grows.
class JournalFile {
 public:
  enum class Flush {
    always,  // a record is on the disk when append() returns
    never,   // the system may lose the last records if it crashes
  };

  /// Continues `file` after `good_bytes`, which cuts off the rest; 0 begins it
  /// anew. Throws Error.
  JournalFile(const std::filesystem::path& file,
              size_t good_bytes,
              Flush flush);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Throws Error.
  void append(const Value& record);

  const std::filesystem::path& path() const { return file_; }

 private:
  std::filesystem::path file_;
  Flush flush_;
  int handle_ = -1;
};

}  // namespace inkcell::design
