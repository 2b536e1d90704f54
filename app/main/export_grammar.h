// The grammar of `handrail export`, beside the rest in command_line.cpp. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/commands.h"

namespace handrail {

// The command without its settings and the scale of maps; `arguments` are filled in place and outlive the grammar.
CLI::App* add_export_command(CLI::App& app, ExportArguments& arguments);

}  // namespace handrail
