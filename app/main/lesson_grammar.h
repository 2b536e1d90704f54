// Adds `handrail lesson` to the grammar of the command line; see command_line.cpp for the rest. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/command_line.h"

namespace handrail::program {

// Adds the command without its settings. Parsing fills in `call`, which must exist for as long as the grammar.
CLI::App* add_lesson_command(CLI::App& app, LessonCall& call);

}  // namespace handrail::program
