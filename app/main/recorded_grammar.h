// Adds `handrail replay` and `handrail report` to the grammar of the command line.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/command_line.h"

namespace handrail::program {

CLI::App* add_replay_command(CLI::App& app, ReplayArguments& arguments);
CLI::App* add_report_command(CLI::App& app, ReportArguments& arguments);

}  // namespace handrail::program
