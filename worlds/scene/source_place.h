// The place in a file that a part of a world comes from.
#pragma once

namespace handrail {

// 0 means unknown.
struct SourcePlace {
    int line = 0;
    int entity = 0;
};

}  // namespace handrail
