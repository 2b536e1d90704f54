// Guides the hand: by a pull along a path, by lines along a path or through a thing, and by grooves while nothing else
// acts. This class decides what the servo gets, and notices when and how the guidance ends. Guide decides what happens
// after that. Lengths are in hand and world metres. Use it on the app thread only.
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
    // Returns false if the hand is simulated because there is no device. A person without a device is guided by ear.
    bool may_lead() const;
    // Returns a sentence that says why there is no force, or an empty text if force may act.
    std::string why_no_force() const;
    bool force_may_act() const { return why_no_force().empty(); }
    // Returns true while a pull or lines act, are about to begin, or will begin again when everything is at rest.
    bool at_work() const { return led_.acts || led_.announced || led_.left; }
    // Returns true while lines act or have been announced.
    bool lines_at_work() const;

    // pull() and lines() announce `words`. The force of the guidance begins a second later.
    void pull(const HandRoute& way, double strength, std::string words, double now_s);
    void lines(const HandRoute& way, std::string words, double now_s);
    void cross_lines(const Vec3& at_m, std::string words, double now_s);
    // Ends the guidance. The force fades out.
    void end();

    // ---- every tick ----
    // Returns true once everything is at rest and a new path to `goal` must be planned and announced. If the person
    // walks, turns or moves the workspace, the hand has not left the guidance.
    bool wants_new_path(const std::optional<Goal>& goal, double now_s);
    // Returns how often the hand has left the path in this lap. The count continues on a new path.
    int errors() const { return led_.errors; }
    void count_errors_from(int errors) { led_.errors = errors; }
    struct Arrival {
        bool by_pull = false;  // true: the hand was guided by a pull; false: by lines
        // True: the path ended at the nearest place, because the goal itself cannot be reached.
        bool to_nearest = false;
    };
    // Returns a value if the hand has arrived at the end of the path. If the guidance ends in any other way, this
    // function announces that.
    std::optional<Arrival> tick(const std::optional<Goal>& goal, double now_s);

    // If the path leads out of the hand's reach, returns the velocity with which the workspace must move along the
    // path, as if keys pushed the workspace. The velocity is in hand metres a second in the device frame.
    Vec3 carry();
    // Returns true if the workspace has moved by carry() since the last call.
    bool take_carried() { return std::exchange(led_.carried, led_.carries); }
    // Call it when the person moves the workspace by keys.
    void person_moved(double now_s) { led_.moved_s = now_s; }

    const servo::GuidancePath& path() const { return led_.path; }  // returns the path that the servo has

private:
    void announce(servo::GuidancePath path, std::string words, double now_s);
    bool hand_at(const std::optional<Goal>& goal) const;
    std::string no_longer_words() const;
    void publish(servo::GuidancePath path);
    void go_on_along(servo::GuidancePath path);
    void watch_path(const std::optional<Goal>& goal, double now_s);
    void lay_lines(const Goal& goal, double now_s);
    void watch_lines(const std::optional<Goal>& goal, double now_s);
    void lay_grooves(double now_s);

    RoutePlans& plans_;
    Doors& doors_;
    FloorGrooves grooves_;
    // Number of the last path. The numbers continue from world to world, because the servo recognises a path by its
    // number.
    std::uint32_t last_number_ = 0;
    struct Led {
        servo::GuidancePath path;                      // the path that the servo has
        std::optional<servo::GuidancePath> announced;  // announced path, which replaces `path` at starts_s
        double starts_s = 0.0;
        bool acts = false;        // true: the path was sent, and the servo has not reported its end
        bool stray = false;       // true: the hand is off the path now
        int errors = 0;           // how often the hand left the path in this lap
        bool to_nearest = false;  // true: the path ends at the nearest place that can be reached
        // These fields show whether the hand left the path because of the workspace, the walker or a moved thing.
        std::uint32_t jump = 0;                   // number of the last jump of the workspace
        Vec3 feet_before_m{0.0};                  // position of the walker in the last tick
        double moved_s = -1e9;                    // when the person last walked or moved the workspace
        double off_since_s = -1e9;                // time since which the hand has been far from the path
        std::shared_ptr<const Scene> planned_in;  // the scene when the path was planned
        bool left = false;                        // true: a new path is planned when everything is at rest
        double lines_laid_s = -1e9;               // time when lines along the path were last set
        bool carries = false;                     // true: the workspace moves with the hand now
        bool carried = false;                     // true: the workspace has moved with the hand since the last check
    } led_;
};

}  // namespace handrail::core
