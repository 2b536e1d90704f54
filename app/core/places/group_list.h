// Lists the groups that the author of a world made in an editor. The person can hide a group from touch and give it one
// material. kept_groups.h defines how that is stored. Use this class on the app thread only.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/kept_groups.h"

namespace handrail::core {

class GroupList : SessionPart {
public:
    GroupList(const SessionContext& context, WorldState& world) : SessionPart(context), world_(world) {}

    // Reads the changes of groups from the side file and puts them on the scene.
    void enter_world();
    // Announces the stored changes that could not be read.
    void announce_unreadable(double now_s) const;
    // Reads the changes again. Call it when another session has changed them in the side file.
    void take_again();
    // Carries out the command Groups. Returns false for other commands.
    bool act(Command command, double now_s);

    // The session sets this function. It is called when the hand must feel the changed scene.
    std::function<void(double now_s)> on_felt;

private:
    GroupChange change_of(const std::string& name) const;
    void open(double now_s);
    void open_one(const std::string& name, double now_s);
    void open_materials(GroupChange change, double now_s);
    void put(const GroupChange& change, const std::string& words, double now_s);

    WorldState& world_;
    std::vector<Error> unreadable_;
};

}  // namespace handrail::core
