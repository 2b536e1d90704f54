// Draws the first-person view: surfaces, their outlines, the ball that shows the proxy, and translucent surfaces last.
// Used by the app thread, on which an OpenGL context must be current.
#pragma once

#include <imgui.h>

#include <glm/mat4x4.hpp>

#include "app/core/context/view.h"
#include "app/window/gl_objects.h"
#include "app/window/uploaded_scene.h"
#include "app/window/window_layout.h"
#include "worlds/base/result.h"

namespace handrail::window {

class FirstPerson {
public:
    // Fails if the driver rejects a shader program.
    Result<void> start();
    // Draws into the box of a window of this size. `scene` must be the uploaded scene of `view`. If the hand is outside
    // the picture, draws a small second picture in a corner, from the eyes towards the hand. ImGui's context must be
    // current, because text and arrow of the force are drawn into its background list; `text_px` is their height.
    void draw(const core::ViewState& view, UploadedScene& scene, const PixelBox& box, PixelSize window, ImFont& font,
              float text_px);

private:
    struct Camera {
        double heading_rad = 0.0, tilt_rad = 0.0;
        double smallest_proxy = 0.02;  // smallest radius of the drawn ball as a fraction of its distance
    };
    void draw_seen(const core::ViewState& view, UploadedScene& scene, const Camera& camera, const PixelBox& box,
                   PixelSize window);
    void draw_proxy(const core::ViewState& view, const Camera& camera, const glm::mat4& clip_from_eye,
                    const Vec3& right, const Vec3& up);

    GlProgram surface_program_, edge_program_, proxy_program_;
    // Core profiles require a bound vertex array even for shaders that compute their own vertices.
    GlVertexArray no_vertices_;
};

}  // namespace handrail::window
