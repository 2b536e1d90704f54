// Stores a scene on the graphics card: triangles and outlines of the building, and separately those of each thing that
// moves freely. Also chooses which parts a view may show. Call the class on the app thread, while its OpenGL context is
// current.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "app/window/draw_mesh.h"
#include "app/window/gl_objects.h"
#include "worlds/scene/scene.h"

namespace handrail::window {

class UploadedMesh {
public:
    explicit UploadedMesh(const DrawMesh& mesh);

    const Vec3& origin_m() const { return origin_m_; }
    double reach_m() const { return reach_m_; }  // greatest distance of a drawn point from the origin
    // Chooses the chunks that the view may show, the nearest first. Near walls are then drawn first, so the graphics
    // card need not paint what they hide.
    void choose(const Vec3& origin_from_eye_m, const std::array<Vec3, 5>& inward_normals);
    void choose_all();
    // draw_opaque and draw_edges draw the chunks that were chosen last.
    void draw_opaque();
    void draw_edges();
    void draw_translucent() const;  // draws all translucent triangles, chosen or not

private:
    template <class Range>
    void draw_chosen(const GlVertexArray& array, Range range);

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
};

class UploadedScene {
public:
    // Uploads the scene. Takes about as long as build_draw_mesh.
    explicit UploadedScene(std::shared_ptr<const Scene> scene);

    const Scene* scene() const { return scene_.get(); }
    UploadedMesh& building() { return *building_; }
    double reach_m() const { return building_->reach_m(); }
    // A thing that moves freely, uploaded at its initial place in the scene.
    struct Body {
        std::uint32_t thing = 0;  // index into Scene::placed
        std::unique_ptr<UploadedMesh> mesh;
    };
    const std::vector<Body>& bodies() const { return bodies_; }

private:
    // Shared ownership, so that no later scene can have the same address and be mistaken for this one.
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<UploadedMesh> building_;
    std::vector<Body> bodies_;
};

}  // namespace handrail::window
