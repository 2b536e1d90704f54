// Reads STL, binary and as text. It reads triangles with z up, without unit, names or materials.
#include <charconv>
#include <cstring>

#include "worlds/base/text.h"
#include "worlds/readers/map_keys.h"
#include "worlds/readers/mesh_scene.h"

namespace handrail::readers {
namespace {

constexpr std::size_t kHead = 84, kTriangle = 50;

std::uint32_t count_in(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    return count;
}

bool begins(std::string_view text, std::string_view word) {
    return text.size() >= word.size() && lower_ascii(text.substr(0, word.size())) == word;
}

// True for a binary file. A binary file may begin with "solid" too, so the length of the file is tested first, and then
// its first bytes.
bool is_binary(std::string_view bytes) {
    if (bytes.size() < kHead) return false;
    if (bytes.size() == kHead + kTriangle * count_in(bytes)) return true;
    return !begins(bytes, "solid") || bytes.substr(0, 1000).find('\0') != std::string_view::npos;
}

Vec3 point_at(std::string_view bytes, std::size_t at) {
    std::array<float, 3> p{};
    std::memcpy(p.data(), bytes.data() + at, sizeof(p));
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

void add_triangle(MeshPart& part) {
    const auto n = static_cast<std::uint32_t>(part.points_m.size());
    part.triangles.push_back({n - 3, n - 2, n - 1});
}

}  // namespace

Result<Scene> read_stl(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    MeshFile file{"stl", options.obj_metres_per_unit, {}, 0, 0};
    Diagnostics diagnostics(file_name);
    const auto too_large = [&] { return fail(phrase("mesh.too_large", {{"most", kMostMeshTriangles}}), file_name); };
    if (is_binary(bytes)) {
        const std::size_t count = count_in(bytes);
        if (count > (bytes.size() - kHead) / kTriangle) return fail(phrase("mesh.cut_short"), file_name);
        if (count > kMostMeshTriangles) return too_large();
        MeshPart part;
        for (std::size_t t = 0; t < count; ++t) {
            for (std::size_t corner = 0; corner < 3; ++corner)
                part.points_m.push_back(point_at(bytes, kHead + t * kTriangle + 12 + 12 * corner) *
                                        file.metres_per_unit);
            add_triangle(part);
        }
        file.parts.push_back(std::move(part));
        return scene_of_meshes(std::move(file), std::move(diagnostics), file_name, options);
    }
    // A text file has "solid name" and then three lines "vertex x y z" for each facet; everything else is ignored.
    int line = 0;
    std::size_t triangles = 0, corners = 0;
    while (!bytes.empty() && !options.stop.stop_requested()) {
        const std::size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
        std::string_view text = trimmed(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + (bytes.substr(end).starts_with("\r\n") ? 2 : 1), bytes.size()));
        ++line;
        if (begins(text, "solid")) {
            file.parts.emplace_back();
            file.parts.back().thing = static_cast<std::uint32_t>(file.parts.size());
            file.parts.back().name = trimmed(text.substr(5));
        }
        if (begins(text, "facet")) corners = 0;
        if (!begins(text, "vertex") || file.parts.empty()) continue;
        MeshPart& part = file.parts.back();
        Vec3 p{0.0};
        text = trimmed(text.substr(6));
        bool good = true;
        for (int axis = 0; axis < 3 && good; ++axis) {
            const std::size_t stop = std::min(text.find_first_of(" \t"), text.size());
            good = parse_finite(text.substr(0, stop), p[axis]);
            text = trimmed(text.substr(stop));
        }
        if (!good) {
            diagnostics.warn({line, 0}, "obj.then_face", "mesh.bad_point");
            ++file.faces_left_out;
            corners = 4;  // The facet has more than three corners and gives no further triangle.
            continue;
        }
        part.points_m.push_back(p * file.metres_per_unit);
        if (++corners == 3) {
            if (++triangles > kMostMeshTriangles) return too_large();
            add_triangle(part);
        }
    }
    return scene_of_meshes(std::move(file), std::move(diagnostics), file_name, options);
}

}  // namespace handrail::readers
