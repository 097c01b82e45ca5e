// The subcommands of inkcell-design.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace inkcell::design {

/// Each function adds a subcommand to `app`; if it is chosen, it sets `work` to
/// the task for main().
using Work = std::function<void()>;

void add_export(CLI::App& app, Work& work);
void add_import(CLI::App& app, Work& work);
void add_import_svg(CLI::App& app, Work& work);
void add_replay(CLI::App& app, Work& work);
void add_roundtrip(CLI::App& app, Work& work);
void add_script(CLI::App& app, Work& work);
void add_trace(CLI::App& app, Work& work);

}  // namespace inkcell::design
