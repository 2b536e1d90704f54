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
    // Returns true once after each request for the set-up by voice.
    bool take_set_up() { return std::exchange(set_up, false); }
    // Returns true once after each request for the short set-up of the first minutes, which covers only headphones and
    // hand. The owner reports when it has ended or the person has left it.
    bool take_first_set_up() { return std::exchange(first_set_up, false); }
    // Returns true once after the person pressed the force key to use the device that was offered last.
    bool take_offered_hand() { return std::exchange(offered_hand, false); }
    // Returns true once after each request for the list of plugged-in devices. The owner answers with DevicesFound.
    bool take_devices() { return std::exchange(devices, false); }
    // Returns the world that the owner has to read and enter, if one was requested.
    std::optional<WorldRequest> take_world() { return std::exchange(world, std::nullopt); }
    // The first returns true once if the present world must be read again, because a person has corrected it. The
    // session then continues at the same place. The second is true if no part of the world is where it was, so the
    // session must start again.
    bool take_read_again() { return std::exchange(read_again, false); }
    bool take_begin_anew() { return std::exchange(begin_anew, false); }
    // Returns the place at which to continue, if that was requested. The owner reads its world if another one is open.
    std::optional<LastPlace> take_last_place() { return std::exchange(last_place, std::nullopt); }

    std::optional<std::size_t> take_lesson() { return std::exchange(lesson, std::nullopt); }
    // The first returns true once after each request for the list of learners, which the owner answers with
    // TeacherActed::Kind::Learners. The second returns the learner to switch to, if one was chosen.
    bool take_learners() { return std::exchange(learners, false); }
    std::optional<std::size_t> take_learner() { return std::exchange(learner, std::nullopt); }
    std::optional<LessonDraft> take_lesson_draft() { return std::exchange(lesson_draft, std::nullopt); }

    bool read_again = false, begin_anew = false;
    bool set_up = false, first_set_up = false, offered_hand = false, devices = false;
    std::optional<WorldRequest> world;
    std::optional<LastPlace> last_place;
    std::optional<LessonDraft> lesson_draft;  // a draft that the owner has to write to a file
    std::optional<std::size_t> lesson;        // number of the offered lesson to begin
    std::optional<std::size_t> learner;       // number of the listed learner to switch to
    bool learners = false;
    bool leave = false;  // the person wants to end the session
};

}  // namespace handrail::core
