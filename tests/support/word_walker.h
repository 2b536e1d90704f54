// Simulates a walker who only hears spoken text. The walker requests the route to a room by its name and obeys each
// leg. It opens doors when directed to, side-steps when a shoulder is named, and uses stairs and lifts by the named
// key. If no direction comes, it repeats its request. Or it requests all legs of the route at once, listens to them,
// and then walks them without another word. It never uses the scene or the position of its feet; the test that judges
// it does that afterwards. It runs an unchanged session in virtual time.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/core/session/session.h"
#include "tests/support/heard_legs.h"
#include "tests/support/names.h"
#include "worlds/scene/scene.h"

namespace handrail::test {

class WordWalker {
public:
    // How a walk ended:
    // - Arrived: the session announced the arrival.
    // - NoRoute: the session announced that there is no route.
    // - Loop: the walk did not end.
    // - Stuck: the directions no longer moved the walker.
    // - NotUnderstood: the walker did not understand the directions.
    enum class End { Arrived, NoRoute, Loop, Stuck, NotUnderstood };

    explicit WordWalker(std::shared_ptr<const Scene> world) : form_(english_legs()), app_({}, {}, {}) {
        app_.apply(WorldEntered{make_ready(std::move(world))}, now_s_);
        run(0.1);
        request(Command::Exits);  // after this query, the session knows the rooms of the world
        run(1.0);
    }

    End go(const std::string& room) {
        if (!begin(room)) return give_up(End::NoRoute);
        std::string leg = request(Command::RepeatLeg);
        for (int legs = 0, idle = 0; legs < kMostLegs && climbs_ < kMostClimbs; ++legs) {
            if (arrived()) return End::Arrived;
            const int before = moves();
            if (!obey(leg)) {
                // If the walker could not obey the leg, it requests the leg once more, after a second.
                run(1.0);
                if (!arrived() && !obey(request(Command::RepeatLeg)))
                    return give_up(heard("No walking route", 0) ? End::NoRoute : End::NotUnderstood);
            }
            if (arrived()) return End::Arrived;
            idle = moves() == before ? idle + 1 : 0;
            if (idle >= kMostIdle) return give_up(End::Stuck);
            leg = request(idle > 0 ? Command::RepeatLeg : Command::NextLeg);
        }
        return arrived() ? End::Arrived : give_up(End::Loop);
    }

    // Walks like go(), but listens to each direction until a voice has spoken it, as a person with a voice does.
    End go_by_voice(const std::string& room) {
        voice_ = true;
        const End end = go(room);
        voice_ = false;
        return end;
    }

    // Walks by the legs of RestOfRoute alone. If the walker has not arrived after the last one, it requests the rest
    // again, at most kMostRests times.
    End go_by_rest(const std::string& room) {
        if (!begin(room)) return give_up(End::NoRoute);
        for (int rests = 0; rests < kMostRests; ++rests) {
            const std::string rest = request(Command::RestOfRoute);
            listen_to(rest);
            for (const std::string& leg : legs_in(rest, form_)) {
                if (arrived()) return End::Arrived;
                if (!obey(leg)) return give_up(End::NotUnderstood);
            }
            run(kListens_s);
            if (arrived()) return End::Arrived;
        }
        return give_up(End::Stuck);
    }

    // ---- functions for the test ----
    std::string last_lines(std::size_t most) const {
        std::string all;
        for (std::size_t i = said_.size() > most ? said_.size() - most : 0; i < said_.size(); ++i)
            all += "    " + said_[i] + "\n";
        return all;
    }
    // Returns where the walker stood when the arrival was announced. Without an arrival, returns its present position.
    Vec3 feet_m() const { return announced_there_m_.value_or(app_.feet_m()); }
    // Returns the number of flights of stairs and lifts that the walker used on its last walk.
    int climbs() const { return climbs_; }
    void put(const Vec3& feet_m) {
        app_.apply(Placed{feet_m, 0.0}, now_s_);
        announced_there_m_.reset();
        run(0.2);
    }

private:
    static constexpr int kMostLegs = 160, kMostClimbs = 8, kMostIdle = 4, kMostAtOnce = 8, kTries = 4;
    static constexpr int kMostRests = 3;
    static constexpr double kWords_per_s = 3.0, kListens_s = 1.0;
    static constexpr double kPatience_s = 3.0;  // the longest time that the walker waits for a leg
    static constexpr double kTick_s = 1.0 / 60.0, kDoorOpens_s = 3.0, kRide_s = 60.0, kSideStep_s = 0.25;

    // ---- what the walker hears ----
    void listen() {
        for (CueRequest& cue : app_.take_cues()) {
            if (cue.kind == CueRequestKind::Footstep) ++footsteps_;
            const bool spoken = cue.kind == CueRequestKind::Say || cue.kind == CueRequestKind::Demonstrate ||
                                cue.kind == CueRequestKind::Bump;
            if (!spoken || cue.text.empty()) continue;
            if (cue.text == there_) announced_there_m_ = app_.feet_m();
            said_.push_back(std::move(cue.text));
        }
    }
    // Lets the time pass in which the text is spoken, at 180 words a minute.
    void listen_to(const std::string& text) {
        run(static_cast<double>(std::count(text.begin(), text.end(), ' ') + 1) / kWords_per_s);
    }
    bool heard(std::string_view part, std::size_t since) const {
        for (std::size_t i = since; i < said_.size(); ++i)
            if (said_[i].find(part) != std::string::npos) return true;
        return false;
    }
    bool arrived() const { return announced_there_m_.has_value(); }
    // Returns the number of footsteps heard, plus the number of stairs, lifts and doors used.
    int moves() const { return footsteps_ + climbs_ + used_; }

    // ---- what the walker does ----
    // Chooses the route to a room. Returns false if there is none.
    bool begin(const std::string& room) {
        said_.clear();
        announced_there_m_.reset();
        there_ = room + ". You are there.";
        climbs_ = 0;
        request(Command::Routes);
        app_.apply(LineTyped{room}, now_s_);
        run(0.05);
        return !heard("No walking route", 0);
    }
    void tick() {
        app_.tick(now_s_ += kTick_s, tool_);
        listen();
    }
    void run(double seconds) {
        for (; seconds > 0.0; seconds -= kTick_s) tick();
    }
    // Waits until the walker stands still, or until the arrival is announced.
    void wait() {
        for (int i = 0; i < 6000 && !app_.idle() && !arrived(); ++i) tick();
        run(0.15);
    }
    std::string request(Command command) {
        const std::size_t before = said_.size();
        app_.apply(CommandDown{command}, now_s_);
        app_.apply(CommandUp{command}, now_s_);
        listen();
        for (double s = 0.0; s < kPatience_s && said_.size() > before && said_.back() == phrase("leg.looks");
             s += kTick_s)
            tick();
        const std::string last = said_.size() > before ? said_.back() : std::string();
        if (voice_) listen_to(last);
        return last;
    }
    void press(Command command, int times = 1) {
        app_.apply(CommandDown{command, times}, now_s_);
        app_.apply(CommandUp{command}, now_s_);
        wait();
    }
    void hold(Command command, double seconds) {
        app_.apply(CommandDown{command}, now_s_);
        run(seconds);
        app_.apply(CommandUp{command}, now_s_);
        wait();
    }
    void use() {
        const std::size_t said = said_.size();
        request(Command::Use);
        run(kDoorOpens_s);
        if (heard(" opens", said) || heard(" is shut", said)) ++used_;
    }
    void ride() {
        const std::size_t said = said_.size();
        request(Command::Use);
        for (double s = 0.0; s < kRide_s && !heard(" stops", said); s += 0.5) run(0.5);
        run(kDoorOpens_s);
        ++climbs_;
    }
    End give_up(End end) {
        request(Command::TakeMe);  // this command also stops following the route
        return end;
    }

    // Obeys a direction. Returns false if the text has no form that the walker understands.
    bool obey(const std::string& text) {
        if (text.find("You are standing at them. ") != std::string::npos) {
            ++climbs_;
            request(Command::Use);
            run(1.0);
        } else if (text.find("You are standing in it. ") != std::string::npos) {
            ride();
        } else if (const auto leg = understood(text, form_)) {
            walk_leg(*leg);
        } else if (const auto direction = text.rfind("To ", 0) == 0 ? direction_in(text) : std::nullopt) {
            walk_direction(*direction, text.find(" Shut it.") != std::string::npos);
        } else {
            return false;
        }
        return true;
    }
    void walk_leg(const HeardLeg& leg) {
        if (leg.turn_notches != 0)
            press(leg.turn_notches > 0 ? Command::TurnRight : Command::TurnLeft, std::abs(leg.turn_notches));
        if (leg.until == HeardLeg::Until::FlightOver) walk_until_over(leg.steps);
        else walk(leg.until == HeardLeg::Until::Counted ? leg.steps : 2 * leg.steps + 6);
        if (leg.use && !arrived()) use();
    }
    // Walks in a direction. If a thing stops the walker there and the session says that it is shut, the walker opens
    // it.
    void walk_direction(const Direction& direction, bool shut) {
        const int fives = static_cast<int>(std::lround(direction.right_deg / 5.0));
        for (int i = 0; i < std::abs(fives); ++i) press(fives > 0 ? Command::FreeRight : Command::FreeLeft);
        const std::size_t said = said_.size();
        walk(std::clamp(direction.steps, 1, kMostAtOnce));
        if (!arrived() && (shut || heard(", shut", said))) use();
    }
    // Walks this many steps, or until an obstacle stops the walker. If only a shoulder hits something, the walker
    // side-steps.
    void walk(int steps) {
        for (int tries = 0; tries < kTries && steps > 0 && !arrived(); ++tries) {
            const std::size_t said = said_.size();
            const int before = footsteps_;
            press(Command::Forward, steps);
            steps -= footsteps_ - before;
            // Only the last sentence counts, because the walker has already passed what was announced before.
            const std::string last = said_.size() > said ? said_.back() : std::string();
            const bool left = last.find("left shoulder") != std::string::npos;
            if (!left && last.find("right shoulder") == std::string::npos) return;
            hold(left ? Command::SideRight : Command::SideLeft, kSideStep_s);
        }
    }
    // Walks up or down the flight of stairs, and releases the key when the session announces the end of the flight.
    void walk_until_over(int steps) {
        const std::size_t began = said_.size();
        std::size_t said = began;
        app_.apply(CommandDown{Command::Forward}, now_s_);
        for (int i = 0; i < 60 * (30 + 2 * steps) && !arrived(); ++i) {
            tick();
            for (; said < said_.size(); ++said) {
                const bool left = said_[said].find("left shoulder") != std::string::npos;
                if (!left && said_[said].find("right shoulder") == std::string::npos) continue;
                app_.apply(CommandUp{Command::Forward}, now_s_);
                hold(left ? Command::SideRight : Command::SideLeft, kSideStep_s);
                app_.apply(CommandDown{Command::Forward}, now_s_);
            }
            if (heard(form_.landed_up, began) || heard(form_.landed_down, began)) break;
        }
        app_.apply(CommandUp{Command::Forward}, now_s_);
        wait();
    }

    LegForm form_;
    Session app_;
    ToolState tool_;
    double now_s_ = 0.0;
    std::vector<std::string> said_;
    std::string there_;
    std::optional<Vec3> announced_there_m_;
    int footsteps_ = 0, climbs_ = 0, used_ = 0;
    bool voice_ = false;  // true: each direction takes the time in which a voice speaks it
};

}  // namespace handrail::test
