// What the session keeps for marks, beacon and being led: plain state of AppCore's part in app_core_guide.cpp. App thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/finding.h"
#include "app/core/grooves.h"
#include "app/core/marks.h"
#include "app/core/sought_way.h"
#include "haptic/servo/guidance.h"

namespace handrail {

// Something to be found or gone to.
struct Goal {
    std::string name;
    Aabb box_m;  // a point for marks and places on walls
    FeatureId feature = kNoFeature;
};

// The way along which a tool leads.
struct AlongWay {
    SoughtWay way;
    std::shared_ptr<const Scene> planned_in;  // as the world was then
    std::uint32_t jump = 0;                   // of the workspace, then
    double looked_s = -1e9;                   // when it was last looked at what stands between, and for shut doors
};

struct Guiding {
    std::vector<Mark> marks;
    Beacon beacon;
    Warmer warmer;
    Laps laps;
    AlongWay beacon_along, warmer_along;  // of the body; of the hand where there is one
    // Of the way that is gone by ear.
    bool turning_first = false;                    // the beacon calls from a turning
    Vec3 turning_m{0.0};                           // which one, soles
    std::optional<Goal> goal;  // what "take me there" goes to

    // Being led: first told, then felt.
    GuidancePath path;                      // as the servo has it
    std::optional<GuidancePath> announced;  // to be published at starts_s
    double starts_s = 0.0;
    bool acts = false;        // published, and the servo has not told of its end
    bool stray = false;       // the hand is off the way now
    int errors = 0;           // how often it went off the way in this lap
    bool to_nearest = false;  // the way ends where one gets nearest to the goal
    std::uint32_t last_number = 0;
    // Leaving the way otherwise than by pulling the hand out of it.
    std::uint32_t jump = 0;                   // of the workspace, when the way was planned
    Vec3 feet_before_m{0.0};                  // a tick before
    double moved_s = -1e9;                    // when the person last walked or moved the workspace
    double off_since_s = -1e9;                // the hand has been far off the way since then
    std::shared_ptr<const Scene> planned_in;  // as the world was then
    bool left = false;                        // the way is to be planned anew when all is at rest
    bool carries = false;                     // the workspace goes along with the hand now
    bool carried = false;                     // and has, since that was last looked at
    std::vector<FeatureId> doors_told;        // shut ones across the way
    double lines_laid_s = -1e9;               // along the way

    // Grooves on the floor, while nothing else acts.
    std::vector<Vec3> way_m;          // soles, of the way planned last; empty: none
    std::vector<GrooveLeg> doorways;  // of this world
    bool doorways_known = false;
    bool grooves_changed = false;  // another way
    Vec3 grooves_near_m{0.0};      // where the hand was when they were laid
    double grooves_good_within_m = 0.0;
    double grooves_scale = 0.0;     // then
    double grooves_ended_s = -1e9;  // by the servo

    // Where hand and body have been told to be near, so that each is told once.
    std::vector<bool> mark_near;
    std::vector<FeatureId> landmarks_near;
    FeatureId touched = kNoFeature;
    bool first_look = true;     // what is near on entering is not told
    std::uint32_t buttons = 0;  // of the device, a tick before
};

}  // namespace handrail
