// Manages the desk of a session. This class binds the controls to the session, shows one page to the hand, follows the
// hand at the desk, and offers the same controls as a list for keys. The world pauses while the hand is at the desk.
// Use it on the app thread only.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/desk/desk.h"
#include "app/core/desk/desk_hand.h"
#include "app/core/desk/desk_panel.h"
#include "app/core/kept/world_shelf.h"

namespace handrail::core {

class DeskVisit : SessionPart {
public:
    explicit DeskVisit(const SessionContext& context) : SessionPart(context) {}

    // Makes the controls, with names in the language spoken now, and shows their first page.
    void furnish();
    // Shows the first page for the present device. If there is no hand, there is no page.
    void lay_out() { lay(0); }
    void offer_worlds(const WorldShelf& shelf);

    // Returns true, and announces why, if the hand is at the desk and the command works only while the world is
    // running.
    bool refuses(Command command, double now_s);
    void tick(double now_s);
    // Opens the controls of the desk as a list for keys.
    void open_list(double now_s);
    // Stores a scale that was chosen at the desk, in TOML syntax. It becomes effective when the hand has returned to
    // the world.
    void keep_scale(std::string value) { scale_waits_ = std::move(value); }

    const Desk& desk() const { return desk_; }
    // Returns the surfaces of the panel that the hand can touch, or null if there is no hand.
    std::shared_ptr<const render::HapticScene> scene() const { return panel_.haptic; }
    // Returns where the proxy touches the control with this name, or the button that turns the pages, in the device
    // frame. Returns no value if the control is not on the present page.
    std::optional<Vec3> place_m(std::string_view control) const;
    // Every change of a control goes through one of these functions, including changes by the hand and the list.
    // `control` is its number in desk().controls(). Each function returns the text to announce.
    std::string step(std::size_t control, int by) { return after_change(desk_.step(control, by)); }
    std::string put(std::size_t control, int position) { return after_change(desk_.put(control, position)); }
    std::string put_number(std::size_t control, double number) {
        return after_change(desk_.put_number(control, number));
    }
    std::string press(std::size_t control) { return after_change(desk_.press(control)); }

    // The session sets these functions.
    std::function<std::string()> where_am_i;
    std::function<std::string(double now_s)> progress;  // returns how much of the world the person has learnt
    // Returns the name of what carries the beacon; none: the beacon is off.
    std::function<std::optional<std::string>()> beacon;
    std::function<void(const Mark* mark)> on_beacon;  // moves the beacon to a mark; null: switches it off
    std::function<void()> on_come;  // called when the hand has come to the desk; the session stops the walker
    // Called when the hand has returned to the world. `scale` is the scale chosen at the desk, if any.
    std::function<void(const std::optional<std::string>& scale, double now_s)> on_back;

private:
    void lay(std::size_t page);
    std::string value_of(std::string_view key) const;
    const std::filesystem::path* world() const;  // the world selected in the list; null: none
    const Mark* mark() const;
    std::string go_to_world();
    std::string switch_beacon();
    std::string switch_units();
    void come(double now_s);
    void go_back(double now_s);
    void hear(const DeskNews& news, double now_s);
    std::vector<ListItem> items() const;
    std::string after_change(std::string words);

    Desk desk_;
    DeskPanel panel_;
    DeskHand hand_;
    bool announced_ = false;                     // true: the arrival of the hand at the desk has been announced
    std::vector<std::filesystem::path> worlds_;  // worlds in the desk's list of worlds
    std::size_t world_ = 0, mark_ = 0;           // selected entries of the lists of worlds and marks
    std::optional<std::string> scale_waits_;
};

}  // namespace handrail::core
