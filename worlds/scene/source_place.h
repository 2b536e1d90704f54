// Where in its file something of a world stands.
#pragma once

namespace handrail {

// 0 when unknown.
struct SourcePlace {
    int line = 0;
    int entity = 0;
};

}  // namespace handrail
