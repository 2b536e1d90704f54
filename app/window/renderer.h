// Draws a ViewState with OpenGL 3.3 core into the current framebuffer: the first-person view, the plan, or the open
// list or question. Below that, draws the last spoken line in large letters on a black band. The class uses no window
// and receives no input. Call the class on the app thread, while its OpenGL context is current.
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

// Height of a line of text as a fraction of the picture's height, for people with low vision.
inline constexpr double kTextLinePart = 1.0 / 12.0;
// Greatest height of the band as a fraction of the picture's height. The band is always at least two lines high, so
// that the picture does not move from one sentence to the next.
inline constexpr double kLargestBandPart = 0.75;

class Renderer {
public:
    // Makes a renderer. An OpenGL context of version 3.3 or later must be current. Fails with a sentence if the driver
    // lacks something that the renderer needs.
    static Result<std::unique_ptr<Renderer>> create();
    // On destruction, the context that create() used must be current.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws the view. The first call with another scene uploads that scene (see build_draw_mesh). After that, a frame
    // costs hardly any processor time, because the graphics card does the work.
    void draw(const core::ViewState& view, PixelSize size);

    // Returns the picture in the read buffer of the current framebuffer.
    static Picture read_back(PixelSize size);

private:
    class Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::window
