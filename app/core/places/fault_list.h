// What should be mended in the world one is in (worlds/check), as a list: from one fault to the next, to its place, and
// mended there where a name, a landmark, a door or a unit is all that is missing. Found in the background; what is
// mended is kept in the side file, and doors that were made can be taken away again in the list. App thread only.
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

namespace handrail {

class FaultList : SessionPart {
public:
    FaultList(const SessionContext& context, WorldState& world, Rooms& rooms);

    // Lays the landmarks that the person has marked upon it.
    void enter_world();
    // Says which of these could not be read.
    void tell_unreadable(double now_s) const;
    // The landmarks have been changed in their file.
    void take_again();
    // Opens the list, now or once the faults are found; says why not.
    void open(double now_s);
    void tick(double now_s);
    // The list is not on its way.
    bool idle() const { return !looking_.busy(); }

    std::function<void(const Goal& goal, double now_s)> on_find;  // set by the session

private:
    struct Found {
        std::shared_ptr<const Scene> scene;  // as its file has it, with the landmarks of now
        std::vector<WorldFault> faults;
        std::vector<std::vector<MissingDoor>> doors;    // of each fault: where a door would mend it
        std::vector<std::optional<MadeDoor>> doorways;  // and which door, cut free, one could pass
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
    BackgroundTask<std::shared_ptr<const Found>> looking_{context_.executor, "faults"};
};

}  // namespace handrail
