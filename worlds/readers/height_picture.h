// Reads a PNG picture as depths: black is the plain surface, white the greatest depth. In a colour picture the blue
// channel gives the depth. Transparent pixels have depth 0. All bit depths, palettes and interlacing are supported.
// Used on the loading thread.
#pragma once

#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/material.h"

namespace handrail::readers {

inline constexpr int kLargestPictureSide = 4096;

// Fails with one sentence if the bytes are not PNG, damaged, or cut short, or if the picture is wider or higher than
// kLargestPictureSide. Never reads beyond `bytes`.
Result<HeightPicture> read_height_picture(std::string_view bytes, const std::string& file_name);

}  // namespace handrail::readers
