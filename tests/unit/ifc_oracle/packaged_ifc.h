// What libifcplusplus, the IFC library that Debian has, makes of a file: an independent reading to hold ours against.
// Its headers stand in packaged_ifc.cpp alone. One thread; what it says may differ from run to run, since it keeps
// parts by their addresses.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "worlds/geometry/convex.h"

namespace handrail::test {

struct PackagedPart {
    std::string kind;             // "IfcWall"
    Aabb box;                     // of its body, openings cut; from the file's own origin
    double closed_volume_m3 = 0;  // of its closed meshes
    int open = 0;                 // meshes that are not closed
};

// Products by GlobalId, those without a form too.
std::map<std::string, PackagedPart> parts_by_package(std::string_view file);

}  // namespace handrail::test
