// The view of somebody who stands in the building: surfaces, their outlines, the ball of the hand, and last what is
// translucent. App thread, the one whose context is current.
#pragma once

#include <glm/mat4x4.hpp>

#include "app/core/context/view.h"
#include "app/window/gl_objects.h"
#include "app/window/renderer.h"
#include "app/window/uploaded_scene.h"

namespace handrail {

class FirstPerson {
public:
    // Fails where the driver refuses a program.
    Result<void> start();
    // Into the picture's pixels, which begin so far above the framebuffer's lower edge. `scene` is that of the view.
    void draw(const ViewState& view, UploadedScene& scene, PixelSize picture, int bottom_px);

private:
    void draw_ball(const ViewState& view, const glm::mat4& clip_from_eye, const Vec3& right, const Vec3& up);

    GlProgram surface_program_, edge_program_, ball_program_;
    GlVertexArray no_vertices_;  // core profiles want one bound even for shaders that make their own vertices
};

}  // namespace handrail
