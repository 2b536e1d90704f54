// Helps the person to learn a place. The class notes what hand and walker touch and walk on, and announces how much of
// a room is known and what is left. The guided mode leads the person from wall to wall and from lane to lane.
// learning.h does the measuring. Use the class on the app thread only.
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
    // Sets the day for the diary, such as "2026-12-01"; empty: not known.
    void set_day(std::string day) { day_ = std::move(day); }

    void enter_world(double now_s);
    // Announces the stored progress in this world, or why it cannot be read. Call it after the world has been
    // announced.
    void announce_kept(double now_s);
    // Reads the stored progress again. Call it when another session has saved more progress in the same world.
    void take_again();
    // Writes new progress to the side file, if the person wants progress to be remembered.
    void keep(double now_s);
    // Carries out the commands Unexplored, ProgressReport, LearnPlace, LearntRooms and Diary. Returns false for other
    // commands.
    bool act(Command command, double now_s);
    // Notes the positions of hand and walker. Call it once a tick. `bumped` is the normal of the wall that the walker
    // bumped into. `trailed` is the normal of the wall that the walker follows.
    void note(const std::optional<Vec3>& bumped, const std::optional<Vec3>& trailed, double now_s);
    // In the guided mode, announces the walls and lanes that are complete.
    void tick(double now_s);
    // Returns how much of the present room is known, or why the progress is not available.
    std::string progress_words(double now_s);

    bool guides() const { return state_.on; }  // returns true while the command LearnPlace leads through a room
    // Returns the progress in a room of the room graph. Valid only once the rooms have been found.
    Progress progress_in(std::uint32_t room) { return progress_of(learnt_of(room)); }

    // The session sets this function. It is called when the person has chosen a room to go to, with the number of the
    // room in the room graph.
    std::function<void(std::uint32_t room, double now_s)> on_go_to_room;

private:
    void corner_of_hand(double now_s);
    void spend_time();
    RoomLearning& room(std::uint32_t number);
    void take_kept();
    void back_at_base(double now_s);
    bool at_base(const RoomLearning& room) const;
    std::string to_base_words(const RoomLearning& room) const;
    bool pose_relation_questions(double now_s);
    void pose_relation_question(std::vector<RelationQuestion> questions, std::size_t at, int right, double now_s);
    const Learnt& learnt_of(std::uint32_t number);
    bool in_known_room(double now_s);
    std::string no_room_words() const;
    std::string share_words(const Progress& progress) const;
    void announce_unexplored(double now_s);
    void list_rooms(double now_s);
    std::vector<DiaryEntry> diary();
    void list_diary(double now_s);
    void toggle(double now_s);
    void guide(double now_s);

    Rooms& rooms_;
    LearningState state_;
    std::string day_;
};

}  // namespace handrail::core
