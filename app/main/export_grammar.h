// Adds `handrail export` to the grammar of the command line; see command_line.cpp for the rest. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/commands.h"

namespace handrail::program {

// Adds the command without its settings and --map-scale. Parsing fills in `arguments`, which must exist for as long as
// the grammar.
CLI::App* add_export_command(CLI::App& app, ExportArguments& arguments);

}  // namespace handrail::program
