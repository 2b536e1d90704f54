// What should be corrected in the present world (worlds/check), as a list with the place of each fault. A missing name,
// landmark, door or unit can be added there. Faults are found in a background task. Corrections are stored in the side
// file, and the list can remove added doors again. App thread only.
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
    FaultList(const SessionContext& context, WorldState& world, Rooms& rooms);

    // Adds the landmarks that the person has marked to the world.
    void enter_world();
    // Announces which of these could not be read.
    void tell_unreadable(double now_s) const;
    // The landmarks have changed in their file.
    void take_again();
    // Opens the list, now or once the faults are found, or announces why it cannot.
    void open(double now_s);
    void tick(double now_s);
    // True if no list is being prepared.
    bool idle() const { return !looking_.busy(); }

    std::function<void(const Goal& goal, double now_s)> on_find;  // set by the session

private:
    struct Found {
        std::shared_ptr<const Scene> scene;  // as in its file, with the present landmarks
        std::vector<check::WorldFault> faults;
        std::vector<std::vector<check::MissingDoor>> doors;  // for each fault: where a door would correct it
        std::vector<std::optional<MadeDoor>> doorways;  // for each fault: the door that, once cut, a walker could pass
    };
    void show(const std::shared_ptr<const Found>& found, double now_s);
    void show_one(const std::shared_ptr<const Found>& found, std::size_t which, double now_s);
    void show_made_door(const MadeDoor& door, double now_s);
    void mark_landmark(FeatureId feature, double now_s);
    void make_door(const MadeDoor& door, double now_s);
    void take_door_away(const MadeDoor& door, double now_s);
    void take_unit(double metres, double now_s);

    WorldState& world_;
    Rooms& rooms_;
    std::vector<Error> unreadable_;
    BackgroundTask<std::shared_ptr<const Found>> looking_{context_.executor, "faults", context_.arrivals};
};

}  // namespace handrail::core
