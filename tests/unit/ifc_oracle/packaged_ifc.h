// Reads a file with libifcplusplus, the IFC library in Debian: an independent reading to compare ours with. Only
// packaged_ifc.cpp includes its headers. Single-threaded. Its results may differ from run to run, because it orders
// parts by their addresses.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "tests/support/names.h"
#include "worlds/geometry/convex.h"

namespace handrail::test {

struct PackagedPart {
    std::string kind;             // "IfcWall"
    Aabb box;                     // of the part's geometry with openings cut; relative to the file's own origin
    double closed_volume_m3 = 0;  // total volume of its closed meshes
    int open = 0;                 // number of meshes that are not closed
};

// All products by GlobalId, including those without geometry.
std::map<std::string, PackagedPart> parts_by_package(std::string_view file);

}  // namespace handrail::test
