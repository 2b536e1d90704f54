// The route to a room, followed by words. A background task plans it, its first legs first. It is announced leg by leg
// from the person's place, and planned again if the rest would no longer lead there. It announces nothing itself. App
// thread only; world metres.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/directions_ground.h"
#include "app/core/wayfinding/leg_words.h"

namespace handrail::core {

class RouteDirections : SessionPart {
public:
    RouteDirections(const SessionContext& context, Rooms& rooms, DirectionsGround& ground);

    // Begins a route from the walker's place, which replaces the previous one; `goal`: name of its end.
    void begin(std::uint32_t room, std::string goal);
    void stop();

    // - None: nothing is followed.
    // - Planned: it is being planned.
    // - Known: at least its first legs can be announced.
    // - NoWay: there is no route in words.
    enum class State : std::uint8_t { None, Planned, Known, NoWay };
    State state() const { return state_; }
    bool at_work() const { return state_ == State::Planned || state_ == State::Known; }
    // True while a requested leg or the rest is being planned; News::planned reports when it is ready.
    bool awaited() const {
        return state_ == State::Planned || (state_ == State::Known && awaited_ != Awaited::Nothing);
    }
    // True if all its legs are known, or it has none.
    bool whole() const { return state_ != State::Planned && (state_ != State::Known || way_.route->whole); }

    struct News {
        bool planned = false;  // what was awaited is ready, or does not exist
        bool arrived = false, left = false;
    };
    // Costs a look at the grid if the walker has moved.
    News tick();

    // The legs as sentences. Empty: it is being planned again, and tick() reports when it is ready, or there is none.
    // leg(): the present leg from the present place, or the next one if it is over.
    std::string leg();
    // The leg after the last announced one.
    std::string next_leg();
    // All remaining legs, one after the other.
    std::vector<std::string> rest();
    // That feature stopped the walker at its present place and heading. If a leg would continue there, it is announced
    // with the door that stopped the walker. If no door did, there is no route in words any more.
    void note_stop(FeatureId by);
    // Direction of the last announced leg; no value: none was announced.
    std::optional<double> heading_rad() const;

private:
    struct Planned {
        std::shared_ptr<const DirectionsFloor> floor;
        std::shared_ptr<const navigation::DirectionsGoal> goal;
        std::optional<navigation::DirectionsRoute> route;
        Vec3 from_m{0.0};
        int notch = 0;
        navigation::DoorsOpen open;  // state of the doors at that time
    };
    enum class Awaited : std::uint8_t { Nothing, NextLeg, Rest };
    void plan(bool in_parts = true);
    void plan_rest();
    void take(Planned planned);
    bool take_rest(Planned planned);
    std::string await(Awaited what);
    LegAt leg_at(std::size_t which) const;
    bool stopped_on(const LegAt& leg) const;
    bool begin_with_door(SpokenLeg& leg) const;
    bool in_outline(const Vec3& feet_m) const;
    bool holds() const;
    std::string tell();
    navigation::DoorsOpen open_now() const { return ground_.open_now(*way_.floor); }

    Rooms& rooms_;
    DirectionsGround& ground_;
    State state_ = State::None;
    std::uint32_t room_ = navigation::kNothing;
    std::string goal_;
    bool wanted_ = false;                 // a plan is wanted as soon as there is a floor
    Awaited awaited_ = Awaited::Nothing;  // what was requested of legs that are not known yet
    Planned way_;
    std::size_t at_ = 0;  // the leg that is being walked
    Vec3 looked_m_{0.0};
    struct Stop {
        Vec3 at_m{0.0};
        double heading_rad = 0.0;
        FeatureId door = kNoFeature;  // kNoFeature: no door stopped it
        int times = 1;                // consecutive stops by the same door
    };
    std::optional<Stop> stopped_;
    BackgroundTask<Planned> planning_{context_.executor, "word-route", context_.arrivals};
};

}  // namespace handrail::core
