// Writes a building as a page: one HTML file that opens in any browser, with a session inside. Functions for the
// command line; app thread.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "worlds/base/result.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"

namespace handrail::program {

// Returns the core of pages, which ./run page builds and the package contains. It is an HTML file with marks such as
// @SCENE@ in place of the building. Fails with a sentence that names ./run page if there is no core.
Result<std::string> page_core();

// Returns the page of a building. `core` is the result of page_core(). Texts are in the language spoken now.
std::string page_of(std::string_view core, const Scene& scene, const navigation::RoomGraph& graph,
                    const navigation::WalkSpace& space);

// Returns the storeys, their rooms and what joins the rooms as HTML, for reading without scripts.
std::string plain_building(const Scene& scene, const navigation::RoomGraph& graph);

}  // namespace handrail::program
