// Connects a lesson with a session. Also runs a lesson with its scripted pupils, in a session without a user interface.
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

// Runs one turn of a lesson. Passes the events since the last turn to the lesson, and applies the lesson's acts to the
// session. Call it between two ticks of the session; ten times a second is enough. `speaking`: the voice is speaking.
void teach_on(TeachingRun& run, core::Session& app, std::span<const core::SessionEvent> events, double now_s,
              bool speaking = false);

// Begins a run of a lesson's session, with the settings and keys of `app`.
TeachingRun begin_lesson(const std::shared_ptr<TaughtWorld>& world, std::size_t session, const LearnerName& learner,
                         const core::Session& app);

struct PupilOutcome {
    std::string name;
    // One sentence with file and line for each expectation that the pupil did not meet.
    std::vector<std::string> failures;
    std::vector<TaskResult> results;
    std::vector<core::LoggedLine> lines;
    double seconds = 0.0;  // duration on the virtual clock
};
// Runs the pupil's script. Fails only if the script contains something impossible. `read` and `rooms_kept` are as for
// run_scenario.
Result<PupilOutcome> run_pupil(const std::shared_ptr<TaughtWorld>& world, const LessonPupil& pupil,
                               cues::AudioSink& audio, cues::SpeechSink& speech, const core::WorldReader& read,
                               core::RoomsKept* rooms_kept = nullptr);

// Returns the protocol of a lesson for a learner, which an instructor can print before the lesson: sessions, steps in
// their order, help in each lap, and blocked doors.
std::string protocol_of(const LessonFile& lesson, const LearnerName& learner);

}  // namespace handrail::teaching
