// What an owner chooses for a session once, when it is made. Plain data.
#pragma once

#include <filesystem>

#include "app/core/bodies/body_engines.h"
#include "worlds/base/arrivals.h"
#include "worlds/base/executor.h"

namespace handrail {

struct SessionOptions {
    // Where background tasks run; outlives the session.
    const Executor& executor = at_once();
    // Where best times are kept; empty: they last as long as the session.
    std::filesystem::path records_in = {};
    // Files of languages of the person's own; empty: there are the bundled ones.
    std::filesystem::path languages_in = {};
    BodyEngines bodies = {};
    // Reports or decides in which tick the result of a background task is there; outlives the session. Null: results
    // are there as soon as they are done.
    Arrivals* arrivals = nullptr;
};

}  // namespace handrail
