#include "app/core/scenario/read_request.h"

namespace handrail::core {

readers::ReadOptions read_options(const WorldRequest& request) {
    readers::ReadOptions options;
    if (request.map_scale_m_per_unit) options.map_metres_per_unit = *request.map_scale_m_per_unit;
    if (request.unit_m) options.map_metres_per_unit = options.obj_metres_per_unit = *request.unit_m;
    options.building = request.building;
    options.unit_is_known = request.map_scale_m_per_unit || request.unit_m;
    return options;
}

Result<Scene> read_requested(const WorldRequest& request) {
    return readers::read_world(request.file, read_options(request));
}

}  // namespace handrail::core
