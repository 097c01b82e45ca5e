// The command-line options of all programs that generate fonts.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "pipeline/request.hpp"

namespace inkcell::gen {

/// Parses a tolerance, "16/255" or "16". Throws CLI::ValidationError.
double parse_tolerance(const std::string& text);

/// Parses "12:1", "16:4:vertical". Throws CLI::ValidationError.
StrikeTarget parse_strike(const std::string& text);

/// Parses a part of the glyphs, "0/4". Throws CLI::ValidationError.
GlyphPart parse_part(const std::string& text);

/// Adds the options from --face to --effort, which fill in `request`; it must
/// live until `app` has parsed. The program adds the font file, text files and
/// threads.
void add_generator_options(CLI::App& app, GenerateRequest& request);

}  // namespace inkcell::gen
