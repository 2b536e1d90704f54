#include "app/window/renderer.h"

#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <cstddef>
#include <filesystem>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "app/window/draw_mesh.h"
#include "app/window/large_text.h"
#include "app/window/plan.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

constexpr double kFieldOfView_rad = kPi / 3.0;  // upright
constexpr double kNear_m = 0.02;
constexpr double kSmallestBallPart = 0.02;  // of its distance: a ball of 5 mm stays in sight across a room
constexpr float kEdgePart = 1.0F / 100.0F;  // width of an outline, of the picture's height; the white core is a third of it
constexpr float kFontBaked_px = 64.0F;

constexpr const char* kSurfaceVertex = R"(#version 330 core
layout(location = 0) in vec3 position_m;
layout(location = 1) in vec2 surface_m;
layout(location = 2) in vec3 rgb;
layout(location = 3) in uint pattern;
uniform mat4 clip_from_eye;
uniform vec3 origin_from_eye_m;
out vec2 place_m;
flat out vec3 colour;
flat out uint kind;
void main() {
    gl_Position = clip_from_eye * vec4(position_m + origin_from_eye_m, 1.0);
    place_m = surface_m;
    colour = rgb;
    kind = pattern;
})";

constexpr const char* kSurfaceFragment = R"(#version 330 core
in vec2 place_m;
flat in vec3 colour;
flat in uint kind;
uniform float opacity;
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
    shown = vec4(colour * (1.0 - 0.6 * dark), opacity);
})";

// A line of a given width in pixels: four corners from the two ends, cut in front of the eye and drawn a little towards it, so that the
// surfaces it borders do not hide it. Core profiles draw lines one pixel wide only.
constexpr const char* kEdgeVertex = R"(#version 330 core
layout(location = 0) in vec3 a_m;
layout(location = 1) in vec3 b_m;
uniform mat4 clip_from_eye;
uniform vec3 origin_from_eye_m;
uniform vec2 half_size_px;
uniform float half_width_px;
out float across;
const float pull = 0.995;
const float nearest_m = 0.1;
void main() {
    int corner = gl_VertexID & 3;
    vec4 a = clip_from_eye * vec4((a_m + origin_from_eye_m) * pull, 1.0);
    vec4 b = clip_from_eye * vec4((b_m + origin_from_eye_m) * pull, 1.0);
    across = (corner & 1) == 0 ? 1.0 : -1.0;
    if (a.w < nearest_m && b.w < nearest_m) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (a.w < nearest_m) a = mix(a, b, (nearest_m - a.w) / (b.w - a.w));
    else if (b.w < nearest_m) b = mix(b, a, (nearest_m - b.w) / (a.w - b.w));
    vec2 along = b.xy / b.w * half_size_px - a.xy / a.w * half_size_px;
    along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
    vec2 sideways = vec2(-along.y, along.x) * across;
    vec4 end = corner < 2 ? a : b;
    end /= end.w;   // both ends lie in front of the eye, so the card need not, and clipping cannot bend `across`
    end.xy += (sideways + (corner < 2 ? -along : along)) * half_width_px / half_size_px;
    gl_Position = end;
})";

// Black with a white core: one of the two stands out on any surface.
constexpr const char* kEdgeFragment = R"(#version 330 core
in float across;
out vec4 shown;
void main() { shown = vec4(vec3(abs(across) < 0.34 ? 1.0 : 0.0), 1.0); })";

constexpr const char* kBallVertex = R"(#version 330 core
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

constexpr const char* kBallFragment = R"(#version 330 core
in vec2 place;
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
        vec3 colour = touching ? vec3(1.0, 0.05, 0.05) : vec3(0.05, 1.0, 0.2);
        shown = vec4(colour * (0.6 + 0.4 * towards), 1.0);
    }
})";

// OpenGL names are owned one by one; the context must be current when they go.
class GlBuffer {
public:
    GlBuffer() { glGenBuffers(1, &name_); }
    ~GlBuffer() { glDeleteBuffers(1, &name_); }
    GlBuffer(const GlBuffer&) = delete;
    GlBuffer& operator=(const GlBuffer&) = delete;

    template <class T>
    void fill(GLenum target, const std::vector<T>& values) {
        glBindBuffer(target, name_);
        glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    }

private:
    GLuint name_ = 0;
};

class GlVertexArray {
public:
    GlVertexArray() { glGenVertexArrays(1, &name_); }
    ~GlVertexArray() { glDeleteVertexArrays(1, &name_); }
    GlVertexArray(const GlVertexArray&) = delete;
    GlVertexArray& operator=(const GlVertexArray&) = delete;
    void bind() const { glBindVertexArray(name_); }

private:
    GLuint name_ = 0;
};

class GlProgram {
public:
    GlProgram() : name_(glCreateProgram()) {}
    ~GlProgram() { glDeleteProgram(name_); }
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    Result<void> build(const char* vertex, const char* fragment) {
        for (const auto& [kind, text] : {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
            const GLuint shader = glCreateShader(kind);
            glShaderSource(shader, 1, &text, nullptr);
            glCompileShader(shader);
            glAttachShader(name_, shader);
            glDeleteShader(shader);  // lives on as long as the program
        }
        glLinkProgram(name_);
        GLint linked = GL_FALSE;
        glGetProgramiv(name_, GL_LINK_STATUS, &linked);
        if (linked == GL_TRUE) return {};
        std::array<char, 512> log{};
        glGetProgramInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
        return fail(phrase("window.driver_refuses", {{"reason", log.data()}}));
    }
    void use() const { glUseProgram(name_); }
    void set(const char* uniform, float value) const { glUniform1f(at(uniform), value); }
    void set(const char* uniform, bool value) const { glUniform1i(at(uniform), value ? 1 : 0); }
    void set(const char* uniform, const glm::vec2& value) const { glUniform2fv(at(uniform), 1, glm::value_ptr(value)); }
    void set(const char* uniform, const glm::vec3& value) const { glUniform3fv(at(uniform), 1, glm::value_ptr(value)); }
    void set(const char* uniform, const glm::mat4& value) const { glUniformMatrix4fv(at(uniform), 1, GL_FALSE, glm::value_ptr(value)); }

private:
    GLint at(const char* uniform) const { return glGetUniformLocation(name_, uniform); }
    GLuint name_ = 0;
};

const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

// A scene on the card.
class UploadedScene {
public:
    explicit UploadedScene(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
        const DrawMesh mesh = build_draw_mesh(*scene_);
        origin_m_ = mesh.origin_m;
        for (const DrawChunk& chunk : mesh.chunks) reach_m_ = std::max({reach_m_, glm::length(chunk.bounds_m.min_m), glm::length(chunk.bounds_m.max_m)});
        chunks_ = mesh.chunks;

        surfaces_.bind();
        vertices_.fill(GL_ARRAY_BUFFER, mesh.vertices);
        std::vector<std::uint32_t> indices = mesh.opaque;
        indices.insert(indices.end(), mesh.translucent.begin(), mesh.translucent.end());
        indices_.fill(GL_ELEMENT_ARRAY_BUFFER, indices);
        opaque_count_ = mesh.opaque.size();
        translucent_count_ = static_cast<GLsizei>(mesh.translucent.size());
        const auto stride = static_cast<GLsizei>(sizeof(DrawVertex));
        for (GLuint i = 0; i < 4; ++i) glEnableVertexAttribArray(i);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, byte_offset(offsetof(DrawVertex, position_m)));
        glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, stride, byte_offset(offsetof(DrawVertex, surface_m)));
        glVertexAttribPointer(2, 3, GL_UNSIGNED_BYTE, GL_TRUE, stride, byte_offset(offsetof(DrawVertex, rgb)));
        glVertexAttribIPointer(3, 1, GL_UNSIGNED_BYTE, stride, byte_offset(offsetof(DrawVertex, pattern)));

        // Each edge four times, so that the vertex shader can take a corner from its number.
        std::vector<DrawEdge> corners;
        std::vector<std::uint32_t> corner_indices;
        corners.reserve(4 * mesh.edges.size());
        corner_indices.reserve(6 * mesh.edges.size());
        for (const DrawEdge& edge : mesh.edges) {
            const auto first = static_cast<std::uint32_t>(corners.size());
            corners.insert(corners.end(), 4, edge);
            for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) corner_indices.push_back(first + corner);
        }
        edges_.bind();
        edge_vertices_.fill(GL_ARRAY_BUFFER, corners);
        edge_indices_.fill(GL_ELEMENT_ARRAY_BUFFER, corner_indices);
        for (GLuint i = 0; i < 2; ++i) glEnableVertexAttribArray(i);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(DrawEdge), byte_offset(offsetof(DrawEdge, a_m)));
        glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(DrawEdge), byte_offset(offsetof(DrawEdge, b_m)));
        glBindVertexArray(0);
    }

    const Scene* scene() const { return scene_.get(); }
    const Vec3& origin_m() const { return origin_m_; }
    double reach_m() const { return reach_m_; }  // of what is drawn, from the origin
    // The chunks that the view may show, nearest first, so that near walls spare the card the painting of what they hide.
    void choose(const Vec3& origin_from_eye_m, const std::array<Vec3, 5>& inward_normals) {
        chosen_.clear();
        for (const DrawChunk& chunk : chunks_) {
            const Vec3 centre = chunk.bounds_m.centre_m() + origin_from_eye_m, half = 0.5 * chunk.bounds_m.size_m();
            const bool outside = std::any_of(inward_normals.begin(), inward_normals.end(),
                                             [&](const Vec3& normal) { return glm::dot(normal, centre) + glm::dot(glm::abs(normal), half) < 0.0; });
            if (!outside) chosen_.emplace_back(glm::length(glm::max(glm::abs(centre) - half, Vec3(0.0))), &chunk);
        }
        std::sort(chosen_.begin(), chosen_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    }
    void draw_opaque() {
        draw_chosen(surfaces_, [](const DrawChunk& chunk) { return std::pair(chunk.first_index, chunk.index_count); });
    }
    void draw_edges() {
        draw_chosen(edges_, [](const DrawChunk& chunk) { return std::pair(6 * chunk.first_edge, 6 * chunk.edge_count); });
    }
    void draw_translucent() const {
        surfaces_.bind();
        glDrawElements(GL_TRIANGLES, translucent_count_, GL_UNSIGNED_INT, byte_offset(opaque_count_ * sizeof(std::uint32_t)));
    }

    const PlanCut& plan(double feet_height_m) {
        // A step up or down is shown; the sway of walking on a slope does not cut the plan anew each frame.
        if (!plan_ || std::abs(plan_->feet_height_m - feet_height_m) > 0.1) plan_ = cut_plan(*scene_, feet_height_m);
        return *plan_;
    }

private:
    template <class Range>
    void draw_chosen(const GlVertexArray& array, Range range) {
        counts_.clear();
        offsets_.clear();
        for (const auto& [distance_m, chunk] : chosen_) {
            const auto [first, count] = range(*chunk);
            counts_.push_back(static_cast<GLsizei>(count));
            offsets_.push_back(byte_offset(first * sizeof(std::uint32_t)));
        }
        array.bind();
        glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, offsets_.data(), static_cast<GLsizei>(counts_.size()));
    }

    std::shared_ptr<const Scene> scene_;  // kept, so that its address cannot come back as another scene
    Vec3 origin_m_{0.0};
    double reach_m_ = 0.0;
    GlVertexArray surfaces_, edges_;
    GlBuffer vertices_, indices_, edge_vertices_, edge_indices_;
    std::size_t opaque_count_ = 0;
    GLsizei translucent_count_ = 0;
    std::vector<DrawChunk> chunks_;
    std::vector<std::pair<double, const DrawChunk*>> chosen_;
    std::vector<GLsizei> counts_;
    std::vector<const void*> offsets_;
    std::optional<PlanCut> plan_;
};

ImVec2 im(const Vec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

// A bold face with Latin letters, where Debian and its relatives put it; without one ImGui's own small face is enlarged.
ImFont* load_font(ImFontAtlas& atlas) {
    // Latin with its extensions, general punctuation, Greek and Cyrillic: names in the buildings of Europe.
    static constexpr std::array<ImWchar, 9> kRanges{0x20, 0x24F, 0x370, 0x3FF, 0x400, 0x45F, 0x2010, 0x2030, 0};
    for (const char* path : {"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf",
                             "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf",
                             "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf"}) {
        std::error_code none;
        if (!std::filesystem::is_regular_file(path, none)) continue;
        ImFontConfig config;
        config.OversampleH = 1;  // baked at about the size it is shown in
        config.OversampleV = 1;
        if (ImFont* font = atlas.AddFontFromFileTTF(path, kFontBaked_px, &config, kRanges.data())) return font;
    }
    return atlas.AddFontDefault();
}

}  // namespace

class Renderer::Impl {
public:
    Result<void> start() {
        for (const auto& built : {surface_program_.build(kSurfaceVertex, kSurfaceFragment), edge_program_.build(kEdgeVertex, kEdgeFragment),
                                  ball_program_.build(kBallVertex, kBallFragment)})
            if (!built) return built;
        imgui_ = ImGui::CreateContext();
        ImGui::SetCurrentContext(imgui_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;  // nothing of ours is kept in ImGui's file
        font_ = load_font(*io.Fonts);
        if (!ImGui_ImplOpenGL3_Init("#version 330 core")) return fail(phrase("window.driver_no_text"));
        imgui_drawing_ = true;
        return {};
    }

    ~Impl() {
        if (!imgui_) return;
        ImGui::SetCurrentContext(imgui_);
        if (imgui_drawing_) ImGui_ImplOpenGL3_Shutdown();
        ImGui::DestroyContext(imgui_);
    }

    void draw(const ViewState& view, PixelSize size) {
        if (size.width < 1 || size.height < 1) return;
        glViewport(0, 0, size.width, size.height);
        glDisable(GL_SCISSOR_TEST);
        glDepthMask(GL_TRUE);
        glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (view.scene && (!uploaded_ || uploaded_->scene() != view.scene.get())) {
            uploaded_.reset();
            uploaded_.emplace(view.scene);
        }

        ImGui::SetCurrentContext(imgui_);
        ImGui::GetIO().DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        const double line_px = kTextLinePart * size.height;
        const PixelSize picture{size.width, size.height - static_cast<int>(std::ceil(2.0 * line_px + 2.0 * margin_px(size)))};
        // In place of the picture, which somebody who reads a list does not need; the sentence then has the two lines below it.
        const bool open = view.dialogue.kind != DialogueView::Kind::None;
        if (open)
            draw_dialogue(*ImGui::GetForegroundDrawList(), *font_, view.dialogue, {0.0F, 0.0F},
                          {static_cast<float>(picture.width), static_cast<float>(picture.height)}, static_cast<float>(std::ceil(line_px)));
        else if (view.scene && view.plan_view) draw_plan(view, picture);
        else if (view.scene) draw_first_person(view, picture, size.height - picture.height);
        draw_text(view.last_spoken, size, open ? 2 : static_cast<std::size_t>(kLargestBandPart / kTextLinePart));
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }

private:
    static double margin_px(PixelSize size) { return size.height / 72.0; }

    void draw_first_person(const ViewState& view, PixelSize picture, int bottom_px) {
        glViewport(0, bottom_px, picture.width, picture.height);
        const Vec3 level = forward_of_heading(view.heading_rad);
        const Vec3 right = right_of_heading(view.heading_rad);
        const Vec3 forward = std::cos(view.tilt_rad) * level + std::sin(view.tilt_rad) * Vec3(0.0, 0.0, 1.0);
        const Vec3 up = glm::cross(right, forward);
        // The eye is taken away in double, so that a building far from its file's origin does not tremble.
        const Vec3 origin_from_eye = uploaded_->origin_m() - view.eyes_m;
        const double far_m = std::max(100.0, 1.1 * (uploaded_->reach_m() + glm::length(origin_from_eye)));
        const glm::mat4 turn(glm::vec4(right.x, up.x, -forward.x, 0.0), glm::vec4(right.y, up.y, -forward.y, 0.0), glm::vec4(right.z, up.z, -forward.z, 0.0),
                             glm::vec4(0.0, 0.0, 0.0, 1.0));
        const double aspect = static_cast<double>(picture.width) / picture.height;
        const glm::mat4 clip_from_eye =
            glm::perspective(static_cast<float>(kFieldOfView_rad), static_cast<float>(aspect), static_cast<float>(kNear_m), static_cast<float>(far_m)) * turn;

        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glDisable(GL_BLEND);
        glEnable(GL_CULL_FACE);
        // What the four sides of the picture and the plane of the eyes leave in sight.
        const double half_high = std::tan(0.5 * kFieldOfView_rad), half_wide = aspect * half_high;
        uploaded_->choose(origin_from_eye,
                          {forward, forward * half_wide - right, forward * half_wide + right, forward * half_high - up, forward * half_high + up});
        surface_program_.use();
        surface_program_.set("clip_from_eye", clip_from_eye);
        surface_program_.set("origin_from_eye_m", glm::vec3(origin_from_eye));
        surface_program_.set("opacity", 1.0F);
        uploaded_->draw_opaque();
        glDisable(GL_CULL_FACE);

        edge_program_.use();
        edge_program_.set("clip_from_eye", clip_from_eye);
        edge_program_.set("origin_from_eye_m", glm::vec3(origin_from_eye));
        edge_program_.set("half_size_px", 0.5F * glm::vec2(picture.width, picture.height));
        edge_program_.set("half_width_px", std::max(1.5F, 0.5F * kEdgePart * static_cast<float>(picture.height)));
        uploaded_->draw_edges();

        if (view.show_hand) draw_ball(view, clip_from_eye, right, up);

        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glDepthMask(GL_FALSE);
        surface_program_.use();
        surface_program_.set("opacity", 0.5F);
        uploaded_->draw_translucent();
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
        glDisable(GL_DEPTH_TEST);
    }

    void draw_ball(const ViewState& view, const glm::mat4& clip_from_eye, const Vec3& right, const Vec3& up) {
        const Vec3 centre = view.proxy_m - view.eyes_m;
        const double distance_m = glm::length(centre);
        const double radius_m = std::max(view.ball_radius_m, kSmallestBallPart * distance_m);
        ball_program_.use();
        ball_program_.set("clip_from_eye", clip_from_eye);
        ball_program_.set("centre_from_eye_m", glm::vec3(centre));
        ball_program_.set("radius_m", static_cast<float>(radius_m));
        // In front of the surface it rests on; a wall between eye and ball still hides it.
        ball_program_.set("pull", static_cast<float>(std::max(0.5, 1.0 - 2.0 * radius_m / std::max(distance_m, 1e-3))));
        ball_program_.set("right", glm::vec3(right));
        ball_program_.set("up", glm::vec3(up));
        ball_program_.set("touching", view.touching);
        ball_program_.set("forces_on", view.forces_on);
        no_vertices_.bind();
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }

    void draw_plan(const ViewState& view, PixelSize picture) {
        const PixelBox box{Vec2(0.0), Vec2(picture.width, picture.height)};
        const PlanLayout layout = lay_out_plan(view.scene->bounds_m, view.feet_m, view.heading_rad, view.north_up, box);
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        list.PushClipRect({0.0F, 0.0F}, im(box.max_px));
        const PlanCut& cut = uploaded_->plan(view.feet_m.z);
        for (const PlanShape& shape : cut.shapes) draw_shape(list, layout, shape);
        for (const auto& [a, b] : cut.sheets_m) list.AddLine(im(layout.to_pixels(a)), im(layout.to_pixels(b)), kWallColour, 3.0F);

        const float unit_px = static_cast<float>(picture.height) / 100.0F;
        draw_room_outlines(list, layout, view, unit_px);
        points_.clear();
        for (const Vec3& step : view.path_m) points_.push_back(im(layout.to_pixels(step)));
        if (!points_.empty()) {
            points_.push_back(im(layout.to_pixels(view.feet_m)));
            list.AddPolyline(points_.data(), static_cast<int>(points_.size()), IM_COL32(0, 255, 255, 255), 0, std::max(2.0F, 0.6F * unit_px));
        }
        draw_hand(list, layout, view, unit_px);
        draw_body(list, layout, view, unit_px);
        draw_room_names(list, layout, view, unit_px);
        draw_scale_and_north(list, layout, unit_px);
        list.PopClipRect();
    }

    static constexpr ImU32 kWallColour = IM_COL32(200, 200, 200, 255);

    // Kinds differ in filling and outline: floors dark, walls full, objects darker with a light border, doors open with a cross, movers open, liquids hatched,
    // low things thin outlines.
    void draw_shape(ImDrawList& list, const PlanLayout& layout, const PlanShape& shape) {
        // ImGui smooths borders rightly when corners run clockwise as seen: the turned y axis makes them so.
        points_.clear();
        Aabb bounds_px;
        for (const Vec2& p : shape.outline_m) {
            const Vec2 q = layout.to_pixels(p);
            bounds_px.include(Vec3(q, 0.0));
            points_.push_back(im(q));
        }
        if (bounds_px.max_m.x < layout.box.min_px.x || bounds_px.min_m.x > layout.box.max_px.x || bounds_px.max_m.y < layout.box.min_px.y ||
            bounds_px.min_m.y > layout.box.max_px.y)
            return;
        std::reverse(points_.begin(), points_.end());
        const int count = static_cast<int>(points_.size());
        const ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
        switch (shape.kind) {
            case PlanKind::Floor:
                list.AddConvexPolyFilled(points_.data(), count, IM_COL32(34, 42, 66, 255));
                break;
            case PlanKind::Wall:
                list.AddConvexPolyFilled(points_.data(), count, kWallColour);
                break;
            case PlanKind::Object:
                list.AddConvexPolyFilled(points_.data(), count, IM_COL32(130, 100, 60, 255));
                list.AddPolyline(points_.data(), count, white, ImDrawFlags_Closed, 2.0F);
                break;
            case PlanKind::Door:
                list.AddConvexPolyFilled(points_.data(), count, black);
                list.AddPolyline(points_.data(), count, IM_COL32(255, 240, 120, 255), ImDrawFlags_Closed, 3.0F);
                for (int i = 0; i < count / 2; ++i)
                    list.AddLine(points_[static_cast<std::size_t>(i)], points_[static_cast<std::size_t>(i + count / 2)], IM_COL32(255, 240, 120, 255), 2.0F);
                break;
            case PlanKind::Mover:
                list.AddConvexPolyFilled(points_.data(), count, black);
                list.AddPolyline(points_.data(), count, IM_COL32(190, 230, 255, 255), ImDrawFlags_Closed, 3.0F);
                break;
            case PlanKind::Liquid:
                draw_hatch(list, bounds_px);
                break;
            case PlanKind::Low:
                list.AddPolyline(points_.data(), count, IM_COL32(150, 150, 150, 255), ImDrawFlags_Closed, 2.5F);
                break;
        }
    }

    // Of the storey, the one that one is in last and thrice as thick: white on black, as all that matters here.
    void draw_room_outlines(ImDrawList& list, const PlanLayout& layout, const ViewState& view, float unit_px) {
        for (const std::size_t r : rooms_of_storey(view)) {
            const float thick_px = (r == view.room ? 1.2F : 0.4F) * unit_px;
            for (const std::vector<Vec2>& loop : (*view.rooms)[r].outline.loops_m) {
                points_.clear();
                for (const Vec2& corner : loop) points_.push_back(im(layout.to_pixels(corner)));
                const int count = static_cast<int>(points_.size());
                list.AddPolyline(points_.data(), count, IM_COL32(0, 0, 0, 255), ImDrawFlags_Closed, thick_px + 0.6F * unit_px);
                list.AddPolyline(points_.data(), count, IM_COL32(255, 255, 255, 255), ImDrawFlags_Closed, thick_px);
            }
        }
    }

    // Places in ViewState::rooms, the smallest first and the one that one is in last.
    static std::vector<std::size_t> rooms_of_storey(const ViewState& view) {
        std::vector<std::size_t> rooms;
        if (!view.rooms) return rooms;
        for (std::size_t r = 0; r < view.rooms->size(); ++r)
            if (const DrawnRoom& room = (*view.rooms)[r];
                r == view.room || (room.outline.lowest_m < view.feet_m.z + kPlanCutAboveFeet_m && room.outline.highest_m > view.feet_m.z - kPlanDeep_m))
                rooms.push_back(r);
        std::stable_sort(rooms.begin(), rooms.end(), [&](std::size_t a, std::size_t b) {
            return std::pair(a == view.room, (*view.rooms)[a].area_m2) < std::pair(b == view.room, (*view.rooms)[b].area_m2);
        });
        return rooms;
    }

    // White on black in the middle of each room, of the one that one is in turned round to black on white. Where names would cover each other or the body, a
    // name moves up or down or gets smaller, and of a small room it is left out at last; the one that one is in always stands.
    void draw_room_names(ImDrawList& list, const PlanLayout& layout, const ViewState& view, float unit_px) const {
        const std::vector<std::size_t> rooms = rooms_of_storey(view);
        const Vec2 feet = layout.to_pixels(view.feet_m);
        const float body_px = 5.0F * unit_px;
        std::vector<std::pair<ImVec2, ImVec2>> taken{{{static_cast<float>(feet.x) - body_px, static_cast<float>(feet.y) - body_px},
                                                      {static_cast<float>(feet.x) + body_px, static_cast<float>(feet.y) + body_px}}};
        for (auto at = rooms.rbegin(); at != rooms.rend(); ++at) {
            const DrawnRoom& room = (*view.rooms)[*at];
            const bool here = *at == view.room;
            const ImVec2 middle = im(layout.to_pixels(room.middle_m));
            const auto place = [&](float text_px, float moved, std::vector<std::string_view>& lines, ImVec2& from, ImVec2& to) {
                lines = wrapped_lines(*font_, text_px, room.name, 6.0F * text_px);
                float wide = 0.0F;
                for (const std::string_view line : lines)
                    wide = std::max(wide, font_->CalcTextSizeA(text_px, 1e9F, 0.0F, line.data(), line.data() + line.size()).x);
                const float edge = 0.5F * unit_px, high = text_px * static_cast<float>(lines.size());
                from = {middle.x - 0.5F * wide - edge, middle.y + (moved - 0.5F) * high - edge};
                to = {middle.x + 0.5F * wide + edge, middle.y + (moved + 0.5F) * high + edge};
                return std::none_of(taken.begin(), taken.end(),
                                    [&](const auto& other) { return from.x < other.second.x && other.first.x < to.x && from.y < other.second.y && other.first.y < to.y; });
            };
            std::vector<std::string_view> lines;
            ImVec2 from, to;
            float text_px = 0.0F;
            bool free = false;
            for (const float size : {5.0F, 4.0F, 3.0F}) {
                text_px = size * unit_px;
                for (const float moved : {0.0F, 1.0F, -1.0F, 2.0F, -2.0F})
                    if ((free = place(text_px, moved, lines, from, to))) break;
                if (free) break;
            }
            if (!free && here) place(text_px = 5.0F * unit_px, 1.5F, lines, from, to);
            else if (!free) continue;
            taken.emplace_back(from, to);
            const ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
            list.AddRectFilled(from, to, here ? white : black);
            for (std::size_t i = 0; i < lines.size(); ++i)
                list.AddText(font_, text_px, {from.x + 0.5F * unit_px, from.y + 0.5F * unit_px + static_cast<float>(i) * text_px}, here ? black : white,
                             lines[i].data(), lines[i].data() + lines[i].size());
        }
    }

    // Level lines across the shape in points_, by cutting it like a plan.
    void draw_hatch(ImDrawList& list, const Aabb& bounds_px) {
        const ImU32 colour = IM_COL32(90, 170, 255, 255);
        list.AddPolyline(points_.data(), static_cast<int>(points_.size()), colour, ImDrawFlags_Closed, 2.0F);
        for (double y = std::ceil(bounds_px.min_m.y / 6.0) * 6.0; y < bounds_px.max_m.y; y += 6.0) {
            float from = std::numeric_limits<float>::infinity(), to = -from;
            for (std::size_t i = 0; i < points_.size(); ++i) {
                const ImVec2 a = points_[i], b = points_[(i + 1) % points_.size()];
                if ((a.y > y) == (b.y > y)) continue;
                const float x = a.x + (static_cast<float>(y) - a.y) / (b.y - a.y) * (b.x - a.x);
                from = std::min(from, x);
                to = std::max(to, x);
            }
            if (from < to) list.AddLine({from, static_cast<float>(y)}, {to, static_cast<float>(y)}, colour, 1.0F);
        }
    }

    static void draw_hand(ImDrawList& list, const PlanLayout& layout, const ViewState& view, float unit_px) {
        if (!view.show_hand) return;
        const ImVec2 at = im(layout.to_pixels(view.proxy_m));
        const float radius_px = 1.2F * unit_px;
        if (view.touching) list.AddCircleFilled(at, 2.0F * radius_px, IM_COL32(255, 255, 255, 255));
        list.AddCircleFilled(at, 1.3F * radius_px, IM_COL32(0, 0, 0, 255));
        list.AddCircleFilled(at, radius_px, view.touching ? IM_COL32(255, 13, 13, 255) : IM_COL32(13, 255, 51, 255));
    }

    // An arrow whose tip points where one faces.
    static void draw_body(ImDrawList& list, const PlanLayout& layout, const ViewState& view, float unit_px) {
        const ImVec2 at = im(layout.to_pixels(view.feet_m));
        const double turn = view.heading_rad - layout.turn_rad;
        const auto corner = [&](double forward, double right, float scale) {
            return ImVec2(at.x + scale * static_cast<float>(forward * std::sin(turn) + right * std::cos(turn)),
                          at.y + scale * static_cast<float>(-forward * std::cos(turn) + right * std::sin(turn)));
        };
        for (const auto& [scale, colour] : {std::pair(6.6F * unit_px, IM_COL32(0, 0, 0, 255)), std::pair(4.8F * unit_px, IM_COL32(255, 255, 0, 255))}) {
            list.AddTriangleFilled(corner(1.0, 0.0, scale), corner(-0.6, 0.6, scale), corner(-0.3, 0.0, scale), colour);
            list.AddTriangleFilled(corner(1.0, 0.0, scale), corner(-0.3, 0.0, scale), corner(-0.6, -0.6, scale), colour);
        }
    }

    void draw_scale_and_north(ImDrawList& list, const PlanLayout& layout, float unit_px) const {
        const ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
        const float text_px = 6.0F * unit_px;
        const ScaleBar bar = scale_bar(layout.pixels_per_m, 0.25 * (layout.box.max_px.x - layout.box.min_px.x));
        const float length_px = static_cast<float>(bar.length_m * layout.pixels_per_m);
        const ImVec2 text_size = font_->CalcTextSizeA(text_px, 1e9F, 0.0F, bar.words.c_str());
        const ImVec2 start(2.0F * unit_px, static_cast<float>(layout.box.max_px.y) - 3.0F * unit_px);
        list.AddRectFilled({0.0F, start.y - text_px - 2.0F * unit_px}, {start.x + std::max(length_px, text_size.x) + 2.0F * unit_px, start.y + 3.0F * unit_px},
                           black);
        list.AddLine(start, {start.x + length_px, start.y}, white, unit_px);
        for (const float x : {start.x, start.x + length_px}) list.AddLine({x, start.y - 1.5F * unit_px}, {x, start.y + 1.5F * unit_px}, white, 0.6F * unit_px);
        list.AddText(font_, text_px, {start.x, start.y - text_px - 1.5F * unit_px}, white, bar.words.c_str());

        // The needle's tip is north.
        const ImVec2 middle(static_cast<float>(layout.box.max_px.x) - 8.0F * unit_px, 8.0F * unit_px);
        const auto needle = [&](double along, double across) {
            return ImVec2(middle.x + unit_px * static_cast<float>(across * std::cos(layout.turn_rad) - along * std::sin(layout.turn_rad)),
                          middle.y - unit_px * static_cast<float>(along * std::cos(layout.turn_rad) + across * std::sin(layout.turn_rad)));
        };
        list.AddCircleFilled(middle, 7.5F * unit_px, black);
        list.AddCircle(middle, 7.5F * unit_px, white, 0, 2.0F);
        list.AddTriangleFilled(needle(6.5, 0.0), needle(1.0, 2.0), needle(1.0, -2.0), white);
        const std::string north = phrase("window.north");
        const ImVec2 letter = font_->CalcTextSizeA(text_px, 1e9F, 0.0F, north.c_str());
        const ImVec2 below = needle(-2.5, 0.0);
        list.AddText(font_, text_px, {below.x - 0.5F * letter.x, below.y - 0.5F * letter.y}, white, north.c_str());
    }

    void draw_text(const std::string& text, PixelSize size, std::size_t most) const {
        const float line_px = static_cast<float>(std::ceil(kTextLinePart * size.height));
        const float margin = static_cast<float>(margin_px(size));
        const float wrap_px = std::max(line_px, static_cast<float>(size.width) - 2.0F * margin);
        const auto lines = wrapped_lines(*font_, line_px, text, wrap_px);
        const std::size_t shown = std::min(lines.size(), most);
        const float band_px = static_cast<float>(std::max<std::size_t>(shown, 2)) * line_px + 2.0F * margin;
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        const auto height = static_cast<float>(size.height);
        list.AddRectFilled({0.0F, height - band_px}, {static_cast<float>(size.width), height}, IM_COL32(0, 0, 0, 255));
        for (std::size_t i = 0; i < shown; ++i) {
            std::string line(lines[i]);
            if (i + 1 == shown && shown < lines.size()) line += " ...";  // the rest was heard and stands in the terminal
            list.AddText(font_, line_px, {margin, height - band_px + margin + static_cast<float>(i) * line_px}, IM_COL32(255, 255, 255, 255), line.c_str());
        }
    }

    GlProgram surface_program_, edge_program_, ball_program_;
    GlVertexArray no_vertices_;  // core profiles want one bound even for shaders that make their own vertices
    std::optional<UploadedScene> uploaded_;
    std::vector<ImVec2> points_;  // of the shape being drawn
    ImGuiContext* imgui_ = nullptr;
    ImFont* font_ = nullptr;
    bool imgui_drawing_ = false;
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create() {
    if (epoxy_gl_version() < 33) return fail(phrase("window.driver_no_opengl"));
    auto impl = std::make_unique<Impl>();
    if (auto started = impl->start(); !started) return tl::unexpected(started.error());
    return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

void Renderer::draw(const ViewState& view, PixelSize size) { impl_->draw(view, size); }

Picture Renderer::read_back(PixelSize size) {
    Picture picture{size.width, size.height, {}};
    const std::size_t row = 3 * static_cast<std::size_t>(size.width), rows = static_cast<std::size_t>(size.height);
    std::vector<std::uint8_t> from_below(row * rows);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, from_below.data());
    picture.rgb.reserve(from_below.size());
    for (std::size_t y = rows; y-- > 0;)
        picture.rgb.insert(picture.rgb.end(), from_below.begin() + static_cast<std::ptrdiff_t>(y * row),
                           from_below.begin() + static_cast<std::ptrdiff_t>((y + 1) * row));
    return picture;
}

}  // namespace handrail
