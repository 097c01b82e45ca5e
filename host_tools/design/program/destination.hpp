// The output of a subcommand that draws: a picture or a glyph.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "import/outline_commands.hpp"
#include "shape/outline.hpp"

namespace inkcell::design {

struct Destination {
  std::string out;      // an SVG file
  std::string project;  // or a glyph of a project
  std::string glyph;
  std::string unicode;
  OutlineUse use;
};

/// Adds --out, --project and --glyph with its options.
void add_destination(CLI::App& command, Destination& destination);

/// Reads the options. Throws Error unless there is exactly one destination, and
/// it can be written.
void check(Destination& destination);

/// `title` is the picture's. Returns what was done, for messages: contours that
/// were added or replaced, the code point and the advance of a new glyph.
std::string write(const gen::Outline& outline,
                  const Destination& destination,
                  const std::string& title);

}  // namespace inkcell::design
