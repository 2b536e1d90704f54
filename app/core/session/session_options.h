// What an owner chooses for a session once, when it is made. Plain data.
#pragma once

#include <filesystem>

#include "app/core/bodies/body_engines.h"
#include "app/core/world/arrivals.h"

namespace handrail {

struct SessionOptions {
    // Rooms and ways of each world are found on a thread beside everything else; else when they are first asked for.
    bool rooms_beside = false;
    // Likewise what a hand feels of each world, and of every later scale: until it is there the hand feels what there
    // was, at first the world as sharp as it is.
    bool touch_beside = false;
    // Where best times are kept; empty: they last as long as the session.
    std::filesystem::path records_in = {};
    // Files of languages of the person's own; empty: there are the bundled ones.
    std::filesystem::path languages_in = {};
    BodyEngines bodies = {};
    // Tells or decides when what is worked out beside is there; outlives the session. Null: it comes as it comes.
    Arrivals* arrivals = nullptr;
};

}  // namespace handrail
