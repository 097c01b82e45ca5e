// What main() of every program does: options, work, and a message if it fails.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

namespace inkcell::tools {

/// Parses the arguments and calls `work`. Returns what main() shall: the result
/// of `work`, `failed` if it threw, or what CLI11 says of wrong arguments.
template <typename Work>
int run_program(
    CLI::App& app, int argc, char** argv, const Work& work, int failed = 1) {
  CLI11_PARSE(app, argc, argv);
  try {
    return work();
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "error: there is not enough memory for that\n");
    return failed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return failed;
  }
}

}  // namespace inkcell::tools
