// Reads a PNG picture as depths: black is the plain surface, white the deepest (S81, S82, S176). For a colour picture
// the blue channel counts; transparent pixels are plain. Reads all bit depths, palettes and interlacing. Loading
// thread.
#pragma once

#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/material.h"

namespace handrail::readers {

inline constexpr int kLargestPictureSide = 4096;

// Fails with one sentence if the bytes are no PNG, damaged, cut short, or wider or higher than kLargestPictureSide.
// Never reads beyond `bytes`.
Result<HeightPicture> read_height_picture(std::string_view bytes, const std::string& file_name);

}  // namespace handrail::readers
