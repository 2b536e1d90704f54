// Learning a place: notes what hand and walker touch and walk on, and announces how much of a room is known and what is
// left. In the guided mode it leads from wall to wall and from lane to lane. App thread only; learning.h does the
// measuring.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/core/context/session_part.h"
#include "app/core/learning/learning_state.h"
#include "app/core/learning/relations.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class PlaceLearning : SessionPart {
public:
    PlaceLearning(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    void enter_world(double now_s);
    // Announces what is remembered of this world, or why it cannot be read. Call it after the world has been announced.
    void tell_kept(double now_s);
    // Another session has saved more about the same world.
    void take_again();
    // Writes new progress to the additions if the person wants it to be remembered.
    void keep(double now_s);
    // Handles Unexplored, ProgressReport, LearnPlace and LearntRooms. Returns false for other commands.
    bool act(Command command, double now_s);
    // Call it once a tick. Notes the places of hand and walker. bumped and trailed: normals of the wall that the walker
    // bumped into and of the wall that it follows.
    void note(const std::optional<Vec3>& bumped, const std::optional<Vec3>& trailed, double now_s);
    // In the guided mode, announces what is complete.
    void tick(double now_s);
    // How much of the present room is known, or why that is unavailable.
    std::string progress_words(double now_s);

    // Progress in a room of the graph; only valid once the rooms are found.
    Progress progress_in(std::uint32_t room) { return progress_of(learnt_of(room)); }

    // Set by the session; called if the person has chosen a room to go to, with its number in the room graph.
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

}  // namespace handrail::core
