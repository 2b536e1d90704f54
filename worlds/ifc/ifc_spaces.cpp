#include "worlds/ifc/ifc_spaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "worlds/geometry/clip.h"

namespace handrail::ifc {
namespace {

constexpr double kLowest_m = 0.05;  // faces within this height of a space's lowest point belong to its floor

// Sets the outline of a room from the faces of its floor. The solid of the space is not used, because in real files it
// is often open.
void outline(const Body& body, StatedRoom& room) {
    if (body.empty()) return;
    const Aabb box = body.bounds_m();
    room.floor_m = box.min_m.z;
    room.height_m = box.size_m().z;
    double largest_m2 = 0.0;
    const auto add = [&](const Polygon& face) {
        const Vec3 area = area_vector_m2(face.points_m);
        if (std::abs(area.z) < 0.99 * glm::length(area) || glm::length(area) < 1e-6) return;
        if (std::any_of(face.points_m.begin(), face.points_m.end(),
                        [&](const Vec3& p) { return p.z > box.min_m.z + kLowest_m; }))
            return;
        Ring ring;
        for (const Vec3& p : face.points_m) ring.emplace_back(p.x, p.y);
        room.area_m2 += std::abs(area.z);
        if (std::abs(area.z) > largest_m2) {
            largest_m2 = std::abs(area.z);
            const Vec3 middle = centre_of(face);
            room.at_m = {middle.x, middle.y, room.floor_m};
        }
        room.rings.push_back(std::move(ring));
    };
    for (const ConvexSolid& solid : body.solids)
        for (const Polygon& face : solid.faces) add(face);
    for (const Polygon& sheet : body.sheets) add(sheet);
}

bool all_equal(const std::vector<StatedStorey>& storeys) {
    return std::all_of(storeys.begin(), storeys.end(),
                       [&](const StatedStorey& one) { return one.floor_m == storeys.front().floor_m; });
}

// Sets the heights of storeys from their elevations. Some programs place every storey at the height of the building and
// state only the elevation above the lowest storey.
void lay_by_elevation(std::vector<StatedStorey>& storeys, const std::vector<double>& elevations_m) {
    if (storeys.empty()) return;
    const double lowest_m = *std::min_element(elevations_m.begin(), elevations_m.end());
    for (std::size_t i = 0; i < storeys.size(); ++i)
        if (const double above_m = elevations_m[i] - lowest_m; std::abs(above_m) <= kFarthestPart_m)
            storeys[i].floor_m += above_m;
}

// Moves the storeys to the parts. Some programs give national coordinates to the parts but leave the storeys at zero.
// Then the lowest storey is moved to the height at which the lowest part begins.
void lay_under_parts(std::vector<StatedStorey>& storeys, const std::vector<IfcPart>& parts) {
    double least_part_m = std::numeric_limits<double>::infinity(), least_storey_m = least_part_m;
    for (const IfcPart& part : parts)
        if (!part.box.empty()) least_part_m = std::min(least_part_m, part.box.min_m.z);
    for (const StatedStorey& storey : storeys) least_storey_m = std::min(least_storey_m, storey.floor_m);
    if (!std::isfinite(least_part_m)) return;
    for (StatedStorey& storey : storeys) storey.floor_m += least_part_m - least_storey_m;
}

// Sets the part of the building that each room is in: the smallest of its zones that has several rooms, but not all.
void name_parts(IfcBuilding& building, const IfcModel& model, const IfcRelations& relations) {
    std::vector<std::size_t> smallest(building.rooms.size(), building.rooms.size());
    for (const auto& [zone, spaces] : relations.spaces_of_zone) {
        const std::string name = text_at(model.values(zone), 2);
        std::set<std::uint32_t> rooms;
        for (const std::uint64_t space : spaces)
            if (const auto room = building.room_of_id.find(space); room != building.room_of_id.end())
                rooms.insert(room->second);
        if (name.empty() || rooms.size() < 2) continue;
        for (const std::uint32_t room : rooms)
            if (rooms.size() < smallest[room]) {
                smallest[room] = rooms.size();
                building.rooms[room].part = name;
            }
    }
}

}  // namespace

void read_spaces(IfcBuilding& building, IfcModel& model, const IfcRelations& relations, IfcShapes& shapes) {
    std::unordered_map<std::uint64_t, std::uint32_t> storey_of_id;
    std::vector<double> elevations_m;
    bool all_elsewhere = true;
    for (const StepInstance& instance : model.file().instances()) {
        if (role_of(instance.name) != PartRole::Storey) continue;
        const Values v = model.file().values_of(instance);
        StatedStorey storey;
        storey.name = text_at(v, 2).empty() ? text_at(v, 7) : text_at(v, 2);
        const Vec3 at = model.placement(reference_at(v, 5)).origin_m - building.origin_m;
        all_elsewhere = all_elsewhere && std::hypot(at.x, at.y) > kFarAway_m;
        storey.floor_m = at.z;
        if (!(std::abs(storey.floor_m) <= kFarthestPart_m)) storey.floor_m = 0.0;
        storey_of_id.emplace(instance.id, static_cast<std::uint32_t>(building.storeys.size()));
        building.storeys.push_back(std::move(storey));
        elevations_m.push_back(number_at(v, 9) * model.metres_per_unit());
    }
    if (all_equal(building.storeys)) lay_by_elevation(building.storeys, elevations_m);
    if (all_elsewhere) lay_under_parts(building.storeys, building.parts);
    for (const StepInstance& instance : model.file().instances()) {
        if (role_of(instance.name) != PartRole::Space) continue;
        const Values v = model.file().values_of(instance);
        StatedRoom room;
        room.guid = text_at(v, 0);
        room.number = text_at(v, 2);
        room.name = text_at(v, 7).empty() ? room.number : text_at(v, 7);
        room.source = {instance.line, 0};
        Frame frame = model.placement(reference_at(v, 5));
        frame.origin_m -= building.origin_m;
        Body body = transformed(shapes.body_of(reference_at(v, 6)), frame);
        building.far += drop_far(body);
        outline(body, room);
        const std::uint64_t storey = relations.whole_named(model, instance.id, "IFCBUILDINGSTOREY");
        if (const auto at = storey_of_id.find(storey); at != storey_of_id.end()) {
            room.storey = at->second;
            ++building.storeys[room.storey].rooms;
        }
        building.room_of_id.emplace(instance.id, static_cast<std::uint32_t>(building.rooms.size()));
        building.rooms.push_back(std::move(room));
    }
    name_parts(building, model, relations);
    // Sorts the storeys from the lowest up.
    std::vector<std::uint32_t> order(building.storeys.size()), place(building.storeys.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return building.storeys[a].floor_m < building.storeys[b].floor_m;
    });
    std::vector<StatedStorey> sorted;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i;
        sorted.push_back(building.storeys[order[i]]);
    }
    building.storeys = std::move(sorted);
    for (StatedRoom& room : building.rooms)
        if (room.storey != kNotStated) room.storey = place[room.storey];
}

namespace {

// Returns for each room the box outside of which `holds` is always false. It contains the outline, from a step below
// the floor up to the ceiling.
std::vector<Aabb> boxes_of(const std::vector<StatedRoom>& rooms) {
    constexpr double kStep_m = 0.4;
    std::vector<Aabb> boxes;
    boxes.reserve(rooms.size());
    for (const StatedRoom& room : rooms) {
        Aabb box;
        for (const Ring& ring : room.rings)
            for (const Vec2& p : ring) {
                box.include({p.x, p.y, room.floor_m - kStep_m});
                box.include({p.x, p.y, room.floor_m + room.height_m});
            }
        boxes.push_back(box);
    }
    return boxes;
}

}  // namespace

RoomsByPlace::RoomsByPlace(const std::vector<StatedRoom>& rooms) : rooms_(rooms), boxes_(boxes_of(rooms)) {}

std::vector<std::uint32_t> RoomsByPlace::near(const Aabb& box) const {
    std::vector<std::uint32_t> found;
    boxes_.find(box, found);
    return found;
}
std::vector<std::uint32_t> RoomsByPlace::all_at(const Vec3& at_m) const {
    std::vector<std::uint32_t> found = near({at_m, at_m});
    std::erase_if(found, [&](std::uint32_t r) { return !holds(rooms_[r], at_m); });
    return found;
}
std::uint32_t RoomsByPlace::first_at(const Vec3& at_m) const {
    const std::vector<std::uint32_t> found = near({at_m, at_m});
    const auto first =
        std::find_if(found.begin(), found.end(), [&](std::uint32_t r) { return holds(rooms_[r], at_m); });
    return first == found.end() ? kNotStated : *first;
}

std::array<std::uint32_t, 2> neighbouring_rooms(const RoomsByPlace& rooms, const WallGap& gap) {
    constexpr double kNear_m = 0.15, kFar_m = 1.2, kStep_m = 0.15, kHeight_m = 0.9;
    std::array<std::uint32_t, 2> found{kNotStated, kNotStated};
    const double middle = 0.5 * (gap.least_m.x + gap.most_m.x),
                 height = std::min(gap.least_m.z + kHeight_m, 0.5 * (gap.least_m.z + gap.most_m.z));
    for (const int side : {0, 1})
        for (double away = kNear_m; away <= kFar_m + 1e-9 && found[static_cast<std::size_t>(side)] == kNotStated;
             away += kStep_m) {
            const Vec3 at = gap.axes.at({middle, side == 0 ? gap.least_m.y - away : gap.most_m.y + away, height});
            found[static_cast<std::size_t>(side)] = rooms.first_at(at);
        }
    return found;
}

}  // namespace handrail::ifc
