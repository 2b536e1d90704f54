// Defines the options that the owner of a session sets once, when it makes the session. Plain data.
#pragma once

#include <filesystem>
#include <string>

#include "app/core/bodies/body_engines.h"
#include "app/core/whereabouts/rooms_kept.h"
#include "worlds/base/arrivals.h"
#include "worlds/base/executor.h"

namespace handrail::core {

struct SessionOptions {
    // Runs the background tasks. It must outlive the session.
    const Executor& executor = at_once();
    // Folder for best times. If it is empty, best times are lost when the session ends.
    std::filesystem::path records_in = {};
    // The day on which the session begins, such as "2026-12-01", for the person's diary; empty: not known.
    std::string day = {};
    // Folder of the person's own language files. If it is empty, only the bundled languages can be spoken.
    std::filesystem::path languages_in = {};
    BodyEngines bodies = {};
    // Records or determines in which tick the result of a background task arrives. It must outlive the session. If it
    // is null, results arrive as soon as they are ready.
    Arrivals* arrivals = nullptr;
    // Shares the rooms of a world between several sessions on this thread, so that the program searches for the rooms
    // only once. It must outlive the session. If it is null, the session searches for the rooms itself.
    RoomsKept* rooms_kept = nullptr;
};

}  // namespace handrail::core
