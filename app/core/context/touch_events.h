// Reports an event when a hand begins to touch another thing. Use it on the app thread only.
#pragma once

#include <array>

#include "app/core/context/session_part.h"

namespace handrail::core {

class TouchEvents : SessionPart {
public:
    explicit TouchEvents(const SessionContext& context) : SessionPart(context) {}
    // Call it once a tick, after the context has received the state of the hands.
    void tick(double now_s);

private:
    // The feature that the only or right hand touches, then the feature that the left hand touches.
    std::array<FeatureId, 2> touched_{kNoFeature, kNoFeature};
};

}  // namespace handrail::core
