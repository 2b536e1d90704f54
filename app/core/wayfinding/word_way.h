// The route to a room that is followed by words: planned for words in the background, its first legs first; told leg by
// leg from where one is, and planned anew where the rest of it would not lead there any more. Says nothing itself. App
// thread only; world metres.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/leg_words.h"
#include "app/core/wayfinding/word_ground.h"

namespace handrail {

class WordWay : SessionPart {
public:
    WordWay(const SessionContext& context, Rooms& rooms, WordGround& ground);

    // From where the body stands; `goal` is what its end is called. In place of what was followed before.
    void begin(std::uint32_t room, std::string goal);
    void stop();

    // None: nothing is followed. Planned: it is being planned. Known: its first legs can be told, at least. NoWay:
    // there is none for words.
    enum class State : std::uint8_t { None, Planned, Known, NoWay };
    State state() const { return state_; }
    bool at_work() const { return state_ == State::Planned || state_ == State::Known; }
    // A leg or the rest that was requested is being planned: News::planned says when it is there.
    bool awaited() const {
        return state_ == State::Planned || (state_ == State::Known && awaited_ != Awaited::Nothing);
    }
    // All its legs are known, or it has none.
    bool whole() const { return state_ != State::Planned && (state_ != State::Known || way_.route->whole); }

    struct News {
        bool planned = false;  // what was awaited is there to be told, or there is none
        bool arrived = false, left = false;
    };
    // Costs a look at the grid where the body has moved.
    News tick();

    // As a sentence each; empty: it is being planned anew, and news() tells when it is there, or there is none. The leg
    // one is on from where one is, or the one after where it is over;
    std::string leg();
    // the one after the leg told last;
    std::string next_leg();
    // and all that are left, one after the other.
    std::vector<std::string> rest();
    // The body was stopped by that part where it stands, in the direction that it faces. If a leg would go on there, it
    // is told with the door that stopped the body. If no door did, there is no way for words any more.
    void note_stop(FeatureId by);
    // Where the leg that was told last leads; none: nothing is told.
    std::optional<double> heading_rad() const;

private:
    struct Planned {
        std::shared_ptr<const WordFloor> floor;
        std::shared_ptr<const WordGoal> goal;
        std::optional<WordRoute> route;
        Vec3 from_m{0.0};
        int notch = 0;
        DoorsOpen open;  // as the doors stood then
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
    DoorsOpen open_now() const { return ground_.open_now(*way_.floor); }

    Rooms& rooms_;
    WordGround& ground_;
    State state_ = State::None;
    std::uint32_t room_ = kNothing;
    std::string goal_;
    bool wanted_ = false;                 // a plan, once there is a floor
    Awaited awaited_ = Awaited::Nothing;  // of the legs that are not known yet
    Planned way_;
    std::size_t at_ = 0;  // the leg that is walked
    Vec3 looked_m_{0.0};
    struct Stop {
        Vec3 at_m{0.0};
        double heading_rad = 0.0;
        FeatureId door = kNoFeature;  // kNoFeature: no door stopped it
        int times = 1;                // by the same door one after the other
    };
    std::optional<Stop> stopped_;
    BackgroundTask<Planned> planning_{context_.executor, "word-route"};
};

}  // namespace handrail
