// Lets a person set questions at places of the world, and asks them in a quiz: the walker is put at each place in turn,
// and the person types an answer. questions.h defines how questions are stored. Use this class on the app thread only.
#pragma once

#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/kept/questions.h"

namespace handrail::core {

class Quiz : SessionPart {
public:
    explicit Quiz(const SessionContext& context) : SessionPart(context) {}

    // Carries out the commands AskHere and Quiz. Returns false for other commands.
    bool act(Command command, double now_s);

private:
    // A quiz that is being asked.
    struct Round {
        std::vector<PlaceQuestion> questions;
        std::size_t at = 0, right = 0;
        // Where the person was before, and is put again afterwards.
        Vec3 feet_m{0.0};
        double heading_rad = 0.0;
    };
    void ask_here(double now_s);
    void request_answer(const PlaceQuestion& question, double now_s);
    void begin(double now_s);
    void pose(Round round, const std::string& before, double now_s);
    void end(const Round& round, const std::string& before, double now_s);
};

}  // namespace handrail::core
