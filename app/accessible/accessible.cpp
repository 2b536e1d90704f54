#include "app/accessible/accessible.h"

#include <atk-bridge.h>
#include <dbus/dbus.h>
#include <glib.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "app/accessible/nodes.h"
#include "app/accessible/reader_keys.h"
#include "app/accessible/reader_watch.h"
#include "worlds/base/executor.h"
#include "worlds/base/language.h"

namespace handrail::accessible {
namespace {

using SteadyTime = std::chrono::steady_clock;
double now_s() { return std::chrono::duration<double>(SteadyTime::now().time_since_epoch()).count(); }

}  // namespace

class Accessible::Impl {
public:
    explicit Impl(std::shared_ptr<sinks::ReaderChannel> channel) : channel_(std::move(channel)) {
        // Do nothing if NO_AT_BRIDGE is 1, because the accessibility bridges of all toolkits obey this variable. Do
        // nothing without a session bus either.
        const char* unwanted = std::getenv("NO_AT_BRIDGE");
        if ((unwanted && std::string_view(unwanted) == "1") || !session_bus_is_there()) return;
        channel_->set_state(sinks::VoiceState::Opening);
        channel_->on_change([] { g_main_context_wakeup(nullptr); });
        thread_ = std::thread([this] { run(); });
    }
    ~Impl() {
        quit_ = true;
        channel_->on_change({});
        channel_->set_state(sinks::VoiceState::Unavailable);
        if (!thread_.joinable()) return;
        g_main_context_wakeup(nullptr);
        thread_.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void set_focus(bool focused) {
        if (focused_.exchange(focused) != focused) g_main_context_wakeup(nullptr);
    }

    void show(const core::DialogueView& dialogue) {
        if (dialogue == given_) return;
        given_ = dialogue;
        {
            const std::lock_guard lock(dialogue_mutex_);
            next_dialogue_ = dialogue;
        }
        g_main_context_wakeup(nullptr);
    }

    std::uint64_t offer(const window::KeyStroke& stroke) {
        const std::uint64_t ticket = keys_.offer(stroke, now_s());
        if (ticket != 0) g_main_context_wakeup(nullptr);
        return ticket;
    }

    std::vector<core::ItemAct> take_acts() {
        const std::lock_guard lock(acts_mutex_);
        return std::exchange(acts_, {});
    }

    window::KeyVerdict verdict(std::uint64_t ticket) { return keys_.verdict(ticket); }

private:
    // ---- accessibility thread ----

    void run() {
        name_this_thread("accessible");
        ReaderWatch watch([this] { look_due_s_ = 0.0; });
        while (!quit_) {
            if (now_s() >= look_due_s_) {
                look_due_s_ = now_s() + kLooksEvery_s;
                listened_to_ = watch.listens();
                if (listened_to_ && !tried_) build();
            }
            follow_focus();
            follow_dialogue();
            keys_.query_reader();
            settle();
            read();
            wait();
        }
        if (built_) atk_bridge_adaptor_cleanup();
        answer_reader({});
    }

    // Waits until there is work, or until the next timed task is due.
    void wait() {
        double due_s = look_due_s_;
        if (settles_at_s_ > now_s()) due_s = std::min(due_s, settles_at_s_);
        const int wait_ms = std::clamp(static_cast<int>(1000.0 * (due_s - now_s())) + 1, 1, 2000);
        GSource* alarm = g_timeout_source_new(static_cast<guint>(wait_ms));
        g_source_set_callback(
            alarm, [](gpointer) -> gboolean { return G_SOURCE_REMOVE; }, nullptr, nullptr);
        g_source_attach(alarm, nullptr);
        g_main_context_iteration(nullptr, TRUE);
        g_source_destroy(alarm);
        g_source_unref(alarm);
        // Process the queued bus messages, but at most 50 of them, so that a text that must be spoken need not wait
        // long.
        for (int i = 0; i < 50 && g_main_context_iteration(nullptr, FALSE); ++i) {
        }
    }

    void build() {
        tried_ = true;
        frame_ = make_node(handrail_frame_get_type(), ATK_ROLE_FRAME, "Handrail", root_node(),
                           {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
        // The role is unknown, because the name is always a message. If the role were a drawing area, Orca 43 would add
        // the role to the name whenever the focus returns.
        view_ = make_node(
            handrail_node_get_type(), ATK_ROLE_UNKNOWN, phrase("window.building").c_str(), frame_,
            {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_FOCUSABLE, ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
        // The arguments are null, because the bridge needs no arguments of the program.
        if (atk_bridge_adaptor_init(nullptr, nullptr) != 0) return;
        // By default, libdbus ends the whole program when the person's session ends. The force on the hand would then
        // end abruptly, without a ramp. So switch that off.
        if (DBusConnection* session = dbus_bus_get(DBUS_BUS_SESSION, nullptr)) {
            dbus_connection_set_exit_on_disconnect(session, FALSE);
            dbus_connection_unref(session);
        }
        answer_reader({[this](std::size_t item, int action) {
                           constexpr std::array kActs{core::ItemAct::Kind::Choose, core::ItemAct::Kind::More,
                                                      // `action` is an index into this array; see ReaderCalls::act.
                                                      core::ItemAct::Kind::Less};
                           note_act(item, kActs[static_cast<std::size_t>(action)], {});
                       },
                       [this](std::size_t item, double number) { note_act(item, core::ItemAct::Kind::Put, number); }});
        focus_ = view_;
        built_ = true;
        built_at_s_ = now_s();
    }

    void note_act(std::size_t item, core::ItemAct::Kind kind, double number) {
        if (item >= shown_.items.size()) return;
        const std::lock_guard lock(acts_mutex_);
        acts_.push_back({kind, item, shown_.items[item].name, number});
    }

    void follow_focus() {
        const bool focused = focused_;
        const bool heard = built_ && listened_to_;
        if (focused != announced_focus_ || heard != heard_) {
            if (heard != heard_) settled_ = false;
            announced_focus_ = focused;
            heard_ = heard;
            settles_at_s_ = heard && focused ? std::max(now_s(), built_at_s_) + kSettles_s : 0.0;
            if (built_) show_focus(focused);
        }
        keys_.set_heard(heard);
        if (!heard || !channel_->wanted()) channel_->set_state(sinks::VoiceState::Unavailable);
        else if (channel_->state() == sinks::VoiceState::Unavailable) channel_->set_state(sinks::VoiceState::Opening);
    }

    void show_focus(bool focused) {
        set_state(focus_, ATK_STATE_FOCUSED, false);
        g_signal_emit_by_name(frame_, focused ? "activate" : "deactivate");
        set_state(frame_, ATK_STATE_ACTIVE, focused);
        if (focused) set_state(focus_, ATK_STATE_FOCUSED, true);
    }

    // Sets which object in the window has the keyboard. Orca announces an object that receives the focus, so a message
    // that is still shown there must not be announced again.
    void move_focus(HandrailNode* to) {
        if (to == focus_) return;
        if (announced_focus_) set_state(focus_, ATK_STATE_FOCUSED, false);
        if (focus_ != view_) atk_object_set_description(&focus_->parent, "");
        focus_ = to;
        if (announced_focus_) set_state(focus_, ATK_STATE_FOCUSED, true);
    }

    // After the settling time, notifies the reader of the window and its focus again. From then on, the channel's voice
    // is ready: the reader speaks for Handrail until the reader ends, even if another window has the keyboard. The
    // reader then also reads that other window, and a second voice would talk over the reader.
    void settle() {
        if (heard_ && announced_focus_ && !settled_ && now_s() >= settles_at_s_) {
            show_focus(true);
            settled_ = true;
        }
        if (heard_ && settled_ && channel_->wanted()) channel_->set_state(sinks::VoiceState::Ready);
    }

    void read() {
        if (!settled_ || !announced_focus_) return;
        auto text = channel_->take();
        if (!text) return;
        follow_dialogue();  // the reader must know the open list before it receives a text about that list
        if (!announced_by_focus_.empty() &&
            (*text == announced_by_focus_ || text->ends_with(". " + announced_by_focus_))) {
            announced_by_focus_.clear();
            return;  // Orca has announced this text already, because the focus moved to the item with that name
        }
        if (focus_ != view_) {
            // If an item of a list has the keyboard, Orca reads each new description of that item as a message. So the
            // text becomes the description, and the name of the item stays the same.
            if (const char* shown = atk_object_get_description(&focus_->parent); shown && *text == shown) *text += ' ';
            return atk_object_set_description(&focus_->parent, text->c_str());
        }
        // The reader reads a name only if the name changes. If the text is the same as before, a blank makes it
        // different.
        if (const char* shown = atk_object_get_name(&view_->parent); shown && *text == shown) *text += ' ';
        atk_object_set_name(&view_->parent, text->c_str());
    }

    static std::string item_name(const core::ListItem& item) {
        return item.value.empty() ? item.name : phrase("window.item", {{"name", item.name}, {"value", item.value}});
    }

    // Updates the objects of the open list or question. If another list or question is open now, makes new objects. The
    // current item, or the question, gets the keyboard.
    void follow_dialogue() {
        if (!built_) return;
        std::optional<core::DialogueView> next;
        {
            const std::lock_guard lock(dialogue_mutex_);
            next = std::exchange(next_dialogue_, std::nullopt);
        }
        if (!next) return;
        if (dialogue_ && is_same(shown_, *next)) change_dialogue(*next);
        else {
            move_focus(view_);
            remove_dialogue();
            if (next->kind != core::DialogueView::Kind::None) add_dialogue(*next);
        }
        shown_ = std::move(*next);
    }

    static bool is_same(const core::DialogueView& a, const core::DialogueView& b) {
        if (a.kind != b.kind || a.title != b.title || a.items.size() != b.items.size()) return false;
        return std::equal(a.items.begin(), a.items.end(), b.items.begin(),
                          [](const core::ListItem& one, const core::ListItem& other) {
                              return one.name == other.name && one.number.has_value() == other.number.has_value();
                          });
    }

    // Stores the value of an item without notifying the reader. The reader is notified only of the changed name, which
    // contains the value. If the number were notified as well, Orca 43 would say the value twice.
    static void fill_item(HandrailNode& node, const core::ListItem& item) {
        node.actions = item.adjustable ? 3 : 1;
        node.number = item.number.value_or(core::ItemNumber{});
        *node.text = item.value;
    }

    void change_dialogue(const core::DialogueView& next) {
        *dialogue_->text = next.text;
        for (std::size_t i = 0; i < next.items.size(); ++i) {
            if (next.items[i] == shown_.items[i]) continue;
            HandrailNode* item = (*dialogue_->children)[i];
            fill_item(*item, next.items[i]);
            atk_object_set_name(&item->parent, item_name(next.items[i]).c_str());
        }
        if (shown_.at == next.at || next.at >= next.items.size()) return;
        select(shown_.at, false);
        select(next.at, true);
        announced_by_focus_ = next.where;
        move_focus((*dialogue_->children)[next.at]);
    }

    void add_dialogue(const core::DialogueView& view) {
        const bool list = view.kind == core::DialogueView::Kind::List;
        dialogue_ = make_node(
            list ? handrail_node_get_type() : handrail_entry_get_type(), list ? ATK_ROLE_LIST : ATK_ROLE_ENTRY,
            view.title.c_str(), frame_,
            {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_FOCUSABLE, ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
        *dialogue_->text = view.text;
        for (const core::ListItem& item : view.items)
            fill_item(*make_node(item.number ? handrail_quantity_get_type() : handrail_item_get_type(),
                                 ATK_ROLE_LIST_ITEM, item_name(item).c_str(), dialogue_,
                                 {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_FOCUSABLE, ATK_STATE_SELECTABLE,
                                  ATK_STATE_ENABLED, ATK_STATE_SENSITIVE}),
                      item);
        if (view.at < view.items.size())
            atk_state_set_add_state((*dialogue_->children)[view.at]->states, ATK_STATE_SELECTED);
        g_signal_emit_by_name(frame_, "children-changed::add", static_cast<guint>(frame_->children->size() - 1),
                              dialogue_, nullptr);
        if (list && view.at < view.items.size()) {
            announced_by_focus_ = view.where;
            move_focus((*dialogue_->children)[view.at]);
        } else if (!list) {
            announced_by_focus_ = view.where;
            move_focus(dialogue_);
        }
    }

    void remove_dialogue() {
        if (!dialogue_) return;
        announced_by_focus_.clear();
        std::erase(*frame_->children, dialogue_);
        g_signal_emit_by_name(frame_, "children-changed::remove", static_cast<guint>(frame_->children->size()),
                              dialogue_, nullptr);
        for (HandrailNode* item : *dialogue_->children)
            atk_object_notify_state_change(&item->parent, ATK_STATE_DEFUNCT, true);
        atk_object_notify_state_change(&dialogue_->parent, ATK_STATE_DEFUNCT, true);
        g_object_unref(std::exchange(dialogue_, nullptr));
    }

    void select(std::size_t item, bool on) {
        if (item < dialogue_->children->size()) set_state((*dialogue_->children)[item], ATK_STATE_SELECTED, on);
    }

    std::shared_ptr<sinks::ReaderChannel> channel_;
    std::thread thread_;
    std::atomic<bool> quit_{false}, focused_{false};
    ReaderKeys keys_;

    std::mutex acts_mutex_;
    std::vector<core::ItemAct> acts_;  // guarded by acts_mutex_

    core::DialogueView given_;  // used by the app thread
    std::mutex dialogue_mutex_;
    // Newest list or question; none: unchanged; guarded by dialogue_mutex_.
    std::optional<core::DialogueView> next_dialogue_;

    // Members that only the accessibility thread uses.
    core::DialogueView shown_;
    HandrailNode* dialogue_ = nullptr;  // object of the open list or question, a child of frame_; null: nothing is open
    double look_due_s_ = 0.0;
    bool listened_to_ = false, tried_ = false, built_ = false;
    double built_at_s_ = 0.0;
    bool announced_focus_ = false, heard_ = false, settled_ = false;
    double settles_at_s_ = 0.0;
    HandrailNode* frame_ = nullptr;  // object of the window, a child of the root
    HandrailNode* view_ = nullptr;
    // The object that has the keyboard while the window has it: view_, or the open list or question.
    HandrailNode* focus_ = nullptr;
    std::string announced_by_focus_;  // words that the reader announces because the focus moved to them
};

Accessible::Accessible(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Accessible::~Accessible() = default;

std::unique_ptr<Accessible> Accessible::start(std::shared_ptr<sinks::ReaderChannel> channel) {
    return std::unique_ptr<Accessible>(new Accessible(std::make_unique<Impl>(std::move(channel))));
}

void Accessible::set_focus(bool focused) { impl_->set_focus(focused); }
void Accessible::show(const core::DialogueView& dialogue) { impl_->show(dialogue); }
std::vector<core::ItemAct> Accessible::take_acts() { return impl_->take_acts(); }
std::uint64_t Accessible::offer(const window::KeyStroke& stroke) { return impl_->offer(stroke); }
window::KeyVerdict Accessible::verdict(std::uint64_t ticket) { return impl_->verdict(ticket); }

}  // namespace handrail::accessible
