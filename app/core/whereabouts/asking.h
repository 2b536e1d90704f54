// What the person asks of the place: where am I, what is around, ahead, in one direction, under the hand; heading,
// place, scale. App thread only.
#pragma once

#include <span>
#include <string>

#include "app/core/context/session_context.h"
#include "app/core/whereabouts/rooms.h"
#include "app/core/world/questions.h"

namespace handrail {

class Asking {
public:
    Asking(const SessionContext& context, Rooms& rooms) : context_(context), rooms_(rooms) {}

    // The questions. False: it is another's.
    bool act(Command command, double now_s);
    // The answer to "where am I" without the room.
    std::string where_am_i() const;

private:
    bool answer(Command command, double now_s);
    Telling telling() const;
    Asker asker() const;
    std::string state_of(const Sight& sight) const;
    std::string tell_sight(const Sight& sight) const;
    std::string tell_sights(std::span<const Sight> sights) const;
    std::string around_me() const;
    std::string ahead_of_me() const;
    void look_round(int by, double now_s);
    std::string heading_words() const;
    std::string coordinates() const;
    std::string scale_bar() const;
    void describe_touched(double now_s);
    std::string touched_words(const ToolState& tool);

    const SessionContext& context_;
    Rooms& rooms_;
    LookRound look_round_;
    FeatureId described_ = kNoFeature, left_described_ = kNoFeature;  // what "what is this" last told of
};

}  // namespace handrail
