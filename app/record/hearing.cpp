#include "app/record/hearing.h"

#include <algorithm>

#include "app/record/json_fields.h"

namespace handrail::record {
namespace {

std::optional<Hearing::Knock> knock_of(const RecordedLine& line) {
    const Json json = Json::parse(line.json, nullptr, false);
    try {
        return Hearing::Knock{vec_of(json.at("at_m")), json.at("force_mn").get<double>() * 1e-3};
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace

Hearing::Hearing(const Recording& recording, double speed)
    : recording_(recording), speed_(std::clamp(speed, kSlowest, kFastest)) {
    for (SaidLine& line : said_lines(recording)) events_.push_back({line.t_s, std::move(line), true, {}});
    for (const RecordedLine& line : recording.lines)
        if (line.is == "contact")
            if (const auto knock = knock_of(line)) events_.push_back({line.t_s, {}, false, *knock});
    std::stable_sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.t_s < b.t_s; });
    if (!recording.lines.empty()) length_s_ = recording.lines.back().t_s;
    if (!recording.frames.empty())
        length_s_ = std::max(length_s_, recording.frames.back().now_s - recording.head.begun_s);
    if (!events_.empty()) length_s_ = std::max(length_s_, events_.back().t_s);
}

Hearing::Heard Hearing::go_on(double dt_s, bool speaking) {
    Heard heard;
    if (stopped_) return heard;
    const double until_s = std::min(at_s_ + dt_s * speed_, length_s_);
    for (; next_ < events_.size() && events_[next_].t_s <= until_s; ++next_) {
        const Event& event = events_[next_];
        if (!event.is_line) {
            heard.knocks.push_back(event.knock);
        } else if (event.line.voiced && speaking) {
            at_s_ = std::max(at_s_, std::min(event.t_s, until_s));
            return heard;
        } else {
            heard.lines.push_back(event.line);
            speaking = speaking || event.line.voiced;
        }
    }
    at_s_ = until_s;
    return heard;
}

void Hearing::jump(double by_s) {
    at_s_ = std::clamp(at_s_ + by_s, 0.0, length_s_);
    const auto at = std::lower_bound(events_.begin(), events_.end(), at_s_,
                                     [](const Event& event, double t_s) { return event.t_s < t_s; });
    next_ = static_cast<std::size_t>(at - events_.begin());
}

const FrameRow* Hearing::place() const {
    const double now_s = at_s_ + recording_.head.begun_s;
    const auto after = std::upper_bound(recording_.frames.begin(), recording_.frames.end(), now_s,
                                        [](double t_s, const FrameRow& row) { return t_s < row.now_s; });
    return after == recording_.frames.begin() ? nullptr : &*(after - 1);
}

}  // namespace handrail::record
