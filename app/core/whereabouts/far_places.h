// For who is lost, and for who wants to know a place before going there: "I am lost", a room described from afar, the
// building in three sentences. App thread only.
#pragma once

#include <deque>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

class FarPlaces : SessionPart {
public:
    // "I am lost" turns `body`.
    FarPlaces(const SessionContext& context, BodyState& body, Rooms& rooms);

    void enter_world();
    // The three questions. False: it is another's.
    bool act(Command command, double now_s);
    // Told of every command that is carried out: where one has been told where one is, one knows the place.
    void note(Command command);
    // Once a tick, after the rooms: a doorway that one goes through is a place that one knows.
    void tick();

private:
    // A place where the person knew where they were.
    struct Known {
        Vec3 feet_m{0.0};
        FeatureId door = kNoFeature;                   // gone through there
        std::uint32_t from = kNothing, to = kNothing;  // the rooms it joins
    };
    void know(Known place);
    std::string name_of_place(const Known& place) const;
    std::string way_back() const;
    void find_bearings(double now_s);
    void choose_room(double now_s);
    void tell_building(double now_s);

    BodyState& body_;
    Rooms& rooms_;
    std::deque<Known> known_;  // the newest last
    std::uint32_t room_ = kNothing;
};

}  // namespace handrail
