// The floor as walkers find it who follow spoken directions with their eyes shut. They walk straight on, slide along
// obstacles that they meet at a slant, and stop at obstacles that they meet more squarely. They slide into a doorway
// whose frame they have met. Door leaves are either shut or open. Spoken directions are tested on this ground.
// Immutable once made, with pure functions; any thread may use it. World metres, radians clockwise from north. A walk
// costs a few nanoseconds for each centimetre.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::navigation {

// A door as people use it: all leaves of one group move together.
struct DirectionsDoor {
    std::uint32_t mover = 0;  // index of the first leaf in Scene::movers
    FeatureId feature = kNoFeature;
    std::uint32_t group = 0;
    struct Leaf {
        Aabb own_m;  // in the leaf's own frame
        Placement shut, open;
    };
    std::vector<Leaf> leaves;
    bool opens = true;  // can be opened at any time, by hand or automatically when someone approaches
};

// All doors that people walk through, in the order of their movers. The movers of the scene must be separate things:
// see with_movers_apart().
std::vector<DirectionsDoor> word_doors(const Scene& scene, std::span<const int> thing_of_mover);

// Which doors are open, by index of the DirectionsDoor.
using DoorsOpen = std::vector<bool>;

// Position of a walker on the ground.
struct BlindWalker {
    Vec2 at_m{0.0};
    std::uint32_t span = kNothing;
};

// What ends a walk.
enum class PaceEnd : std::uint8_t {
    Steps,    // the given distance is complete
    Stopped,  // something solid met at more than 45 degrees: a wall or a shut door
    Stairs,   // a flight of stairs is behind the walker
};

// What happened on the walk.
struct Paced {
    double walked_m = 0.0;
    bool stopped = false;
    bool at_edge = false;  // the walker would have gone over an edge
    bool climbed = false;  // a whole flight, up or down
    double rise_m = 0.0;
};

// A walk counts as stopped if less than this part of the intended distance was covered over kStoppedWindow_m. The value
// is between the sines of 22.5 and 45 degrees, with room for a turn that is 5 degrees off.
inline constexpr double kStoppedBelow = 0.55, kStoppedWindow_m = 0.2;
// A flight rises at least this far, and is over after this much level floor.
inline constexpr double kFlightRise_m = 0.4, kFlightOver_m = 0.6;
// Lining up with a doorway that the walker has missed: how far the walker slides sideways, how deep the way beyond must
// be, and how wide it may be. The width is for the walker's centre; anything wider is no doorway.
inline constexpr double kLineUp_m = 0.5, kLineUpDeep_m = 0.35, kDoorway_m = 1.4;

class BlindGround {
public:
    // `space` must outlive this object. Costs a search around each leaf and a few bytes for each span.
    BlindGround(const WalkSpace& space, std::vector<DirectionsDoor> doors);

    const WalkSpace& space() const { return space_; }
    const std::vector<DirectionsDoor>& doors() const { return doors_; }
    DoorsOpen all_shut() const { return DoorsOpen(doors_.size(), false); }

    // A walker at that place; `span` is kNothing if nobody can stand there.
    BlindWalker body_at(const Vec3& feet_m) const;
    Vec3 feet_m(const BlindWalker& body) const { return {body.at_m.x, body.at_m.y, space_.place_m(body.span).z}; }
    // Walks on until `end` applies, something stops the walker, or `most_m` is covered.
    Paced walk(BlindWalker& body, double heading_rad, double most_m, PaceEnd end, const DoorsOpen& open,
               const std::function<bool(const BlindWalker&)>& each_step = {}, double step_m = 0.7) const;
    // How far to the right a stopped walker must slide to go on through a doorway in the same direction. Negative: to
    // the left. 0: the doorway is straight ahead, perhaps with a shut door. Nothing: no doorway within kLineUp_m.
    std::optional<double> line_up_m(const BlindWalker& body, double heading_rad, const DoorsOpen& open) const;
    // Index in doors() of the door within reach at that span; kNothing if there is none.
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
    // For each span: 1 + index of the door whose leaf is there; 0: none.
    std::vector<std::uint16_t> shut_leaf_, open_leaf_;
    std::vector<bool> shut_middle_;  // for each span: the walker's centre would be in a shut leaf
    std::vector<std::uint32_t> near_door_;
    // For each span: the distance within which nothing is in the way, ends or rises; 0 if it is not known.
    std::vector<float> free_m_;
};

}  // namespace handrail::navigation
