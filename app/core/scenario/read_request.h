// How a reader is asked for the world of a request. Pure function; any thread.
#pragma once

#include "app/core/kept/world_request.h"
#include "worlds/readers/reader.h"

namespace handrail {

ReadOptions read_options(const WorldRequest& request);

}  // namespace handrail
