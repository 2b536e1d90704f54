// Answers questions about the walker's place: where it is, what is around, ahead, in one direction or under the hand.
// It also answers questions about the heading, the coordinates and the scale. Use it on the app thread only.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/rooms.h"
#include "app/core/world/questions.h"

namespace handrail::core {

class Queries : SessionPart {
public:
    static constexpr std::size_t kMostWords = 25;

    Queries(const SessionContext& context, Rooms& rooms) : SessionPart(context), rooms_(rooms) {}

    // Carries out the commands that ask such questions. Returns false for other commands.
    bool act(Command command, double now_s);
    // Answers "where am I" with place, direction, exits, and what is ahead. At the default verbosity, the answer has at
    // most `most_words` words. From verbosity 3 on, nothing is left out.
    std::string where_am_i(std::size_t most_words = kMostWords) const;
    // Returns the thing that the person asked about last, under the hand or ahead, or kNoFeature. Each thing is
    // returned only once.
    FeatureId take_queried_thing() { return std::exchange(queried_thing_, kNoFeature); }
    // Returns what is on one side of the person, counted in quarter circles clockwise from straight ahead, 0 to 3.
    std::string side_sentence(int quarter) const;
    // Returns the present state of a thing that moves, such as "shut" or "moved"; empty if the thing has no state.
    std::string state_of(FeatureId thing) const;
    // Returns what where_am_i() leaves out: the other sides and what else is near.
    std::string what_else() const;

private:
    bool answer(Command command, double now_s);
    DescriptionStyle style() const;
    Viewpoint viewpoint() const;
    std::string state_of(const Sight& sight) const;
    std::string describe_sight(const Sight& sight) const;
    std::string place_and_heading() const;
    std::uint32_t room_here() const;
    std::string where_words_now(double now_s);
    std::string describe_there(std::span<const Sight> sights) const;
    std::vector<std::string> ways_out() const;
    std::string describe_sights(std::span<const Sight> sights) const;
    std::string around_me() const;
    std::string ahead_of_me();
    void look_round(int by, double now_s);
    std::string heading_words() const;
    std::string coordinates() const;
    std::string scale_bar() const;
    void describe_touched(double now_s);
    std::string touched_words(const servo::ToolState& tool);

    Rooms& rooms_;
    FeatureId queried_thing_ = kNoFeature;
    LookRound look_round_;
    struct Stood {
        Vec3 feet_m{0.0};
        double heading_rad = 0.0;
    };
    std::optional<Stood> queried_at_;  // where the person last got the short answer to "where am I"
    // The things that "what is this" described last, for the right or only hand and the left hand.
    FeatureId described_ = kNoFeature, left_described_ = kNoFeature;
};

}  // namespace handrail::core
