// Learning a place: notes what hand and body touch and walk, tells how much of a room is known by that and what is
// left, and in its mode leads from wall to wall and from lane to lane. App thread only; learning.h does the measuring.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/learning/learning_state.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

class PlaceLearning {
public:
    PlaceLearning(const SessionContext& context, Rooms& rooms) : context_(context), rooms_(rooms) {}
    PlaceLearning(const PlaceLearning&) = delete;  // open lists know it by its place
    PlaceLearning& operator=(const PlaceLearning&) = delete;

    void enter_world(double now_s);
    // Unexplored, ProgressReport, LearnPlace and LearntRooms. False: it is another's.
    bool act(Command command, double now_s);
    // Once a tick: where hand and body are by now, and of the body the normals of what it has bumped into and of the
    // wall that it is led along.
    void note(const std::optional<Vec3>& bumped, const std::optional<Vec3>& trailed, double now_s);
    // In the mode: tells what is done by now.
    void tick(double now_s);
    // How much of the room that one is in is known by now, or why that cannot be told.
    std::string progress_words(double now_s);

    // Set by the session: the person has chosen a room to go to, by its number in the room graph.
    std::function<void(std::uint32_t room, double now_s)> on_go_to_room;

private:
    void corner_of_hand(double now_s);
    void spend_time();
    const Learnt& learnt_of(std::uint32_t room);
    bool in_known_room(double now_s);
    std::string no_room_words() const;
    std::string share_words(const Progress& progress) const;
    void tell_unexplored(double now_s);
    void list_rooms(double now_s);
    void toggle(double now_s);
    void guide(double now_s);

    const SessionContext& context_;
    Rooms& rooms_;
    LearningState state_;
};

}  // namespace handrail
