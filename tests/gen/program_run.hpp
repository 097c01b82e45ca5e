// Runs inkcell-fontgen from a shell.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "messages.hpp"
#include "paths.hpp"
#include "sfnt_builder.hpp"

namespace inkcell::gen::test {

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

/// Runs the program in a folder that has plain.ttf, a font of a few rectangles:
/// fast, and nothing to install.
class ProgramTest : public testing::Test {
 protected:
  using Names = std::vector<std::string>;

  ProgramTest() { folder_.write("plain.ttf", Sfnt::plain()); }

  /// Its output files are in another folder.
  Outcome run(const std::string& arguments) const {
    const TestFolder logs;
    const std::string command = "cd '" + folder_.path().string() + "' && " +
                                kFontgen + " " + arguments + " >'" +
                                (logs.path() / "out").string() + "' 2>'" +
                                (logs.path() / "err").string() + "'";
    Outcome result;
    const int status = std::system(command.c_str());
    result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.out = read_text(logs.path() / "out");
    result.err = read_text(logs.path() / "err");
    return result;
  }
  /// Runs it, which must not fail.
  Outcome make(const std::string& arguments) const {
    Outcome result = run(arguments);
    EXPECT_EQ(result.code, 0) << arguments << ": " << result.err;
    return result;
  }
  /// Fails with this message and leaves no files.
  void check_refused(const std::string& arguments,
                     const std::string& said) const {
    const Names before = folder_.names();
    const Outcome result = run(arguments);
    EXPECT_EQ(result.code, 1) << arguments;
    EXPECT_TRUE(contains(result.err, said)) << arguments;
    // Messages of work that has begun may come before.
    EXPECT_TRUE(contains("\n" + result.err, "\nerror: "));
    EXPECT_EQ(folder_.names(), before) << arguments;
  }

  std::vector<uint8_t> bytes_of(const std::string& name) const {
    return read_file(folder_.path() / name);
  }
  std::string text_of(const std::string& name) const {
    return read_text(folder_.path() / name);
  }
  /// What --report a.json wrote.
  nlohmann::json read_report() const {
    return nlohmann::json::parse(text_of("a.json"));
  }

  TestFolder folder_;
};

}  // namespace inkcell::gen::test
