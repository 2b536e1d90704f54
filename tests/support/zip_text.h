// ZIP archives for tests.
#pragma once

#include <map>
#include <string>

#include "tests/support/names.h"

namespace handrail::test {

// All files are stored uncompressed, or deflated.
std::string zipped(const std::map<std::string, std::string>& files, bool deflated = false);

}  // namespace handrail::test
