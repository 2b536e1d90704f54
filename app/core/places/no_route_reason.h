// Explains why a room cannot be reached and what would help, to a person who requested a route to the room. A
// background task finds the reason, because it must build the walkable area again for other sizes of the walker. Use
// this class on the app thread only.
#pragma once

#include <string>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"
#include "worlds/base/background_task.h"

namespace handrail::core {

class NoRouteReason : SessionPart {
public:
    NoRouteReason(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world() { looking_.give_up(); }
    // Examines a room of the room graph, and announces the reason once it is known. Announces nothing if the room can
    // be reached from the base.
    void look(std::uint32_t room);
    void tick(double now_s);

private:
    Rooms& rooms_;
    BackgroundTask<std::string> looking_{context_.executor, "why-no-way", context_.arrivals};
};

}  // namespace handrail::core
