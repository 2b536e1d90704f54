// A report made of a recording and the world it was made in: measures, strategies, contacts, the way and the course.
// Any thread; takes as long as finding the rooms of the world.
#pragma once

#include <memory>

#include "app/learners/kept_results.h"
#include "app/record/recorded_events.h"
#include "app/report/report_page.h"

namespace handrail {

// Fails with a sentence where the rooms of the world cannot be found. scene: that of events.world.
Result<SessionReport> report_of(const Recording& recording, const RecordedEvents& events,
                                const std::shared_ptr<const Scene>& scene);

// Of a session whose results alone were kept: its tasks, and neither way nor course.
SessionReport report_of(const KeptResults& results);

}  // namespace handrail
