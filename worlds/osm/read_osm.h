// Reads OpenStreetMap as a Scene: the rooms, corridors, doors, stairs and lifts of a building by Simple Indoor Tagging,
// or the outdoor ways of a site whose rooms are not joined. Any thread may call it; it uses two more threads during the
// call.
#pragma once

#include "worlds/floorplan/plan_scene.h"
#include "worlds/osm/osm_data.h"

namespace handrail::osm {

struct OsmOptions {
    // If there are several buildings, the one to read, by part of its name, its reference or its number; empty: the one
    // with the most rooms.
    std::string building;
    floorplan::PlanOptions plan;
};

// The same bytes always give the same Scene. Fails with one sentence if the file is damaged, or contains nothing to
// walk on or too much.
Result<Scene> read_osm_building(std::string_view bytes, OsmForm form, const std::string& file_name,
                                const OsmOptions& options);

}  // namespace handrail::osm
