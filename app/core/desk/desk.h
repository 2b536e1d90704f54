// The person's desk as data: controls with a name, a value in words and what they change. One function changes a
// control, whoever asks: the hand at the desk, the keys, a screen reader. How they lie before the hand is
// desk_panel.h's affair, what a hand does with them desk_hand.h's. App thread only.
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

namespace handrail {

// How a control feels and is worked by the hand. By key all that have positions go up and down, and all others are
// pressed.
enum class DeskKind {
    Button,     // pressed
    Assign,     // a button that puts its own value on the knob
    Slider,     // pressed where its value is to be; slid along while pressed
    Knob,       // turned round while pressed, one position every 30 degrees
    List,       // pressed above its middle: the one before, below: the next
    Indicator,  // read only
};

struct DeskControl {
    std::string name;  // "Sound volume"
    DeskKind kind = DeskKind::Indicator;
    int positions = 0;                   // 0: it has no value to change
    std::function<int()> many;           // positions where they come and go, as marks do; else empty
    std::function<std::string()> value;  // in words: "80 percent"; empty function: none
    std::function<int()> position;       // of the value, the nearest one
    std::function<int(int)>
        beside;  // the position of one step down (-1) or up (+1) from the value; empty: position and step
    std::function<void(int)> put;  // changes the value
    // Its value as a number, and the position whose number is nearest to one; empty: it is a choice, not a quantity.
    std::function<ItemNumber()> number;
    std::function<int(double)> nearest;
    std::function<std::string()> pressed;  // what happens when it is pressed; returns what is to be said

    int count() const { return many ? many() : positions; }  // of positions now
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
    // What the knob turns; no value: nothing is on it yet.
    std::optional<std::size_t> on_knob() const { return on_knob_; }
    // The control whose value this one shows and changes: itself, or what is on the knob.
    std::size_t target(std::size_t control) const;

    // The one way to change a value: to a position, or by steps. Positions beyond the ends are the ends. Returns its
    // value in words; of a control without a value, nothing.
    std::string put(std::size_t control, int position);
    std::string step(std::size_t control, int by);
    // Of a control that shows a quantity, itself or through the knob, that quantity; a knob with nothing on it has a
    // range of nothing.
    std::optional<ItemNumber> number(std::size_t control) const;
    // To the position whose number is nearest. What is no number changes nothing.
    std::string put_number(std::size_t control, double number);
    // Pressed as a button; what is to be said. Controls with a value say it.
    std::string press(std::size_t control);

private:
    std::vector<DeskControl> controls_;
    std::optional<std::size_t> on_knob_;
};

// A setting as a row of the desk: its key, the values it takes there, rising, and how they are said.
struct DeskSetting {
    std::string_view name;  // key of its text
    DeskKind kind;
    std::string_view key;
    std::vector<std::string> values;  // as TOML writes them
    std::string (*words)(const std::string& value);
};
std::span<const DeskSetting> desk_settings();
// The place of `value` among the row's values: the nearest number, or the same word.
int position_of(const DeskSetting& row, const std::string& value);
// One step down or up: a value between two positions goes to the next one that way.
int beside(const DeskSetting& row, const std::string& value, int step);
// A control bound to a setting: `read` gives its value as TOML writes it, `write` changes it.
DeskControl bound(const DeskSetting& row, std::function<std::string()> read,
                  std::function<void(const std::string&)> write);

}  // namespace handrail
