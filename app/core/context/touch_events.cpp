#include "app/core/context/touch_events.h"

#include <utility>

namespace handrail::core {

void TouchEvents::tick(double now_s) {
    for (const bool left : {false, true}) {
        const servo::ToolState& tool = left ? context_.hands.left_tool : context_.hands.tool;
        const FeatureId now = tool.touched();
        const FeatureId before = std::exchange(touched_[left ? 1 : 0], now);
        if (now == before || now == kNoFeature) continue;
        context_.events.report(Touched{now, left, tool.proxy_m, tool.contact_n}, now_s);
    }
}

}  // namespace handrail::core
