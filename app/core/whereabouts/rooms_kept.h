// Rooms and routes of worlds that are entered repeatedly, found only once, as for a lesson with several pupils. While
// such an object lives, a session on its thread takes the earlier result for the same scene, the same walker size and
// the language spoken; otherwise it leaves its own result here. A scene is recognised by its address, and kept as long
// as its result. Costs the memory of a WalkSpace for each stored world. Only the thread that made it uses it.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/scene/scene.h"

namespace handrail {

class RoomsKept {
public:
    struct Found {
        std::shared_ptr<const Scene> scene;
        WalkBody body;
        std::string language;  // of messages about it and of the rooms' names
        WalkSpace space;       // without its walls
        RoomGraph graph;
        std::vector<std::string> out_of_reach;
    };

    // Stores at most this many worlds, those found last.
    explicit RoomsKept(std::size_t most = 1) : most_(most), before_(now_) { now_ = this; }
    ~RoomsKept() { now_ = before_; }
    RoomsKept(const RoomsKept&) = delete;
    RoomsKept& operator=(const RoomsKept&) = delete;

    // The latest one of this thread; null: there is none.
    static RoomsKept* here() { return now_; }

    // Null: not found yet. Valid until the next keep().
    const Found* of(const std::shared_ptr<const Scene>& scene, const WalkBody& body) const;
    void keep(Found found);

private:
    static inline thread_local RoomsKept* now_ = nullptr;

    std::size_t most_;
    RoomsKept* before_;
    std::deque<Found> found_;  // latest last
};

}  // namespace handrail
