// The command-line options for more faces and for icons.
#pragma once

#include <CLI/CLI.hpp>

#include "pipeline/request.hpp"

namespace inkcell::gen {

/// Adds --merge and the options that begin with --svg, which fill in `request`;
/// it must live until `app` has parsed.
void add_face_options(CLI::App& app, GenerateRequest& request);

}  // namespace inkcell::gen
