// The grammar of .map files of the Quake family, without its meaning: entities with keys, brushes and curved patches.
// Brush faces are three points, Standard or Valve 220 for each face, plain or within brushDef; or planes of brushDef3
// (Doom 3). Accepts any bytes: reports damage and keeps what is complete. No recursion. Time and memory are
// proportional to the file.
#pragma once

#include <array>
#include <stop_token>
#include <string_view>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/bezier_patch.h"
#include "worlds/readers/diagnostics.h"

namespace handrail::readers {

// The string views point into the parsed bytes.
struct MapKey {
    std::string_view key, value;  // the text between the quotes, including backslashes
    TextPlace place;              // where the value is
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

// A curved surface, patchDef2 or patchDef3: control points in map units. The split counts of patchDef3 are ignored; the
// reader's own error bound decides.
struct MapPatch {
    PatchGrid grid_units;
    std::string_view texture;
    TextPlace place;
};

struct MapEntity {
    std::vector<MapKey> keys;  // a key given twice is here once, with its last value
    std::vector<MapBrush> brushes;
    std::vector<MapPatch> patches;
    TextPlace place;

    const MapKey* find(std::string_view key) const;
    std::string_view value(std::string_view key) const;  // empty if the key is missing
};

struct MapFile {
    std::vector<MapEntity> entities;
    int brushes = 0;          // both complete and damaged ones
    int brushes_damaged = 0;  // damaged ones, which are left out
    int curves_damaged = 0;   // damaged patchDef2 and patchDef3, which are left out
    int primitives = 0;       // other forms, which are left out
    int version = 0;          // from its first line; from 2 on, coordinates are relative to the origin of their entity
};

// If stopped, it returns what it has read so far.
MapFile parse_map(std::string_view bytes, Diagnostics& diagnostics, const std::stop_token& stop = {});

// Decodes a quoted string: \" becomes ", everything else stays.
std::string unquoted(std::string_view raw);

}  // namespace handrail::readers
