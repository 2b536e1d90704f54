// How ways to goals went before: where a person who was led turned too early or went past a turn, kept in the world's
// side file (list `learnt_way`) where the person wants to be remembered, and told when one is led to that goal again. A
// way without such an error is learnt, and what was amiss before is forgotten. App thread only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_context.h"
#include "app/core/whereabouts/rooms.h"
#include "app/results/measures.h"

namespace handrail {

class WayMemory {
public:
    WayMemory(const SessionContext& context, Rooms& rooms) : context_(context), rooms_(rooms) {}
    WayMemory(const WayMemory&) = delete;
    WayMemory& operator=(const WayMemory&) = delete;

    void enter_world() { going_ = {}; }
    // Everything that happens in the session, as it happens.
    void see(const SessionEvent& event);
    // Once a tick: where the body is by now; tells what is remembered, and looks back on a way that has ended.
    void tick(double now_s);

private:
    void tell(double now_s);
    void look_back(double now_s);

    const SessionContext& context_;
    Rooms& rooms_;
    struct Going {
        std::string goal;  // empty: nowhere
        std::vector<WayPoint> walk;
        bool to_tell = false, arrived = false;
    } going_;
};

}  // namespace handrail
