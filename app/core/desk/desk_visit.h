// A session's desk: what its controls are bound to, the page that lies before the hand, the hand at it, the same by
// keys, and the world that waits meanwhile. App thread only.
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

namespace handrail {

class DeskVisit : SessionPart {
public:
    explicit DeskVisit(const SessionContext& context) : SessionPart(context) {}

    // Its controls, named in the language that is spoken now, and the first page of them.
    void furnish();
    // The first page for the device there is now; nothing lies there without a hand.
    void lay_out() { lay(0); }
    void offer_worlds(const WorldShelf& shelf);

    // True: the hand is here and the command needs the world to go on, which was said.
    bool refuses(Command command, double now_s);
    void tick(double now_s);
    // The same desk by keys.
    void open_list(double now_s);
    // Chosen while the hand is here, as TOML writes it: the world is larger or smaller when the hand is back in it.
    void keep_scale(std::string value) { scale_waits_ = std::move(value); }

    const Desk& desk() const { return desk_; }
    // What of it the hand can touch; null without a hand.
    std::shared_ptr<const HapticScene> scene() const { return panel_.haptic; }
    // Device frame: where the ball touches a control of the page that lies there, or the button that turns the pages.
    std::optional<Vec3> place_m(std::string_view control) const;
    // The one way to change a control, by its number among desk().controls(); each returns what is to be said. By the
    // hand and in the list they are called likewise.
    std::string step(std::size_t control, int by) { return after_change(desk_.step(control, by)); }
    std::string put(std::size_t control, int position) { return after_change(desk_.put(control, position)); }
    std::string put_number(std::size_t control, double number) {
        return after_change(desk_.put_number(control, number));
    }
    std::string press(std::size_t control) { return after_change(desk_.press(control)); }

    // Set by the session.
    std::function<std::string()> where_am_i;
    std::function<std::string(double now_s)> progress;   // what is learnt of the place
    std::function<std::optional<std::string>()> beacon;  // what it is on; none: off
    std::function<void(const Mark* mark)> on_beacon;     // on that mark; null: off
    std::function<void()> on_come;                       // the hand is here: the body stands
    // The hand is back in the world; with the scale that was chosen meanwhile.
    std::function<void(const std::optional<std::string>& scale, double now_s)> on_back;

private:
    void lay(std::size_t page);
    std::string value_of(std::string_view key) const;
    const std::filesystem::path* world() const;  // the one its list is at; null: none
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
    bool told_ = false;                          // that the hand is here
    std::vector<std::filesystem::path> worlds_;  // that its list offers
    std::size_t world_ = 0, mark_ = 0;           // where its lists are
    std::optional<std::string> scale_waits_;
};

}  // namespace handrail
