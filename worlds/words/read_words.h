// A building described in words, English or German, as a Scene. Any thread.
#pragma once

#include "worlds/drawn/plan_scene.h"

namespace handrail {

// The same bytes give the same Scene. What is not understood or could not be placed is a warning with its line and what
// was assumed; fails with one sentence where the text names no room or is too large.
Result<Scene> read_words_building(std::string_view bytes, const std::string& file_name, const PlanOptions& options);

}  // namespace handrail
