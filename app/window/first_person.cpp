#include "app/window/first_person.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <vector>

#include "app/core/dialogue/words.h"
#include "app/window/drawn_colour.h"
#include "app/window/force_arrow.h"
#include "worlds/base/language.h"

namespace handrail::window {
namespace {

constexpr double kFieldOfView_rad = kPi / 3.0;  // vertical field of view
constexpr double kNear_m = 0.02;
constexpr float kDarkerFrom_m = 4.0F;  // surfaces farther from the eyes than this are darker
constexpr double kSmallestInInset = 0.06;
constexpr double kInsetPart = 0.36;         // size of the picture of a hand that is out of view, as a part of the whole
constexpr float kEdgePart = 1.0F / 100.0F;  // width of an outline as a part of the picture's height
constexpr float kCorePart = 0.34F;          // width of an outline's white core as a part of the outline's

constexpr const char* kSurfaceVertex = R"(#version 330 core
layout(location = 0) in vec3 position_m;
layout(location = 1) in vec2 surface_m;
layout(location = 2) in vec3 rgb;
layout(location = 3) in uint pattern;
uniform mat4 clip_from_eye;
uniform vec3 origin_from_eye_m;
uniform mat3 turn;
out vec2 place_m;
flat out vec3 colour;
flat out uint kind;
out float away_m;
void main() {
    vec3 from_eye_m = turn * position_m + origin_from_eye_m;
    away_m = length(from_eye_m);
    gl_Position = clip_from_eye * vec4(from_eye_m, 1.0);
    place_m = surface_m;
    colour = rgb;
    kind = pattern;
})";

constexpr const char* kSurfaceFragment = R"(#version 330 core
in vec2 place_m;
flat in vec3 colour;
flat in uint kind;
uniform float opacity;
uniform bool bare;       // no filling; stripes in the colour of the outlines
uniform float away_from_m;
in float away_m;
out vec4 shown;
// 1 in the dark half of a stripe; far away, where stripes are finer than a pixel, their mean.
float stripe(float x) {
    float width = fwidth(x);
    float wave = abs(fract(x) - 0.5) * 2.0;
    float sharp = smoothstep(0.5 - width, 0.5 + width, wave);
    return mix(sharp, 0.5, clamp(2.0 * width - 0.5, 0.0, 1.0));
}
void main() {
    float dark = 0.0;
    if (kind == 1u) dark = stripe(place_m.x / 0.24);
    else if (kind == 2u) dark = stripe(place_m.y / 0.24);
    else if (kind == 3u) dark = stripe((place_m.x + place_m.y) / 0.5);
    else if (kind == 4u) dark = abs(stripe(place_m.x / 0.3) - stripe(place_m.y / 0.3));
    // Far surfaces are darker, so that the depth of a room can be seen.
    float far = 1.0 - 0.45 * smoothstep(away_from_m, 10.0 * away_from_m, away_m);
    vec3 filled = colour * (1.0 - 0.6 * dark) * far;
    shown = vec4(bare ? (kind == 0u ? vec3(0.0) : vec3(dark, dark, 0.0)) : filled, opacity);
})";

// Draws a line of a given width in pixels, because core profiles only draw lines that are one pixel wide. The shader
// makes four corners from the two ends and cuts the line off in front of the eye. It also moves the line a little
// towards the eye, so that the surfaces next to it do not hide it.
constexpr const char* kEdgeVertex = R"(#version 330 core
layout(location = 0) in vec3 a_m;
layout(location = 1) in vec3 b_m;
uniform mat4 clip_from_eye;
uniform vec3 origin_from_eye_m;
uniform mat3 turn;
uniform vec2 half_size_px;
uniform float half_width_px;
const float pull = 0.995;
const float nearest_m = 0.1;
void main() {
    int corner = gl_VertexID & 3;
    vec4 a = clip_from_eye * vec4((turn * a_m + origin_from_eye_m) * pull, 1.0);
    vec4 b = clip_from_eye * vec4((turn * b_m + origin_from_eye_m) * pull, 1.0);
    if (a.w < nearest_m && b.w < nearest_m) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (a.w < nearest_m) a = mix(a, b, (nearest_m - a.w) / (b.w - a.w));
    else if (b.w < nearest_m) b = mix(b, a, (nearest_m - b.w) / (a.w - b.w));
    vec2 along = b.xy / b.w * half_size_px - a.xy / a.w * half_size_px;
    along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
    vec2 sideways = vec2(-along.y, along.x) * ((corner & 1) == 0 ? 1.0 : -1.0);
    vec4 end = corner < 2 ? a : b;
    end /= end.w;   // both ends lie in front of the eye, so the card need not
    end.xy += (sideways + (corner < 2 ? -along : along)) * half_width_px / half_size_px;
    gl_Position = end;
})";

constexpr const char* kEdgeFragment = R"(#version 330 core
uniform float grey;
out vec4 shown;
void main() { shown = vec4(vec3(grey), 1.0); })";

constexpr const char* kProxyVertex = R"(#version 330 core
uniform mat4 clip_from_eye;
uniform vec3 centre_from_eye_m;
uniform float radius_m;
uniform float pull;
uniform vec3 right;
uniform vec3 up;
out vec2 place;
void main() {
    place = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1) * 1.9;
    gl_Position = clip_from_eye * vec4((centre_from_eye_m + radius_m * (place.x * right + place.y * up)) * pull, 1.0);
})";

constexpr const char* kProxyFragment = R"(#version 330 core
in vec2 place;
uniform vec3 filling;
uniform bool touching;
uniform bool forces_on;
out vec4 shown;
void main() {
    float r = length(place);
    vec3 white = vec3(1.0), black = vec3(0.0);
    if (r > 1.85 || (!touching && r > 1.22)) discard;
    if (r > 1.7) shown = vec4(black, 1.0);
    else if (r > 1.3) shown = vec4(white, 1.0);
    else if (r > 1.0) shown = vec4(black, 1.0);
    else {
        if (!forces_on && r < 0.55) discard;
        float towards = sqrt(1.0 - r * r);
        shown = vec4(filling * (0.6 + 0.4 * towards), 1.0);
    }
})";

// Returns the pixel at which a camera shows a place, which is relative to the eyes and must be in front of the camera.
Vec2 pixel_of(const Vec3& from_eyes_m, double heading_rad, double tilt_rad, const PixelBox& box) {
    const double ahead = glm::dot(from_eyes_m, forward_of_heading(heading_rad)),
                 right = glm::dot(from_eyes_m, right_of_heading(heading_rad));
    const double depth = ahead * std::cos(tilt_rad) + from_eyes_m.z * std::sin(tilt_rad);
    const double up = from_eyes_m.z * std::cos(tilt_rad) - ahead * std::sin(tilt_rad);
    const Vec2 size = box.max_px - box.min_px;
    const double focal_px = 0.5 * size.y / std::tan(0.5 * kFieldOfView_rad);
    return 0.5 * (box.min_px + box.max_px) + focal_px / std::max(depth, 1e-6) * Vec2(right, -up);
}

// Returns true if the camera shows the place in its picture.
bool is_seen(const Vec3& from_eyes_m, double heading_rad, double tilt_rad, const PixelBox& box) {
    const double depth = glm::dot(
        from_eyes_m, std::cos(tilt_rad) * forward_of_heading(heading_rad) + std::sin(tilt_rad) * Vec3(0.0, 0.0, 1.0));
    if (depth < kNear_m) return false;
    const Vec2 at = pixel_of(from_eyes_m, heading_rad, tilt_rad, box);
    return at.x >= box.min_px.x && at.x < box.max_px.x && at.y >= box.min_px.y && at.y < box.max_px.y;
}

// A mesh to draw, its rotation about its origin, and the position of its origin relative to the eye.
struct Part {
    UploadedMesh* mesh;
    glm::mat3 turn;
    Vec3 origin_from_eye_m;
};

// Returns the part of a thing that the scene placed at `from` and that is now at `to`.
Part moved_part(UploadedMesh& mesh, const Placement& from, const Placement& to, const Vec3& eyes_m) {
    const PlacedFrame was(from), is(to);
    glm::mat3 turn;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 along(0.0);
        along[axis] = 1.0;
        turn[axis] = glm::vec3(is.turned(was.turned_back(along)) * (is.scale / was.scale));
    }
    return {&mesh, turn, is.to_world(was.to_own(mesh.origin_m())) - eyes_m};
}

// Returns the building first, then the bodies that move freely in it.
std::vector<Part> parts_of(const core::ViewState& view, UploadedScene& scene) {
    std::vector<Part> parts{{&scene.building(), glm::mat3(1.0F), scene.building().origin_m() - view.eyes_m}};
    for (const UploadedScene::Body& body : scene.bodies()) {
        const Placement& stood = view.scene->placed[body.thing].at;
        const auto moved = std::find_if(view.moved.begin(), view.moved.end(),
                                        [&](const core::MovedThing& one) { return one.thing == body.thing; });
        parts.push_back(moved_part(*body.mesh, stood, moved == view.moved.end() ? stood : moved->at, view.eyes_m));
        body.mesh->choose_all();
    }
    return parts;
}

}  // namespace

Result<void> FirstPerson::start() {
    for (const auto& built :
         {surface_program_.build(kSurfaceVertex, kSurfaceFragment), edge_program_.build(kEdgeVertex, kEdgeFragment),
          proxy_program_.build(kProxyVertex, kProxyFragment)})
        if (!built) return built;
    return {};
}

void FirstPerson::draw(const core::ViewState& view, UploadedScene& scene, const PixelBox& box, PixelSize window,
                       ImFont& font, float text_px) {
    const Camera ahead{view.heading_rad, view.tilt_rad};
    draw_seen(view, scene, ahead, box, window);
    if (!view.show_hand) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const Palette& palette = palette_of(view.display.colours);
    const auto put_force = [&](const Camera& camera, const PixelBox& picture) {
        const Vec2 at = pixel_of(view.proxy_m - view.eyes_m, camera.heading_rad, camera.tilt_rad, picture);
        const Vec2 to =
            pixel_of(view.proxy_m + 0.05 * view.force_n - view.eyes_m, camera.heading_rad, camera.tilt_rad, picture) -
            at;
        const Vec2 direction = glm::length(to) > 1e-6 ? to / glm::length(to) : Vec2(1.0, 0.0);
        const ImVec2 from(static_cast<float>(at.x), static_cast<float>(at.y)),
            along(static_cast<float>(direction.x), static_cast<float>(direction.y));
        const double newtons = glm::length(view.force_n);
        const ImVec2 tip = draw_force(list, from, along, newtons, text_px / 5.0F, palette);
        write_force(list, font, tip, along, newtons, text_px / 5.0F, palette);
    };
    if (is_seen(view.proxy_m - view.eyes_m, ahead.heading_rad, ahead.tilt_rad, box)) return put_force(ahead, box);

    const Vec3 to = view.proxy_m - view.eyes_m;
    const Camera towards{std::atan2(to.x, to.y), std::atan2(to.z, std::max(1e-6, std::hypot(to.x, to.y))),
                         kSmallestInInset};
    const Vec2 inset_px = glm::floor(kInsetPart * (box.max_px - box.min_px));
    const PixelBox inset{Vec2(box.max_px.x - inset_px.x, box.min_px.y), Vec2(box.max_px.x, box.min_px.y + inset_px.y)};
    draw_seen(view, scene, towards, inset, window);
    for (const auto& [wide, colour] : {std::pair(6.0F, palette.ground), std::pair(2.0F, palette.text)})
        list.AddRect({static_cast<float>(inset.min_px.x), static_cast<float>(inset.min_px.y)},
                     {static_cast<float>(inset.max_px.x), static_cast<float>(inset.max_px.y)}, colour_of(colour), 0.0F,
                     0, wide);
    put_force(towards, inset);
    // The title says in which direction the inset looks.
    const std::string title =
        phrase("window.inset", {{"direction", core::direction_words(towards.heading_rad, view.heading_rad,
                                                                    settings::DirectionChoice::Sides)}});
    const ImVec2 size = font.CalcTextSizeA(text_px, 1e9F, 0.0F, title.c_str());
    const ImVec2 corner(static_cast<float>(box.max_px.x) - size.x - 4.0F, static_cast<float>(inset.max_px.y) + 4.0F);
    list.AddRectFilled(corner, {corner.x + size.x + 4.0F, corner.y + size.y}, colour_of(palette.ground));
    list.AddText(&font, text_px, corner, colour_of(palette.text), title.c_str());
}

void FirstPerson::draw_seen(const core::ViewState& view, UploadedScene& scene, const Camera& camera,
                            const PixelBox& box, PixelSize window) {
    const PixelSize picture{static_cast<int>(box.max_px.x - box.min_px.x),
                            static_cast<int>(box.max_px.y - box.min_px.y)};
    if (picture.width < 1 || picture.height < 1) return;
    const int left_px = static_cast<int>(box.min_px.x), bottom_px = window.height - static_cast<int>(box.max_px.y);
    glViewport(left_px, bottom_px, picture.width, picture.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(left_px, bottom_px, picture.width, picture.height);
    const Palette& palette = palette_of(view.display.colours);
    glClearColor(static_cast<float>(palette.outside[0]) / 255.0F, static_cast<float>(palette.outside[1]) / 255.0F,
                 static_cast<float>(palette.outside[2]) / 255.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Vec3 level = forward_of_heading(camera.heading_rad);
    const Vec3 right = right_of_heading(camera.heading_rad);
    const Vec3 forward = std::cos(camera.tilt_rad) * level + std::sin(camera.tilt_rad) * Vec3(0.0, 0.0, 1.0);
    const Vec3 up = glm::cross(right, forward);
    // Positions relative to the eye are computed in double precision. So a building that is far from its file's origin
    // does not tremble.
    const std::vector<Part> parts = parts_of(view, scene);
    const Vec3& origin_from_eye = parts.front().origin_from_eye_m;
    const double far_m = std::max(100.0, 1.1 * (scene.reach_m() + glm::length(origin_from_eye)));
    const glm::mat4 towards(glm::vec4(right.x, up.x, -forward.x, 0.0), glm::vec4(right.y, up.y, -forward.y, 0.0),
                            glm::vec4(right.z, up.z, -forward.z, 0.0), glm::vec4(0.0, 0.0, 0.0, 1.0));
    const double aspect = static_cast<double>(picture.width) / picture.height;
    const glm::mat4 clip_from_eye = glm::perspective(static_cast<float>(kFieldOfView_rad), static_cast<float>(aspect),
                                                     static_cast<float>(kNear_m), static_cast<float>(far_m)) *
                                    towards;

    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    // Choose what is visible: inside the four sides of the picture, and in front of the plane through the eyes.
    const double half_high = std::tan(0.5 * kFieldOfView_rad), half_wide = aspect * half_high;
    scene.building().choose(origin_from_eye, {forward, forward * half_wide - right, forward * half_wide + right,
                                              forward * half_high - up, forward * half_high + up});
    surface_program_.use();
    surface_program_.set("clip_from_eye", clip_from_eye);
    surface_program_.set("opacity", 1.0F);
    surface_program_.set("bare", palette.bare);
    surface_program_.set("away_from_m", kDarkerFrom_m);
    const auto draw_parts = [&](const GlProgram& program, void (*draw_one)(UploadedMesh&)) {
        for (const Part& part : parts) {
            program.set("turn", part.turn);
            program.set("origin_from_eye_m", glm::vec3(part.origin_from_eye_m));
            draw_one(*part.mesh);
        }
    };
    draw_parts(surface_program_, [](UploadedMesh& mesh) { mesh.draw_opaque(); });
    glDisable(GL_CULL_FACE);

    edge_program_.use();
    edge_program_.set("clip_from_eye", clip_from_eye);
    edge_program_.set("half_size_px", 0.5F * glm::vec2(picture.width, picture.height));
    // A line is black with a white core, because one of the two colours stands out on any surface. All black lines are
    // drawn before all cores and do not write depth. So no line hides the core of another where they meet.
    const float half_width_px = std::max(
        1.5F, 0.5F * kEdgePart * static_cast<float>(view.display.outline_width) * static_cast<float>(window.height));
    for (const bool core : {false, true}) {
        glDepthMask(core ? GL_TRUE : GL_FALSE);
        edge_program_.set("half_width_px", core ? kCorePart * half_width_px : half_width_px);
        edge_program_.set("grey", core ? 1.0F : 0.0F);
        draw_parts(edge_program_, [](UploadedMesh& mesh) { mesh.draw_edges(); });
    }

    if (view.show_hand) draw_proxy(view, camera, clip_from_eye, right, up);

    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    surface_program_.use();
    surface_program_.set("opacity", 0.5F);
    draw_parts(surface_program_, [](UploadedMesh& mesh) { mesh.draw_translucent(); });
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

void FirstPerson::draw_proxy(const core::ViewState& view, const Camera& camera, const glm::mat4& clip_from_eye,
                             const Vec3& right, const Vec3& up) {
    const Vec3 centre = view.proxy_m - view.eyes_m;
    const double distance_m = glm::length(centre);
    const double radius_m = std::max(view.proxy_radius_m, camera.smallest_proxy * distance_m);
    proxy_program_.use();
    proxy_program_.set("clip_from_eye", clip_from_eye);
    proxy_program_.set("centre_from_eye_m", glm::vec3(centre));
    proxy_program_.set("radius_m", static_cast<float>(radius_m));
    // Draw the ball nearer to the eye, so that the surface on which it rests does not hide it. A wall between the eye
    // and the ball still hides the ball.
    proxy_program_.set("pull", static_cast<float>(std::max(0.5, 1.0 - 2.0 * radius_m / std::max(distance_m, 1e-3))));
    proxy_program_.set("right", glm::vec3(right));
    proxy_program_.set("up", glm::vec3(up));
    const Palette& palette = palette_of(view.display.colours);
    const Rgb& filling = view.touching ? palette.touching : palette.hand;
    proxy_program_.set("filling", glm::vec3(filling[0], filling[1], filling[2]) / 255.0F);
    proxy_program_.set("touching", view.touching);
    proxy_program_.set("forces_on", view.forces_on);
    no_vertices_.bind();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace handrail::window
