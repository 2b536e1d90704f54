// The list of what was simplified for the hand at a scale. What is simplified is the touch view's affair. App thread
// only.
#pragma once

#include <functional>

#include "app/core/context/session_part.h"
#include "app/core/hand/simplified_words.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

class SimplifiedList : SessionPart {
public:
    SimplifiedList(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    // portals: the openings that `plan` was told of.
    void open(const Simplification& plan, const OpenPortals& portals, double now_s);

    // Set by the session: one of them was chosen, to be found or gone to.
    std::function<void(const Goal& goal, double now_s)> on_choose;

private:
    Rooms& rooms_;
};

}  // namespace handrail
