// The desk of a session. This class binds the controls to the session, shows one page to the hand, follows the hand at
// the desk, and offers the same controls as a list for keys. The world pauses while the hand is at the desk. App thread
// only.
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
    // Shows the first page for the present device. Without a hand, there is no page.
    void lay_out() { lay(0); }
    void offer_worlds(const WorldShelf& shelf);

    // Returns true, and announces why, if the hand is at the desk and the command works only while the world is
    // running.
    bool refuses(Command command, double now_s);
    void tick(double now_s);
    // Opens the controls of the desk as a list for keys.
    void open_list(double now_s);
    // Keeps a scale that was chosen at the desk, in TOML syntax, until the hand has returned to the world.
    void keep_scale(std::string value) { scale_waits_ = std::move(value); }

    const Desk& desk() const { return desk_; }
    // Returns the surfaces that the hand can touch, or null if there is no hand.
    std::shared_ptr<const render::HapticScene> scene() const { return panel_.haptic; }
    // Returns where the proxy touches a control, or the button that turns the pages, in the device frame. No value: the
    // control is not on the present page.
    std::optional<Vec3> place_m(std::string_view control) const;
    // Every change of a control goes through one of these functions, also from the hand and the list. `control` is its
    // number in desk().controls(). Each returns the text to announce.
    std::string step(std::size_t control, int by) { return after_change(desk_.step(control, by)); }
    std::string put(std::size_t control, int position) { return after_change(desk_.put(control, position)); }
    std::string put_number(std::size_t control, double number) {
        return after_change(desk_.put_number(control, number));
    }
    std::string press(std::size_t control) { return after_change(desk_.press(control)); }

    // These functions are set by the session.
    std::function<std::string()> where_am_i;
    std::function<std::string(double now_s)> progress;   // returns how much of the world the person has learnt
    std::function<std::optional<std::string>()> beacon;  // returns what the beacon is on; none: it is off
    std::function<void(const Mark* mark)> on_beacon;     // moves the beacon to a mark; null: switches it off
    std::function<void()> on_come;  // called when the hand has come to the desk; the session stops the walker
    // Called when the hand has returned to the world, with the scale chosen at the desk, if any.
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
    bool told_ = false;                          // true: it has been announced that the hand is at the desk
    std::vector<std::filesystem::path> worlds_;  // worlds that the list offers
    std::size_t world_ = 0, mark_ = 0;           // selected entries of the lists of worlds and marks
    std::optional<std::string> scale_waits_;
};

}  // namespace handrail::core
