// Collects the requests of a session to its owner, which is the program, a scenario or a test. Each request waits until
// the owner fetches it. Plain state for the app thread only.
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
    // Returns the world that the owner has to read and enter, if the session requested one.
    std::optional<WorldRequest> take_world() { return std::exchange(world, std::nullopt); }
    // take_read_again() returns true once if the owner must read the present world again because a person has corrected
    // it. The session then continues at the same place. take_begin_anew() returns true once if every part of that world
    // has moved, so that the session must start again.
    bool take_read_again() { return std::exchange(read_again, false); }
    bool take_begin_anew() { return std::exchange(begin_anew, false); }
    // Returns the place at which the session wants to continue, if there is one. If another world is open, the owner
    // first reads the world of that place.
    std::optional<LastPlace> take_last_place() { return std::exchange(last_place, std::nullopt); }

    std::optional<std::size_t> take_lesson() { return std::exchange(lesson, std::nullopt); }
    // take_learners() returns true once after each request for the list of learners. The owner answers with
    // TeacherActed::Kind::Learners. take_learner() returns the learner to switch to, if the person chose one.
    bool take_learners() { return std::exchange(learners, false); }
    std::optional<std::size_t> take_learner() { return std::exchange(learner, std::nullopt); }
    std::optional<LessonDraft> take_lesson_draft() { return std::exchange(lesson_draft, std::nullopt); }

    bool read_again = false, begin_anew = false;
    bool set_up = false, first_set_up = false, offered_hand = false, devices = false;
    std::optional<WorldRequest> world;
    std::optional<LastPlace> last_place;
    std::optional<LessonDraft> lesson_draft;  // a draft that the owner has to write to a file
    std::optional<std::size_t> lesson;        // number of the offered lesson that the person wants to begin
    std::optional<std::size_t> learner;       // number of the listed learner to switch to
    bool learners = false;
    bool leave = false;  // the person wants to end the session
};

}  // namespace handrail::core
