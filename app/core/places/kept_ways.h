// Ways that a person keeps in a world under a name: keeping the one that was planned or walked, and what can be done
// with a kept one. Going along one is another's affair. App thread only; ways.h says how they are kept.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/ways.h"
#include "app/core/wayfinding/stops.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

class KeptWays : SessionPart {
public:
    KeptWays(const SessionContext& context, Rooms& rooms, const PlannedStops& planned);

    // Those of the world that was entered; says what of their file cannot be read.
    void enter_world(double now_s);
    // They have been changed in their file.
    void take_again();
    // Ways and KeepWay. False: it is another's.
    bool act(Command command, double now_s);
    // Once the rooms are known: which ones no longer fit the world.
    void tell_unfit(double now_s);
    // The stops in the room of that name know it by the new one from here on; saved by whoever renamed it. `before`
    // empty: it had none that files know it by.
    void follow_room_name(const std::string& before, const std::string& name);

    // The way planned and the ways walked, and then those that were kept, the last one first: as they are told.
    struct Offer {
        std::string name, value;
        std::vector<Stop> stops;
    };
    std::vector<Offer> offers() const;

    // Set by the session: the person wants to go along these stops, led by the hand or told by ear.
    std::function<void(const std::vector<Stop>& stops, bool by_hand, double now_s)> on_go;

private:
    FoundWay look_at(const SavedWay& way) const;
    std::string fault_words_of(const FoundWay& found) const;
    bool save(double now_s);
    void save_and_answer(const std::string& words, double now_s);
    // "Way Hall to Kitchen kept", if it is.
    void save_and_answer_kept(const std::string& name, double now_s);
    std::vector<Offer> untold_offers() const;
    void open_keep(double now_s);
    bool name_taken(const std::string& name, std::size_t except) const;
    void ask_name(const std::vector<Stop>& stops, double now_s);
    std::optional<std::string> free_name(const std::string& typed, std::size_t except, double now_s) const;
    void open_all(double now_s);
    void open(std::size_t which, double now_s);
    void add_ways_to_go(ListSpec& list, std::vector<std::function<void()>>& acts, const std::string& name,
                        const std::vector<Stop>& stops);
    void open_backwards(std::size_t which, double now_s);
    void open_add_stop(std::size_t which, double now_s);
    void add_stop(std::size_t which, Stop stop, double now_s);
    void take_over(std::size_t which, double now_s);
    void ask_new_name(std::size_t which, double now_s);
    void remove(std::size_t which, double now_s);

    Rooms& rooms_;
    const PlannedStops& planned_;
    std::vector<SavedWay> ways_;
    std::optional<Vec3> begins_m_;  // where the person said that a way begins
};

}  // namespace handrail
