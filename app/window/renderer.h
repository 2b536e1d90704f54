// Draws a ViewState with OpenGL 3.3 core into the current framebuffer: the first-person view and the plan, or the open
// list or question. Below that, draws the state of the hand, the task and the last messages. window_layout.h defines
// where. The class uses no window and receives no input. Call the class on the app thread, while its OpenGL context is
// current.
#pragma once

#include <memory>

#include "app/core/context/view.h"
#include "app/window/picture.h"
#include "app/window/window_layout.h"
#include "worlds/base/result.h"

namespace handrail::window {

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
