// Makes ZIP archives for tests.
#pragma once

#include <map>
#include <string>

#include "tests/support/names.h"

namespace handrail::test {

// Returns an archive in which all files are uncompressed or, with `deflated`, all are deflated.
std::string zipped(const std::map<std::string, std::string>& files, bool deflated = false);

}  // namespace handrail::test
