#include "app/core/kept/save_soon.h"

#include <utility>

namespace handrail::core {

void SaveSoon::changed(double now_s) {
    if (!due_s_ || *due_s_ > now_s + kAfter_s) due_s_ = now_s + kAfter_s;
}

bool SaveSoon::take_due(double now_s) {
    if (!due_s_ || now_s < *due_s_) return false;
    due_s_.reset();
    return true;
}

std::optional<std::string> SaveSoon::ended(const Result<void>& saved, double now_s) {
    if (saved) {
        reported_.clear();
        return std::nullopt;
    }
    if (!due_s_) due_s_ = now_s + kRetry_s;
    std::string sentence = saved.error().sentence();
    if (sentence == std::exchange(reported_, sentence)) return std::nullopt;
    return sentence;
}

}  // namespace handrail::core
