// Requests of a session to its owner (the program, a scenario or a test). Each one waits until the owner takes it.
// Plain state; app thread only.
#pragma once

#include <optional>
#include <utility>

#include "app/core/context/lesson_draft.h"
#include "app/core/kept/last_place.h"
#include "app/core/kept/world_request.h"

namespace handrail::core {

struct OwnerRequests {
    // The set-up by voice was requested; true once for each request.
    bool take_set_up() { return std::exchange(set_up, false); }
    // The set-up of the first minutes was requested: only headphones and hand. The owner reports when it is over or was
    // left.
    bool take_first_set_up() { return std::exchange(first_set_up, false); }
    // The person wants the hand that was offered last, and pressed the force key.
    bool take_offered_hand() { return std::exchange(offered_hand, false); }
    // The list of plugged-in devices is wanted; the owner answers with DevicesFound.
    bool take_devices() { return std::exchange(devices, false); }
    // A world to read and enter.
    std::optional<WorldRequest> take_world() { return std::exchange(world, std::nullopt); }
    // A person has corrected the present world, so it must be read again. The session then continues at the same place,
    // or starts again if no place in it is where it was.
    bool take_read_again() { return std::exchange(read_again, false); }
    bool take_begin_anew() { return std::exchange(begin_anew, false); }
    // The place to continue at. The owner reads its world if that is another one.
    std::optional<LastPlace> take_last_place() { return std::exchange(last_place, std::nullopt); }

    std::optional<std::size_t> take_lesson() { return std::exchange(lesson, std::nullopt); }
    // The list of learners is wanted; the owner answers with TeacherActed::Kind::Learners. The second is the learner to
    // switch to.
    bool take_learners() { return std::exchange(learners, false); }
    std::optional<std::size_t> take_learner() { return std::exchange(learner, std::nullopt); }
    std::optional<LessonDraft> take_lesson_draft() { return std::exchange(lesson_draft, std::nullopt); }

    bool read_again = false, begin_anew = false;
    bool set_up = false, first_set_up = false, offered_hand = false, devices = false;
    std::optional<WorldRequest> world;
    std::optional<LastPlace> last_place;
    std::optional<LessonDraft> lesson_draft;  // to be written
    std::optional<std::size_t> lesson;        // number of the offered lesson to begin
    std::optional<std::size_t> learner;       // number of the listed learner to switch to
    bool learners = false;
    bool leave = false;  // the session is to end
};

}  // namespace handrail::core
