#include "app/main/kept_settings.h"

#include <fmt/ostream.h>

namespace handrail::program {

bool KeptSettings::take(const std::vector<std::pair<std::string, std::string>>& changes) {
    bool changed = false;
    for (const auto& [key, value] : changes)
        changed |= settings_.set(key, value, settings::SettingSource::Live).has_value();
    if (changed) save_.changed(clock_.now_s());
    return changed;
}

void KeptSettings::keep_saved(double now_s) {
    if (const auto written = writer_.take_result()) report_unsaved(*written, now_s);
    if (writer_.busy() || !save_.take_due(now_s)) return;
    auto wanted = settings_.to_save();
    if (!wanted) return report_unsaved(tl::unexpected(wanted.error()), now_s);
    if (*wanted) writer_.write(std::move((*wanted)->file), std::move((*wanted)->text));
    else report_unsaved({}, now_s);
}

void KeptSettings::report_unsaved(const Result<void>& saved, double now_s) {
    if (auto sentence = save_.ended(saved, now_s)) say_(std::move(*sentence), now_s);
}

void KeptSettings::save_at_the_end(std::ostream& err) {
    writer_.wait();
    if (const auto written = writer_.take_result(); written && !*written) save_.changed(clock_.now_s());
    if (!save_.unsaved()) return;
    const auto saved = settings_.save_user_file();
    if (saved) return;
    fmt::print(err, "{}\n", saved.error().sentence());
    say_(saved.error().sentence());
}

}  // namespace handrail::program
