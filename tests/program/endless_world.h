// Makes a world that needs more than a minute to be read, because its faces have the greatest number of corners that
// the reader accepts.
#pragma once

#include <cmath>
#include <string>

namespace handrail::test {

inline std::string endless_obj() {
    std::string text, face = "f";
    constexpr int kCorners = 4096, kFaces = 2000;
    for (int i = 0; i < kCorners; ++i) {
        const double turn = 6.283185307179586 * i / kCorners, out_m = 100.0 + (i % 2 == 0 ? 10.0 : 0.0);
        text += "v " + std::to_string(out_m * std::cos(turn)) + " " + std::to_string(out_m * std::sin(turn)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    for (int i = 0; i < kFaces; ++i) text += face + "\n";
    return text;
}

}  // namespace handrail::test
