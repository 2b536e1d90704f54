// Reads an IFC file with libifcplusplus, the IFC library in Debian, as an independent reading for comparison. Only
// packaged_ifc.cpp includes the library's headers. Single-threaded. The results may differ from run to run, because the
// library orders parts by their addresses.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "tests/support/names.h"
#include "worlds/geometry/convex.h"

namespace handrail::test {

struct PackagedPart {
    std::string kind;  // IFC class of the part, such as "IfcWall"
    Aabb box;          // bounds of the part's geometry after its openings are cut, relative to the file's own origin
    double closed_volume_m3 = 0;  // total volume of the part's closed meshes
    int open = 0;                 // number of meshes that are not closed
};

// Returns all products of the file by GlobalId, including those without geometry.
std::map<std::string, PackagedPart> parts_by_package(std::string_view file);

}  // namespace handrail::test
