// Reads the path of a hand from a text, so that `handrail touch` can replay the path. The text is a header t,x,y,z and
// a row of four numbers for each tick.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail::program {

struct PathRow {
    double t_s = 0.0;  // finite, and later than in the row before
    // World position; may be any value, including nan and inf, because a device with a fault may have written it.
    Vec3 position_m{0.0};
};

// Returns all rows, or an error for the first mistake, with its line. `file` is the file's name in errors. Spaces,
// tabs, CR LF, empty lines and a byte order mark are accepted.
Result<std::vector<PathRow>> parse_path(std::string_view text, const std::string& file);

}  // namespace handrail::program
