// Reads the Indoor Mapping Data Format (IMDF), a ZIP archive of GeoJSON, as a Scene: levels, units as rooms, openings
// as doors. Any thread may call it.
#pragma once

#include <string_view>

#include "worlds/floorplan/plan_scene.h"

namespace handrail::imdf {

struct ImdfOptions {
    // If a venue has several buildings: part of the name, or the number, of the one to read. Empty: all buildings are
    // read.
    std::string building;
    floorplan::PlanOptions plan;
};

// Returns true for a ZIP archive that lists a unit.geojson, or a manifest and other GeoJSON files, in any folder.
bool is_imdf(std::string_view bytes);

// Reads a venue. The same bytes always give the same Scene. Fails with one sentence if the archive is damaged, or
// contains no units or too many.
Result<Scene> read_imdf_venue(std::string_view bytes, const std::string& file_name, const ImdfOptions& options);

}  // namespace handrail::imdf
