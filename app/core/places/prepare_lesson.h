// Opens the list in which a teacher prepares a lesson: sets the base, chooses landmarks and a route, and saves the
// lesson. The draft is kept until another world is entered. Use it on the app thread only.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/lesson_draft.h"
#include "app/core/context/session_context.h"
#include "app/core/kept/saved_routes.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class PrepareLesson {
public:
    static constexpr std::size_t kMostLandmarks = 20;

    PrepareLesson(const SessionContext& context, Rooms& rooms) : context_(context), rooms_(rooms) {}
    PrepareLesson(const PrepareLesson&) = delete;  // not copyable, because open lists keep the address of this object
    PrepareLesson& operator=(const PrepareLesson&) = delete;

    void enter_world() { draft_ = {}, begun_ = false; }
    void open(double now_s) { open_at(0, now_s); }

    // A route that the teacher can choose, with its spoken name. The session sets `routes`, which returns the planned,
    // the walked and the saved routes.
    struct Offer {
        std::string name;
        std::vector<Stop> stops;
    };
    std::function<std::vector<Offer>()> routes;

private:
    void open_at(std::size_t at, double now_s);
    void base_here();
    void open_again(std::size_t at);  // closes the open lists and opens the list of this lesson again
    void open_landmarks(double now_s);
    void open_routes(double now_s);
    void save(double now_s);
    // Returns the names of the landmarks in the order in which the route from the base reaches them.
    std::vector<std::string> on_route(const std::vector<LessonDraft::Place>& requested) const;
    LessonDraft::Place place_of(const Stop& stop) const;

    const SessionContext& context_;
    Rooms& rooms_;
    LessonDraft draft_;
    std::string base_name_;  // name of the base's room, or of the ground outside; empty: none
    bool begun_ = false;
};

}  // namespace handrail::core
