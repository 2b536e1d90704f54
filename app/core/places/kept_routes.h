// Manages the routes that a person has saved in a world under a name. The person can save the planned or the walked
// route, and a list offers what can be done with a saved route. Another class guides along a saved route.
// saved_routes.h defines how routes are stored. Use this class on the app thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/saved_routes.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class KeptRoutes : SessionPart {
public:
    KeptRoutes(const SessionContext& context, Rooms& rooms, const PlannedStops& planned);

    // Reads the saved routes of the world that was entered, and announces the entries that cannot be read.
    void enter_world(double now_s);
    // Reads the saved routes again. Call it when another session has changed them in the side file.
    void take_again();
    // Carries out the commands KeptRoutes and KeepRoute. Returns false for other commands.
    bool act(Command command, double now_s);
    // Announces which routes no longer fit the world. Call it once the rooms are known.
    void announce_unfit(double now_s);
    // Call it when a room was renamed. Stops in that room then refer to the new name. `before` is empty if the room had
    // no stored name. The caller saves the side file.
    void follow_room_name(const std::string& before, const std::string& name);

    // A route that the person can choose, with its spoken name. offers() lists the planned route first, then the walked
    // routes, then the saved ones, the latest first.
    struct Offer {
        std::string name, value;
        std::vector<Stop> stops;
    };
    std::vector<Offer> offers() const;

    // The session sets this function. It is called when the person wants to follow these stops, guided by the hand or
    // by ear.
    std::function<void(const std::vector<Stop>& stops, bool by_hand, double now_s)> on_go;

private:
    FoundRoute look_at(const SavedRoute& way) const;
    std::string fault_words_of(const FoundRoute& found) const;
    bool save(double now_s);
    void save_and_answer(const std::string& words, double now_s);
    // Saves, and answers "Way Hall to Kitchen kept" if saving succeeded.
    void save_and_answer_kept(const std::string& name, double now_s);
    std::vector<Offer> unannounced_offers() const;
    void open_keep(double now_s);
    bool name_taken(const std::string& name, std::size_t except) const;
    void request_name(const std::vector<Stop>& stops, double now_s);
    std::optional<std::string> free_name(const std::string& typed, std::size_t except, double now_s) const;
    void open_all(double now_s);
    void open(std::size_t which, double now_s);
    void add_routes_to_go(ListSpec& list, std::vector<std::function<void()>>& acts, const std::string& name,
                          const std::vector<Stop>& stops);
    void open_backwards(std::size_t which, double now_s);
    void open_add_stop(std::size_t which, double now_s);
    void add_stop(std::size_t which, Stop stop, double now_s);
    void take_over(std::size_t which, double now_s);
    void request_new_name(std::size_t which, double now_s);
    void remove(std::size_t which, double now_s);

    Rooms& rooms_;
    const PlannedStops& planned_;
    std::vector<SavedRoute> ways_;
    std::optional<Vec3> begins_m_;  // the place that the person has chosen as the beginning of a route
};

}  // namespace handrail::core
