// Turns a building described in English or German sentences into a Scene. Any thread.
#pragma once

#include "worlds/floorplan/plan_scene.h"

namespace handrail::words {

// The same bytes always give the same Scene. A sentence that is not understood, or a thing that cannot be placed, gives
// a warning with its line and the assumption made. Fails with one sentence if the text names no room or is too large.
Result<Scene> read_words_building(std::string_view bytes, const std::string& file_name,
                                  const floorplan::PlanOptions& options);

}  // namespace handrail::words
