// Options that the owner of a session sets once, when it makes the session. Plain data.
#pragma once

#include <filesystem>

#include "app/core/bodies/body_engines.h"
#include "app/core/whereabouts/rooms_kept.h"
#include "worlds/base/arrivals.h"
#include "worlds/base/executor.h"

namespace handrail::core {

struct SessionOptions {
    // Runs the background tasks. It must outlive the session.
    const Executor& executor = at_once();
    // Folder for best times. If it is empty, they are lost when the session ends.
    std::filesystem::path records_in = {};
    // Folder of the person's own language files. If it is empty, there are only the bundled languages.
    std::filesystem::path languages_in = {};
    BodyEngines bodies = {};
    // Records or determines in which tick the result of a background task arrives. It must outlive the session. Null:
    // results arrive as soon as they are ready.
    Arrivals* arrivals = nullptr;
    // The rooms of worlds that several sessions on this thread enter, so that they are searched for only once. It must
    // outlive the session. Null: the session searches for them itself.
    RoomsKept* rooms_kept = nullptr;
};

}  // namespace handrail::core
