#include "app/window/palette.h"

#include <algorithm>
#include <cmath>

namespace handrail::window {
namespace {

constexpr Rgb kBlack{0, 0, 0}, kWhite{255, 255, 255}, kYellow{255, 255, 0};

constexpr Palette kDark{
    .ground = kBlack,
    .text = kWhite,
    .outside = kBlack,
    .inside = {82, 92, 122},
    .wall = {205, 205, 205},
    .object = {130, 100, 60},
    .object_outline = kWhite,
    .low = {200, 200, 200},
    .liquid = {140, 205, 255},
    .door = kBlack,
    .door_outline = {255, 240, 120},
    .mover_outline = {190, 230, 255},
    .room_outline = kWhite,
    .path = {0, 255, 255},
    .route = kYellow,
    .hand_path = {255, 190, 255},
    .beacon = {255, 200, 60},
    .mark = kWhite,
    .walker = kYellow,
    .hand = {13, 255, 51},
    .touching = {255, 13, 13},
    .force = kWhite,
};

constexpr Palette kLight{
    .ground = kWhite,
    .text = kBlack,
    .outside = kWhite,
    .inside = {138, 148, 163},
    .wall = {25, 25, 25},
    .object = {205, 175, 130},
    .object_outline = kBlack,
    .low = {40, 40, 40},
    .liquid = {0, 40, 110},
    .door = kWhite,
    .door_outline = {90, 0, 90},
    .mover_outline = {0, 40, 110},
    .room_outline = kBlack,
    .path = {0, 30, 130},
    .route = {90, 0, 90},
    .hand_path = {70, 30, 0},
    .beacon = {90, 0, 0},
    .mark = kBlack,
    .walker = {90, 0, 90},
    .hand = {0, 70, 10},
    .touching = {125, 0, 0},
    .force = kBlack,
};

constexpr Palette kHighContrast{
    .ground = kBlack,
    .text = kWhite,
    .outside = kBlack,
    .inside = kBlack,
    .wall = kWhite,
    .object = kBlack,
    .object_outline = kWhite,
    .low = kWhite,
    .liquid = kWhite,
    .door = kBlack,
    .door_outline = kYellow,
    .mover_outline = kYellow,
    .room_outline = kWhite,
    .path = kWhite,
    .route = kYellow,
    .hand_path = kWhite,
    .beacon = kYellow,
    .mark = kWhite,
    .walker = kYellow,
    .hand = kWhite,
    .touching = kYellow,
    .force = kYellow,
    .bare = true,
};

// Blue and orange instead of green and red; Okabe and Ito, "Color Universal Design", 2008.
constexpr Palette colour_safe() {
    Palette safe = kDark;
    safe.hand = {86, 180, 233};
    safe.touching = {230, 159, 0};
    safe.path = {130, 205, 245};
    safe.hand_path = {240, 228, 66};
    safe.beacon = {240, 228, 66};
    return safe;
}
constexpr Palette kColourSafe = colour_safe();

double relative_luminance(const Rgb& rgb) {
    std::array<double, 3> linear{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = rgb[i] / 255.0;
        linear[i] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    }
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
}

}  // namespace

const Palette& palette_of(settings::ColourSet colours) {
    switch (colours) {
        case settings::ColourSet::Light:
            return kLight;
        case settings::ColourSet::HighContrast:
            return kHighContrast;
        case settings::ColourSet::ColourSafe:
            return kColourSafe;
        case settings::ColourSet::Dark:
            break;
    }
    return kDark;
}

double contrast(const Rgb& a, const Rgb& b) {
    const auto [least, most] = std::minmax({relative_luminance(a), relative_luminance(b)});
    return (most + 0.05) / (least + 0.05);
}

}  // namespace handrail::window
