// Tells when a hand comes to touch something else than before. App thread only.
#pragma once

#include <array>

#include "app/core/context/session_context.h"

namespace handrail {

class TouchEvents {
public:
    explicit TouchEvents(const SessionContext& context) : context_(context) {}
    // Once a tick, when the context knows what the hands feel.
    void tick(double now_s);

private:
    const SessionContext& context_;
    std::array<FeatureId, 2> touched_{kNoFeature, kNoFeature};  // by the only or right hand, and by the left one
};

}  // namespace handrail
