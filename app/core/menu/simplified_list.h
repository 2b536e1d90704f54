// Lists what is simplified for the hand at the present scale. TouchView decides what is simplified. Use it on the app
// thread only.
#pragma once

#include <functional>
#include <span>

#include "app/core/context/session_part.h"
#include "app/core/hand/simplified_words.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class SimplifiedList : SessionPart {
public:
    SimplifiedList(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    // `portals` are the openings that the simplification plan considered.
    void open(const compile::Simplification& plan, const OpenPortals& portals,
              std::span<const compile::CoarserMesh> coarser, double now_s);

    // The session sets this function. It is called when the person has chosen an item, to find it or go to it.
    std::function<void(const Goal& goal, double now_s)> on_choose;

private:
    Rooms& rooms_;
};

}  // namespace handrail::core
