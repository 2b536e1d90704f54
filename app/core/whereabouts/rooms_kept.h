// Rooms and routes of worlds that are entered again and again, found once: those of a lesson and each of its pupils. A
// session that gets one takes what was found of the same scene, for a body of the same size, in the spoken language;
// otherwise it leaves here what it finds. Scenes are compared by address, and kept as long as what was found of them.
// Costs as much memory as a WalkSpace for each world. Owned by whoever enters the worlds; one thread.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

class RoomsKept {
public:
    struct Found {
        std::shared_ptr<const Scene> scene;
        navigation::WalkerMeasures body;
        std::string language;         // of messages about it and of the rooms' names
        navigation::WalkSpace space;  // without its walls
        navigation::RoomGraph graph;
        std::vector<std::string> out_of_reach;
    };

    // Keeps at most this many worlds, those that were found last.
    explicit RoomsKept(std::size_t most = 1) : most_(most) {}
    RoomsKept(const RoomsKept&) = delete;
    RoomsKept& operator=(const RoomsKept&) = delete;

    // Null: not found yet. Valid until the next keep().
    const Found* of(const std::shared_ptr<const Scene>& scene, const navigation::WalkerMeasures& body) const;
    void keep(Found found);

private:
    std::size_t most_;
    std::deque<Found> found_;  // the latest last
};

}  // namespace handrail::core
