// Why nobody comes to a room, and what would help, for who has asked for the way there. Looked for on a thread beside
// everything else where rooms are: the walkable space is made anew for other bodies. App thread only.
#pragma once

#include <string>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"
#include "app/core/world/beside.h"

namespace handrail {

class WhyNoWay : SessionPart {
public:
    WhyNoWay(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world() { looking_.give_up(); }
    // Of a room of the graph; told as soon as it is known, nothing where one comes there from the base.
    void look(std::uint32_t room, double now_s);
    void tick(double now_s);

private:
    Rooms& rooms_;
    Beside<std::string> looking_;
};

}  // namespace handrail
