// Defines the place in a file from which a part of a world comes.
#pragma once

namespace handrail {

// Line and column count from 1; 0 means unknown.
struct SourcePlace {
    int line = 0;
    int entity = 0;
};

}  // namespace handrail
