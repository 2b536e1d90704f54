#include "worlds/imdf/meet_buildings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "worlds/floorplan/upright.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail::imdf {
namespace {

constexpr double kSharedDoor_m = 0.3;

class Meeting {
public:
    Meeting(std::size_t buildings, const std::vector<VenueUnit>& units, const std::vector<VenueDoor>& doors)
        : units_(units), doors_(doors), shift_(buildings, 0.0), settled_(buildings, false), size_(buildings, 0) {
        std::vector<Aabb> boxes;
        for (const VenueUnit& unit : units) {
            Aabb box;
            for (const Ring& ring : unit.rings)
                for (const Vec2& p : ring) box.include(Vec3(p, 0.0));
            boxes.push_back(grown(box, kSharedDoor_m));
            ++size_[unit.building];
        }
        index_ = BoxIndex(boxes);
    }

    std::vector<double> shifts() {
        std::vector<std::size_t> order(shift_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size_[a] > size_[b]; });
        if (order.empty()) return {};
        settled_[0] = settled_[order[0]] = true;
        // First settles the buildings that share a door with a settled building, one after the other. Then settles the
        // buildings that share no door.
        for (bool any = true; any;) {
            any = false;
            for (const std::size_t b : order) {
                const std::map<double, int> votes = settled_[b] ? std::map<double, int>{} : votes_of(b);
                if (votes.empty()) continue;
                if (!votes.contains(0.0))
                    shift_[b] = std::max_element(votes.begin(), votes.end(), [](const auto& one, const auto& other) {
                                    return one.second < other.second;
                                })->first;
                settled_[b] = any = true;
            }
        }
        for (const std::size_t b : order)
            if (!settled_[b]) shift_[b] = -floating_ordinals(b);
        return shift_;
    }

private:
    // Returns possible shifts of the building, each with the number of shared doors that require it. The doors are the
    // building's own and those of other buildings on its outlines.
    std::map<double, int> votes_of(std::size_t building) const {
        std::map<double, int> votes;
        std::vector<std::uint32_t> near;
        for (const VenueDoor& door : doors_) {
            if (door.building != building && !settled_[door.building]) continue;
            index_.find({Vec3(door.at, 0.0), Vec3(door.at, 0.0)}, near);
            for (const std::uint32_t u : near) {
                const VenueUnit& unit = units_[u];
                const bool own = door.building == building;
                if (own == (unit.building == building) || (own && !settled_[unit.building])) continue;
                if (floorplan::distance_to_outline(unit.rings, door.at) > kSharedDoor_m) continue;
                const double there = own ? unit.ordinal + shift_[unit.building] : door.ordinal + shift_[door.building];
                ++votes[there - (own ? door.ordinal : unit.ordinal)];
            }
        }
        return votes;
    }

    // Returns the lowest ordinal of the building if it is above the ground and nothing is below it. Returns 0 if the
    // building begins at the ground or is above another building.
    double floating_ordinals(std::size_t building) const {
        double lowest = 1e300;
        for (const VenueUnit& unit : units_)
            if (unit.building == building) lowest = std::min(lowest, unit.ordinal);
        if (!(lowest > 0.0 && lowest < 1e300)) return 0.0;
        std::vector<std::uint32_t> near;
        for (const VenueUnit& unit : units_) {
            if (unit.building != building) continue;
            Vec2 middle{0.0};
            for (const Vec2& p : unit.rings[0]) middle += p / static_cast<double>(unit.rings[0].size());
            index_.find({Vec3(middle, 0.0), Vec3(middle, 0.0)}, near);
            if (std::any_of(near.begin(), near.end(), [&](std::uint32_t u) {
                    return units_[u].building != building && units_[u].ordinal < lowest &&
                           inside(units_[u].rings, middle);
                }))
                return 0.0;
        }
        return lowest;
    }

    const std::vector<VenueUnit>& units_;
    const std::vector<VenueDoor>& doors_;
    BoxIndex index_;
    std::vector<double> shift_;
    std::vector<bool> settled_;
    std::vector<std::size_t> size_;  // number of units of each building
};

}  // namespace

std::vector<double> shifts_of_buildings(std::size_t buildings, const std::vector<VenueUnit>& units,
                                        const std::vector<VenueDoor>& doors) {
    return Meeting(buildings, units, doors).shifts();
}

}  // namespace handrail::imdf
