// OpenStreetMap as a Scene: rooms, corridors, doors, stairs and lifts of a building as Simple Indoor Tagging has them,
// or the ways of a place where rooms are not joined. Any thread; reads with two more while it is called.
#pragma once

#include "worlds/drawn/plan_scene.h"
#include "worlds/osm/osm_data.h"

namespace handrail {

struct OsmOptions {
    std::string building;  // of several the one with this in its name, its reference or as its number; empty: the one
                           // with most rooms
    PlanOptions plan;
};

// The same bytes give the same Scene. Fails with one sentence for what is damaged, holds nothing to walk in or too
// much.
Result<Scene> read_osm_building(std::string_view bytes, OsmForm form, const std::string& file_name,
                                const OsmOptions& options);

}  // namespace handrail
