// Learning a place: notes what hand and body touch and walk, tells how much of a room is known by that and what is
// left, and in its mode leads from wall to wall and from lane to lane. App thread only; learning.h does the measuring.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/learning/learning_state.h"
#include "app/core/learning/relations.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

class PlaceLearning : SessionPart {
public:
    PlaceLearning(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world(double now_s);
    // What is remembered of this world, or why that cannot be read; once it has been told of.
    void tell_kept(double now_s);
    // Another session has kept something more of the same world.
    void take_again();
    // Writes what was learnt to the additions where the person wants to be remembered and something has changed.
    void keep(double now_s);
    // Unexplored, ProgressReport, LearnPlace and LearntRooms. False: it is another's.
    bool act(Command command, double now_s);
    // Once a tick: where hand and body are by now, and of the body the normals of what it has bumped into and of the
    // wall that it is led along.
    void note(const std::optional<Vec3>& bumped, const std::optional<Vec3>& trailed, double now_s);
    // In the mode: tells what is done by now.
    void tick(double now_s);
    // How much of the room that one is in is known by now, or why that cannot be told.
    std::string progress_words(double now_s);

    // What is known by now of a room of the graph; the rooms are found.
    Progress progress_in(std::uint32_t room) { return progress_of(learnt_of(room)); }

    // Set by the session: the person has chosen a room to go to, by its number in the room graph.
    std::function<void(std::uint32_t room, double now_s)> on_go_to_room;

private:
    void corner_of_hand(double now_s);
    void spend_time();
    RoomLearning& room(std::uint32_t number);
    void take_kept();
    void back_at_base(double now_s);
    bool at_base(const RoomLearning& room) const;
    std::string to_base_words(const RoomLearning& room) const;
    bool ask_relations(double now_s);
    void ask_relation(std::vector<RelationQuestion> questions, std::size_t at, int right, double now_s);
    const Learnt& learnt_of(std::uint32_t number);
    bool in_known_room(double now_s);
    std::string no_room_words() const;
    std::string share_words(const Progress& progress) const;
    void tell_unexplored(double now_s);
    void list_rooms(double now_s);
    void toggle(double now_s);
    void guide(double now_s);

    Rooms& rooms_;
    LearningState state_;
};

}  // namespace handrail
