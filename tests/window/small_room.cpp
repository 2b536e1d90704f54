#include "tests/window/small_room.h"
#include "tests/support/names.h"

namespace handrail::test {

ConvexSolid box(const Vec3& min_m, const Vec3& max_m) {
    ConvexSolid solid;
    solid.bounds_m = {min_m, max_m};
    for (const int axis : {0, 1, 2}) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const double side : {-1.0, 1.0}) {
            Vec3 normal(0.0);
            normal[axis] = side;
            const double at = side < 0.0 ? min_m[axis] : max_m[axis];
            Polygon face;
            for (const auto& [fu, fv] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
                Vec3 p(0.0);
                p[axis] = at;
                p[u] = fu ? max_m[u] : min_m[u];
                p[v] = fv ? max_m[v] : min_m[v];
                face.points_m.push_back(p);
            }
            if (side < 0.0) std::reverse(face.points_m.begin(), face.points_m.end());
            solid.planes.push_back({normal, side * at});
            solid.faces.push_back(std::move(face));
        }
    }
    return solid;
}

void add_box(Scene& scene, const Vec3& min_m, const Vec3& max_m, FeatureKind kind, SolidRole role) {
    const FeatureId feature{static_cast<std::uint32_t>(scene.features.size())};
    Feature described;
    described.kind = kind;
    described.bounds_m = {min_m, max_m};
    scene.features.push_back(described);
    Solid solid;
    solid.shape = box(min_m, max_m);
    solid.role = role;
    solid.feature = kind == FeatureKind::Wall ? kNoFeature : feature;
    solid.face_features.assign(6, feature);
    solid.face_materials.assign(6, kDefaultMaterial);
    solid.face_hidden.assign(6, false);
    for (std::size_t i = 0; i < 6; ++i)
        scene.surfaces.push_back({solid.shape.faces[i], solid.shape.planes[i].normal, feature, kDefaultMaterial, role});
    scene.bounds_m.include(solid.shape.bounds_m);
    scene.solids.push_back(std::move(solid));
}

std::shared_ptr<const Scene> small_room(const Vec3& at_m) {
    auto scene = std::make_shared<Scene>();
    scene->materials.resize(1);
    const auto add = [&](Vec3 from, Vec3 to, FeatureKind kind, SolidRole role = SolidRole::Solid) {
        add_box(*scene, at_m + from, at_m + to, kind, role);
    };
    add({-0.2, -0.2, -0.2}, {6.2, 4.2, 0.0}, FeatureKind::Wall);  // floor
    add({-0.2, -0.2, 2.5}, {6.2, 4.2, 2.7}, FeatureKind::Wall);   // ceiling
    add({-0.2, 4.0, 0.0}, {6.2, 4.2, 2.5}, FeatureKind::Wall);    // north
    add({-0.2, -0.2, 0.0}, {6.2, 0.0, 2.5}, FeatureKind::Wall);   // south
    add({-0.2, 0.0, 0.0}, {0.0, 4.0, 2.5}, FeatureKind::Wall);    // west
    add({6.0, 0.0, 0.0}, {6.2, 4.0, 2.5}, FeatureKind::Wall);     // east
    add({5.9, 1.5, 0.0}, {6.0, 2.5, 2.1}, FeatureKind::Door, SolidRole::Mover);
    add({0.5, 2.5, 0.0}, {2.0, 3.5, 0.7}, FeatureKind::Object);
    add({0.5, 0.5, 0.0}, {2.0, 1.5, 0.05}, FeatureKind::Liquid, SolidRole::Liquid);
    return scene;
}

ViewState view_in(std::shared_ptr<const Scene> scene, double x_m, double y_m, double heading_degrees) {
    ViewState view;
    const Vec3 corner = scene->bounds_m.min_m + Vec3(0.2);
    view.scene = std::move(scene);
    view.feet_m = corner + Vec3(x_m, y_m, 0.0);
    view.eyes_m = view.feet_m + Vec3(0.0, 0.0, 1.6);
    view.heading_rad = radians_from_degrees(heading_degrees);
    view.pictures = Pictures::FirstPerson;
    return view;
}

ViewState two_rooms_on_the_plan() {
    ViewState view = view_in(small_room(), 1.0, 3.6, 0.0);
    view.pictures = Pictures::Plan;
    const auto room = [](const char* name, double x_m) {
        return DrawnRoom{
            name,
            {x_m + 1.5, 2.0, 0.0},
            12.0,
            false,
            {0.0, 0.0, {{{x_m + 0.25, 0.25}, {x_m + 2.75, 0.25}, {x_m + 2.75, 3.75}, {x_m + 0.25, 3.75}}}}};
    };
    std::vector<DrawnRoom> rooms{room("Kitchen", 0.0), room("Hall", 3.0)};
    rooms.push_back(room("Attic", 3.0));
    rooms.back().outline.lowest_m = rooms.back().outline.highest_m = 2.7;
    view.rooms = std::make_shared<const std::vector<DrawnRoom>>(std::move(rooms));
    view.room = 0;
    return view;
}

}  // namespace handrail::test
