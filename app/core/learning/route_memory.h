// Remembers how earlier guidance to goals went: where the person turned too early or passed a turn. The world's side
// file stores it (list `learnt_way`) if the person wants that. It is announced when guidance to the same goal begins
// again. A route walked without such an error counts as learnt, and its earlier errors are forgotten. App thread only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/whereabouts/rooms.h"
#include "app/results/measures.h"

namespace handrail::core {

class RouteMemory {
public:
    RouteMemory(const SessionContext& context, Rooms& rooms) : context_(context), rooms_(rooms) {}
    RouteMemory(const RouteMemory&) = delete;
    RouteMemory& operator=(const RouteMemory&) = delete;

    void enter_world() { going_ = {}; }
    // Call it with every event of the session.
    void see(const SessionEvent& event);
    // Call it once a tick. Notes the walker's place, announces what is remembered, and evaluates a route that has
    // ended.
    void tick(double now_s);

private:
    void tell(double now_s);
    void look_back(double now_s);

    const SessionContext& context_;
    Rooms& rooms_;
    struct Going {
        std::string goal;  // empty: no guidance
        std::vector<results::WayPoint> walk;
        bool to_tell = false, arrived = false;
    } going_;
};

}  // namespace handrail::core
