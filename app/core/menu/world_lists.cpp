#include "app/core/menu/world_lists.h"

#include <algorithm>
#include <cstdlib>

#include "worlds/base/language.h"

namespace handrail::core {

void WorldLists::go_to(const std::filesystem::path& file) {
    context_.requests.world = WorldRequest{file};
    context_.answer(phrase("menu.going_to", {{"world", name_of_file(file)}}), context_.tick_s);
}

std::optional<std::filesystem::path> WorldLists::bundled(std::string_view stem) const {
    for (const ShelvedWorld& world : worlds_in(shelf_.bundled))
        if (world.file.stem() == stem) return world.file;
    return std::nullopt;
}

void WorldLists::open(double now_s) {
    ListSpec list;
    list.title = phrase("menu.worlds");
    list.stays_open = true;
    std::vector<std::filesystem::path> files;
    const auto add = [&](const std::filesystem::path& file, std::string_view where) {
        if (std::find(files.begin(), files.end(), file) != files.end()) return;
        list.items.push_back({name_of_file(file), std::string(where), false});
        files.push_back(file);
    };
    for (const std::filesystem::path& file : shelf_.recent) add(file, phrase("menu.visited_before"));
    for (const ShelvedWorld& world : worlds_in(shelf_.bundled)) add(world.file, phrase("menu.bundled"));
    list.items.push_back({phrase("menu.another_world"), {}, false});
    list.chosen = [this, files](std::size_t i) {
        if (i < files.size()) {
            context_.lists.dialogue.close_all();
            return go_to(files[i]);
        }
        TextSpec question;
        question.question = phrase("menu.which_file");
        question.done = [this](const std::string& path) { open_folder(path, context_.tick_s); };
        context_.request_text(std::move(question), context_.tick_s);
    };
    context_.open_list(std::move(list), now_s);
}

void WorldLists::open_folder(const std::filesystem::path& typed, double now_s) {
    std::filesystem::path path = typed;
    const char* home = std::getenv("HOME");
    if (const std::string text = typed.string(); home && (text == "~" || text.starts_with("~/")))
        path = std::filesystem::path(home) / text.substr(std::min<std::size_t>(2, text.size()));
    std::error_code ec;
    if (std::filesystem::is_regular_file(path, ec)) {
        context_.lists.dialogue.close_all();
        return go_to(path);
    }
    const std::vector<ShelvedWorld> worlds = worlds_in(path);
    if (worlds.empty()) {
        context_.play(cues::SoundKind::Denied, now_s);
        return context_.answer(phrase("menu.no_world_at", {{"path", path.string()}}), now_s);
    }
    ListSpec list;
    list.title = name_of_file(path);
    std::vector<std::filesystem::path> files;
    for (const ShelvedWorld& world : worlds) {
        list.items.push_back({world.name, {}, false});
        files.push_back(world.file);
    }
    list.chosen = [this, files](std::size_t i) { go_to(files[i]); };
    context_.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
