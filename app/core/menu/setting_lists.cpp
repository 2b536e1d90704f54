#include "app/core/menu/setting_lists.h"

#include "settings/adjust.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {

namespace {

// Changes the setting. Returns the new value in words, or why the value was refused.
std::string change_setting(const SessionContext& context, std::string_view key, const std::string& value) {
    const auto set = context.session_requests.set(key, value, context.tick_s);
    return set ? settings::setting_line(key, context.settings).value : set.error().message;
}

void open_settings(const SessionContext& context, std::string_view topic, double now_s) {
    ListSpec list;
    list.title = phrase("menu.settings_of", {{"topic", sentence_case(settings::topic_name(topic))}});
    list.stays_open = true;
    std::vector<std::string_view> keys;
    for (const settings::SettingLine& line : settings::setting_lines(topic, context.settings)) {
        list.items.push_back({sentence_case(line.name), line.value, line.steps});
        keys.push_back(line.key);
    }
    list.adjusted = [&context, keys](std::size_t i, int by) { return step_setting(context, keys[i], by); };
    list.chosen = [&context, keys, topic](std::size_t i) {
        const settings::SettingLine line = settings::setting_line(keys[i], context.settings);
        TextSpec question;
        question.question =
            phrase("menu.setting_question", {{"meaning", line.meaning}, {"value", line.value}, {"range", line.range}});
        question.done = [&context, topic, key = keys[i]](const std::string& typed) {
            const std::string value = change_setting(context, key, typed);
            std::vector<ListItem> items;
            for (const settings::SettingLine& now : settings::setting_lines(topic, context.settings))
                items.push_back({sentence_case(now.name), now.value, now.steps});
            context.lists.dialogue.change_items(std::move(items));
            context.answer(value, context.tick_s);
        };
        context.request_text(std::move(question), context.tick_s);
    };
    context.open_list(std::move(list), now_s);
}

}  // namespace

std::string step_setting(const SessionContext& context, std::string_view key, int by) {
    return change_setting(context, key, settings::stepped(key, context.settings, by));
}

void open_setting_topics(const SessionContext& context, double now_s) {
    ListSpec list;
    list.title = phrase("menu.settings");
    list.stays_open = true;
    const std::vector<std::string_view> topics = settings::setting_topics();
    for (const std::string_view topic : topics)
        list.items.push_back({sentence_case(settings::topic_name(topic)), {}, false});
    list.chosen = [&context, topics](std::size_t i) { open_settings(context, topics[i], context.tick_s); };
    context.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
