#include "app/page/page_session.h"

#include <nlohmann/json.hpp>

#include "app/core/dialogue/command.h"
#include "app/core/dialogue/command_words.h"
#include "app/core/world/walker.h"
#include "worlds/navigation/reach.h"
#include "worlds/stored/stored_navigation.h"

namespace handrail::page {
namespace {

using nlohmann::json;

// Puts the rooms that came with the world where the session looks for them.
void keep_rooms(core::RoomsKept& kept, const std::shared_ptr<const Scene>& scene, std::string_view packed) {
    const core::WalkerSize size = core::walker_size(*scene, settings::Settings{}.walk.body_radius_m);
    const auto body = navigation::walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m);
    auto found = stored::navigation_from(stored::unpacked_navigation(packed), body, *scene);
    if (!found) return;
    std::vector<std::string> out_of_reach = navigation::unreachable_rooms(*scene, found->space, found->graph);
    kept.keep(
        {scene, body, spoken_language(), std::move(found->space), std::move(found->graph), std::move(out_of_reach)});
}

// Invalid UTF-8 cannot be here, because readers and sessions make all texts valid; if it is, it is replaced.
std::string text_of(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

}  // namespace

Result<std::unique_ptr<PageSession>> PageSession::begin(std::string_view packed_scene, std::string_view navigation) {
    Result<Scene> read = stored::scene_from(packed_scene);
    if (!read) return tl::unexpected(read.error());
    const auto scene = std::make_shared<const Scene>(std::move(*read));
    std::unique_ptr<PageSession> made(new PageSession);
    keep_rooms(made->rooms_, scene, navigation);
    made->session_.app().apply(core::WorldEntered{core::make_ready(scene)}, 0.0);
    return made;
}

bool PageSession::advance(int ms) {
    for (int i = 0; i < ms; ++i) session_.advance();
    return !session_.lines().done() || !session_.app().idle();
}

std::string PageSession::take_said() {
    json said = json::array();
    for (const cues::Utterance& line : speech_.take())
        said.push_back({{"text", line.text}, {"urgent", line.speech_class <= cues::SpeechClass::Warning}});
    return text_of(said);
}

std::string PageSession::view() {
    const core::DialogueView shown = session_.app().dialogue().view();
    json items = json::array();
    for (const core::ListItem& item : shown.items)
        items.push_back({{"name", item.name}, {"value", item.value}, {"adjustable", item.adjustable}});
    constexpr const char* kKinds[] = {"none", "list", "text"};
    return text_of({{"kind", kKinds[static_cast<int>(shown.kind)]},
                    {"title", shown.title},
                    {"items", items},
                    {"at", shown.at},
                    {"text", shown.text}});
}

std::string commands_json() {
    json all = json::array();
    for (const core::CommandInfo& row : core::command_table())
        all.push_back({{"word", core::spoken_word(row.command)}, {"key", row.key}, {"help", row.help()}});
    return text_of(all);
}

}  // namespace handrail::page
