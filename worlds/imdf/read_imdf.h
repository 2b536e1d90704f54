// The Indoor Mapping Data Format (IMDF), a ZIP archive of GeoJSON, as a Scene: levels, units as rooms, openings as
// doors. Any thread.
#pragma once

#include <string_view>

#include "worlds/drawn/plan_scene.h"

namespace handrail {

struct ImdfOptions {
    std::string building;  // of several the one with this in its name or as its number; empty: all of a venue
    PlanOptions plan;
};

// A ZIP archive that names a unit.geojson or a manifest beside others, in whatever folder.
bool is_imdf(std::string_view bytes);

// The same bytes give the same Scene. Fails with one sentence for an archive that is damaged, holds no units or too
// many.
Result<Scene> read_imdf_venue(std::string_view bytes, const std::string& file_name, const ImdfOptions& options);

}  // namespace handrail
