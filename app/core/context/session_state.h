// Groups all plain state of a session with the context through which features read that state. Each session owns one
// object, and so does each test of features without a session. Use it on the app thread only.
#pragma once

#include <optional>

#include "app/core/context/owner_requests.h"
#include "app/core/context/session_context.h"

namespace handrail::core {

struct SessionState {
    explicit SessionState(const settings::Settings& settings, const HandFacts& hand = {},
                          const Executor& executor = at_once(), Arrivals* arrivals = nullptr,
                          RoomsKept* rooms_kept = nullptr)
        : person(settings), context{person.settings, person.keys, world,    avatar,   hands,    cues,      lists,
                                    additions,       events,      requests, executor, arrivals, rooms_kept} {
        hands.right = hand;
    }
    SessionState(const SessionState&) = delete;  // not copyable, because the context refers to this object
    SessionState& operator=(const SessionState&) = delete;

    Person person;
    HandsState hands;
    WorldState world;
    WalkerState avatar;
    Cues cues{avatar};
    Lists lists{cues};
    SideFile additions;
    // Time of the next attempt to save the additions; no value: nothing is unsaved.
    std::optional<double> additions_due_s;
    Events events;
    OwnerRequests requests;
    SessionContext context;
};

}  // namespace handrail::core
