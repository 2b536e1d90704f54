// Makes a report from a recording and its world: measures, strategies, contacts, the walked path and the course of the
// session. Any thread may call it. It takes about as long as finding the rooms of the world.
#pragma once

#include <memory>

#include "app/learners/kept_results.h"
#include "app/record/recorded_events.h"
#include "app/report/report_page.h"

namespace handrail::core {
class RoomsKept;
}

namespace handrail::program {

// Fails with a sentence if the rooms of the world cannot be found. `scene` is the scene of events.world. `rooms_kept`
// contains the rooms found for other reports on the same world; it may be null.
Result<report::SessionReport> report_of(const record::Recording& recording, const record::RecordedEvents& events,
                                        const std::shared_ptr<const Scene>& scene,
                                        core::RoomsKept* rooms_kept = nullptr);

// Makes the report of a session of which only the results were stored. The report contains the tasks, but neither path
// nor course.
report::SessionReport report_of(const learners::KeptResults& results);

}  // namespace handrail::program
