// The grammar of `handrail learner` and of --learner, beside the rest in command_line.cpp. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/commands.h"

namespace handrail {

// The command; `arguments` are filled in place and outlive the grammar.
CLI::App* add_learner_command(CLI::App& app, LearnerArguments& arguments);

// --learner NAME of exploring; not together with --record-in, which is there by then.
void add_learner_option(CLI::App& app, ExploreArguments& arguments);

}  // namespace handrail
