#include "worlds/osm/read_osm.h"

#include "worlds/base/language.h"
#include "worlds/osm/osm_plan.h"

namespace handrail::osm {

Result<Scene> read_osm_building(std::string_view bytes, OsmForm form, const std::string& file_name,
                                const OsmOptions& options) {
    Result<floorplan::FloorPlan> plan = [&]() -> Result<floorplan::FloorPlan> {
        const Result<OsmData> data = read_osm_data(bytes, form, file_name, options.plan.stop);
        if (!data) return tl::unexpected(data.error());
        if (options.plan.progress) options.plan.progress(0.2);
        return OsmPlan(*data, options).build(file_name);
    }();
    if (!plan) return tl::unexpected(plan.error());
    if (options.plan.stop.stop_requested()) return fail(phrase("files.stopped"), file_name);
    return floorplan::scene_of_plan(std::move(*plan), file_name, options.plan);
}

}  // namespace handrail::osm
