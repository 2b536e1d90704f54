// Lists the faults that somebody should correct in the present world (worlds/check), each with its place. The person
// can add a missing name, landmark, door or unit there. A background task searches for the faults. Corrections are
// stored in the side file, and the list can remove added doors again. Use this class on the app thread only.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/whereabouts/rooms.h"
#include "worlds/base/background_task.h"
#include "worlds/check/faults.h"
#include "worlds/check/missing_doors.h"

namespace handrail::core {

class FaultList : SessionPart {
public:
    FaultList(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world() { looking_.give_up(); }
    // Opens the list now, or later when the faults have been found. If that is impossible, announces why.
    void open(double now_s);
    void tick(double now_s);
    // Returns true if no list is being prepared.
    bool idle() const { return !looking_.busy(); }

    // The session sets these functions. on_find finds a place or goes to it; on_landmark marks a thing as a landmark.
    std::function<void(const Goal& goal, double now_s)> on_find;
    std::function<void(FeatureId thing, double now_s)> on_landmark;

private:
    struct Found {
        std::shared_ptr<const Scene> scene;  // the world of the file with the present landmarks
        std::vector<check::WorldFault> faults;
        std::vector<std::vector<check::MissingDoor>> doors;  // for each fault: the places where a door would correct it
        std::vector<std::optional<MadeDoor>> doorways;  // for each fault: the door to cut so that a walker can pass
    };
    void show(const std::shared_ptr<const Found>& found, double now_s);
    void show_one(const std::shared_ptr<const Found>& found, std::size_t which, double now_s);
    void show_made_door(const MadeDoor& door, double now_s);
    void make_door(const MadeDoor& door, double now_s);
    void take_door_away(const MadeDoor& door, double now_s);
    void take_unit(double metres, double now_s);

    Rooms& rooms_;
    BackgroundTask<std::shared_ptr<const Found>> looking_{context_.executor, "faults", context_.arrivals};
};

}  // namespace handrail::core
