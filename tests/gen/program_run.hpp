// Runs inkcell-fontgen from a shell.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "paths.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

/// Runs the program in `folder`; its output files are in another one.
inline Outcome run(const TestFolder& folder, const std::string& arguments) {
  const TestFolder logs;
  const std::string command = "cd '" + folder.path().string() + "' && " +
                              kFontgen + " " + arguments + " >'" +
                              (logs.path() / "out").string() + "' 2>'" +
                              (logs.path() / "err").string() + "'";
  Outcome result;
  const int status = std::system(command.c_str());
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  const auto text = [&](const char* name) {
    const std::vector<uint8_t> bytes = read_file(logs.path() / name);
    return std::string(bytes.begin(), bytes.end());
  };
  result.out = text("out");
  result.err = text("err");
  return result;
}

}  // namespace inkcell::gen::test
