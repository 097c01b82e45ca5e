// What main() of every program does: options, work, and a message if it fails.
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

/// "inkcell-fontgen 0.1.0, font format 0.2".
inline std::string version_of(const std::string& program) {
  const auto number = [](auto part) { return std::to_string(part); };
  return program + " " + number(kLibraryVersionMajor) + "." +
         number(kLibraryVersionMinor) + "." + number(kLibraryVersionPatch) +
         ", font format " + number(kFormatMajor) + "." + number(kFormatMinor);
}

/// What is wrong with the arguments. One that is not known comes first: where
/// it is misspelt, another one seems to be missing.
inline std::string problem_of(const CLI::App& app,
                              const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining();
  return unknown.empty() ? error.what() : unknown.front() + " is not expected";
}

/// Makes an option of a list take one value each time it is written, and its
/// help say so: what follows the value may be an argument of the program.
inline CLI::Option* take_one(CLI::Option* option) {
  return option->expected(1)->take_all()->allow_extra_args(false);
}

/// Arguments with `--option=` as `--option` and an empty one behind it, which
/// CLI11 would look for in the next argument.
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

/// Exit codes of all programs: 0, it is done; 1, it could not be done, and
/// standard error says why; 2, it is done, and the font that was judged misses
/// a limit.
inline constexpr int kFailed = 1;
inline constexpr int kMissed = 2;

/// Adds --version, parses the arguments and calls `work`. Returns what main()
/// shall: the result of `work`, or kFailed if the arguments are wrong or it
/// threw, with a message on standard error.
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
