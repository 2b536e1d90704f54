// The floor as a body finds it that follows words with shut eyes: it walks straight on, slides along what it meets at a
// slant, is stopped by what it meets more squarely, and slides into a doorway whose frame it has met. Leaves of doors
// stand shut or open. What routes for words are tried on. Immutable after it is made; pure functions; any thread. World
// metres, radians clockwise from north. A walk costs a few nanoseconds for each centimetre.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "worlds/geometry/placement.h"
#include "worlds/navigation/walk_space.h"

namespace handrail {

// A door as somebody uses it: all leaves of one group go together.
struct WordDoor {
    std::uint32_t mover = 0;  // the first leaf's place in Scene::movers
    FeatureId feature = kNoFeature;
    std::uint32_t group = 0;
    struct Leaf {
        Aabb own_m;  // in its own frame
        Placement shut, open;
    };
    std::vector<Leaf> leaves;
    bool opens = true;  // by hand or as one comes near, at any time
};

// All doors that one walks through, in the order of their movers, of a scene whose movers are things apart: see
// with_movers_apart().
std::vector<WordDoor> word_doors(const Scene& scene, std::span<const int> thing_of_mover);

// Which doors stand open, by their place among the WordDoors.
using DoorsOpen = std::vector<bool>;

// Where a body is on the ground.
struct BlindBody {
    Vec2 at_m{0.0};
    std::uint32_t span = kNothing;
};

// What ends a walk.
enum class PaceEnd : std::uint8_t {
    Steps,    // counted
    Stopped,  // something solid, met at more than 45 degrees: a wall, a shut door
    Stairs,   // a flight is behind one
};

// What happened on it.
struct Paced {
    double walked_m = 0.0;
    bool stopped = false;
    bool at_edge = false;  // it would have gone over an edge
    bool climbed = false;  // a whole flight, up or down
    double rise_m = 0.0;
};

// A walk counts as stopped where less than this part of the wished way was made over kStoppedWindow_m. Between the
// sine of 22.5 and of 45 degrees, with room for a turn that is 5 degrees off.
inline constexpr double kStoppedBelow = 0.55, kStoppedWindow_m = 0.2;
// A flight rises as much as this, and is over after so much level floor.
inline constexpr double kFlightRise_m = 0.4, kFlightOver_m = 0.6;
// How far to the side the body slides into a doorway it has missed, how deep a way must open there, and how wide, for
// the middle of the body, what lies there may be to be a doorway.
inline constexpr double kLineUp_m = 0.5, kLineUpDeep_m = 0.35, kDoorway_m = 1.4;

class BlindGround {
public:
    // `space` outlives it. Costs a look at the places round each leaf and a few bytes for each span.
    BlindGround(const WalkSpace& space, std::vector<WordDoor> doors);

    const WalkSpace& space() const { return space_; }
    const std::vector<WordDoor>& doors() const { return doors_; }
    DoorsOpen all_shut() const { return DoorsOpen(doors_.size(), false); }

    // At that place; span kNothing: one cannot stand there.
    BlindBody body_at(const Vec3& feet_m) const;
    Vec3 feet_m(const BlindBody& body) const { return {body.at_m.x, body.at_m.y, space_.place_m(body.span).z}; }
    // Walks on until what is asked for, or until it is stopped, or at most so far.
    Paced walk(BlindBody& body, double heading_rad, double most_m, PaceEnd end, const DoorsOpen& open,
               const std::function<bool(const BlindBody&)>& each_step = {}, double step_m = 0.7) const;
    // How far to the right a body must slide that has been stopped there, to go on in its direction through a doorway;
    // negative to the left; 0: the doorway is straight ahead, with a shut door maybe; none: there is none within
    // kLineUp_m.
    std::optional<double> line_up_m(const BlindBody& body, double heading_rad, const DoorsOpen& open) const;
    // The door within reach of somebody who stands there, among doors(); kNothing: none.
    std::uint32_t door_at(std::uint32_t span) const { return near_door_.empty() ? kNothing : near_door_[span]; }

private:
    struct OnCell;
    struct Stride;
    bool held(std::uint32_t from, std::uint32_t to, const DoorsOpen& open, bool through_doors) const;
    void find_free();
    bool leap(OnCell& body, const Vec2& ahead, double by_m) const;
    bool advance(OnCell& body, const Stride& by, const DoorsOpen& open, bool through_doors, bool& edge) const;

    const WalkSpace& space_;
    std::vector<WordDoor> doors_;
    std::vector<std::uint16_t> shut_leaf_, open_leaf_;  // of each span: 1 + the door whose leaf it is in; 0: none
    std::vector<bool> shut_middle_;                     // of each span: the middle of a body there is in a shut leaf
    std::vector<std::uint32_t> near_door_;
    std::vector<float> free_m_;  // of each span: nothing stands, ends or rises nearer; 0 where that is not known
};

}  // namespace handrail
