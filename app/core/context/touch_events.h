// Reports when a hand begins to touch something else. App thread only.
#pragma once

#include <array>

#include "app/core/context/session_part.h"

namespace handrail::core {

class TouchEvents : SessionPart {
public:
    explicit TouchEvents(const SessionContext& context) : SessionPart(context) {}
    // Call it once a tick, after the context has the state of the hands.
    void tick(double now_s);

private:
    std::array<FeatureId, 2> touched_{kNoFeature, kNoFeature};  // by the only or right hand, and by the left one
};

}  // namespace handrail::core
