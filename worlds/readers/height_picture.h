// A PNG picture as depths: black is the plain surface, white the deepest (S81, S82, S176). Of a colour picture the blue
// channel counts; what is transparent is plain. Every depth of bits, palettes and interlacing are read. Loading thread.
#pragma once

#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/scene/material.h"

namespace handrail {

inline constexpr int kLargestPictureSide = 4096;

// Fails with one sentence for what is no PNG, damaged, cut short or larger than kLargestPictureSide on a side. Never
// reads beyond `bytes`.
Result<HeightPicture> read_height_picture(std::string_view bytes, const std::string& file_name);

}  // namespace handrail
