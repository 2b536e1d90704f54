#include "app/window/uploaded_scene.h"

#include <algorithm>
#include <cstddef>

namespace handrail::window {

UploadedScene::UploadedScene(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {
    std::vector<bool> free(scene_->features.size(), false);
    for (const FreeBody& body : scene_->bodies) free[body.feature.value] = true;
    const auto is_free = [&](FeatureId id) { return id && free[id.value]; };
    building_ = std::make_unique<UploadedMesh>(build_draw_mesh(*scene_, [&](FeatureId id) { return !is_free(id); }));
    for (std::uint32_t i = 0; i < scene_->placed.size(); ++i)
        if (const FeatureId own = scene_->placed[i].feature; is_free(own))
            bodies_.push_back(
                {i, std::make_unique<UploadedMesh>(build_draw_mesh(*scene_, [&](FeatureId id) { return id == own; }))});
}

UploadedMesh::UploadedMesh(const DrawMesh& mesh) {
    origin_m_ = mesh.origin_m;
    for (const DrawChunk& chunk : mesh.chunks)
        reach_m_ = std::max({reach_m_, glm::length(chunk.bounds_m.min_m), glm::length(chunk.bounds_m.max_m)});
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

    // Store each edge four times, once for each corner of the drawn line. The vertex shader derives from the vertex
    // number which of these corners to compute.
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

void UploadedMesh::choose(const Vec3& origin_from_eye_m, const std::array<Vec3, 5>& inward_normals) {
    chosen_.clear();
    for (const DrawChunk& chunk : chunks_) {
        const Vec3 centre = chunk.bounds_m.centre_m() + origin_from_eye_m, half = 0.5 * chunk.bounds_m.size_m();
        const bool outside = std::any_of(inward_normals.begin(), inward_normals.end(), [&](const Vec3& normal) {
            return glm::dot(normal, centre) + glm::dot(glm::abs(normal), half) < 0.0;
        });
        if (!outside) chosen_.emplace_back(glm::length(glm::max(glm::abs(centre) - half, Vec3(0.0))), &chunk);
    }
    std::sort(chosen_.begin(), chosen_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

void UploadedMesh::choose_all() {
    chosen_.clear();
    for (const DrawChunk& chunk : chunks_) chosen_.emplace_back(0.0, &chunk);
}

template <class Range>
void UploadedMesh::draw_chosen(const GlVertexArray& array, Range range) {
    counts_.clear();
    offsets_.clear();
    for (const auto& [distance_m, chunk] : chosen_) {
        const auto [first, count] = range(*chunk);
        counts_.push_back(static_cast<GLsizei>(count));
        offsets_.push_back(byte_offset(first * sizeof(std::uint32_t)));
    }
    array.bind();
    glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, offsets_.data(),
                        static_cast<GLsizei>(counts_.size()));
}

void UploadedMesh::draw_opaque() {
    draw_chosen(surfaces_, [](const DrawChunk& chunk) { return std::pair(chunk.first_index, chunk.index_count); });
}

void UploadedMesh::draw_edges() {
    draw_chosen(edges_, [](const DrawChunk& chunk) { return std::pair(6 * chunk.first_edge, 6 * chunk.edge_count); });
}

void UploadedMesh::draw_translucent() const {
    surfaces_.bind();
    glDrawElements(GL_TRIANGLES, translucent_count_, GL_UNSIGNED_INT,
                   byte_offset(opaque_count_ * sizeof(std::uint32_t)));
}

}  // namespace handrail::window
