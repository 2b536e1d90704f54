// The grammar of `handrail lesson`; the rest is in command_line.cpp. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/command_line.h"

namespace handrail::program {

// The command without its settings. Parsing fills in `call`, which outlives the grammar.
CLI::App* add_lesson_command(CLI::App& app, LessonCall& call);

}  // namespace handrail::program
