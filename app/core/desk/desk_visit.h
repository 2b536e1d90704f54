// The desk of a session: what its controls are bound to, the page before the hand, the hand at the desk, and the same
// controls by keys. It also pauses the world meanwhile. App thread only.
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

    // Makes the controls, named in the language spoken now, and shows their first page.
    void furnish();
    // Shows the first page for the present device; without a hand there is nothing to show.
    void lay_out() { lay(0); }
    void offer_worlds(const WorldShelf& shelf);

    // Returns true, and announces it, if the hand is at the desk and the command needs the world to run.
    bool refuses(Command command, double now_s);
    void tick(double now_s);
    // Opens the same desk as a list for keys.
    void open_list(double now_s);
    // Keeps a scale chosen at the desk, in TOML syntax, until the hand is back in the world.
    void keep_scale(std::string value) { scale_waits_ = std::move(value); }

    const Desk& desk() const { return desk_; }
    // The surfaces that the hand can touch; null without a hand.
    std::shared_ptr<const render::HapticScene> scene() const { return panel_.haptic; }
    // Device frame: where the proxy touches a control of the present page, or the button that turns the pages. No
    // value: on another page.
    std::optional<Vec3> place_m(std::string_view control) const;
    // All changes of a control go through these, with its number in desk().controls(). Each returns what to announce.
    // The hand and the list use them too.
    std::string step(std::size_t control, int by) { return after_change(desk_.step(control, by)); }
    std::string put(std::size_t control, int position) { return after_change(desk_.put(control, position)); }
    std::string put_number(std::size_t control, double number) {
        return after_change(desk_.put_number(control, number));
    }
    std::string press(std::size_t control) { return after_change(desk_.press(control)); }

    // Set by the session.
    std::function<std::string()> where_am_i;
    std::function<std::string(double now_s)> progress;   // how much of the place is learnt
    std::function<std::optional<std::string>()> beacon;  // what the beacon is on; none: off
    std::function<void(const Mark* mark)> on_beacon;     // puts the beacon on that mark; null: off
    std::function<void()> on_come;                       // the hand has come to the desk: the walker stops
    // The hand is back in the world; with the scale chosen meanwhile, if any.
    std::function<void(const std::optional<std::string>& scale, double now_s)> on_back;

private:
    void lay(std::size_t page);
    std::string value_of(std::string_view key) const;
    const std::filesystem::path* world() const;  // the selected world; null: none
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
    bool told_ = false;                          // that the hand is at the desk has been announced
    std::vector<std::filesystem::path> worlds_;  // offered in its list
    std::size_t world_ = 0, mark_ = 0;           // selected entries of its lists
    std::optional<std::string> scale_waits_;
};

}  // namespace handrail::core
