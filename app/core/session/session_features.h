// Groups the features of the session, with one struct for each folder. The members are in the order in which they
// depend on each other. Use them on the app thread only.
#pragma once

#include <optional>
#include <string>

#include "app/core/context/session_state.h"
#include "app/core/context/soundscape.h"
#include "app/core/dialogue/held_keys.h"
#include "app/core/hand/forces.h"
#include "app/core/hand/touch_view.h"
#include "app/core/hand/workspace.h"
#include "app/core/learning/clock_hunt.h"
#include "app/core/learning/place_learning.h"
#include "app/core/learning/route_memory.h"
#include "app/core/lessons/exercise.h"
#include "app/core/movers/doors.h"
#include "app/core/movers/triggers.h"
#include "app/core/places/fault_list.h"
#include "app/core/places/group_list.h"
#include "app/core/places/kept_routes.h"
#include "app/core/places/label_list.h"
#include "app/core/places/mark_list.h"
#include "app/core/places/no_route_reason.h"
#include "app/core/places/prepare_lesson.h"
#include "app/core/places/quiz.h"
#include "app/core/walking/by_ear.h"
#include "app/core/walking/cane.h"
#include "app/core/walking/footing.h"
#include "app/core/walking/walking.h"
#include "app/core/wayfinding/answers.h"
#include "app/core/wayfinding/guide.h"
#include "app/core/whereabouts/climbs.h"
#include "app/core/whereabouts/far_places.h"
#include "app/core/whereabouts/queries.h"
#include "app/core/whereabouts/rooms.h"
#include "app/core/whereabouts/visits.h"

namespace handrail::core {

// Features that describe where the walker is: its room and the surroundings.
struct Whereabouts {
    explicit Whereabouts(SessionState& state)
        : rooms(state.context),
          queries(state.context, rooms),
          far(state.context, state.avatar, rooms),
          climbs(state.context, rooms, queries),
          visits(state.context) {}
    Rooms rooms;
    Queries queries;
    FarPlaces far;
    Climbs climbs;
    Visits visits;
};

// Features for things that move when the person uses them, walks against them or enters them.
struct MoverFeatures {
    explicit MoverFeatures(SessionState& state)
        : doors(state.context, state.world, state.avatar), triggers(state.context, state.world) {}
    Doors doors;
    Triggers triggers;
};

// Features that move the walker: by keys, by sticks, or along walls by ear.
struct WalkingFeatures {
    explicit WalkingFeatures(SessionState& state)
        : by_ear(state.context, state.avatar, keys_held),
          footing(state.context, state.avatar),
          walking(state.context, state.avatar, keys_held, by_ear, footing),
          cane(state.context, state.avatar, keys_held) {}
    HeldKeys keys_held;
    ByEar by_ear;
    Footing footing;
    Walking walking;
    Cane cane;
};

// The questions that the person asks.
struct Questions {
    Questions(SessionState& state, Whereabouts& where, Guide& guide)
        : answers(state.context, where.rooms, where.queries, guide) {}
    Answers answers;
    struct TooEarly {
        std::optional<Command> command;
        std::string line;  // a typed question, if there is no command
        double requested_s = 0.0;
    };
    // A question that the person asked while the session was still searching for the rooms. It is answered once the
    // rooms are known.
    std::optional<TooEarly> too_early;
};

// Features that determine what the hand feels, where its workspace is, and whether there is force.
struct HandFeatures {
    HandFeatures(SessionState& state, const HeldKeys& keys_held)
        : touch_view(state.context, state.world, state.avatar, state.hands),
          workspace(state.context, state.hands, keys_held, touch_view),
          forces(state.context, state.hands) {}
    TouchView touch_view;
    Workspace workspace;
    Forces forces;
};

// Features that save places and routes of a world, so that the person can return to them.
struct PlacesFeatures {
    PlacesFeatures(SessionState& state, Rooms& rooms, const PlannedStops& planned)
        : marks(state.context, state.world.marks),
          ways(state.context, rooms, planned),
          labels(state.context, state.world),
          groups(state.context, state.world),
          quiz(state.context),
          faults(state.context, rooms),
          why_no_route(state.context, rooms),
          lesson(state.context, rooms) {}
    MarkList marks;
    KeptRoutes ways;
    LabelList labels;
    GroupList groups;
    Quiz quiz;
    FaultList faults;
    NoRouteReason why_no_route;
    PrepareLesson lesson;
};

// Features for an instructor's lessons.
struct TeachingFeatures {
    explicit TeachingFeatures(SessionState& state) : exercise(state.context) {}
    Exercise exercise;
    std::vector<FeatureId> blocked;  // doors that a lesson keeps shut
};

// Features for learning a place, for the hunt as a game of exploring, and for an instructor's lessons.
struct LearningFeatures {
    LearningFeatures(SessionState& state, Rooms& rooms, Soundscape& soundscape)
        : place(state.context, rooms),
          ways(state.context, rooms),
          hunt(state.context, rooms, soundscape),
          teaching(state) {}
    PlaceLearning place;
    RouteMemory ways;
    ClockHunt hunt;
    TeachingFeatures teaching;
};

}  // namespace handrail::core
