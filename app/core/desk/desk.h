// Defines the controls of the person's desk as data. Each control has a name, a value in words and an effect. The hand
// at the desk, the keys and screen readers change a control through the same function. desk_panel.h places the controls
// before the hand, and desk_hand.h interprets the hand. Use them on the app thread only.
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

// How a control feels to the hand and how the hand operates it. Keys move controls with positions up and down, and
// press all others.
enum class DeskKind {
    Button,     // the hand presses it
    Assign,     // the hand presses it; the knob then changes the value of this control
    Slider,     // the hand presses it at the wanted value; the value follows the hand until the hand lets go
    Knob,       // the hand turns it while pressing, one position every 30 degrees
    List,       // a press above its middle selects the previous entry, a press below it the next one
    Indicator,  // shows a value that nobody can change here
};

struct DeskControl {
    std::string name;  // the spoken name: "Sound volume"
    DeskKind kind = DeskKind::Indicator;
    int positions = 0;          // number of positions; 0: there is no value to change
    std::function<int()> many;  // returns the number of positions if this number varies, as with marks; otherwise empty
    // Returns the value in words: "80 percent". If the function is empty, the control has no value.
    std::function<std::string()> value;
    std::function<int()> position;  // returns the position nearest to the value
    // Returns the position one step below (-1) or above (+1) the value. If the function is empty, that is the
    // present position plus the step.
    std::function<int(int)> beside;
    std::function<void(int)> put;  // sets the value of this position
    // `number` returns the value as a number, and `nearest` returns the position nearest to a number. If both are
    // empty, the control is a choice, not a quantity.
    std::function<ItemNumber()> number;
    std::function<int(double)> nearest;
    std::function<std::string()> pressed;  // acts on a press, and returns the text to announce

    int count() const { return many ? many() : positions; }  // present number of positions
    bool adjustable() const { return positions > 0 || many || kind == DeskKind::Knob; }
};

class Desk {
public:
    explicit Desk(std::vector<DeskControl> controls = {}) : controls_(std::move(controls)) {}

    std::span<const DeskControl> controls() const { return controls_; }
    std::optional<std::size_t> find(std::string_view name) const;  // finds a control by name; ignores case
    // Returns the name and the value: "Sound volume, 80 percent".
    std::string words(std::size_t control) const;
    std::string value(std::size_t control) const;
    // Returns the control that the knob turns, or no value if no control is assigned to the knob yet.
    std::optional<std::size_t> on_knob() const { return on_knob_; }
    // Returns the control whose value `control` shows and changes. For the knob, that is the control assigned to it.
    // For any other control, it is `control`.
    std::size_t target(std::size_t control) const;

    // Every change of a value goes through put() or step(): to a position, or by a number of steps. A position beyond
    // an end is replaced by that end. Both functions return the new value in words, or an empty text if the control has
    // no value.
    std::string put(std::size_t control, int position);
    std::string step(std::size_t control, int by);
    // Returns the quantity that a control shows, directly or through the knob. A knob without a control has an empty
    // range.
    std::optional<ItemNumber> number(std::size_t control) const;
    // Moves the control to the position whose number is nearest to `number`. A number that is not finite changes
    // nothing.
    std::string put_number(std::size_t control, double number);
    // Presses the control as a button, and returns the text to announce. For a control with a value, that text is the
    // value.
    std::string press(std::size_t control);

private:
    std::vector<DeskControl> controls_;
    std::optional<std::size_t> on_knob_;
};

// Describes a setting as a control of the desk: its key, its values in rising order, and the words for them.
struct DeskSetting {
    std::string_view name;  // key of the setting's name in the texts
    DeskKind kind;
    std::string_view key;
    std::vector<std::string> values;  // the values in TOML syntax
    std::string (*words)(const std::string& value);
};
std::span<const DeskSetting> desk_settings();
// Returns the index of `value` among the values of `row`: the nearest number, or the same word.
int position_of(const DeskSetting& row, const std::string& value);
// Returns the position one step below or above `value`. If `value` is between two positions, the result is the next
// position in that direction.
int beside(const DeskSetting& row, const std::string& value, int step);
// Makes a control for a setting: `read` returns the value in TOML syntax, `write` changes it.
DeskControl bound(const DeskSetting& row, std::function<std::string()> read,
                  std::function<void(const std::string&)> write);

}  // namespace handrail::core
