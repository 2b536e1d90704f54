// Plays a scenario in a headless session, for `handrail scenario` and for tests.
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

// Runs a scenario in its world from start to end and keeps what happened. Fails only where the scenario itself asks for
// something impossible: an unknown device or setting. read: reads models, and further worlds that are entered. each_ms:
// by whoever goes along, before each millisecond. undone: takes the file lines of actions that could not be done, which
// are passed over; null: the first of them fails. rooms_kept: as of SessionOptions.
Result<SessionLog> run_scenario(const Scenario& scenario, const std::shared_ptr<const Scene>& scene,
                                cues::AudioSink& audio, cues::SpeechSink& speech, const WorldReader& read,
                                const std::function<void(HeadlessSession&)>& each_ms = {},
                                std::vector<int>* undone = nullptr, RoomsKept* rooms_kept = nullptr);

}  // namespace handrail::core
