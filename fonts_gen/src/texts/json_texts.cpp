#include "texts/json_texts.hpp"

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>

namespace inkcell::gen {
namespace {

using Json = nlohmann::json;

// Bytes of a file that count their lines.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, int& line) : at_(at), line_(&line) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    *line_ += *at_ == '\n' ? 1 : 0;
    ++at_;
    return *this;
  }
  bool operator==(const CountingIterator& other) const {
    return at_ == other.at_;
  }
  bool operator!=(const CountingIterator& other) const {
    return at_ != other.at_;
  }

 private:
  const char* at_;
  int* line_;
};

// Takes the strings while the file is read.
class StringTaker : public nlohmann::json_sax<Json> {
 public:
  StringTaker(const std::string& file, const int& line, LocatedText& out)
      : file_(file), line_(line), out_(out) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool string(string_t& text) override {
    add_shown(text, line_, file_, out_);
    return true;
  }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t,
                   const std::string&,
                   const nlohmann::detail::exception& error) override {
    // "[json.exception.parse_error.101] parse error at line 2, column 3: ..."
    std::string what = error.what();
    const size_t colon = what.find(": ");
    what = colon == std::string::npos ? what : what.substr(colon + 2);
    refuse(file_, line_,
           "the JSON is wrong here: " + what +
               "; check commas, brackets and quotation marks, and save the "
               "file as UTF-8");
  }

 private:
  const std::string& file_;
  const int& line_;
  LocatedText& out_;
};

}  // namespace

void read_json_file(std::string_view content,
                    const std::string& file,
                    LocatedText& out) {
  int line = 1;
  StringTaker taker(file, line, out);
  Json::sax_parse(CountingIterator(content.data(), line),
                  CountingIterator(content.data() + content.size(), line),
                  &taker);
}

}  // namespace inkcell::gen
