// Remembers errors during earlier guidance to goals: where the person turned too early or passed a turn. If the person
// wants errors to be remembered, the world's side file stores them (list `learnt_way`). When guidance to the same goal
// begins again, the errors are announced. After a walk without such an error, the route is learnt, and its earlier
// errors are forgotten. Use this class on the app thread only.
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
    // Notes an event. Call it with every event of the session.
    void see(const SessionEvent& event);
    // Notes the walker's position. Announces the remembered errors when guidance begins, and evaluates a route when the
    // person has arrived. Call it once a tick.
    void tick(double now_s);

private:
    void announce(double now_s);
    void look_back(double now_s);

    const SessionContext& context_;
    Rooms& rooms_;
    struct Going {
        std::string goal;  // name of the goal; empty: no guidance
        std::vector<results::WalkedPoint> walk;
        bool to_announce = false, arrived = false;
    } going_;
};

}  // namespace handrail::core
