// Rooms and ways of worlds that are entered again and again, found once: of a lesson and each of its pupils. While one
// lives, a session on its thread takes what was found of the same scene for a body of the same size in the language
// spoken, and else leaves here what it finds. A scene is told by its place, and kept as long as what was found of it.
// Costs what a WalkSpace does, for each of so many worlds. The thread that made it.
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
        std::string language;  // of what is said about it and of the rooms' names
        WalkSpace space;       // without its walls
        RoomGraph graph;
        std::vector<std::string> out_of_reach;
    };

    // Of so many worlds at most, those that were found last.
    explicit RoomsKept(std::size_t most = 1) : most_(most), before_(now_) { now_ = this; }
    ~RoomsKept() { now_ = before_; }
    RoomsKept(const RoomsKept&) = delete;
    RoomsKept& operator=(const RoomsKept&) = delete;

    // The one of this thread, made last; null: there is none.
    static RoomsKept* here() { return now_; }

    // Null: it was not found yet. Good until the next keep().
    const Found* of(const std::shared_ptr<const Scene>& scene, const WalkBody& body) const;
    void keep(Found found);

private:
    static inline thread_local RoomsKept* now_ = nullptr;

    std::size_t most_;
    RoomsKept* before_;
    std::deque<Found> found_;  // the latest last
};

}  // namespace handrail
