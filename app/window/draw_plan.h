// The plan as it is painted: the cut through the storey, the rooms with their names, the way, the hand, the body, the
// scale and north. App thread.
#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

#include "app/core/context/view.h"
#include "app/window/plan.h"
#include "app/window/renderer.h"

namespace handrail {

class PlanDrawing {
public:
    // Into ImGui's background, whose context is current.
    void draw(const ViewState& view, ImFont& font, PixelSize picture);
    // The view has another scene from here on.
    void forget_scene() {
        cut_.reset();
        free_.clear();
    }

private:
    void cut(const ViewState& view);
    void draw_shape(ImDrawList& list, const PlanLayout& layout, const PlanShape& shape);
    void draw_room_outlines(ImDrawList& list, const PlanLayout& layout, const ViewState& view, float unit_px);
    void draw_hatch(ImDrawList& list, const Aabb& bounds_px);

    std::optional<PlanCut> cut_;  // without what moves freely
    std::vector<bool> free_;      // of Scene::placed; empty: not known yet
    std::vector<ImVec2> points_;  // of the shape being drawn
};

}  // namespace handrail
