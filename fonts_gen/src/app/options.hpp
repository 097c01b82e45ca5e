// The command-line options that all programs which generate fonts share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "pipeline/request.hpp"

namespace inkcell::gen {

/// Reads a tolerance, "16/255" or "16". Throws CLI::ValidationError.
double parse_tolerance(const std::string& text);

/// Adds --face, --axis, --chars, --symbols, --min-px, --max-px, --tolerance,
/// --coding, --predicate and --effort, which fill in `request`; it
/// must live until `app` has parsed. The font file, text files and threads are
/// left to the program: inkcell-render gives --text and --jobs other meanings.
void add_generator_options(CLI::App& app, GenerateRequest& request);

}  // namespace inkcell::gen
