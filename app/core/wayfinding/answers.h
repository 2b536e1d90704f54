// Answers typed questions about the building in one sentence each: where a thing is, how far, how many rooms, what is
// above, and so on (dialogue/question.h). Lengths are in world metres. Use it on the app thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/question.h"
#include "app/core/wayfinding/find_list.h"
#include "app/core/wayfinding/guide.h"
#include "app/core/whereabouts/queries.h"

namespace handrail::core {

class Answers : SessionPart {
public:
    Answers(const SessionContext& context, Rooms& rooms, Queries& queries, Guide& guide)
        : SessionPart(context), rooms_(rooms), queries_(queries), guide_(guide) {}

    // Returns true if the line contains a question that this class answers. Needs no rooms.
    bool knows(std::string_view line) const;
    // Answers the question in the line. If the question needs the rooms and they are not known yet, announces that
    // instead, and Rooms::take_refused() returns true. The line must be one for which knows() returns true.
    void answer(std::string_view line, double now_s);
    // Returns a sentence with questions that would have worked, if the line contains a name of this world; empty
    // otherwise.
    std::string hint(std::string_view line) const;

    // The session sets this function. It returns true while the person is guided through learning a room.
    std::function<bool()> learns;

private:
    // A room or a thing that a question may name.
    struct Named {
        NameInWorld is;
        std::uint32_t room = navigation::kNothing;  // set if the name is that of a room
        std::optional<Goal> goal;                   // set otherwise
    };
    std::vector<Named> named() const;
    std::optional<std::string> words(const Question& question, const Named* named, double now_s);
    std::optional<std::string> end_learning(double now_s);
    std::string place_of(const Named& named) const;
    std::string place_of_room(std::uint32_t room) const;
    std::string room_of_thing(const Named& named) const;
    std::string size_of(std::uint32_t room) const;
    std::string state_of_door(FeatureId door) const;
    std::string door_nearby(const Named* named) const;
    std::string nearest(CommonNoun noun) const;
    std::string how_many(CommonNoun noun) const;
    std::string all_rooms() const;
    std::string storey_beside(int by) const;
    std::string over(const Named* named, int by) const;
    std::string own_storey() const;
    std::string own_part() const;
    void go_to(const Named& named, double now_s);
    std::optional<std::string> go_storey(int by, double now_s);
    std::uint32_t first_room_of(const std::vector<std::uint32_t>& among) const;
    std::optional<FeatureId> nearest_door() const;

    Rooms& rooms_;
    Queries& queries_;
    Guide& guide_;
};

}  // namespace handrail::core
