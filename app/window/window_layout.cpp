#include "app/window/window_layout.h"

#include <algorithm>
#include <cmath>

namespace handrail::window {
namespace {

constexpr double kStatusLines = 2.0, kNewestLines = 2.0, kOlderLines = 4.0;
constexpr double kGapPart = 1.0 / 180.0;  // between the two pictures, and above and below texts

}  // namespace

WindowLayout lay_out_window(PixelSize size, core::Pictures pictures, double text_size) {
    const double width = std::max(1, size.width), height = std::max(1, size.height);
    const double gap = std::max(1.0, std::round(kGapPart * height));
    // Older messages and the status are half as high as the newest message.
    const double lines = kNewestLines + 0.5 * (kStatusLines + kOlderLines);
    double line = std::min(kTextLinePart * text_size * height, width / 8.0);
    line = std::max(2.0, std::floor(std::min(line, ((1.0 - kLeastPicturesPart) * height - 4.0 * gap) / lines)));
    const double small = std::max(1.0, std::floor(0.5 * line));

    WindowLayout layout;
    layout.line_px = static_cast<float>(line);
    layout.small_px = static_cast<float>(small);
    const double messages_top = std::max(0.0, height - (kNewestLines * line + kOlderLines * small + 2.0 * gap));
    const double status_top = std::max(0.0, messages_top - (kStatusLines * small + 2.0 * gap));
    layout.pictures = {Vec2(0.0), Vec2(width, status_top)};
    layout.status = {Vec2(gap, status_top + gap), Vec2(width - gap, messages_top - gap)};
    layout.messages = {Vec2(gap, messages_top + gap), Vec2(width - gap, height - gap)};
    layout.first_person = layout.plan = layout.pictures;
    if (pictures == core::Pictures::Plan) layout.first_person = {};
    if (pictures == core::Pictures::FirstPerson) layout.plan = {};
    if (pictures == core::Pictures::Both) {
        const int axis = width >= status_top ? 0 : 1;
        const double middle = std::floor(0.5 * layout.pictures.max_px[axis]);
        layout.first_person.max_px[axis] = middle - std::ceil(0.5 * gap);
        layout.plan.min_px[axis] = middle + std::ceil(0.5 * gap);
    }
    return layout;
}

}  // namespace handrail::window
