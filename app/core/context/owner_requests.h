// What a session asks of whoever owns it (the program, a scenario, a test): each waits until the owner takes it. Plain
// state; app thread only.
#pragma once

#include <optional>
#include <utility>

#include "app/core/context/lesson_draft.h"
#include "app/core/kept/last_place.h"
#include "app/core/kept/world_request.h"

namespace handrail {

struct OwnerRequests {
    // The set-up by voice; once for each time it was asked for.
    bool take_set_up() { return std::exchange(set_up, false); }
    // That one of the first minutes: headphones and the hand only. The owner tells when it is over, or left.
    bool take_first_set_up() { return std::exchange(first_set_up, false); }
    // The hand that was offered last is wanted, by the force key.
    bool take_offered_hand() { return std::exchange(offered_hand, false); }
    // What is plugged in, to be answered by DevicesFound.
    bool take_devices() { return std::exchange(devices, false); }
    // To be read and entered.
    std::optional<WorldRequest> take_world() { return std::exchange(world, std::nullopt); }
    // The world one is in, which a person has mended: to be read again and gone on in at the same place, or begun anew
    // where no place in it is where it was.
    bool take_read_again() { return std::exchange(read_again, false); }
    bool take_begin_anew() { return std::exchange(begin_anew, false); }
    // To be gone on at: the owner reads that world where it is another one.
    std::optional<LastPlace> take_last_place() { return std::exchange(last_place, std::nullopt); }

    std::optional<std::size_t> take_lesson() { return std::exchange(lesson, std::nullopt); }
    // Who can be here, to be answered by TeacherActed::Kind::Learners; and who of those is to be here instead.
    bool take_learners() { return std::exchange(learners, false); }
    std::optional<std::size_t> take_learner() { return std::exchange(learner, std::nullopt); }
    std::optional<LessonDraft> take_lesson_draft() { return std::exchange(lesson_draft, std::nullopt); }

    bool read_again = false, begin_anew = false;
    bool set_up = false, first_set_up = false, offered_hand = false, devices = false;
    std::optional<WorldRequest> world;
    std::optional<LastPlace> last_place;
    std::optional<LessonDraft> lesson_draft;  // to be written
    std::optional<std::size_t> lesson;        // to be begun: of those that were offered, by number
    std::optional<std::size_t> learner;       // likewise: of those that were listed
    bool learners = false;
    bool leave = false;  // the session is to end
};

}  // namespace handrail
