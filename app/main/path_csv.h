// The path of a hand that `handrail touch` replays, as text: a head t,x,y,z and a row of four numbers for each tick.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/base/vec.h"

namespace handrail {

struct PathRow {
    double t_s = 0.0;      // finite, later than the row before
    Vec3 position_m{0.0};  // world; may be anything, as a broken device leaves it
};

// Every row, or the first mistake with its line; `file` is the name it is told by. Spaces, tabs, CR LF, empty lines and
// a byte order mark are no mistakes.
Result<std::vector<PathRow>> parse_path(std::string_view text, const std::string& file);

}  // namespace handrail
