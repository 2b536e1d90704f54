// Guides the person to a goal, by the hand if there is one, or else by ear. This class decides what happens when the
// person arrives, releases the hand or leaves the route. Other features request guidance from this class. Lengths are
// in world metres. Use it on the app thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/arrival.h"
#include "app/core/wayfinding/finding.h"
#include "app/core/wayfinding/hand_lead.h"
#include "app/core/wayfinding/seek.h"
#include "app/core/wayfinding/spoken_route.h"
#include "app/core/wayfinding/stops.h"
#include "worlds/base/contract.h"

namespace handrail::core {

// The kinds of guidance that a person can end by name. Route is a route by ear or a guided hand.
enum class Guidance : std::uint8_t { Route, Beacon, Warmer, Lines };

class Guide : SessionPart {
public:
    Guide(const SessionContext& context, Rooms& rooms, Doors& doors)
        : SessionPart(context),
          rooms_(rooms),
          doors_(doors),
          planned_(context, rooms),
          plans_(context, rooms),
          ground_(context, rooms),
          arrival_(context),
          ear_(context, rooms, plans_, ground_),
          hand_(context, rooms, plans_, doors),
          seek_(context, rooms, plans_, doors) {
        doors_.of_leg = [this] { return ear_.door_to_use(); };
    }

    void enter_world();
    // Carries out the commands SetBeacon, MuteBeacon, TakeMe, Find, CrossLines, Routes, Storeys, Places and FaceRoute,
    // and those for the legs of a route. While a route is followed by ear, also carries out LeapNext and LeapLast.
    // Returns false for other commands.
    bool act(Command command, double now_s);
    // Call these three functions in each tick, in this order. They update the route that is followed by ear, the
    // guidance of the hand, and the sounds of the things that the person searches for.
    void follow(double now_s);
    void lead(double now_s);
    void call(double now_s);
    // Announces the whole route or its next leg once more, because the line about it was cut off.
    void announce_anew(cues::SpeechTopic topic, double now_s);
    // Announces an arrival once more, because the line about it was cut off. Returns false if there is no such arrival
    // or it no longer holds.
    bool tell_arrival_anew(cues::SpeechTopic topic, double now_s) {
        return arrival_.announce_anew(topic, on_route(), now_s);
    }

    // ---- for other features ----
    // Follows the stops of a saved route, guided by the hand or by ear. If necessary, leads to the first stop before
    // that.
    void go_along(const std::vector<Stop>& stops, bool by_hand, double now_s);
    void go_to_room(std::uint32_t room, double now_s);
    // Leads to a thing, as the command TakeMe does.
    void go_to_thing(const Goal& goal, double now_s);
    // Follows the route from the walker to `goal_m`. If `by_room` is true, the goal is the room around that place.
    // Otherwise it is a thing with this name. Returns false if no route leads there.
    bool follow_to(const Vec3& goal_m, const std::string& name, bool by_room, double now_s);
    // Returns true while legs that the person requested are still being planned. A later tick announces them.
    bool plans_legs() const { return ear_.plans_legs(); }
    // Returns true while the legs to the end of the route are still being planned.
    bool plans_rest() const { return ear_.plans_rest(); }
    // Returns the legs that the command RestOfRoute announces, one text each, and ends the guidance. The list is empty
    // if there is no route.
    std::vector<std::string> take_legs();
    // Opens the list of the tools to find this thing.
    void open_tools(const Goal& goal, double now_s);
    // Switches the beacon on at this goal, without an announcement.
    void call_from(const Goal& goal);
    // Ends one kind of guidance. Returns the announcement: that it has ended, or that there is none.
    std::string end(Guidance what);
    // Returns a sentence on the route or the beacon: its goal and how far that is, or that there is none.
    std::string state_words(Guidance of, double now_s);
    // Returns the amount of guidance, 0 to 1. change_help(1) increases it, and change_help(-1) decreases it.
    double help() const { return help_limit_.value_or(laps_.strength()); }
    // Sets the amount of guidance for a lesson, 0 to 1. If `help` has no value, the laps determine the amount.
    void limit_help(std::optional<double> help) {
        contract_pre(!help || (*help >= 0.0 && *help <= 1.0));
        help_limit_ = help;
    }
    // Returns true if the hand is guided or will soon be. The hand may then be ahead of the walker.
    bool leads_hand() const { return hand_.at_work() || hand_.lines_at_work(); }
    bool may_lead_hand() const { return hand_.may_lead() && hand_.force_may_act(); }
    // Returns true while the hand is guided, a route is followed by ear, or the beacon is on.
    bool leads() const { return on_route() || beacon().on(); }
    // Ends all guidance silently.
    void leave_route();
    void change_help(int by) { laps_.change(by); }
    // Ends the guidance of the hand. Call it when another device is used.
    void let_go() { hand_.end(); }
    // The workspace calls these functions. HandLead explains them.
    Vec3 carry() { return hand_.carry(); }
    bool take_carried() { return hand_.take_carried(); }
    void person_moved(double now_s) { hand_.person_moved(now_s); }

    // Returns the value of BlindGround::line_up_m, or no value if the routes of the world are not known.
    std::optional<double> line_up_m(const Vec3& feet_m, double heading_rad) {
        return ground_.line_up_m(feet_m, heading_rad);
    }
    void note_stop(FeatureId by) { ear_.note_stop(by); }
    std::optional<navigation::RoutePassage> climb_here() const { return ear_.climb_here(); }
    // The session sets these functions. `on_face` turns the walker. The other one explains why a room cannot be
    // reached.
    std::function<void(double heading_rad, double now_s)> on_face;
    std::function<void(std::uint32_t room, double now_s)> on_no_route;
    std::function<void()> on_leap;  // called before a leap along a route; stores the present place for undoing

    const std::optional<Goal>& goal() const { return goal_; }  // returns the goal of the command TakeMe
    const Beacon& beacon() const { return seek_.beacon(); }
    const Seek& seek() const { return seek_; }
    const PlannedStops& planned() const { return planned_; }
    // Returns the name of the end of the route that is followed by ear, as it was announced. The name is empty if no
    // such route is followed.
    std::string route_name() const { return ear_.following() ? ear_.name() : std::string{}; }
    // Returns the last planned route, at floor level.
    const std::vector<Vec3>& way_m() const { return plans_.last_m(); }
    // Returns the path that the servo of the right hand has.
    const servo::GuidancePath& path() const { return hand_.path(); }

private:
    bool on_route() const { return ear_.following() || hand_.at_work(); }
    void tell_found(const std::string& name, double now_s);
    std::string beacon_words(double now_s);
    void tell_beacon(double now_s);
    void tell_warmer(double now_s);
    void mute_beacon(double now_s);
    void silence_beacon() { seek_.silence_beacon(); }
    void take_me(double now_s);
    bool leap_along(bool on, double now_s);
    void list_routes(double now_s);
    void list_storeys(double now_s);
    void list_places(double now_s);
    void open_find(double now_s);
    void set_beacon(const Goal& goal, double now_s);
    void beacon_here(double now_s);
    void seek_warmer(const Goal& goal, double now_s);
    void lead_as_planned(const Goal& goal, double now_s);
    void lead_to(const Goal& goal, const std::string& first, double now_s);
    void lead_by_ear(const Goal& goal, const std::string& first, double now_s);
    void cross_lines(const Goal& goal, double now_s);
    void toggle_lines(double now_s);
    void face_route(double now_s);
    void go_on(const std::string& first, double now_s);
    bool next_stop(const std::string& words, double now_s);

    Rooms& rooms_;
    Doors& doors_;
    std::optional<Goal> goal_;
    PlannedStops planned_;
    Laps laps_;
    std::optional<double> help_limit_;
    RoutePlans plans_;
    DirectionsGround ground_;
    Arrival arrival_;
    SpokenRoute ear_;
    HandLead hand_;
    Seek seek_;
};

}  // namespace handrail::core
