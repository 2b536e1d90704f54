#include "app/core/menu/understood_list.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/honest_report.h"

namespace handrail::core {
namespace {

// Removes the full stop, because items of a list have none.
std::string without_stop(std::string sentence) {
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

}  // namespace

void open_understood(const SessionContext& context, std::function<void(const Goal& goal, double now_s)> on_choose,
                     double now_s) {
    contract_pre(context.world.scene != nullptr);
    const Scene& scene = *context.world.scene;
    ListSpec list;
    list.title = phrase("honest.title");
    std::vector<std::optional<Goal>> goals;
    const auto add = [&](std::string name, std::string value = {}, std::optional<Goal> goal = std::nullopt) {
        list.items.push_back({without_stop(std::move(name)), std::move(value)});
        goals.push_back(std::move(goal));
    };
    if (scene.stated) {
        const HonestReport report = honest_report(scene);
        HonestReport counts = report;
        counts.check.clear();  // The loop below makes an item from each of these sentences.
        add(honest_sentence(scene, counts));
        for (const CheckPoint& point : report.check) {
            const std::string what = sentence_case(check_words(scene, point));
            add(what, where_words(context, point_box(point.at_m)), Goal{what, point_box(point.at_m)});
        }
        for (const std::string& sentence : honest_details(scene, report)) add(sentence);
    } else {
        add(phrase("honest.nothing_stated"));
    }
    add(honest_counts(scene.report));
    list.stays_open = true;  // The list stays open, so that the person can go from one place to the next.
    list.chosen = [goals, on_choose = std::move(on_choose), &context, items = list.items](std::size_t i) {
        if (goals[i]) on_choose(*goals[i], context.tick_s);
        else context.answer(items[i].name, context.tick_s);
    };
    context.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
