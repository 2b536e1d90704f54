// Helps a person who is lost, or who wants to know a place before going there. It carries out the command "I am lost",
// the description of a distant room, the rooms above and below, and the description of the building in three sentences.
// Use it on the app thread only.
#pragma once

#include <deque>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class FarPlaces : SessionPart {
public:
    // For the command "I am lost", turns the walker in `body`.
    FarPlaces(const SessionContext& context, WalkerState& avatar, Rooms& rooms);

    void enter_world();
    // Carries out these four commands. Returns false for other commands.
    bool act(Command command, double now_s);
    // Call it with every command that was carried out. If the command announced the person's location, the present
    // place becomes a known place.
    void note(Command command);
    // Notes a doorway that the person passes as a known place. Call it once a tick, after Rooms::tick().
    void tick();

private:
    // A place where the person knew their own location.
    struct Known {
        Vec3 feet_m{0.0};
        FeatureId door = kNoFeature;  // the door that the person passed there
        // The rooms on either side of the doorway.
        std::uint32_t from = navigation::kNothing, to = navigation::kNothing;
    };
    void know(Known place);
    std::string name_of_place(const Known& place) const;
    std::string route_back() const;
    void find_bearings(double now_s);
    void choose_room(double now_s);
    void announce_building(double now_s);
    void announce_above_and_below(double now_s);

    WalkerState& avatar_;
    Rooms& rooms_;
    std::deque<Known> known_;  // known places, the newest last
    std::uint32_t room_ = navigation::kNothing;
};

}  // namespace handrail::core
