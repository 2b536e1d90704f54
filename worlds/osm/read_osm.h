// Reads OpenStreetMap as a Scene. It reads the rooms, corridors, doors, stairs and lifts of a building from Simple
// Indoor Tagging, and the outdoor ways near them. If doors do not join the rooms of a site, it reads all ways of the
// site. Any thread may call it; it uses two more threads during the call.
#pragma once

#include "worlds/floorplan/plan_scene.h"
#include "worlds/osm/osm_data.h"

namespace handrail::osm {

struct OsmOptions {
    // If there are several buildings: part of the name, the reference, or the number of the one to read. Empty: the one
    // with the most rooms is read.
    std::string building;
    floorplan::PlanOptions plan;
};

// Reads the file. The same bytes always give the same Scene. Fails with one sentence if the file is damaged, or
// contains nothing to walk on or too much.
Result<Scene> read_osm_building(std::string_view bytes, OsmForm form, const std::string& file_name,
                                const OsmOptions& options);

}  // namespace handrail::osm
