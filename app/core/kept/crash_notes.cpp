#include "app/core/kept/crash_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {

void CrashNotes::note(std::string_view act, double now_s) {
    ++changes_;
    if (!acts_.empty() && acts_.back().word == act) {
        acts_.back().at_s = now_s;
        ++acts_.back().times;
        return;
    }
    acts_.push_back({std::string(act), now_s, 1});
    if (acts_.size() > kMost) acts_.pop_front();
}

std::string CrashNotes::text() const {
    std::string text;
    for (const std::string& line : lines_) text += line + "\n";
    if (acts_.empty()) return text + phrase("crash_report.no_acts") + "\n";
    text += phrase("crash_report.acts") + "\n";
    for (const Act& act : acts_)
        text += phrase("crash_report.act", {{"act", act.word},
                                            {"times", act.times},
                                            {"seconds", std::round(10.0 * (acts_.back().at_s - act.at_s)) / 10.0}}) +
                "\n";
    return text;
}

bool may_be_reported(std::string_view value, std::string_view range) {
    double number = 0.0;
    if (value == "true" || value == "false" || parse_finite(value, number)) return true;
    if (value.size() < 3 || value.front() != '"' || value.back() != '"') return false;
    const std::string_view word = value.substr(1, value.size() - 2);
    const auto of_word = [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; };
    if (!std::all_of(word.begin(), word.end(), of_word)) return false;
    const std::size_t at = range.find(word);
    if (at == std::string_view::npos) return false;
    const std::size_t end = at + word.size();
    return (at == 0 || !of_word(range[at - 1])) && (end == range.size() || !of_word(range[end]));
}

std::string spoken_end(int signal) {
    const char* how = signal == 0         ? "unseen"
                      : signal == SIGSEGV ? "memory"
                      : signal == SIGBUS  ? "memory"
                      : signal == SIGFPE  ? "number"
                      : signal == SIGILL  ? "instruction"
                      : signal == SIGABRT ? "gave_up"
                                          : "other";
    return phrase("crash_report.end", {{"how", how}, {"signal", signal}});
}

}  // namespace handrail::core
