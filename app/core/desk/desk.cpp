#include "app/core/desk/desk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace {

// Returns the value of a setting as a number, or 0 if the text is not a number.
double number(const std::string& text) {
    double value = 0.0;
    parse_finite(text, value);
    return value;
}

std::string percent(const std::string& value) {
    return phrase("desk.percent", {{"percent", std::lround(100.0 * number(value))}});
}
std::string words_per_minute(const std::string& value) {
    return phrase("desk.words_per_minute", {{"words", std::lround(number(value))}});
}
std::string level(const std::string& value) { return phrase("desk.level", {{"level", value}}); }
std::string on_off(const std::string& value) { return phrase(value == "true" ? "desk.on" : "desk.off"); }
std::string one_to(const std::string& value) { return phrase("desk.one_to", {{"scale", number(value)}}); }
std::string ceiling(const std::string& value) {
    if (value == "light") return phrase("desk.light", {{"newtons", settings::kLightCeiling_n}});
    if (value == "normal") return phrase("desk.normal", {{"newtons", settings::kNormalCeiling_n}});
    return phrase("desk.full");
}

std::vector<std::string> tenths(int from) {
    std::vector<std::string> values;
    for (int i = from; i <= 10; ++i) values.push_back(fmt::format("{}.{}", i / 10, i % 10));
    return values;
}

int nearest_position(const DeskSetting& row, double wanted) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(row.values.size()); ++i)
        if (std::abs(number(row.values[static_cast<std::size_t>(i)]) - wanted) <
            std::abs(number(row.values[static_cast<std::size_t>(best)]) - wanted))
            best = i;
    return best;
}

// Returns true if the values of this setting are words. Each setting has either only words or only numbers.
bool is_word(const DeskSetting& row) {
    return !row.values.front().empty() && std::isalpha(static_cast<unsigned char>(row.values.front().front())) != 0;
}

}  // namespace

std::span<const DeskSetting> desk_settings() {
    static const std::array rows{
        DeskSetting{"desk.sound_volume", DeskKind::Assign, "sound.volume", tenths(0), percent},
        DeskSetting{"desk.speech_volume", DeskKind::Assign, "sound.speech_volume", tenths(0), percent},
        DeskSetting{"desk.touch_volume", DeskKind::Assign, "sound.contact_volume", tenths(0), percent},
        DeskSetting{"desk.footstep_volume", DeskKind::Assign, "sound.footstep_volume", tenths(0), percent},
        DeskSetting{"desk.wall_tone_volume", DeskKind::Assign, "sound.wall_tone_volume", tenths(0), percent},
        DeskSetting{"desk.world_volume", DeskKind::Assign, "sound.world_volume", tenths(0), percent},
        DeskSetting{"desk.signal_volume", DeskKind::Assign, "sound.earcon_volume", tenths(0), percent},
        DeskSetting{"desk.speech_rate",
                    DeskKind::Slider,
                    "speech.rate_wpm",
                    {"100", "125", "150", "175", "200", "225", "250", "300", "350", "400", "450"},
                    words_per_minute},
        DeskSetting{
            "desk.scale", DeskKind::List, "workspace.scale", {"15.0", "30.0", "60.0", "120.0", "240.0"}, one_to},
        DeskSetting{"desk.amount", DeskKind::Slider, "speech.verbosity", {"0", "1", "2", "3", "4"}, level},
        DeskSetting{"desk.stiffness", DeskKind::Slider, "haptic.stiffness_fraction", tenths(2), percent},
        DeskSetting{"desk.ceiling", DeskKind::Slider, "haptic.ceiling", {"light", "normal", "full"}, ceiling},
        DeskSetting{"desk.pull", DeskKind::List, "guidance.pull", {"false", "true"}, on_off},
        DeskSetting{"desk.strength", DeskKind::Slider, "guidance.strength", tenths(1), percent},
        DeskSetting{"desk.grooves", DeskKind::List, "guidance.grooves", {"false", "true"}, on_off},
    };
    return rows;
}

int position_of(const DeskSetting& row, const std::string& value) {
    if (!is_word(row)) return nearest_position(row, number(value));
    const auto same = std::find(row.values.begin(), row.values.end(), value);
    return same == row.values.end() ? 0 : static_cast<int>(same - row.values.begin());
}

int beside(const DeskSetting& row, const std::string& value, int step) {
    const int at = position_of(row, value);
    if (is_word(row)) return at + step;
    const double off = number(value) - number(row.values[static_cast<std::size_t>(at)]);
    // If the value is between two positions, the nearest position may already be the next position in the wanted
    // direction. It is then the result.
    if (std::abs(off) < 1e-9 * std::max(1.0, std::abs(number(value))) || (off > 0.0) == (step > 0)) return at + step;
    return at;
}

DeskControl bound(const DeskSetting& row, std::function<std::string()> read,
                  std::function<void(const std::string&)> write) {
    DeskControl control;
    control.name = phrase(row.name);
    control.kind = row.kind;
    control.positions = static_cast<int>(row.values.size());
    control.position = [&row, read] { return position_of(row, read()); };
    control.beside = [&row, read](int step) { return beside(row, read(), step); };
    control.put = [&row, write = std::move(write)](int position) {
        write(row.values[static_cast<std::size_t>(position)]);
    };
    // For a numeric setting, screen readers show the value in the setting's own unit. A word has no number, so for
    // words they show the position.
    if (!is_word(row)) {
        control.number = [&row, read] {
            double step = number(row.values.back()) - number(row.values.front());
            for (std::size_t i = 1; i < row.values.size(); ++i)
                step = std::min(step, number(row.values[i]) - number(row.values[i - 1]));
            return ItemNumber{number(read()), number(row.values.front()), number(row.values.back()), step};
        };
        control.nearest = [&row](double wanted) { return nearest_position(row, wanted); };
    } else if (row.kind == DeskKind::Slider) {
        const int last = control.positions - 1;
        control.number = [&row, read, last] {
            return ItemNumber{static_cast<double>(position_of(row, read())), 0.0, static_cast<double>(last), 1.0};
        };
        control.nearest = [last](double wanted) {
            return static_cast<int>(std::lround(std::clamp(wanted, 0.0, static_cast<double>(last))));
        };
    }
    control.value = [&row, read = std::move(read)] { return row.words(read()); };
    return control;
}

std::optional<std::size_t> Desk::find(std::string_view name) const {
    const std::string wanted = lower_ascii(name);
    for (std::size_t i = 0; i < controls_.size(); ++i)
        if (lower_ascii(controls_[i].name) == wanted) return i;
    return std::nullopt;
}

std::size_t Desk::target(std::size_t control) const {
    contract_pre(control < controls_.size());
    return controls_[control].kind == DeskKind::Knob && on_knob_ ? *on_knob_ : control;
}

std::string Desk::value(std::size_t control) const {
    contract_pre(control < controls_.size());
    const DeskControl& own = controls_[control];
    if (own.kind == DeskKind::Knob)
        return on_knob_ ? fmt::format("{}, {}", value(*on_knob_), controls_[*on_knob_].name)
                        : phrase("desk.nothing_on_knob");
    return own.value ? own.value() : std::string();
}

std::string Desk::words(std::size_t control) const {
    contract_pre(control < controls_.size());
    const std::string now = value(control);
    return now.empty() ? controls_[control].name : fmt::format("{}, {}", controls_[control].name, now);
}

std::string Desk::put(std::size_t control, int position) {
    contract_pre(control < controls_.size());
    const DeskControl& own = controls_[target(control)];
    const int count = own.count();
    if (count == 0) return value(control);
    if (const int to = std::clamp(position, 0, count - 1); to != own.position() || own.beside) own.put(to);
    return value(control);
}

std::string Desk::step(std::size_t control, int by) {
    contract_pre(control < controls_.size());
    const DeskControl& own = controls_[target(control)];
    const int count = own.count();
    if (count == 0 || by == 0) return value(control);
    const int one = by > 0 ? 1 : -1;
    const int first = own.beside ? own.beside(one) : own.position() + one;
    // The control is already at this end, so only its value is announced.
    if (first < 0 || first >= count) return value(control);
    return put(control, first + by - one);
}

std::optional<ItemNumber> Desk::number(std::size_t control) const {
    contract_pre(control < controls_.size());
    if (const DeskControl& shown = controls_[target(control)]; shown.number) return shown.number();
    return controls_[control].kind == DeskKind::Knob ? std::optional<ItemNumber>(ItemNumber{}) : std::nullopt;
}

std::string Desk::put_number(std::size_t control, double number) {
    contract_pre(control < controls_.size());
    const DeskControl& own = controls_[target(control)];
    return own.nearest && std::isfinite(number) ? put(control, own.nearest(number)) : value(control);
}

std::string Desk::press(std::size_t control) {
    contract_pre(control < controls_.size());
    const DeskControl& own = controls_[control];
    if (own.kind == DeskKind::Assign) {
        on_knob_ = control;
        return phrase("desk.on_knob", {{"name", own.name}, {"value", value(control)}});
    }
    if (own.pressed) return own.pressed();
    return words(control);
}

}  // namespace handrail::core
