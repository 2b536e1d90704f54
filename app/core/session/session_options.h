// What an owner sets once when it makes a session. Plain data.
#pragma once

#include <filesystem>

#include "app/core/bodies/body_engines.h"
#include "app/core/whereabouts/rooms_kept.h"
#include "worlds/base/arrivals.h"
#include "worlds/base/executor.h"

namespace handrail::core {

struct SessionOptions {
    // Runs the background tasks; outlives the session.
    const Executor& executor = at_once();
    // Folder for best times; empty: they last as long as the session.
    std::filesystem::path records_in = {};
    // Folder of the person's own language files; empty: only the bundled ones.
    std::filesystem::path languages_in = {};
    BodyEngines bodies = {};
    // Records or determines in which tick the result of a background task arrives; outlives the session. Null: results
    // arrive as soon as they are ready.
    Arrivals* arrivals = nullptr;
    // Rooms of worlds that other sessions on this thread enter as well; outlives the session. Null: the session finds
    // its own.
    RoomsKept* rooms_kept = nullptr;
};

}  // namespace handrail::core
