#include "worlds/check/examined.h"

#include <algorithm>
#include <cmath>

#include "worlds/geometry/clip.h"
#include "worlds/scene/outer_ground.h"
#include "worlds/scene/stated_building.h"

namespace handrail::check {
namespace {

constexpr float kOpenSky = 1e6F;  // a ceiling at least this high means the open sky

bool stops_a_body(const Solid& solid) { return solid.role == SolidRole::Solid || solid.role == SolidRole::Mover; }

std::vector<std::uint32_t> bodies_of(const Scene& scene) {
    std::vector<std::uint32_t> bodies;
    for (std::uint32_t i = 0; i < scene.solids.size(); ++i)
        if (stops_a_body(scene.solids[i])) bodies.push_back(i);
    return bodies;
}

BoxIndex boxes_of(const Scene& scene, const std::vector<std::uint32_t>& bodies) {
    std::vector<Aabb> boxes;
    for (const std::uint32_t i : bodies) boxes.push_back(scene.solids[i].shape.bounds_m);
    return BoxIndex(boxes);
}

BoxIndex sheets_of(const Scene& scene) {
    std::vector<Aabb> boxes;
    for (const MeshTriangle& triangle : scene.triangles) {
        Aabb box;
        for (const Vec3& p : {triangle.a_m, triangle.b_m, triangle.c_m}) box.include(p);
        boxes.push_back(box);
    }
    return BoxIndex(boxes);
}

Aabb box_round(const Vec3& at_m, double by_m) { return {at_m - Vec3(by_m), at_m + Vec3(by_m)}; }

// Returns the height at which a vertical line through the point enters the solid from above.
std::optional<double> top_on_line(const ConvexSolid& solid, const Vec3& at_m) {
    double top = std::numeric_limits<double>::infinity(), bottom = -top;
    for (const Plane& plane : solid.planes) {
        const double beyond = plane.offset_m - plane.normal.x * at_m.x - plane.normal.y * at_m.y;
        if (plane.normal.z > 1e-9) top = std::min(top, beyond / plane.normal.z);
        else if (plane.normal.z < -1e-9) bottom = std::max(bottom, beyond / plane.normal.z);
        else if (beyond < 0.0) return std::nullopt;
    }
    return top > bottom ? std::optional(top) : std::nullopt;
}

}  // namespace

Examined::Examined(const Scene& the_scene, const navigation::WalkSpace* the_space,
                   const navigation::RoomGraph* the_graph)
    : scene(the_scene),
      space(the_space),
      graph(the_graph),
      bodies_(bodies_of(the_scene)),
      index_(boxes_of(the_scene, bodies_)),
      sheets_(sheets_of(the_scene)),
      solids_of_(the_scene.features.size()) {
    for (const std::uint32_t i : bodies_)
        if (scene.find(scene.solids[i].feature)) solids_of_[scene.solids[i].feature.value].push_back(i);
    if (!graph) return;
    covers_.resize(graph->rooms.size());
    for (std::uint32_t s = 0; s < space->spans.size(); ++s) {
        const std::uint32_t room = graph->room_of_span[s];
        if (room == navigation::kNothing) continue;
        Cover& cover = covers_[room];
        const bool open = space->spans[s].ceiling_m >= kOpenSky;
        ++(open ? cover.open : cover.under_roof);
        if (open && cover.first_open == navigation::kNothing) cover.first_open = s;
    }
}

const std::vector<std::uint32_t>& Examined::solids_near(const Aabb& box) const {
    index_.find(box, near_);
    for (std::uint32_t& place : near_) place = bodies_[place];
    return near_;
}

const Solid* Examined::solid_at(const Vec3& at_m, double grow_m, const std::vector<FeatureId>& but) const {
    for (const std::uint32_t i : solids_near(box_round(at_m, grow_m + 1e-6))) {
        const Solid& solid = scene.solids[i];
        if (solid.feature != kNoFeature && std::find(but.begin(), but.end(), solid.feature) != but.end()) continue;
        if (contains(solid.shape, at_m, grow_m)) return &solid;
    }
    return nullptr;
}

bool Examined::sheet_near(const Aabb& box) const {
    sheets_.find(box, sheets_near_);
    return !sheets_near_.empty();
}

bool Examined::something_at(const Vec3& at_m, double near_m, const std::vector<FeatureId>& but) const {
    return solid_at(at_m, near_m, but) != nullptr || sheet_near(box_round(at_m, near_m));
}

std::optional<double> Examined::top_below(const Vec3& at_m) const {
    const double lowest = scene.bounds_m.empty() ? at_m.z : std::min(at_m.z, scene.bounds_m.min_m.z) - 1.0;
    const Aabb column{{at_m.x, at_m.y, lowest}, at_m};
    std::optional<double> highest;
    for (const std::uint32_t i : solids_near(column)) {
        const auto top = top_on_line(scene.solids[i].shape, at_m);
        if (top && *top <= at_m.z + 1e-6) highest = std::max(*top, highest.value_or(*top));
    }
    if (!scene.triangles.empty() && sheet_near(column))
        for (const std::uint32_t i : sheets_near_) {
            const MeshTriangle& t = scene.triangles[i];
            const double top = std::min(at_m.z, std::max({t.a_m.z, t.b_m.z, t.c_m.z}));
            highest = std::max(top, highest.value_or(top));
        }
    return highest;
}

SourcePlace Examined::ground_source(const Vec3& at_m) const {
    if (const Solid* ground = solid_at(at_m - Vec3(0.0, 0.0, 0.05), 0.02)) return ground->source;
    // The search includes the surroundings of the point, because a person at an edge may stand slightly beyond the
    // floor.
    const double around = space ? space->body.radius_m + space->cell_m : 0.3;
    const Solid* best = nullptr;
    for (const std::uint32_t i : solids_near({at_m - Vec3(around, around, 0.3), at_m + Vec3(around, around, 0.05)})) {
        const Solid& solid = scene.solids[i];
        if (solid.shape.bounds_m.max_m.z > at_m.z + 0.05) continue;
        if (!best || solid.shape.bounds_m.max_m.z > best->shape.bounds_m.max_m.z) best = &solid;
    }
    return best ? best->source : SourcePlace{};
}

std::uint32_t Examined::room_of(const Feature& feature) const {
    if (!space || !graph || feature.bounds_m.empty()) return navigation::kNothing;
    const Vec3 size = feature.bounds_m.size_m(), middle = feature.bounds_m.centre_m();
    const double around = 1.0 + 0.5 * std::max(size.x, size.y);
    const std::uint32_t span = space->nearest({middle.x, middle.y, feature.bounds_m.min_m.z}, around, 0.6, 3.0);
    return span == navigation::kNothing ? navigation::kNothing : graph->room_of_span[span];
}

SourcePlace Examined::room_source(std::uint32_t r) const {
    const navigation::Room& room = graph->rooms[r];
    if (scene.stated)
        for (const StatedRoom& stated : scene.stated->rooms)
            if (holds(stated, room.middle_m)) return stated.source;
    return ground_source(room.middle_m);
}

bool Examined::is_ground(std::uint32_t room) const {
    return scene.stated && graph->rooms[room].map_name.empty() && !covers_[room].covered();
}

std::string Examined::room_name(std::uint32_t room) const {
    return graph && room < graph->rooms.size() ? graph->rooms[room].name : std::string();
}

bool Examined::is_thing(FeatureId id) const {
    const Feature* feature = scene.find(id);
    return feature && feature->kind == FeatureKind::Object && !feature->bounds_m.empty() && !solids_of(id).empty() &&
           !is_outer_ground(*feature);
}

}  // namespace handrail::check
