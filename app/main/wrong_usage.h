// What is wrong with a command line, in one sentence of the language spoken: what the parsing library found, in our
// words. App thread.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace handrail {

// app: the command whose words they are. The library's own words only where it has found something that none of ours
// tells.
std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error);

}  // namespace handrail
