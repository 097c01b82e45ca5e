// Records on disk, one a line, each complete or ignored.
//
//   1c2f00a9 {"do":"set_advance","glyph":"a","width":500}
//
// The number is the CRC-32 of the text after the space. It detects a line that
// a crash has cut; all lines before it are valid.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/value.hpp"

namespace inkcell::design {

struct JournalRecords {
  std::vector<Value> records;
  /// Bytes of valid records; the rest of the file is damaged.
  size_t good_bytes = 0;
  size_t lost_bytes = 0;
};

/// The records of a journal up to the first damaged line. Throws Error if the
/// file cannot be read.
JournalRecords read_journal(const std::filesystem::path& file);

/// The commands of a script: a journal, or lines of JSON without checksums.
/// Skips empty lines and lines that begin with #. Throws Error that names file
/// and line.
std::vector<Value> read_script(const std::filesystem::path& file);

/// A journal that is appended to.
class JournalFile {
 public:
  enum class Flush {
    always,  // a record is on the disk when append() returns
    never,   // the system may lose the last records if it crashes
  };

  /// Continues `file` after `good_bytes` and cuts off the rest; 0 starts it
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
