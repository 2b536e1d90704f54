#include "app/window/plan_labels.h"

#include <algorithm>
#include <optional>

#include "app/window/large_text.h"

namespace handrail::window {
namespace {

PlacedLabel laid(ImFont& font, const Label& label, float text_px, float moved, float unit_px) {
    PlacedLabel placed;
    placed.text_px = text_px;
    placed.inverted = label.inverted;
    float wide = 0.0F;
    for (const std::string_view line : wrapped_lines(font, text_px, label.text, 6.0F * text_px)) {
        wide = std::max(wide, font.CalcTextSizeA(text_px, 1e9F, 0.0F, line.data(), line.data() + line.size()).x);
        placed.lines.emplace_back(line);
    }
    const float edge = 0.5F * unit_px, high = text_px * static_cast<float>(placed.lines.size());
    placed.box = {{label.at.x - 0.5F * wide - edge, label.at.y + (moved - 0.5F) * high - edge},
                  {label.at.x + 0.5F * wide + edge, label.at.y + (moved + 0.5F) * high + edge}};
    return placed;
}

bool is_within(const LabelBox& box, const PixelBox& inside) {
    return box.from.x >= static_cast<float>(inside.min_px.x) && box.to.x <= static_cast<float>(inside.max_px.x) &&
           box.from.y >= static_cast<float>(inside.min_px.y) && box.to.y <= static_cast<float>(inside.max_px.y);
}

std::optional<PlacedLabel> placed(ImFont& font, const Label& label, const std::vector<LabelBox>& taken,
                                  const PixelBox& inside, float unit_px) {
    for (const float size : {5.0F, 4.0F, 3.0F})
        for (const float moved : {0.0F, 1.0F, -1.0F}) {
            PlacedLabel tried = laid(font, label, size * unit_px, moved, unit_px);
            if (is_within(tried.box, inside) &&
                std::none_of(taken.begin(), taken.end(), [&](const LabelBox& box) { return box.meets(tried.box); }))
                return tried;
        }
    return {};
}

}  // namespace

std::vector<PlacedLabel> place_labels(ImFont& font, const std::vector<Label>& labels, std::vector<LabelBox> taken,
                                      const PixelBox& inside, float unit_px) {
    std::vector<PlacedLabel> all;
    for (const Label& label : labels)
        if (auto one = placed(font, label, taken, inside, unit_px)) {
            taken.push_back(one->box);
            all.push_back(std::move(*one));
        }
    return all;
}

}  // namespace handrail::window
