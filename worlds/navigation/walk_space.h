// Where a body of a certain size can stand and walk in a Scene: upright columns through its solids, each grown by the
// body, so that a place is free exactly when the body there overlaps nothing. The same growth and slopes as walking
// itself uses. Built by flooding from where a designer put something, so its size goes with what can be reached, not
// with the world's. Immutable afterwards. Deterministic. Any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/navigation/route.h"
#include "worlds/scene/scene.h"

namespace handrail {

struct WalkBody {
    double radius_m = 0.25;
    double height_m = 1.8;
    double step_up_m = 0.25;
    double most_drop_m = 1.0;  // farther down nobody is led
    double cell_m = 0.05;      // of the columns; larger where there is too much floor for it
    bool operator==(const WalkBody&) const = default;
};

// No span, no obstacle, no room.
inline constexpr std::uint32_t kNothing = 0xffffffffU;

// One place to stand in a column.
struct WalkSpan {
    float floor_m = 0.0F;    // above WalkSpace::origin_m.z
    float ceiling_m = 0.0F;  // where the soles could at most be
    std::uint32_t cell = 0;
    std::uint32_t next[4] = {kNothing, kNothing, kNothing,
                             kNothing};  // the span one walks to: east, north, west, south
    std::uint32_t ground = kNothing;     // obstacle one stands on
    std::uint32_t door = kNothing;       // place in Scene::movers of the door that hangs here
    float clearance_m = 0.0F;            // from here to where the body would touch something or step off an edge
    std::uint32_t beside = kNothing;     // the obstacle that is nearest; kNothing: an edge
    bool near_edge = false;              // nearest is an edge that one would fall from
    bool liquid = false;
    bool stairs = false;
};

// The same where furniture is left out, things lower than a wall: only what finding rooms looks at.
struct WallSpan {
    float floor_m = 0.0F;
    std::uint32_t next[4] = {kNothing, kNothing, kNothing, kNothing};
    float clearance_m = 0.0F;
    std::uint32_t cell : 29 = 0;  // a grid has far fewer
    std::uint32_t door : 1 = 0, liquid : 1 = 0, stairs : 1 = 0;
};
static_assert(sizeof(WallSpan) == 28);  // there are millions

// A way that walking alone does not make.
struct WalkLink {
    PassageKind kind = PassageKind::Drop;
    std::uint32_t from = 0, to = 0;  // spans
    bool both_ways = false;
    FeatureId feature = kNoFeature;
};

// Columns side by side, each with its spans from below.
template <class Span>
struct SpanGrid {
    Vec3 origin_m{0.0};  // corner of cell 0
    double cell_m = 0.05;
    std::uint32_t width = 0, depth = 0;  // cells to the east and to the north
    std::vector<std::uint32_t> first;    // of each cell the first span; size width x depth + 1
    std::vector<Span> spans;

    Vec3 place_m(std::uint32_t span) const {
        const std::uint32_t x = spans[span].cell % width, y = spans[span].cell / width;
        return origin_m + Vec3((x + 0.5) * cell_m, (y + 0.5) * cell_m, static_cast<double>(spans[span].floor_m));
    }
    // The span whose middle is nearest, at most that far level and up or down; kNothing: none. Costs a look at the
    // cells nearer than it, and never at more than the grid has.
    std::uint32_t nearest(const Vec3& feet_m, double level_m, double up_m, double down_m) const;
};
extern template struct SpanGrid<WalkSpan>;
extern template struct SpanGrid<WallSpan>;

struct WalkSpace : SpanGrid<WalkSpan> {
    WalkBody body;
    std::vector<WalkLink> links;
    std::vector<FeatureId> obstacle_features;  // of each obstacle the feature it is, kNoFeature for the building itself
    std::vector<std::string> said;             // sentences about what was simplified or left out
    double outdoors_m = 0.0;  // how far from the building ground outside is part of this, if some of it is not; else 0
    bool part = false;        // there is more floor than could be looked at: this is what is nearest to the start
    std::shared_ptr<const SpanGrid<WallSpan>> walls;  // without furniture, for make_rooms; may be let go after that

    // The span of the column at that place whose floor is nearest in height; kNothing where there is none within a step
    // and a half.
    std::uint32_t at(const Vec3& feet_m) const;
    // True when one walks straight from one place to the other without leaving the spans. `touched` is told every span
    // on the way, in order.
    bool straight(const Vec3& from_m, const Vec3& to_m, const std::function<void(std::uint32_t)>& touched = {}) const;
    double cell_area_m2() const { return cell_m * cell_m; }
};

// What a listener should know of a space that was requested with this body: that its columns are coarser, and what is
// left out of it.
std::vector<std::string> said_of(const WalkSpace& space, const WalkBody& asked);

// What is made of a space for a body that is only tried: where it comes to, its drops, lifts and stairs in one go. No
// walls without furniture, no rooms that nothing leads to, no mark of stairs and nothing about what is nearest.
struct WalkTrial {
    bool clearance = false;  // WalkSpan::clearance_m is measured too
    // If set, the body starts at `from_m` and stays in the box. Only what touches the box is considered, and lifts,
    // teleporters and stairs in one go are left out.
    struct Stretch {
        Vec3 from_m{0.0};
        Aabb box_m;
    };
    std::optional<Stretch> within;
};
// Fails as make_walk_space does, and costs about a third of it, a stretch a small part.
Result<WalkSpace> make_trial_space(const Scene& scene, const WalkBody& body, const WalkTrial& trial,
                                   const std::stop_token& stop = {});

// Fails with a sentence if there is nothing to walk on, and if `stop` ends it: it is queried every few milliseconds. If
// there is much floor, the columns are coarser and ground far from everything else is left out; if there is too much
// even so, it ends with what is nearest to the start. One flood gives both the space and its walls. At most 150 bytes
// for each span while it is made.
Result<WalkSpace> make_walk_space(const Scene& scene, const WalkBody& body, const std::stop_token& stop = {});

}  // namespace handrail
