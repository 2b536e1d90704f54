// The hand is led: a pull along a way, lines along one or through a thing, grooves while nothing else acts. What the
// servo is told of it, when it has ended and how; what follows then is for Guide to decide. Hand and world metres. App
// thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/core/context/session_part.h"
#include "app/core/movers/doors.h"
#include "app/core/wayfinding/floor_grooves.h"
#include "app/core/wayfinding/way_plans.h"
#include "haptic/servo/guidance.h"

namespace handrail {

class HandLead : SessionPart {
public:
    static constexpr std::size_t kMostLinePoints = GuidancePath::kMostPoints / 2 + 1;

    HandLead(const SessionContext& context, Rooms& rooms, WayPlans& plans, Doors& doors)
        : SessionPart(context), plans_(plans), doors_(doors), grooves_(context, rooms, plans) {}

    void enter_world();
    // A hand that is only simulated for want of a device is led by ear.
    bool may_lead() const;
    // A sentence; empty: it may act.
    std::string why_no_force() const;
    bool force_may_act() const { return why_no_force().empty(); }
    // It leads, is about to, or does again when all is at rest.
    bool at_work() const { return led_.acts || led_.announced || led_.left; }
    // Lines act, or have been told.
    bool lines_at_work() const;

    // Each says the words, and acts a second later.
    void pull(const WayForHand& way, double strength, std::string words, double now_s);
    void lines(const WayForHand& way, std::string words, double now_s);
    void cross_lines(const Vec3& at_m, std::string words, double now_s);
    // Nothing pulls any more; what is felt fades.
    void end();

    // ---- every tick ----
    // Who walks, turns or moves the workspace has not pulled the hand out of the lead: true once all is at rest, when a
    // new way to `goal` is to be told.
    bool wants_new_way(const std::optional<Goal>& goal, double now_s);
    // How often the hand went off the way in this lap; a new way goes on with it.
    int errors() const { return led_.errors; }
    void count_errors_from(int errors) { led_.errors = errors; }
    struct Arrival {
        bool by_pull = false;     // and not by lines
        bool to_nearest = false;  // of what cannot be reached
    };
    // The hand has come to the end of the way. Of another end it says itself what there is to say.
    std::optional<Arrival> tick(const std::optional<Goal>& goal, double now_s);

    // Where the way leads out of the hand's reach the workspace goes on along it, as under the keys that push it: hand
    // metres a second, device frame.
    Vec3 carry();
    // It has, since this was last asked.
    bool take_carried() { return std::exchange(led_.carried, led_.carries); }
    // The person moves the workspace by keys.
    void person_moved(double now_s) { led_.moved_s = now_s; }

    const GuidancePath& path() const { return led_.path; }  // as the servo has it

private:
    void announce(GuidancePath path, std::string words, double now_s);
    bool hand_at(const std::optional<Goal>& goal) const;
    std::string no_longer_words() const;
    void publish(GuidancePath path);
    void go_on_along(GuidancePath path);
    void watch_way(const std::optional<Goal>& goal, double now_s);
    void lay_lines(const Goal& goal, double now_s);
    void watch_lines(const std::optional<Goal>& goal, double now_s);
    void lay_grooves(double now_s);

    WayPlans& plans_;
    Doors& doors_;
    FloorGrooves grooves_;
    std::uint32_t last_number_ = 0;  // of any path of any world: the servo knows it
    struct Led {
        GuidancePath path;                      // as the servo has it
        std::optional<GuidancePath> announced;  // to be published at starts_s
        double starts_s = 0.0;
        bool acts = false;        // published, and the servo has not told of its end
        bool stray = false;       // the hand is off the way now
        int errors = 0;           // how often it went off the way in this lap
        bool to_nearest = false;  // the way ends where one gets nearest to the goal
        // Leaving the way otherwise than by pulling the hand out of it.
        std::uint32_t jump = 0;                   // of the workspace, when the way was planned
        Vec3 feet_before_m{0.0};                  // a tick before
        double moved_s = -1e9;                    // when the person last walked or moved the workspace
        double off_since_s = -1e9;                // the hand has been far off the way since then
        std::shared_ptr<const Scene> planned_in;  // as the world was then
        bool left = false;                        // the way is to be planned anew when all is at rest
        double lines_laid_s = -1e9;               // along the way
        bool carries = false;                     // the workspace goes along with the hand now
        bool carried = false;                     // and has, since that was last looked at
    } led_;
};

}  // namespace handrail
