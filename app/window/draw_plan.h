// Draws the plan: the horizontal cut through the storey, the rooms with their names, the route, the hand, the walker,
// the scale bar and the north needle. App thread.
#pragma once

#include <imgui.h>

#include <optional>
#include <vector>

#include "app/core/context/view.h"
#include "app/window/plan.h"
#include "app/window/renderer.h"

namespace handrail::window {

class PlanDrawing {
public:
    // Draws into ImGui's background list. ImGui's context must be current.
    void draw(const core::ViewState& view, ImFont& font, PixelSize picture);
    // Call this function when the view receives another scene.
    void forget_scene() {
        cut_.reset();
        free_.clear();
    }

private:
    void cut(const core::ViewState& view);
    void draw_shape(ImDrawList& list, const PlanLayout& layout, const plan::PlanShape& shape);
    void draw_room_outlines(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view, float unit_px);
    void draw_hatch(ImDrawList& list, const Aabb& bounds_px);

    std::optional<plan::PlanCut> cut_;  // the cut without freely moving bodies
    std::vector<bool> free_;      // for each thing in Scene::placed: true if it moves freely; empty: not known yet
    std::vector<ImVec2> points_;  // corners of the current shape
};

}  // namespace handrail::window
