// Runs a scenario in a headless session. The command `handrail scenario` and tests use it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/core/scenario/read_request.h"
#include "app/core/scenario/scenario.h"
#include "app/core/scenario/session_log.h"
#include "audio-cues/plan/sinks.h"

namespace handrail::core {

class HeadlessSession;
class RoomsKept;

// Runs a scenario in its world from start to end, and returns a log of the session. Fails only if the scenario
// requires something impossible, such as an unknown device or setting.
// - `read` reads models, and the worlds that are entered later.
// - `each_ms` is called before each millisecond.
// - `undone` receives the file lines of actions that could not be done and were skipped. If it is null, the first
//   such action is an error.
// - `rooms_kept` has the same meaning as in SessionOptions.
Result<SessionLog> run_scenario(const Scenario& scenario, const std::shared_ptr<const Scene>& scene,
                                cues::AudioSink& audio, cues::SpeechSink& speech, const WorldReader& read,
                                const std::function<void(HeadlessSession&)>& each_ms = {},
                                std::vector<int>* undone = nullptr, RoomsKept* rooms_kept = nullptr);

}  // namespace handrail::core
