// Guidance of the hand: a pull along a path, lines along a path or through a thing, and grooves while nothing else
// acts. This class decides what the servo gets, and notices when and how guidance ends; Guide decides what follows.
// Hand and world metres. App thread only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/core/context/session_part.h"
#include "app/core/movers/doors.h"
#include "app/core/wayfinding/floor_grooves.h"
#include "app/core/wayfinding/route_plans.h"
#include "haptic/servo/guidance.h"

namespace handrail::core {

class HandLead : SessionPart {
public:
    static constexpr std::size_t kMostLinePoints = servo::GuidancePath::kMostPoints / 2 + 1;

    HandLead(const SessionContext& context, Rooms& rooms, RoutePlans& plans, Doors& doors)
        : SessionPart(context), plans_(plans), doors_(doors), grooves_(context, rooms, plans) {}

    void enter_world();
    // False for a hand that is simulated for lack of a device: such a person is guided by ear.
    bool may_lead() const;
    // A sentence; empty: force may act.
    std::string why_no_force() const;
    bool force_may_act() const { return why_no_force().empty(); }
    // True while it guides, is about to, or will again when everything is at rest.
    bool at_work() const { return led_.acts || led_.announced || led_.left; }
    // True while lines act or have been announced.
    bool lines_at_work() const;

    // Each announces the words and begins to act a second later.
    void pull(const HandRoute& way, double strength, std::string words, double now_s);
    void lines(const HandRoute& way, std::string words, double now_s);
    void cross_lines(const Vec3& at_m, std::string words, double now_s);
    // Ends the pull; the force fades out.
    void end();

    // ---- every tick ----
    // A person who walks, turns or moves the workspace has not pulled the hand out of the guidance. Returns true once
    // everything is at rest and a new path to `goal` must be announced.
    bool wants_new_way(const std::optional<Goal>& goal, double now_s);
    // How often the hand left the path in this lap; a new path continues the count.
    int errors() const { return led_.errors; }
    void count_errors_from(int errors) { led_.errors = errors; }
    struct Arrival {
        bool by_pull = false;     // false: by lines
        bool to_nearest = false;  // the goal itself cannot be reached
    };
    // Returns a value if the hand has arrived at the end. Any other end is announced here.
    std::optional<Arrival> tick(const std::optional<Goal>& goal, double now_s);

    // If the path leads out of the hand's reach, the workspace moves along it, as with the keys that push it. Hand
    // metres a second, device frame.
    Vec3 carry();
    // True if the workspace has moved in this way since the last call.
    bool take_carried() { return std::exchange(led_.carried, led_.carries); }
    // The person moves the workspace by keys.
    void person_moved(double now_s) { led_.moved_s = now_s; }

    const servo::GuidancePath& path() const { return led_.path; }  // as the servo has it

private:
    void announce(servo::GuidancePath path, std::string words, double now_s);
    bool hand_at(const std::optional<Goal>& goal) const;
    std::string no_longer_words() const;
    void publish(servo::GuidancePath path);
    void go_on_along(servo::GuidancePath path);
    void watch_way(const std::optional<Goal>& goal, double now_s);
    void lay_lines(const Goal& goal, double now_s);
    void watch_lines(const std::optional<Goal>& goal, double now_s);
    void lay_grooves(double now_s);

    RoutePlans& plans_;
    Doors& doors_;
    FloorGrooves grooves_;
    std::uint32_t last_number_ = 0;  // of all paths in all worlds, because the servo recognises paths by it
    struct Led {
        servo::GuidancePath path;                      // as the servo has it
        std::optional<servo::GuidancePath> announced;  // becomes `path` at starts_s
        double starts_s = 0.0;
        bool acts = false;        // sent, and the servo has not reported its end
        bool stray = false;       // the hand is off the path now
        int errors = 0;           // how often the hand left the path in this lap
        bool to_nearest = false;  // the path ends at the nearest place that can be reached
        // Leaving the path in other ways than by pulling the hand out of it.
        std::uint32_t jump = 0;                   // of the workspace, when the path was planned
        Vec3 feet_before_m{0.0};                  // in the last tick
        double moved_s = -1e9;                    // when the person last walked or moved the workspace
        double off_since_s = -1e9;                // the hand has been far off the path since then
        std::shared_ptr<const Scene> planned_in;  // the scene at that time
        bool left = false;                        // plan again when everything is at rest
        double lines_laid_s = -1e9;               // when lines along the path were last set
        bool carries = false;                     // the workspace moves along with the hand now
        bool carried = false;                     // and has done so since the last check
    } led_;
};

}  // namespace handrail::core
