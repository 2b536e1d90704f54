// Plays a scenario in a headless session, for `handrail scenario` and for tests.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/core/scenario/read_request.h"
#include "app/core/scenario/scenario.h"
#include "app/core/scenario/session_log.h"
#include "audio-cues/plan/sinks.h"

namespace handrail {

class HeadlessSession;

// Runs a scenario in its world from start to end and logs what happens. Fails only if the scenario itself requests
// something impossible, such as an unknown device or setting. read: reads models and further worlds. each_ms: called
// before each millisecond. undone: receives the file lines of actions that were impossible and therefore skipped; null:
// the first of them fails.
Result<SessionLog> run_scenario(const Scenario& scenario, const std::shared_ptr<const Scene>& scene, AudioSink& audio,
                                SpeechSink& speech, const WorldReader& read,
                                const std::function<void(HeadlessSession&)>& each_ms = {},
                                std::vector<int>* undone = nullptr);

}  // namespace handrail
