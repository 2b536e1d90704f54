// The grammar of `handrail export`; the rest is in command_line.cpp. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/commands.h"

namespace handrail::program {

// The command without its settings and the map scale. Parsing fills in `arguments`, which outlive the grammar.
CLI::App* add_export_command(CLI::App& app, ExportArguments& arguments);

}  // namespace handrail::program
