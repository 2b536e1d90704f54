// Parses the grammar of .map files of the Quake family, without their meaning: entities with keys, brushes and curved
// patches. Three points or a plane define a brush face. Faces with points have the Standard or the Valve 220 form,
// which may differ from face to face, plain or within brushDef. Faces with planes are those of brushDef3 (Doom 3). The
// parser accepts any bytes; it reports damage and keeps the complete parts. It uses no recursion. Time and memory are
// proportional to the size of the file.
#pragma once

#include <array>
#include <stop_token>
#include <string_view>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/geometry/bezier_patch.h"
#include "worlds/readers/diagnostics.h"

namespace handrail::readers {

// A key of an entity with its value. The string views point into the parsed bytes.
struct MapKey {
    std::string_view key, value;  // the text between the quotes, with its backslashes
    TextPlace place;              // place of the value in the file
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

// A curved surface, patchDef2 or patchDef3, with control points in map units. The split counts of patchDef3 are
// ignored, because the reader splits by its own error bound.
struct MapPatch {
    PatchGrid grid_units;
    std::string_view texture;
    TextPlace place;
};

struct MapEntity {
    std::vector<MapKey> keys;  // each key occurs once; if the file repeats a key, the last value is used
    std::vector<MapBrush> brushes;
    std::vector<MapPatch> patches;
    TextPlace place;

    const MapKey* find(std::string_view key) const;
    std::string_view value(std::string_view key) const;  // returns an empty text if the key is missing
};

struct MapFile {
    std::vector<MapEntity> entities;
    int brushes = 0;          // number of brushes, complete and damaged
    int brushes_damaged = 0;  // number of damaged brushes, which are left out
    int curves_damaged = 0;   // number of damaged patches (patchDef2 and patchDef3), which are left out
    int primitives = 0;       // number of shapes in other forms, which are left out
    // Version of the format, from the first line of the file; from 2 on, coordinates are relative to the origin of
    // their entity.
    int version = 0;
};

// Parses a map. After a stop request it returns the part that it has read by then.
MapFile parse_map(std::string_view bytes, Diagnostics& diagnostics, const std::stop_token& stop = {});

// Decodes a quoted string: \" becomes ", everything else is unchanged.
std::string unquoted(std::string_view raw);

}  // namespace handrail::readers
