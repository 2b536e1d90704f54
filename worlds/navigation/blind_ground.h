// Simulates how people walk who follow spoken directions with their eyes shut. They walk straight on, slide along an
// obstacle if they hit it at a slant, and stop if they hit it more squarely. They slide into a doorway if its frame
// stops them. Door leaves are either shut or open. Handrail tests spoken directions on this ground. Immutable once
// made. Any thread may call its functions, which change nothing but their arguments. World metres; radians clockwise
// from north. A walk costs a few nanoseconds for each centimetre.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// A door as people use it: all leaves of one group move together and form one door.
struct DirectionsDoor {
    std::uint32_t mover = 0;  // index of the first leaf in Scene::movers
    FeatureId feature = kNoFeature;
    std::uint32_t group = 0;
    struct Leaf {
        Aabb own_m;  // box of the leaf in its own coordinate frame
        Placement shut, open;
    };
    std::vector<Leaf> leaves;
    bool opens = true;  // people can open the door at any time by hand, or it opens when someone approaches
};

// Returns all doors that people walk through, in the order of their movers. In `thing_of_mover`, each mover of the
// scene must be a separate thing: see with_movers_apart().
std::vector<DirectionsDoor> word_doors(const Scene& scene, std::span<const int> thing_of_mover);

// State of a door. `Cleared`: the door is open, and wherever its leaf is in the way, the walker shuts it again. So the
// door blocks nothing.
enum class DoorState : std::uint8_t { Shut, Open, Cleared };
// For each index of a DirectionsDoor: its state.
using DoorsOpen = std::vector<DoorState>;

// Position of a walker on the ground.
struct BlindWalker {
    Vec2 at_m{0.0};
    std::uint32_t span = kNothing;
};

// The event that ends a walk.
enum class PaceEnd : std::uint8_t {
    Steps,    // the walker has covered the given distance
    Stopped,  // the walker met a wall or a shut door at more than 45 degrees
    Stairs,   // the walker has completed a flight of stairs
};

// The result of a walk.
struct Paced {
    double walked_m = 0.0;
    bool stopped = false;
    bool at_edge = false;  // the walker would have stepped over an edge
    bool climbed = false;  // the walker went up or down a whole flight
    double rise_m = 0.0;
};

// A walk ends as stopped if the walker has covered less than this fraction of the intended distance over
// kStoppedWindow_m. The fraction is between the sines of 22.5 and 45 degrees, with room for a turn that is 5 degrees
// off.
inline constexpr double kStoppedBelow = 0.55, kStoppedWindow_m = 0.2;
// Least height of a flight, and the length of level floor after which the flight is over.
inline constexpr double kFlightRise_m = 0.4, kFlightOver_m = 0.6;
// Limits for sliding into a doorway that the walker has just missed. kLineUp_m: greatest distance that the walker
// slides sideways. kLineUpDeep_m: distance that the walker must be able to go on beyond the doorway. kDoorway_m: the
// greatest width over which the walker's centre can move; a wider opening is not a doorway.
inline constexpr double kLineUp_m = 0.5, kLineUpDeep_m = 0.35, kDoorway_m = 1.4;

class BlindGround {
public:
    // `space` must outlive this object. The constructor searches the space around each leaf. The object needs a few
    // bytes for each span.
    BlindGround(const WalkSpace& space, std::vector<DirectionsDoor> doors);

    const WalkSpace& space() const { return space_; }
    const std::vector<DirectionsDoor>& doors() const { return doors_; }
    DoorsOpen all_shut() const { return DoorsOpen(doors_.size(), DoorState::Shut); }

    // Returns a walker at that place. BlindWalker::span is kNothing if nobody can stand there.
    BlindWalker body_at(const Vec3& feet_m) const;
    Vec3 feet_m(const BlindWalker& body) const { return {body.at_m.x, body.at_m.y, space_.place_m(body.span).z}; }
    // Moves `body` straight on until the event `end` happens, something stops the walker, or the walker has covered
    // `most_m`.
    Paced walk(BlindWalker& body, double heading_rad, double most_m, PaceEnd end, const DoorsOpen& open,
               const std::function<bool(const BlindWalker&)>& each_step = {}, double step_m = 0.7) const;
    // Returns the distance to the right that a stopped walker must slide to go on through a doorway in the same
    // direction. Negative: to the left. 0: the doorway is straight ahead, perhaps with a shut door. Returns nothing if
    // there is no doorway within kLineUp_m.
    std::optional<double> line_up_m(const BlindWalker& body, double heading_rad, const DoorsOpen& open) const;
    // Returns the index in doors() of the door that a walker on that span can reach; kNothing if there is none.
    std::uint32_t door_at(std::uint32_t span) const { return near_door_.empty() ? kNothing : near_door_[span]; }

private:
    struct OnCell;
    struct Stride;
    bool held(std::uint32_t from, std::uint32_t to, const DoorsOpen& open, bool through_doors) const;
    void find_free();
    bool leap(OnCell& body, const Vec2& ahead, double by_m) const;
    bool advance(OnCell& body, const Stride& by, const DoorsOpen& open, bool through_doors, bool& edge) const;

    const WalkSpace& space_;
    std::vector<DirectionsDoor> doors_;
    // For each span: 1 + the index of the door whose leaf a walker there would overlap. 0: no leaf.
    std::vector<std::uint16_t> shut_leaf_, open_leaf_;
    std::vector<bool> shut_middle_;  // for each span: whether a walker's centre would be in the middle of a shut leaf
    std::vector<std::uint32_t> near_door_;
    // For each span: the radius within which the floor is level and has no obstacle, edge or step. 0 if unknown.
    std::vector<float> free_m_;
};

}  // namespace handrail::navigation
