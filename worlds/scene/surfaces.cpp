#include "worlds/scene/surfaces.h"

#include <map>

#include "worlds/geometry/clip.h"

namespace handrail {
namespace {

bool is_touchable(SolidRole role) { return role == SolidRole::Solid || role == SolidRole::Mover; }

// Kind and name of a face of the building by the way it faces. Within 10 degrees of level is level, steeper than 80 degrees is a wall.
constexpr double kLevel = 0.985;
constexpr double kSteep = 0.174;

FeatureKind kind_of_face(const Vec3& normal) {
    if (normal.z >= kLevel) return FeatureKind::Floor;
    if (normal.z <= -kLevel) return FeatureKind::Ceiling;
    return std::abs(normal.z) <= kSteep ? FeatureKind::Wall : FeatureKind::Slope;
}

std::string name_of_face(const Vec3& normal) {
    switch (kind_of_face(normal)) {
        case FeatureKind::Floor:
            return "floor";
        case FeatureKind::Ceiling:
            return "ceiling";
        case FeatureKind::Wall:
            return std::string(compass_word(-normal)) + " wall";  // one stands on the side its normal points to
        default:
            return normal.z > 0.0 ? "slope rising " + std::string(compass_word(-normal)) : "sloping ceiling";
    }
}

}  // namespace

std::string_view compass_word(const Vec3& direction) noexcept {
    constexpr std::array<std::string_view, 8> kWords{"east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east"};
    const double eighths = std::atan2(direction.y, direction.x) / (kPi / 4.0);
    return kWords[static_cast<std::size_t>(static_cast<int>(std::lround(eighths)) + 8) % 8];
}

std::string shape_name(const Aabb& bounds_m) {
    const Vec3 size = bounds_m.size_m();
    const double wide_m = std::max(size.x, size.y), deep_m = std::min(size.x, size.y);
    if (size.z >= 1.2 && wide_m <= 0.5 * size.z) return "pillar";
    if (size.z >= 1.0 && deep_m <= 0.4) return "partition";
    if (size.z <= 0.1) return "plate";
    if (size.z <= 0.6) return "low block";
    return size.z <= 1.2 ? "block" : "large block";
}

void derive_surfaces(Scene& scene, std::span<const std::vector<FaceLook>> looks, double) {
    std::map<std::tuple<std::string, FaceLook>, FeatureId> walls;
    for (std::size_t s = 0; s < scene.solids.size(); ++s) {
        Solid& solid = scene.solids[s];
        const std::size_t faces = solid.shape.planes.size();
        solid.face_features.assign(faces, solid.feature);
        solid.face_hidden.assign(faces, false);
        for (std::size_t f = 0; f < faces; ++f) {
            const Polygon& polygon = solid.shape.faces[f];
            const Vec3& normal = solid.shape.planes[f].normal;
            if (!solid.feature && is_touchable(solid.role)) {
                const auto [found, is_new] =
                    walls.try_emplace({name_of_face(normal), looks[s][f]}, FeatureId{static_cast<std::uint32_t>(scene.features.size())});
                if (is_new) {
                    Feature wall;
                    wall.kind = kind_of_face(normal);
                    wall.name = name_of_face(normal);
                    wall.material = solid.face_materials[f];
                    wall.normal = normal;
                    wall.source = solid.source;
                    scene.features.push_back(wall);
                }
                solid.face_features[f] = found->second;
            }
            if (Feature* feature = solid.face_features[f] ? &scene.features[solid.face_features[f].value] : nullptr) {
                feature->area_m2 += area_m2(polygon);
                feature->bounds_m.include(bounds_of(polygon));
            }
            if (solid.role != SolidRole::Trigger && solid.role != SolidRole::BodyClip)
                scene.surfaces.push_back({polygon, normal, solid.face_features[f], solid.face_materials[f], solid.role});
        }
    }
    for (Feature& feature : scene.features)
        if (feature.name.empty()) feature.name = shape_name(feature.bounds_m);
}

}  // namespace handrail
