// Draws a ViewState with OpenGL 3.3 core into the current framebuffer: the first-person view, the plan, or the open
// list or question. The last spoken line is in large letters on a black band. Knows nothing of windows and takes no
// input. Used by the app thread, whose context must be current.
#pragma once

#include <memory>

#include "app/core/context/view.h"
#include "app/window/picture.h"
#include "worlds/base/result.h"

namespace handrail::window {

struct PixelSize {
    int width = 0;
    int height = 0;

    bool operator==(const PixelSize&) const = default;
};

// Height of a line of text as a share of the picture's height, for people with low vision.
inline constexpr double kTextLinePart = 1.0 / 12.0;
// The band takes at least two lines, so that the picture stays in place from one sentence to the next, and at most this
// share of the height.
inline constexpr double kLargestBandPart = 0.75;

class Renderer {
public:
    // Needs a current OpenGL context of 3.3 or later. Fails with a sentence if the driver lacks something.
    static Result<std::unique_ptr<Renderer>> create();
    // Needs the same context to be current.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // The first call with another scene uploads it (build_draw_mesh). After that a frame costs only the card's own
    // work.
    void draw(const core::ViewState& view, PixelSize size);

    // Reads the picture in the read buffer of the current framebuffer.
    static Picture read_back(PixelSize size);

private:
    class Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::window
