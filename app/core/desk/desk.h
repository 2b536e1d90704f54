// The person's desk as data: controls with a name, a value in words and an effect. One function changes a control for
// the hand at the desk, for keys and for screen readers. desk_panel.h places the controls before the hand, and
// desk_hand.h interprets the hand. App thread only.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/core/dialogue/dialogue.h"
#include "settings/settings.h"

namespace handrail::core {

// How a control feels to the hand and is operated by it. With keys, controls with positions go up and down; all others
// are pressed.
enum class DeskKind {
    Button,     // pressed
    Assign,     // pressed; puts its own value on the knob
    Slider,     // pressed at the wanted value; follows the hand while pressed
    Knob,       // turned while pressed, one position every 30 degrees
    List,       // pressed above its middle: previous entry; below: next entry
    Indicator,  // read only
};

struct DeskControl {
    std::string name;  // "Sound volume"
    DeskKind kind = DeskKind::Indicator;
    int positions = 0;                   // 0: no value to change
    std::function<int()> many;           // number of positions if it varies, as with marks; otherwise empty
    std::function<std::string()> value;  // in words: "80 percent"; empty function: none
    std::function<int()> position;       // the position nearest to the value
    std::function<int(int)>
        beside;  // The position one step down (-1) or up (+1) from the value. Empty: the position plus the step.
    std::function<void(int)> put;  // changes the value
    // `number` gives the value as a number, `nearest` the position nearest to a number. Empty: the control is a choice,
    // not a quantity.
    std::function<ItemNumber()> number;
    std::function<int(double)> nearest;
    std::function<std::string()> pressed;  // acts on a press; returns what to announce

    int count() const { return many ? many() : positions; }  // number of positions now
    bool adjustable() const { return positions > 0 || many || kind == DeskKind::Knob; }
};

class Desk {
public:
    explicit Desk(std::vector<DeskControl> controls = {}) : controls_(std::move(controls)) {}

    std::span<const DeskControl> controls() const { return controls_; }
    std::optional<std::size_t> find(std::string_view name) const;  // case-insensitive
    // "Sound volume, 80 percent".
    std::string words(std::size_t control) const;
    std::string value(std::size_t control) const;
    // The control that the knob turns; no value: none yet.
    std::optional<std::size_t> on_knob() const { return on_knob_; }
    // The control whose value this one shows and changes: itself, or what is on the knob.
    std::size_t target(std::size_t control) const;

    // All changes of a value go through these: to a position, or by steps. Positions beyond the ends count as the ends.
    // Returns the value in words, or nothing for a control without a value.
    std::string put(std::size_t control, int position);
    std::string step(std::size_t control, int by);
    // The quantity that a control shows, itself or through the knob. An empty knob has an empty range.
    std::optional<ItemNumber> number(std::size_t control) const;
    // Moves to the position whose number is nearest. A number that is not finite changes nothing.
    std::string put_number(std::size_t control, double number);
    // Presses the control as a button; returns what to announce. A control with a value announces the value.
    std::string press(std::size_t control);

private:
    std::vector<DeskControl> controls_;
    std::optional<std::size_t> on_knob_;
};

// A setting as a control of the desk: its key, its values in rising order, and their words.
struct DeskSetting {
    std::string_view name;  // key of its name in the texts
    DeskKind kind;
    std::string_view key;
    std::vector<std::string> values;  // as TOML writes them
    std::string (*words)(const std::string& value);
};
std::span<const DeskSetting> desk_settings();
// Index of `value` among the row's values: the nearest number, or the same word.
int position_of(const DeskSetting& row, const std::string& value);
// One step down or up. From a value between two positions, it goes to the next position in that direction.
int beside(const DeskSetting& row, const std::string& value, int step);
// A control bound to a setting: `read` returns its value in TOML syntax, `write` changes it.
DeskControl bound(const DeskSetting& row, std::function<std::string()> read,
                  std::function<void(const std::string&)> write);

}  // namespace handrail::core
