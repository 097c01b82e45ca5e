// The command-line options that all programs which generate fonts share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "pipeline/request.hpp"

namespace inkcell::gen {

/// Reads a tolerance, "16/255" or "16". Throws CLI::ValidationError.
double parse_tolerance(const std::string& text);

/// Adds the options that say what to generate, from --face to --effort, which
/// fill in `request`; it must live until `app` has parsed. The font file, text
/// files and threads are left to the program.
void add_generator_options(CLI::App& app, GenerateRequest& request);

}  // namespace inkcell::gen
