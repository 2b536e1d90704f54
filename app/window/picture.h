// Defines a picture of the window in memory, as a plain value.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "worlds/base/contract.h"

namespace handrail::window {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;  // red, green and blue of each pixel (width * height * 3), top row first

    std::array<std::uint8_t, 3> at(int x, int y) const {
        contract_pre(x >= 0 && x < width && y >= 0 && y < height);
        const std::size_t i =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
};

}  // namespace handrail::window
