// Says what is wrong with a command line in one sentence of the spoken language: the parsing library finds the fault,
// the words are ours. App thread.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace handrail::program {

// `app` is the command that was parsed. The library's own words appear only for a fault for which we have no sentence.
std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error);

}  // namespace handrail::program
