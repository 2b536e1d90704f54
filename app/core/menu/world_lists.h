// The worlds one can go to, as lists: those visited before, those that come with the program, those of any folder. App
// thread only.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "app/core/context/session_part.h"
#include "app/core/kept/world_shelf.h"

namespace handrail {

class WorldLists : SessionPart {
public:
    explicit WorldLists(const SessionContext& context) : SessionPart(context) {}

    void offer(WorldShelf shelf) { shelf_ = std::move(shelf); }
    void open(double now_s);
    // Says so, and asks the owner to read and enter it.
    void go_to(const std::filesystem::path& file);
    // The file of that name, without what follows the dot, among those that come with the program.
    std::optional<std::filesystem::path> bundled(std::string_view stem) const;

private:
    void open_folder(const std::filesystem::path& typed, double now_s);

    WorldShelf shelf_;
};

}  // namespace handrail
