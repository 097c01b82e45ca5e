// The output of a subcommand that draws: a picture or a glyph.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "shape/outline.hpp"

namespace inkcell::design {

struct Destination {
  std::string out;      // an SVG file
  std::string project;  // or a glyph of a project
  std::string glyph;
};

/// Adds --out, --project and --glyph.
void add_destination(CLI::App& command, Destination& destination);

/// Throws Error unless there is exactly one, and it can be written.
void check(const Destination& destination);

/// `title` is the picture's. Returns what was written, for messages.
std::string write(const gen::Outline& outline,
                  const Destination& destination,
                  const std::string& title);

}  // namespace inkcell::design
