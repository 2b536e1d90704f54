// Searches for the rooms and routes of the present world in a background task, so that entering a world does not wait.
// The session owns this object and uses it on the app thread only.
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
    // `keeper` returns what was stored for this scene and size of the walker. After ready(), it stores a new result.
    // Without a `keeper`, `shared` returns and stores the result, unless it is null. `arrivals` decides when ready()
    // returns true. If `arrivals` is null, that is as soon as the search is done.
    RoomsOfWorld(std::shared_ptr<const Scene> scene, const navigation::WalkerMeasures& body, const Executor& executor,
                 RoutesKeeper keeper = {}, RoomsKept* shared = nullptr, Arrivals* arrivals = nullptr);
    ~RoomsOfWorld();  // gives up an unfinished search, and waits for its end
    RoomsOfWorld(const RoomsOfWorld&) = delete;
    RoomsOfWorld& operator=(const RoomsOfWorld&) = delete;

    // Returns true once the search is done, with or without success. The other functions are valid only after that.
    bool ready();
    bool found() const { return navigation_ != nullptr; }
    bool kept() const { return kept_; }  // returns true if the result was stored earlier, so that there was no search
    // Returns the reason why there are no rooms, as a sentence, or an empty text if there are rooms.
    const std::string& problem() const { return problem_; }
    // Ends the search. Call it if the result is not needed any more. After that, ready() may never return true.
    void give_up() { stop_.request_stop(); }
    // Returns the result of unreachable_rooms().
    const std::vector<std::string>& out_of_reach() const { return out_of_reach_; }
    // Returns the scene from the constructor.
    const std::shared_ptr<const Scene>& scene() const { return scene_; }
    navigation::Navigation& navigation() { return *navigation_; }
    // Returns the navigation for background tasks that may still plan routes while another world is entered.
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
