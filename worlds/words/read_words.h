// Turns a building described in English or German sentences into a Scene. Any thread may call this.
#pragma once

#include "worlds/floorplan/plan_scene.h"

namespace handrail::words {

// Reads a room description. The same bytes always give the same Scene. If a sentence is not understood, or a thing
// cannot be placed, a warning gives the line and the assumption that was made. Fails with one sentence if the text
// describes no room or is too large.
Result<Scene> read_words_building(std::string_view bytes, const std::string& file_name,
                                  const floorplan::PlanOptions& options);

}  // namespace handrail::words
