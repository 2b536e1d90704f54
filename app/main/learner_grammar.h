// Adds `handrail learner` and --learner to the grammar of the command line; see command_line.cpp for the rest. App
// thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/commands.h"

namespace handrail::program {

// Adds the command. Parsing fills in `arguments`, which must exist for as long as the grammar.
CLI::App* add_learner_command(CLI::App& app, LearnerArguments& arguments);

// Adds --learner NAME for exploring. --learner excludes --record-in, so --record-in must be in the grammar already.
void add_learner_option(CLI::App& app, ExploreArguments& arguments);

}  // namespace handrail::program
