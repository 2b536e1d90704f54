#include "app/core/menu/report_lists.h"

#include "app/core/context/context_words.h"
#include "worlds/base/language.h"

namespace handrail::core {

void ReportLists::request_devices(double now_s) {
    context_.requests.devices = true;
    requested_s_ = now_s;
    context_.answer(phrase("devices.looking"), now_s);
}

void ReportLists::open_devices(const std::vector<std::string>& sentences, double now_s) {
    std::vector<std::string> lines{phrase("devices.in_use", {{"hand", hand_words(context_.hands)}})};
    lines.insert(lines.end(), sentences.begin(), sentences.end());
    requested_s_ = -1e9;
    open(phrase("devices.title"), lines, now_s);
}

void ReportLists::open_crash(double now_s) { open(phrase("crash_report.title"), crash_, now_s); }

void ReportLists::open_settings_faults(double now_s) { open(phrase("menu.settings_faults"), faults_, now_s); }

void ReportLists::open(std::string title, const std::vector<std::string>& lines, double now_s) {
    ListSpec list;
    list.title = std::move(title);
    list.stays_open = true;
    for (const std::string& line : lines)
        list.items.push_back({line.ends_with('.') ? line.substr(0, line.size() - 1) : line, {}, false});
    list.chosen = [this, lines](std::size_t i) { context_.answer(lines[i], context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
