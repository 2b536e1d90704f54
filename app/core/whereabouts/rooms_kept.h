// Keeps the rooms and routes of worlds that several sessions enter, so that they are searched for only once. An example
// is a lesson's world with the sessions of its pupils. A session with a RoomsKept uses the earlier result for the same
// scene, the same size of the walker and the spoken language. If there is none, the session stores its own result here.
// Scenes are compared by address and kept as long as their results. Each world costs the memory of one WalkSpace. The
// code that enters the worlds owns the object, and only one thread uses it.
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
        std::string language;         // language of the messages and of the rooms' names
        navigation::WalkSpace space;  // the walls of the space are not included
        navigation::RoomGraph graph;
        std::vector<std::string> out_of_reach;
    };

    // Keeps the results of at most `most` worlds. When there are more, the oldest results are dropped.
    explicit RoomsKept(std::size_t most = 1) : most_(most) {}
    RoomsKept(const RoomsKept&) = delete;
    RoomsKept& operator=(const RoomsKept&) = delete;

    // Returns the result for this scene and size of the walker, or null if there is none. The pointer is valid until
    // the next keep().
    const Found* of(const std::shared_ptr<const Scene>& scene, const navigation::WalkerMeasures& body) const;
    void keep(Found found);

private:
    std::size_t most_;
    std::deque<Found> found_;  // the latest result is last
};

}  // namespace handrail::core
