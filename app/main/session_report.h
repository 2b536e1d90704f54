// Makes a report from a recording and the world in which it was made: measures, strategies, contacts, the walked path
// and the course of the session. Any thread; takes as long as finding the rooms of the world.
#pragma once

#include <memory>

#include "app/learners/kept_results.h"
#include "app/record/recorded_events.h"
#include "app/report/report_page.h"

namespace handrail {

// Fails with a sentence if the rooms of the world cannot be found. `scene` is that of events.world.
Result<SessionReport> report_of(const Recording& recording, const RecordedEvents& events,
                                const std::shared_ptr<const Scene>& scene);

// For a session of which only the results were kept: has its tasks, but neither path nor course.
SessionReport report_of(const KeptResults& results);

}  // namespace handrail
