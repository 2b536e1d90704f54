// Lists the worlds to choose from: the worlds visited before, the worlds that come with the program, and the worlds in
// any folder. Use it on the app thread only.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "app/core/context/session_part.h"
#include "app/core/kept/world_shelf.h"

namespace handrail::core {

class WorldLists : SessionPart {
public:
    explicit WorldLists(const SessionContext& context) : SessionPart(context) {}

    void offer(WorldShelf shelf) { shelf_ = std::move(shelf); }
    void open(double now_s);
    // Announces the world, and requests that the owner read and enter it.
    void go_to(const std::filesystem::path& file);
    // Returns the file of the bundled world with the name `stem`, which has no extension.
    std::optional<std::filesystem::path> bundled(std::string_view stem) const;

private:
    void open_folder(const std::filesystem::path& typed, double now_s);

    WorldShelf shelf_;
};

}  // namespace handrail::core
