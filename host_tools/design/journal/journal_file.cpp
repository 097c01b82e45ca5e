#include "journal/journal_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include "model/error.hpp"

namespace inkcell::design {
namespace {

constexpr size_t kSumDigits = 8;

std::string sum_of(const std::string& text) {
  const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(text.data()),
                          static_cast<uInt>(text.size()));
  char digits[kSumDigits + 1];
  std::snprintf(digits, sizeof digits, "%08lx", sum);
  return digits;
}

std::string read_all(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw Error(file.string() + ": cannot be read: " + std::strerror(errno));
  }
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

std::optional<Value> parse_record(const std::string& line) {
  if (line.size() <= kSumDigits || line[kSumDigits] != ' ') {
    return std::nullopt;
  }
  const std::string text = line.substr(kSumDigits + 1);
  if (sum_of(text) != line.substr(0, kSumDigits)) {
    return std::nullopt;
  }
  Value value = Value::parse(text, nullptr, false);
  return value.is_object() ? std::optional<Value>(std::move(value))
                           : std::nullopt;
}

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw Error(file.string() +
              ": the journal cannot be written: " + std::strerror(errno) +
              "; what is not saved yet would be lost in a crash");
}

}  // namespace

JournalRecords read_journal(const std::filesystem::path& file) {
  const std::string text = read_all(file);
  JournalRecords result;
  size_t end = 0;
  while ((end = text.find('\n', result.good_bytes)) != std::string::npos) {
    std::optional<Value> record =
        parse_record(text.substr(result.good_bytes, end - result.good_bytes));
    if (!record) {
      break;
    }
    result.records.push_back(std::move(*record));
    result.good_bytes = end + 1;
  }
  result.lost_bytes = text.size() - result.good_bytes;
  return result;
}

std::vector<Value> read_script(const std::filesystem::path& file) {
  std::istringstream lines(read_all(file));
  std::vector<Value> commands;
  std::string line;
  for (size_t number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line[0] == '#') {
      continue;
    }
    std::optional<Value> record;
    if (line[0] == '{') {
      Value value = Value::parse(line, nullptr, false);
      if (value.is_object()) {
        record = std::move(value);
      }
    } else {
      record = parse_record(line);
    }
    if (!record) {
      throw Error(file.string() + ":" + std::to_string(number) +
                  ": is no command, or is damaged; a command is a line such "
                  "as {\"do\": \"set_advance\", \"glyph\": \"a\", "
                  "\"width\": 500}");
    }
    commands.push_back(std::move(*record));
  }
  return commands;
}

JournalFile::JournalFile(const std::filesystem::path& file,
                         size_t good_bytes,
                         Flush flush)
    : file_(file), flush_(flush) {
  handle_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (handle_ < 0 ||
      ::ftruncate(handle_, static_cast<off_t>(good_bytes)) != 0 ||
      ::lseek(handle_, 0, SEEK_END) < 0) {
    fail(file_);
  }
}

JournalFile::~JournalFile() {
  ::close(handle_);
}

void JournalFile::append(const Value& record) {
  const std::string text = record.dump();
  const std::string line = sum_of(text) + " " + text + "\n";
  size_t done = 0;
  while (done < line.size()) {
    const ssize_t count =
        ::write(handle_, line.data() + done, line.size() - done);
    if (count < 0) {
      fail(file_);
    }
    done += static_cast<size_t>(count);
  }
  if (flush_ == Flush::always && ::fdatasync(handle_) != 0) {
    fail(file_);
  }
}

}  // namespace inkcell::design
