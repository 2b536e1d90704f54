// For a person who is lost, or who wants to know a place before going there: "I am lost", a description of a distant
// room, and the building in three sentences. App thread only.
#pragma once

#include <deque>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class FarPlaces : SessionPart {
public:
    // `body`: turned by "I am lost".
    FarPlaces(const SessionContext& context, WalkerState& body, Rooms& rooms);

    void enter_world();
    // Handles the three questions. Returns false for other commands.
    bool act(Command command, double now_s);
    // Call it with every command that was carried out: a place where the location was announced to the person is a
    // known place.
    void note(Command command);
    // Call it once a tick, after the rooms: a doorway that the person passes is a known place.
    void tick();

private:
    // A place where the person knew their location.
    struct Known {
        Vec3 feet_m{0.0};
        FeatureId door = kNoFeature;                                           // passed there
        std::uint32_t from = navigation::kNothing, to = navigation::kNothing;  // the rooms that it joins
    };
    void know(Known place);
    std::string name_of_place(const Known& place) const;
    std::string way_back() const;
    void find_bearings(double now_s);
    void choose_room(double now_s);
    void tell_building(double now_s);

    WalkerState& body_;
    Rooms& rooms_;
    std::deque<Known> known_;  // newest last
    std::uint32_t room_ = navigation::kNothing;
};

}  // namespace handrail::core
