// Whoever teaches beside a session, and the scripted pupils of a lesson in a headless one.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/core/scenario/scenario_run.h"
#include "app/teaching/teaching_run.h"

namespace handrail {

class Session;

// What one turn of a lesson is: what has happened since the last one is seen, and what the lesson wishes reaches the
// session. Between two ticks of it; ten times a second is enough. speaking: somebody speaks.
void teach_on(TeachingRun& run, Session& app, std::span<const SessionEvent> events, double now_s,
              bool speaking = false);

// A run begun for a session with these settings and keys.
TeachingRun begin_lesson(const std::shared_ptr<TaughtWorld>& world, std::size_t session, const LearnerName& learner,
                         const Session& app);

struct PupilOutcome {
    std::string name;
    std::vector<std::string> failures;  // sentences with file and line
    std::vector<TaskResult> results;
    std::vector<LoggedLine> lines;
    double seconds = 0.0;  // of virtual time
};
// Fails only where the script asks for something impossible. read: as of run_scenario.
Result<PupilOutcome> run_pupil(const std::shared_ptr<TaughtWorld>& world, const LessonPupil& pupil, AudioSink& audio,
                               SpeechSink& speech, const WorldReader& read);

// The protocol of a lesson for a learner, as it is written down before: sessions, steps in their order, help of each
// lap, what is blocked.
std::string protocol_of(const LessonFile& lesson, const LearnerName& learner);

}  // namespace handrail
