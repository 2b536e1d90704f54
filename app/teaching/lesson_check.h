// Connects a lesson with a session, and runs the scripted pupils of a lesson in a session without a user interface.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/scenario/scenario_run.h"
#include "app/teaching/teaching_run.h"

namespace handrail::core {
class Session;
}

namespace handrail::teaching {

// One turn of a lesson: it sees what has happened since the last turn, and its wishes reach the session. Call it
// between two ticks of the session; ten times a second is enough. `speaking`: the voice is speaking.
void teach_on(TeachingRun& run, core::Session& app, std::span<const core::SessionEvent> events, double now_s,
              bool speaking = false);

// Begins a run for a session, with the session's settings and keys.
TeachingRun begin_lesson(const std::shared_ptr<TaughtWorld>& world, std::size_t session, const LearnerName& learner,
                         const core::Session& app);

struct PupilOutcome {
    std::string name;
    std::vector<std::string> failures;  // sentences with file and line
    std::vector<TaskResult> results;
    std::vector<core::LoggedLine> lines;
    double seconds = 0.0;  // in virtual time
};
// Fails only where the script asks for something impossible. read, rooms_kept: as of run_scenario.
Result<PupilOutcome> run_pupil(const std::shared_ptr<TaughtWorld>& world, const LessonPupil& pupil,
                               cues::AudioSink& audio, cues::SpeechSink& speech, const core::WorldReader& read,
                               core::RoomsKept* rooms_kept = nullptr);

// The protocol of a lesson for a learner, to be written down in advance: sessions, steps in their order, help in each
// lap, and blocked doors.
std::string protocol_of(const LessonFile& lesson, const LearnerName& learner);

}  // namespace handrail::teaching
