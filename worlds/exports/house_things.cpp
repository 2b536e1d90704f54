// Finds the windows and objects, for the text that describes a building. Each window or object belongs to the room that
// contains it, or else to the nearest room.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "worlds/base/text.h"
#include "worlds/exports/as_words.h"
#include "worlds/exports/names.h"
#include "worlds/geometry/flat_parts.h"
#include "worlds/words/words_text.h"

namespace handrail::exports {
namespace {

constexpr double kUnderFloor_m = 0.1, kUnderCeiling_m = 0.2;
constexpr double kThickestPane_m = 0.6;
// An object outside an outline by at most this distance still belongs to the room, such as shelves along its wall.
constexpr double kNextToRoom_m = 0.5;
// Factor for height differences in the search for the room of an object: a metre of height is as much as this many
// metres sideways. So the object stays on its storey.
constexpr double kStoreyFirst = 100.0;

bool is_called_window(const Feature& feature) {
    const std::string name = words::folded(feature.name);
    const Vec3 size_m = feature.bounds_m.size_m();
    return (name.ends_with("window") || name.ends_with("fenster")) && std::min(size_m.x, size_m.y) < kThickestPane_m;
}

// Returns whether a name is that of stairs. The stairs of a map become a separate room, in which they are rebuilt.
bool is_called_stairs(const std::string& of) {
    const std::string name = words::folded(of);
    return name.starts_with("stair") || name.starts_with("treppe");
}

double distance_from(const std::vector<Ring>& rings, const Vec2& at) {
    double least = 1e300;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], along = ring[(i + 1) % ring.size()] - a;
            const double part = std::clamp(glm::dot(at - a, along) / std::max(glm::dot(along, along), 1e-12), 0.0, 1.0);
            least = std::min(least, glm::length(at - a - along * part));
        }
    return least;
}

class Furnisher {
public:
    Furnisher(WordsHouse& house, const Scene& scene) : house_(house), scene_(scene) {
        for (const WordsHouse::Room& room : house.rooms) {
            Aabb box;
            for (const Ring& ring : room.rings)
                for (const Vec2& p : ring) box.include(Vec3(p, 0.0));
            const WordsHouse::Storey &low = house.storeys[room.storey], &high = house.storeys[room.to_storey];
            box.min_m.z = low.floor_m + room.raised_m;
            box.max_m.z = std::max(high.floor_m + high.height_m, box.min_m.z);
            boxes_.push_back(box);
        }
        for (const Solid& solid : scene.solids)
            if (solid.feature)
                for (const MaterialId of_face : solid.face_materials)
                    if (const std::string& name = scene.material(of_face).name; !name.empty())
                        ++of_faces_[solid.feature.value][name];
    }

    void furnish() {
        if (house_.rooms.empty()) return;
        std::vector<bool> stated(scene_.features.size(), false);
        const auto add_stated = [&](const std::vector<StatedThing>& things, bool window) {
            for (const StatedThing& thing : things) {
                if (thing.feature) stated[thing.feature.value] = true;
                if (thing.bounds_m.empty()) ++without_form_;
                else add(thing.feature, thing.bounds_m, window, false, true);
            }
        };
        if (scene_.stated) {
            add_stated(scene_.stated->windows, true);
            add_stated(scene_.stated->furnishings, false);
            for (const StatedPortal& portal : scene_.stated->portals)
                if (portal.feature) stated[portal.feature.value] = true;
        }
        // Adds the named objects in the building, except doors, stairs, lifts and walls. If the file lists its
        // furniture, all other objects are fixtures.
        const bool counted = scene_.stated && !scene_.stated->furnishings.empty();
        std::vector<bool> solid(scene_.features.size(), false);
        for (const Solid& one : scene_.solids)
            if (one.role == SolidRole::Solid && one.feature) solid[one.feature.value] = true;
        for (std::uint32_t f = 0; f < scene_.features.size(); ++f) {
            const Feature& feature = scene_.features[f];
            if (stated[f] || !solid[f] || feature.kind != FeatureKind::Object || feature.made_name ||
                feature.name.empty() || feature.bounds_m.empty())
                continue;
            add({f}, feature.bounds_m, !scene_.stated && is_called_window(feature), counted, false);
        }
    }

    int without_form() const { return without_form_; }
    const std::vector<std::string>& outside() const { return outside_; }
    const std::vector<std::string>& of_stairs() const { return of_stairs_; }

private:
    // Adds one window or object. `counted`: the file lists it as furniture or a window, so the text names it even if it
    // is outside all rooms.
    void add(FeatureId id, const Aabb& box, bool window, bool fixture, bool counted) {
        WordsHouse::Thing thing;
        thing.box_m = box;
        thing.window = window;
        thing.fixture = fixture;
        if (const Feature* feature = scene_.find(id)) {
            thing.name = one_line(spoken_name(*feature));
            if (window && feature->made_name) thing.name.clear();
            thing.landmark = feature->landmark;
            thing.clue = feature->clue;
            thing.material = material_of(id);
        }
        if (!window && thing.name.empty()) thing.name = spoken_kind("object");
        thing.room = window ? nearest(box, 0.5) : holding(box);
        if (!window && thing.room == house_.rooms.size()) {
            thing.room = nearest(box, 0.0);
            if (!counted && distance_to(thing.room, box, 0.0) > kNextToRoom_m) {
                outside_.push_back(thing.name);
                return;
            }
        }
        if (is_called_stairs(thing.name) && !counted) of_stairs_.push_back(thing.name);
        else house_.things.push_back(std::move(thing));
    }

    // Returns the object's own material, or the material that most of its faces have.
    std::string material_of(FeatureId id) const {
        if (const std::string& own = scene_.material(scene_.features[id.value].material).name; !own.empty()) return own;
        const auto found = of_faces_.find(id.value);
        if (found == of_faces_.end()) return {};
        return std::max_element(found->second.begin(), found->second.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    }

    std::size_t holding(const Aabb& box) const {
        const Vec3 size = box.size_m();
        for (std::size_t r = 0; r < boxes_.size(); ++r) {
            const Aabb& room = boxes_[r];
            const Vec2 middle(box.centre_m());
            if (box.min_m.z >= room.min_m.z - kUnderFloor_m && box.min_m.z <= room.max_m.z - kUnderCeiling_m &&
                middle.x >= room.min_m.x && middle.x <= room.max_m.x && middle.y >= room.min_m.y &&
                middle.y <= room.max_m.y && size.x <= room.size_m().x && size.y <= room.size_m().y &&
                handrail::inside(house_.rooms[r].rings, middle))
                return r;
        }
        return boxes_.size();
    }

    // Returns the room with the nearest outline. The object's height is measured at the fraction `up` between its
    // bottom and its top.
    std::size_t nearest(const Aabb& box, double up) const {
        std::size_t best = 0;
        double best_m = 1e300;
        for (std::size_t r = 0; r < boxes_.size(); ++r)
            if (const double off_m = distance_to(r, box, up, best_m); off_m < best_m) best_m = off_m, best = r;
        return best;
    }

    // Returns the distance of an object from a room's outline. It is larger if the object is above or below the room.
    // The function may stop and return `most_m` as soon as the distance reaches that value.
    double distance_to(std::size_t r, const Aabb& box, double up, double most_m = 1e300) const {
        const Aabb& room = boxes_[r];
        const Vec2 middle(box.centre_m());
        const double z = box.min_m.z + up * box.size_m().z;
        const double off_z = std::max({room.min_m.z - kUnderFloor_m - z, z - room.max_m.z, 0.0}) * kStoreyFirst;
        const Vec2 off = glm::max(glm::max(Vec2(room.min_m) - middle, middle - Vec2(room.max_m)), Vec2(0.0));
        if (off_z + glm::length(off) >= most_m) return most_m;
        return off_z + distance_from(house_.rooms[r].rings, middle);
    }

    WordsHouse& house_;
    const Scene& scene_;
    std::vector<Aabb> boxes_;  // for each room: its box, from its floor to the top of its highest storey
    // For each feature: the number of its faces that have each material.
    std::map<std::uint32_t, std::map<std::string, int>> of_faces_;
    std::vector<std::string> outside_;  // names of the objects outside every room
    std::vector<std::string> of_stairs_;
    int without_form_ = 0;
};

}  // namespace

void furnish(WordsHouse& house, const Scene& scene, words::WordLanguage language) {
    const bool german = language == words::WordLanguage::German;
    Furnisher furnisher(house, scene);
    furnisher.furnish();
    if (const int n = furnisher.without_form(); n > 0)
        house.lost.push_back(fmt::format("{}: {}.",
                                         german ? "Fenster und Möbel, denen die Datei keine Form gibt"
                                                : "Windows and furniture that the file gives no form",
                                         n));
    if (!furnisher.of_stairs().empty())
        house.lost.push_back(fmt::format("{}: {}.", german ? "Mit der Treppe neu gelegt" : "Laid anew with the stairs",
                                         names_list(furnisher.of_stairs())));
    if (!furnisher.outside().empty())
        house.lost.push_back(
            fmt::format("{}: {}.", german ? "In keinem Raum" : "In no room", names_list(furnisher.outside())));
}

}  // namespace handrail::exports
