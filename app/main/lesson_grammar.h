// The grammar of `handrail lesson`, beside the rest in command_line.cpp. App thread.
#pragma once

#include <CLI/CLI.hpp>

#include "app/main/command_line.h"

namespace handrail {

// The command without its settings; `call` is filled in place and outlives the grammar.
CLI::App* add_lesson_command(CLI::App& app, LessonCall& call);

}  // namespace handrail
