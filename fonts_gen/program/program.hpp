// The frame of every main(): options, work, and a message if it fails.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "inkcell/version.hpp"

namespace inkcell::tools {

/// "inkcell-fontgen 0.2.0, font format 0.3".
inline std::string version_of(const std::string& program) {
  const auto number = [](auto part) { return std::to_string(part); };
  return program + " " + number(kLibraryVersionMajor) + "." +
         number(kLibraryVersionMinor) + "." + number(kLibraryVersionPatch) +
         ", font format " + number(kFormatMajor) + "." + number(kFormatMinor);
}

/// The first problem of the arguments. Unknown ones come first: a misspelt
/// option may make another one seem missing.
inline std::string problem_of(const CLI::App& app,
                              const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining();
  return unknown.empty() ? error.what() : unknown.front() + " is not expected";
}

/// Makes a list option take one value at a time, also in its help: the next
/// word may be an argument of the program.
inline CLI::Option* take_one(CLI::Option* option) {
  return option->expected(1)->take_all()->allow_extra_args(false);
}

/// Splits `--option=` into `--option` and an empty argument; otherwise CLI11
/// would use the next argument as the value.
class Words {
 public:
  Words(int argc, char** argv) {
    bool are_options = true;
    for (int i = 0; i < argc; ++i) {
      const std::string word = argv[i];
      are_options = are_options && word != "--";
      const bool is_empty = are_options && i > 0 && word.size() > 3 &&
                            word.compare(0, 2, "--") == 0 &&
                            word.find('=') == word.size() - 1;
      words_.push_back(is_empty ? word.substr(0, word.size() - 1) : word);
      if (is_empty) {
        words_.emplace_back();
      }
    }
    for (const std::string& word : words_) {
      pointers_.push_back(word.c_str());
    }
  }

  int count() const { return static_cast<int>(pointers_.size()); }
  const char* const* data() const { return pointers_.data(); }

 private:
  std::vector<std::string> words_;
  std::vector<const char*> pointers_;
};

/// Exit codes of all programs: 0: done; 1: failed, with a message on standard
/// error; 2: done, but the judged font misses a limit.
inline constexpr int kFailed = 1;
inline constexpr int kMissed = 2;

/// Adds --version, parses the arguments and calls `work`. Returns the result of
/// main(): that of `work`, or kFailed with a message on standard error if the
/// arguments are wrong or it threw.
template <typename Work>
int run_program(CLI::App& app, int argc, char** argv, const Work& work) {
  app.set_version_flag(
      "--version",
      version_of(std::filesystem::path(argv[0]).filename().string()));
  try {
    const Words words(argc, argv);
    app.parse(words.count(), words.data());
    return work();
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "error: %s; see --help\n",
                 problem_of(app, error).c_str());
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "error: there is not enough memory for that\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
  }
  return kFailed;
}

}  // namespace inkcell::tools
