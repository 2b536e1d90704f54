// Draws the plan: the horizontal cut through the storey, the rooms with their names, the route and the walked path, the
// beacon and the marks, the hand with its force, the walker, the scale bar and the north needle. App thread.
#pragma once

#include <imgui.h>

#include <functional>
#include <optional>
#include <vector>

#include "app/core/context/view.h"
#include "app/window/palette.h"
#include "app/window/plan.h"

namespace handrail::window {

class PlanDrawing {
public:
    // Draws into ImGui's background list. ImGui's context must be current. `text_px` is the height of room names.
    void draw(const core::ViewState& view, ImFont& font, const PixelBox& box, float text_px);
    // Call this function when the view receives another scene.
    void forget_scene() {
        cut_.reset();
        free_.clear();
    }

private:
    void cut(const core::ViewState& view);
    void draw_grounds(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view);
    void draw_shape(ImDrawList& list, const PlanLayout& layout, const plan::PlanShape& shape);
    void draw_room_outlines(ImDrawList& list, const PlanLayout& layout, const core::ViewState& view);
    void draw_line(ImDrawList& list, const PlanLayout& layout, const std::vector<Vec3>& line_m, const Rgb& colour,
                   float wide_px, float dash_px);
    void draw_hatch(ImDrawList& list);
    // Calls `use` with each horizontal piece inside the closed outline in points_, at rows that are `step_px` apart.
    void for_each_span(float step_px, const std::function<void(float y, float from, float to)>& use) const;

    std::optional<plan::PlanCut> cut_;  // the cut without freely moving bodies
    std::vector<bool> free_;      // for each thing in Scene::placed: true if it moves freely; empty: not known yet
    std::vector<ImVec2> points_;  // corners of the current shape
    // The following fields are valid during draw().
    const Palette* palette_ = nullptr;
    float unit_px_ = 1.0F;  // a fifth of the height of room names
    float line_ = 1.0F;     // the setting display.outline_width
};

}  // namespace handrail::window
