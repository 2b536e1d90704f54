// Makes a report from a recording and the world in which it was made: measures, strategies, contacts, the walked path
// and the course of the session. Any thread; takes as long as finding the rooms of the world.
#pragma once

#include <memory>

#include "app/learners/kept_results.h"
#include "app/record/recorded_events.h"
#include "app/report/report_page.h"

namespace handrail::core {
class RoomsKept;
}

namespace handrail::program {

// Fails with a sentence where the rooms of the world cannot be found. scene: that of events.world. rooms_kept: of
// other reports in the same world; may be null.
Result<report::SessionReport> report_of(const record::Recording& recording, const record::RecordedEvents& events,
                                        const std::shared_ptr<const Scene>& scene,
                                        core::RoomsKept* rooms_kept = nullptr);

// For a session of which only the results were kept: has its tasks, but neither path nor course.
report::SessionReport report_of(const learners::KeptResults& results);

}  // namespace handrail::program
