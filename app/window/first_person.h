// Draws the first-person view: surfaces, their outlines, the ball that shows the proxy, and translucent surfaces last.
// Used by the app thread, on which an OpenGL context must be current.
#pragma once

#include <glm/mat4x4.hpp>

#include "app/core/context/view.h"
#include "app/window/gl_objects.h"
#include "app/window/renderer.h"
#include "app/window/uploaded_scene.h"

namespace handrail::window {

class FirstPerson {
public:
    // Fails if the driver rejects a shader program.
    Result<void> start();
    // Draws into a picture that begins `bottom_px` above the lower edge of the framebuffer. `scene` must be the
    // uploaded scene of `view`.
    void draw(const core::ViewState& view, UploadedScene& scene, PixelSize picture, int bottom_px);

private:
    void draw_proxy(const core::ViewState& view, const glm::mat4& clip_from_eye, const Vec3& right, const Vec3& up);

    GlProgram surface_program_, edge_program_, proxy_program_;
    // Core profiles require a bound vertex array even for shaders that compute their own vertices.
    GlVertexArray no_vertices_;
};

}  // namespace handrail::window
