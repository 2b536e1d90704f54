#include "app/window/force_arrow.h"

#include <string>

#include "app/window/drawn_colour.h"
#include "worlds/base/language.h"

namespace handrail::window {

ImVec2 draw_force(ImDrawList& list, ImVec2 from, ImVec2 direction, double newtons, float unit_px,
                  const Palette& palette) {
    if (newtons < kLeastDrawnForce_n) return from;
    const float text_px = 5.0F * unit_px, gap_px = 2.5F * unit_px;
    const float length_px = gap_px + text_px * static_cast<float>(newtons);
    const auto at = [&](float along, float across) {
        return ImVec2(from.x + along * direction.x - across * direction.y,
                      from.y + along * direction.y + across * direction.x);
    };
    for (const auto& [border, colour] : {std::pair(0.6F * unit_px, palette.ground), std::pair(0.0F, palette.force)}) {
        const float half = 2.0F * unit_px + 1.5F * border;
        list.AddLine(at(gap_px, 0.0F), at(length_px, 0.0F), colour_of(colour), 1.2F * unit_px + 2.0F * border);
        list.AddTriangleFilled(at(length_px + 3.0F * unit_px + 2.0F * border, 0.0F), at(length_px - border, half),
                               at(length_px - border, -half), colour_of(colour));
    }
    return at(length_px + 4.0F * unit_px, 0.0F);
}

void write_force(ImDrawList& list, ImFont& font, ImVec2 tip, ImVec2 direction, double newtons, float unit_px,
                 const Palette& palette) {
    if (newtons < kLeastDrawnForce_n) return;
    const float text_px = 5.0F * unit_px;
    const std::string words = phrase("window.force", {{"newtons", newtons}});
    const ImVec2 size = font.CalcTextSizeA(text_px, 1e9F, 0.0F, words.c_str());
    const ImVec2 corner(tip.x + (direction.x < 0.0F ? -size.x : 0.0F), tip.y + (direction.y < 0.0F ? -size.y : 0.0F));
    list.AddRectFilled({corner.x - 0.4F * unit_px, corner.y}, {corner.x + size.x + 0.4F * unit_px, corner.y + size.y},
                       colour_of(palette.ground));
    list.AddText(&font, text_px, corner, colour_of(palette.text), words.c_str());
}

}  // namespace handrail::window
