// The rooms and routes of the present world. A background task searches for them, so that entering a world does not
// wait. Owned by the session and used on the app thread only.
#pragma once

#include <atomic>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/core/kept/routes_keeper.h"
#include "worlds/base/arrivals.h"
#include "worlds/base/executor.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail::core {

class RoomsKept;

class RoomsOfWorld {
public:
    // `keeper` returns what was stored for this scene and size of the walker. After ready(), it stores a new result. If
    // there is no `keeper`, `shared` does both, unless it is null. `arrivals` decides when ready() returns true; null:
    // as soon as the search is done.
    RoomsOfWorld(std::shared_ptr<const Scene> scene, const navigation::WalkerMeasures& body, const Executor& executor,
                 RoutesKeeper keeper = {}, RoomsKept* shared = nullptr, Arrivals* arrivals = nullptr);
    ~RoomsOfWorld();  // gives up an unfinished search, and waits for its end
    RoomsOfWorld(const RoomsOfWorld&) = delete;
    RoomsOfWorld& operator=(const RoomsOfWorld&) = delete;

    // True once the search is done, with or without success. The other functions are valid only after that.
    bool ready();
    bool found() const { return navigation_ != nullptr; }
    bool kept() const { return kept_; }  // true: the result was stored earlier, so there was no search
    // The reason why there are no rooms, as a sentence; empty: there is no problem.
    const std::string& problem() const { return problem_; }
    // Call it if the result is not needed any more. ready() may then never return true.
    void give_up() { stop_.request_stop(); }
    // See unreachable_rooms().
    const std::vector<std::string>& out_of_reach() const { return out_of_reach_; }
    // Returns the scene from the constructor.
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    navigation::Navigation& navigation() { return *navigation_; }
    // For background tasks that may still plan routes while another world is entered.
    std::shared_ptr<const navigation::Navigation> navigation_kept() const { return navigation_; }
    navigation::RoomGraph& graph() { return graph_; }

private:
    bool take_from(const RoomsKept& shared);
    void find(const std::stop_token& stop);
    void find_or_take(const std::string& key, const std::stop_token& stop);

    std::shared_ptr<const Scene> scene_;
    navigation::WalkerMeasures body_;
    bool kept_ = false;
    RoutesKeeper keeper_;
    Arrivals* arrivals_;
    std::shared_ptr<navigation::Navigation> navigation_;
    navigation::RoomGraph graph_;
    std::vector<std::string> out_of_reach_;
    std::string problem_;
    std::atomic<bool> done_{false};
    bool known_ = false;  // true: the session knows that the search is done
    std::stop_source stop_;
    std::thread worker_;
};

}  // namespace handrail::core
