// Why nobody comes to a room, and what would help, said to a person who asked for the route to it. Found in the
// background, since the walkable space is made anew for other bodies. App thread only.
#pragma once

#include <string>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"
#include "worlds/base/background_task.h"

namespace handrail {

class WhyNoWay : SessionPart {
public:
    WhyNoWay(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world() { looking_.give_up(); }
    // Of a room of the graph; told as soon as it is known, nothing where one comes there from the base.
    void look(std::uint32_t room);
    void tick(double now_s);

private:
    Rooms& rooms_;
    BackgroundTask<std::string> looking_{context_.executor, "why-no-way"};
};

}  // namespace handrail
