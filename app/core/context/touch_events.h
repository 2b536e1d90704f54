// Tells when a hand comes to touch something else than before. App thread only.
#pragma once

#include <array>

#include "app/core/context/session_part.h"

namespace handrail {

class TouchEvents : SessionPart {
public:
    explicit TouchEvents(const SessionContext& context) : SessionPart(context) {}
    // Once a tick, when the context knows what the hands feel.
    void tick(double now_s);

private:
    std::array<FeatureId, 2> touched_{kNoFeature, kNoFeature};  // by the only or right hand, and by the left one
};

}  // namespace handrail
