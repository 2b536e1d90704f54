// Explains in one sentence of the spoken language what is wrong with a command line. CLI11 finds the fault; the
// functions here choose the sentence. App thread.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace handrail::program {

// `app` is the command that was parsed. CLI11's own message is used only for a fault for which Handrail has no
// sentence.
std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error);

}  // namespace handrail::program
