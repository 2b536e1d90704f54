#include "app/core/learning/best_times.h"

#include <system_error>

#include "app/core/kept/side_file.h"
#include "app/core/learning/time_words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {

std::string BestTimes::finish(const std::string& world, double took_s) {
    contract_pre(took_s >= 0.0);
    // The folder must exist. Otherwise the side file would be saved in another folder.
    std::error_code reported_when_saving;
    if (!folder_.empty()) std::filesystem::create_directories(folder_, reported_when_saving);
    SideFile times = folder_.empty() ? SideFile() : SideFile::of_world(folder_ / game_, folder_);
    SideEntry best = times.table("best_seconds");
    std::string text;
    for (const std::string& news : times.news()) text += news + " ";
    const auto known = session_s_.find(world);
    const double before_s = !folder_.empty()            ? number_of(best, world, -1.0)
                            : known != session_s_.end() ? known->second
                                                        : -1.0;
    if (before_s >= 0.0 && took_s >= before_s) return text + phrase("hunt.best", {{"time", time_words(before_s)}});
    text += before_s < 0.0 ? phrase("hunt.first_time") : phrase("hunt.better", {{"time", time_words(before_s)}});
    session_s_[world] = took_s;
    best[world] = took_s;
    times.set_table("best_seconds", best);
    if (const auto saved = times.save(); !saved) text += " " + saved.error().sentence();
    return text;
}

}  // namespace handrail::core
