// The grammar of Quake-family .map files, without its meaning: entities with keys brushes of three-point faces,
// Standard or Valve 220 per face or within brushDef, planes of brushDef3 (Doom 3), and curved patches. Takes any bytes:
// damage is reported and what is complete is kept. No recursion. Time and memory are proportional to the file.
#pragma once

#include <array>
#include <stop_token>
#include <string_view>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/bezier_patch.h"
#include "worlds/readers/diagnostics.h"

namespace handrail {

// Views point into the bytes that were parsed.
struct MapKey {
    std::string_view key, value;  // as between the quotes, backslashes included
    TextPlace place;              // of the value
};

struct MapFace {
    std::array<Vec3, 3> points_units;
    std::string_view texture;
    TextPlace place;
};

struct MapBrush {
    std::vector<MapFace> faces;
    TextPlace place;
};

// A curved surface, patchDef2 or patchDef3: control points in units. The splits that patchDef3 names are left to the
// reader's own error bound.
struct MapPatch {
    PatchGrid grid_units;
    std::string_view texture;
    TextPlace place;
};

struct MapEntity {
    std::vector<MapKey> keys;  // a key given twice stands here once, with its last value
    std::vector<MapBrush> brushes;
    std::vector<MapPatch> patches;
    TextPlace place;

    const MapKey* find(std::string_view key) const;
    std::string_view value(std::string_view key) const;  // empty when absent
};

struct MapFile {
    std::vector<MapEntity> entities;
    int brushes = 0;          // complete ones and damaged ones
    int brushes_damaged = 0;  // left out
    int curves_damaged = 0;   // patchDef2, patchDef3: left out
    int primitives = 0;       // other forms: left out
    int version = 0;          // as its first line says; 2 and later: forms lie around the origin of their entity
};

// Stopped in the middle it gives what it has by then.
MapFile parse_map(std::string_view bytes, Diagnostics& diagnostics, const std::stop_token& stop = {});

// What a quoted string says: \" becomes ", everything else stays.
std::string unquoted(std::string_view raw);

}  // namespace handrail
