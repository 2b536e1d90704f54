// Makes the instructor's summary of the lesson so far. See teaching_run.h.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/teaching/run_words.h"
#include "app/teaching/teaching_run.h"

namespace handrail::teaching {
namespace {

constexpr double kWindow_s = 100.0;  // the current strategy is that of the samples in the last time of this length

}  // namespace

std::vector<results::WalkSample> TeachingRun::last_samples() const {
    const auto from = std::partition_point(whole_.samples.begin(), whole_.samples.end(),
                                           [&](const results::WalkSample& s) { return s.t_s < now_s_ - kWindow_s; });
    return {from, whole_.samples.end()};
}

double TeachingRun::share_of(results::Strategy strategy) const {
    const auto windows = results::strategy_windows(whole_.samples, world_->base().stand_m);
    std::size_t all = 0, such = 0;
    for (const results::StrategyWindow& window : windows)
        if (window.kind != results::Strategy::None) ++all, such += window.kind == strategy ? 1U : 0U;
    return all == 0 ? 0.0 : static_cast<double>(such) / static_cast<double>(all);
}

std::string TeachingRun::summary() const {
    std::string words = view_.room.empty() ? std::string() : phrase("teaching.sum_room", {{"room", view_.room}});
    if (view_.walls > 0)
        words = one_after(words, phrase("teaching.sum_walls", {{"done", view_.walls_done}, {"count", view_.walls}}));
    words = one_after(words, phrase("teaching.sum_contacts", {{"count", results::contact_episodes(whole_.touches)}}));
    words = one_after(words, whole_.helped_s
                                 ? phrase("teaching.sum_help",
                                          {{"seconds", static_cast<int>(std::lround(now_s_ - *whole_.helped_s))}})
                                 : phrase("teaching.sum_no_help"));
    const auto windows = results::strategy_windows(last_samples(), world_->base().stand_m);
    if (!windows.empty()) {
        constexpr std::array<const char*, results::kStrategies> kKeys{"",       "perimeter", "grid",
                                                                      "object", "base",      "mixed"};
        const char* key = kKeys.at(static_cast<std::size_t>(windows.back().kind));
        if (*key) words = one_after(words, phrase(std::string("report.strategy_") + key) + ".");
    }
    return words;
}

}  // namespace handrail::teaching
