// Places the names on the plan so that none covers another name, or a sign that must stay visible. Pure function of its
// arguments; it only measures letters. App thread. Lengths are in pixels.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "app/window/plan.h"

namespace handrail::window {

struct LabelBox {
    ImVec2 from, to;

    bool meets(const LabelBox& other) const {
        return from.x < other.to.x && other.from.x < to.x && from.y < other.to.y && other.from.y < to.y;
    }
};

// A name that is wanted at a place. `inverted`: the colours of letters and ground are exchanged.
struct Label {
    std::string text;
    ImVec2 at;
    bool inverted = false;
};

struct PlacedLabel {
    LabelBox box;
    std::vector<std::string> lines;
    float text_px = 0.0F;  // height of the letters
    bool inverted = false;
};

// Places the labels in their order, so the first ones get the best places. A label that would meet another one, one of
// the boxes `taken`, or the border of `inside` moves up or down by its height, or gets smaller letters. If that does
// not suffice, it is left out. `unit_px` is a fifth of the height of the largest letters.
std::vector<PlacedLabel> place_labels(ImFont& font, const std::vector<Label>& labels, std::vector<LabelBox> taken,
                                      const PixelBox& inside, float unit_px);

}  // namespace handrail::window
