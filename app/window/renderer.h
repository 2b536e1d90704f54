// Draws a ViewState with OpenGL 3.3 core into whatever is the current framebuffer: first person or plan, or the list or
// question that is open, and the last spoken line in large letters on a black band. Knows nothing of windows and takes
// no input. App thread, the one whose context is current.
#pragma once

#include <memory>

#include "app/core/context/view.h"
#include "app/window/picture.h"
#include "worlds/base/result.h"

namespace handrail {

struct PixelSize {
    int width = 0;
    int height = 0;

    bool operator==(const PixelSize&) const = default;
};

// The height of a letter's line as a part of the picture's height, for people with low vision.
inline constexpr double kTextLinePart = 1.0 / 12.0;
// The band takes at least two lines, so that the picture stays in place from one sentence to the next, and at most this
// part.
inline constexpr double kLargestBandPart = 0.75;

class Renderer {
public:
    // Needs a current OpenGL context of 3.3 or later; fails with a sentence where the driver cannot do what is needed.
    static Result<std::unique_ptr<Renderer>> create();
    // Needs the same context to be current.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // The first call with another scene uploads it (build_draw_mesh); after that a frame costs what the card needs.
    void draw(const ViewState& view, PixelSize size);

    // What stands in the current framebuffer's read buffer.
    static Picture read_back(PixelSize size);

private:
    class Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail
