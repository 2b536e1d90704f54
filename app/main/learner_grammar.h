// The grammar of `handrail learner` and of --learner; the rest is in command_line.cpp. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/commands.h"

namespace handrail::program {

// Adds the command. Parsing fills in `arguments`, which outlive the grammar.
CLI::App* add_learner_command(CLI::App& app, LearnerArguments& arguments);

// Adds --learner NAME for exploring. It excludes --record-in, which must already be in the grammar.
void add_learner_option(CLI::App& app, ExploreArguments& arguments);

}  // namespace handrail::program
