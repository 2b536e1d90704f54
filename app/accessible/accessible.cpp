#include "app/accessible/accessible.h"

#include <atk-bridge.h>
#include <atk/atk.h>
#include <dbus/dbus.h>
#include <gio/gio.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "worlds/base/language.h"

// ---- accessible objects: GObject classes, so in C's manner ----

namespace {

// An object of the tree. Plain data beside what AtkObject keeps itself.
struct HandrailNode {
    AtkObject parent;
    std::vector<HandrailNode*>* children;  // owned references
    AtkStateSet* states;
    int actions;        // of an item: 0 none, 1 pressed, 3 also more and less
    std::string* text;  // of an entry: what is typed; of a quantity: its value in words
    handrail::ItemNumber number;  // of a quantity
};
struct HandrailNodeClass {
    AtkObjectClass parent;
};
struct HandrailFrame {
    HandrailNode parent;
};
struct HandrailFrameClass {
    HandrailNodeClass parent;
};
struct HandrailItem {
    HandrailNode parent;
};
struct HandrailItemClass {
    HandrailNodeClass parent;
};
// An item that is a quantity as well.
struct HandrailQuantity {
    HandrailItem parent;
};
struct HandrailQuantityClass {
    HandrailItemClass parent;
};
struct HandrailEntry {
    HandrailNode parent;
};
struct HandrailEntryClass {
    HandrailNodeClass parent;
};

HandrailNode* node_of(gpointer object) { return static_cast<HandrailNode*>(object); }

// The whole window; nobody points into it.
void node_extents(AtkComponent*, gint* x, gint* y, gint* width, gint* height, AtkCoordType) {
    *x = *y = 0;
    *width = 960;
    *height = 720;
}
void node_component_init(gpointer interface, gpointer) { static_cast<AtkComponentIface*>(interface)->get_extents = node_extents; }
void frame_window_init(gpointer, gpointer) {}

// What a reader does with an item: its place in the list, and which of the names below. Accessibility thread.
std::function<void(std::size_t item, int action)> the_act;
constexpr std::array kActionNames{"press", "increase", "decrease"};

gint node_index(AtkObject* object);
gboolean item_act(AtkAction* object, gint action) {
    const gint index = node_index(static_cast<AtkObject*>(static_cast<gpointer>(object)));
    if (index < 0 || action < 0 || action >= node_of(object)->actions || !the_act) return FALSE;
    the_act(static_cast<std::size_t>(index), action);
    return TRUE;
}
gint item_action_count(AtkAction* object) { return node_of(object)->actions; }
const gchar* item_action_name(AtkAction* object, gint action) {
    return action >= 0 && action < node_of(object)->actions ? kActionNames[static_cast<std::size_t>(action)] : nullptr;
}
void item_action_init(gpointer interface, gpointer) {
    auto* actions = static_cast<AtkActionIface*>(interface);
    actions->do_action = item_act;
    actions->get_n_actions = item_action_count;
    actions->get_name = item_action_name;
}

// A number that a reader sets is the program's to judge: the nearest value that the item takes. Accessibility thread.
std::function<void(std::size_t item, double number)> the_put;
void quantity_now(AtkValue* object, gdouble* now, gchar** words) {
    if (now) *now = node_of(object)->number.now;
    if (words) *words = g_strdup(node_of(object)->text->c_str());
}
AtkRange* quantity_range(AtkValue* object) { return atk_range_new(node_of(object)->number.least, node_of(object)->number.most, nullptr); }
gdouble quantity_step(AtkValue* object) { return node_of(object)->number.step; }
void quantity_put(AtkValue* object, gdouble number) {
    if (const gint index = node_index(static_cast<AtkObject*>(static_cast<gpointer>(object))); index >= 0 && the_put)
        the_put(static_cast<std::size_t>(index), number);
}
void quantity_value_init(gpointer interface, gpointer) {
    auto* value = static_cast<AtkValueIface*>(interface);
    value->get_value_and_text = quantity_now;
    value->get_range = quantity_range;
    value->get_increment = quantity_step;
    value->set_value = quantity_put;
}

// Read only: what is typed goes through the program's own keys, and is echoed by it.
gchar* entry_text(AtkText* object, gint begin, gint end) {
    const gchar* text = node_of(object)->text->c_str();
    const glong length = g_utf8_strlen(text, -1);
    const glong to = end < 0 || end > length ? length : end, from = std::clamp<glong>(begin, 0, to);
    return g_utf8_substring(text, from, to);
}
gint entry_length(AtkText* object) { return static_cast<gint>(g_utf8_strlen(node_of(object)->text->c_str(), -1)); }
void entry_text_init(gpointer interface, gpointer) {
    auto* text = static_cast<AtkTextIface*>(interface);
    text->get_text = entry_text;
    text->get_character_count = entry_length;
    text->get_caret_offset = entry_length;
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"  // in GLib's macros
G_DEFINE_TYPE_WITH_CODE(HandrailNode, handrail_node, ATK_TYPE_OBJECT, G_IMPLEMENT_INTERFACE(ATK_TYPE_COMPONENT, node_component_init))
G_DEFINE_TYPE_WITH_CODE(HandrailFrame, handrail_frame, handrail_node_get_type(), G_IMPLEMENT_INTERFACE(ATK_TYPE_WINDOW, frame_window_init))
G_DEFINE_TYPE_WITH_CODE(HandrailItem, handrail_item, handrail_node_get_type(), G_IMPLEMENT_INTERFACE(ATK_TYPE_ACTION, item_action_init))
G_DEFINE_TYPE_WITH_CODE(HandrailQuantity, handrail_quantity, handrail_item_get_type(), G_IMPLEMENT_INTERFACE(ATK_TYPE_VALUE, quantity_value_init))
G_DEFINE_TYPE_WITH_CODE(HandrailEntry, handrail_entry, handrail_node_get_type(), G_IMPLEMENT_INTERFACE(ATK_TYPE_TEXT, entry_text_init))
#pragma GCC diagnostic pop

void handrail_node_init(HandrailNode* node) {
    node->children = new std::vector<HandrailNode*>;
    node->states = atk_state_set_new();
    node->actions = 0;
    node->text = new std::string;
    node->number = {};
}
void node_finalize(GObject* object) {
    HandrailNode* node = node_of(object);
    for (HandrailNode* child : *node->children) g_object_unref(child);
    delete node->children;
    delete node->text;
    g_object_unref(node->states);
    G_OBJECT_CLASS(handrail_node_parent_class)->finalize(object);
}
gint node_child_count(AtkObject* object) { return static_cast<gint>(node_of(object)->children->size()); }
AtkObject* node_child(AtkObject* object, gint index) {
    const auto& children = *node_of(object)->children;
    if (index < 0 || index >= static_cast<gint>(children.size())) return nullptr;
    return static_cast<AtkObject*>(g_object_ref(&children[static_cast<std::size_t>(index)]->parent));
}
gint node_index(AtkObject* object) {
    AtkObject* parent = atk_object_get_parent(object);
    if (!parent || !G_TYPE_CHECK_INSTANCE_TYPE(parent, handrail_node_get_type())) return -1;
    const auto& children = *node_of(parent)->children;
    const auto found = std::find(children.begin(), children.end(), node_of(object));
    return found == children.end() ? -1 : static_cast<gint>(found - children.begin());
}
AtkStateSet* node_states(AtkObject* object) {
    AtkStateSet* none = atk_state_set_new();
    AtkStateSet* copy = atk_state_set_or_sets(none, node_of(object)->states);
    g_object_unref(none);
    return copy;
}
void handrail_node_class_init(HandrailNodeClass* type) {
    G_OBJECT_CLASS(type)->finalize = node_finalize;
    type->parent.get_n_children = node_child_count;
    type->parent.ref_child = node_child;
    type->parent.get_index_in_parent = node_index;
    type->parent.ref_state_set = node_states;
}
void handrail_frame_class_init(HandrailFrameClass*) {}
void handrail_frame_init(HandrailFrame*) {}
void handrail_item_class_init(HandrailItemClass*) {}
void handrail_item_init(HandrailItem*) {}
void handrail_quantity_class_init(HandrailQuantityClass*) {}
void handrail_quantity_init(HandrailQuantity*) {}
void handrail_entry_class_init(HandrailEntryClass*) {}
void handrail_entry_init(HandrailEntry*) {}

HandrailNode* make_node(GType type, AtkRole role, const char* name, HandrailNode* parent, std::initializer_list<AtkStateType> states) {
    HandrailNode* node = node_of(g_object_new(type, nullptr));
    atk_object_set_role(&node->parent, role);
    atk_object_set_name(&node->parent, name);
    atk_object_set_description(&node->parent, "");  // of the first one nobody is told
    for (const AtkStateType state : states) atk_state_set_add_state(node->states, state);
    if (parent) {
        atk_object_set_parent(&node->parent, &parent->parent);
        parent->children->push_back(node);
    }
    return node;
}

void set_state(HandrailNode* node, AtkStateType state, bool on) {
    if (on) atk_state_set_add_state(node->states, state);
    else atk_state_set_remove_state(node->states, state);
    atk_object_notify_state_change(&node->parent, state, on);
}

// What AtkUtil asks through plain functions; accessibility thread only, one Accessible at a time.
HandrailNode* the_root = nullptr;
AtkKeySnoopFunc the_listener = nullptr;
gpointer the_listeners_data = nullptr;

AtkObject* util_root() { return &the_root->parent; }
const gchar* util_toolkit() { return "handrail"; }
const gchar* util_version() { return "1"; }
guint util_add_listener(AtkKeySnoopFunc listener, gpointer data) {
    the_listener = listener;
    the_listeners_data = data;
    return 1;
}
void util_remove_listener(guint) { the_listener = nullptr; }

}  // namespace

namespace handrail {
namespace {

using SteadyTime = std::chrono::steady_clock;
double now_s() { return std::chrono::duration<double>(SteadyTime::now().time_since_epoch()).count(); }

template <class T>
struct Unref {
    void operator()(T* object) const { g_object_unref(object); }
};
struct FreeVariant {
    void operator()(GVariant* variant) const { g_variant_unref(variant); }
};
using BusConnection = std::unique_ptr<GDBusConnection, Unref<GDBusConnection>>;
using Variant = std::unique_ptr<GVariant, FreeVariant>;

constexpr int kCallPatience_ms = 1000;

// GLib and libdbus start a bus of their own where they find none, and leave it behind; so it is looked for first.
bool session_bus_is_there() {
    const char* address = std::getenv("DBUS_SESSION_BUS_ADDRESS");
    if (address && *address) return std::string_view(address) != "disabled:";
    const char* folder = std::getenv("XDG_RUNTIME_DIR");
    struct stat socket {};
    return folder && ::stat((std::string(folder) + "/bus").c_str(), &socket) == 0 && S_ISSOCK(socket.st_mode);
}

Variant call(GDBusConnection* bus, const char* name, const char* path, const char* interface, const char* method, GVariant* arguments) {
    return Variant(g_dbus_connection_call_sync(bus, name, path, interface, method, arguments, nullptr, G_DBUS_CALL_FLAGS_NO_AUTO_START, kCallPatience_ms,
                                               nullptr, nullptr));
}

// Whether somebody on the accessibility bus hears of names and focus, as a screen reader does.
class ReaderWatch {
public:
    // `news` is called from GLib's default context when somebody comes or goes.
    explicit ReaderWatch(std::function<void()> news) : news_(std::move(news)) {}
    ~ReaderWatch() { forget(); }
    ReaderWatch(const ReaderWatch&) = delete;
    ReaderWatch& operator=(const ReaderWatch&) = delete;

    bool listens() {
        if (!connect()) return false;
        const Variant answer =
            call(bus_.get(), "org.a11y.atspi.Registry", "/org/a11y/atspi/registry", "org.a11y.atspi.Registry", "GetRegisteredEvents", nullptr);
        if (!answer || !g_variant_is_of_type(answer.get(), G_VARIANT_TYPE("(a(ss))"))) return false;
        GVariantIter* events = nullptr;
        g_variant_get(answer.get(), "(a(ss))", &events);
        const gchar* who = nullptr;
        const gchar* event = nullptr;
        bool names = false, focus = false;
        while (g_variant_iter_loop(events, "(&s&s)", &who, &event)) {
            names |= g_ascii_strcasecmp(event, "Object:PropertyChange:AccessibleName") == 0 || g_ascii_strcasecmp(event, "Object:PropertyChange:") == 0;
            focus |= g_ascii_strcasecmp(event, "Object:StateChanged:Focused") == 0 || g_ascii_strcasecmp(event, "Object:StateChanged:") == 0;
        }
        g_variant_iter_free(events);
        return names && focus;
    }

private:
    // The bus that readers use, where one runs; nothing is started.
    bool connect() {
        if (bus_ && !g_dbus_connection_is_closed(bus_.get())) return true;
        forget();
        if (!session_ || g_dbus_connection_is_closed(session_.get())) {
            session_.reset();
            gchar* address = g_dbus_address_get_for_bus_sync(G_BUS_TYPE_SESSION, nullptr, nullptr);
            if (address) session_.reset(open(address));
            g_free(address);
            if (!session_) return false;
        }
        const Variant answer = call(session_.get(), "org.a11y.Bus", "/org/a11y/bus", "org.a11y.Bus", "GetAddress", nullptr);
        if (!answer || !g_variant_is_of_type(answer.get(), G_VARIANT_TYPE("(s)"))) return false;
        const gchar* address = nullptr;
        g_variant_get(answer.get(), "(&s)", &address);
        bus_.reset(open(address));
        if (!bus_) return false;
        for (const auto& [interface, member] :
             {std::pair{"org.a11y.atspi.Registry", static_cast<const char*>(nullptr)}, {"org.freedesktop.DBus", "NameOwnerChanged"}})
            subscriptions_.push_back(g_dbus_connection_signal_subscribe(
                bus_.get(), nullptr, interface, member, nullptr, nullptr, G_DBUS_SIGNAL_FLAGS_NONE,
                [](GDBusConnection*, const gchar*, const gchar*, const gchar*, const gchar*, GVariant*, gpointer self) {
                    static_cast<ReaderWatch*>(self)->news_();
                },
                this, nullptr));
        return true;
    }

    static GDBusConnection* open(const gchar* address) {
        constexpr auto kFlags =
            static_cast<GDBusConnectionFlags>(G_DBUS_CONNECTION_FLAGS_AUTHENTICATION_CLIENT | G_DBUS_CONNECTION_FLAGS_MESSAGE_BUS_CONNECTION);
        return g_dbus_connection_new_for_address_sync(address, kFlags, nullptr, nullptr, nullptr);
    }

    void forget() {
        for (const guint subscription : subscriptions_) g_dbus_connection_signal_unsubscribe(bus_.get(), subscription);
        subscriptions_.clear();
        bus_.reset();
    }

    std::function<void()> news_;
    BusConnection session_, bus_;
    std::vector<guint> subscriptions_;
};

}  // namespace

class Accessible::Impl {
public:
    explicit Impl(std::shared_ptr<ReaderChannel> channel) : channel_(std::move(channel)) {
        const char* unwanted = std::getenv("NO_AT_BRIDGE");  // as every toolkit's bridge has it
        if ((unwanted && std::string_view(unwanted) == "1") || !session_bus_is_there()) return;
        channel_->set_state(VoiceState::Opening);
        channel_->on_change([] { g_main_context_wakeup(nullptr); });
        thread_ = std::thread([this] { run(); });
    }
    ~Impl() {
        quit_ = true;
        channel_->on_change({});
        channel_->set_state(VoiceState::Gone);
        if (!thread_.joinable()) return;
        g_main_context_wakeup(nullptr);
        thread_.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    void set_focus(bool focused) {
        if (focused_.exchange(focused) != focused) g_main_context_wakeup(nullptr);
    }

    void show(const DialogueView& dialogue) {
        if (dialogue == given_) return;
        given_ = dialogue;
        {
            const std::lock_guard lock(dialogue_mutex_);
            next_dialogue_ = dialogue;
        }
        g_main_context_wakeup(nullptr);
    }

    std::uint64_t offer(const KeyStroke& stroke) {
        if (!hears_keys_) return 0;
        {
            const std::lock_guard lock(keys_mutex_);
            if (!keys_.empty() && now_s() - keys_.front().since_s > KeyGate::kPatience_s) return 0;
            keys_.push_back({++last_ticket_, stroke, now_s()});
        }
        g_main_context_wakeup(nullptr);
        return last_ticket_;
    }

    std::vector<ItemAct> take_acts() {
        const std::lock_guard lock(acts_mutex_);
        return std::exchange(acts_, {});
    }

    KeyVerdict verdict(std::uint64_t ticket) {
        const std::lock_guard lock(keys_mutex_);
        const auto found = verdicts_.find(ticket);
        if (found == verdicts_.end()) return ticket <= answered_ ? KeyVerdict::Ours : KeyVerdict::Waiting;
        const KeyVerdict verdict = found->second;
        verdicts_.erase(verdicts_.begin(), std::next(found));
        return verdict;
    }

private:
    struct OfferedKey {
        std::uint64_t ticket = 0;
        KeyStroke stroke;
        double since_s = 0.0;
    };

    // ---- accessibility thread ----

    void run() {
        pthread_setname_np(pthread_self(), "accessible");
        ReaderWatch watch([this] { look_due_s_ = 0.0; });
        while (!quit_) {
            if (now_s() >= look_due_s_) {
                look_due_s_ = now_s() + kLooksEvery_s;
                listened_to_ = watch.listens();
                if (listened_to_ && !tried_) build();
            }
            follow_focus();
            follow_dialogue();
            ask_about_keys();
            settle();
            read();
            wait();
        }
        if (built_) atk_bridge_adaptor_cleanup();
        the_act = {};
        the_put = {};
    }

    // Until something is to be done or the next thing is due.
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
        // What the bus has queued is worked off, but never for so long that words wait.
        for (int i = 0; i < 50 && g_main_context_iteration(nullptr, FALSE); ++i) {
        }
    }

    void build() {
        tried_ = true;
        auto* util = static_cast<AtkUtilClass*>(g_type_class_ref(ATK_TYPE_UTIL));
        util->get_root = util_root;
        util->get_toolkit_name = util_toolkit;
        util->get_toolkit_version = util_version;
        util->add_key_event_listener = util_add_listener;
        util->remove_key_event_listener = util_remove_listener;
        if (!the_root) the_root = make_node(handrail_node_get_type(), ATK_ROLE_APPLICATION, "Handrail", nullptr, {ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
        frame_ = make_node(handrail_frame_get_type(), ATK_ROLE_FRAME, "Handrail", the_root,
                           {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
        // Of a drawing area Orca 43 says the role after the name whenever the focus comes back to it, and each message is its name.
        view_ = make_node(handrail_node_get_type(), ATK_ROLE_UNKNOWN, phrase("window.building").c_str(), frame_,
                          {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_FOCUSABLE, ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
        // The bridge reads no arguments of ours.
        if (atk_bridge_adaptor_init(nullptr, nullptr) != 0) return;
        // libdbus would end the whole program when the person's session does, and the hand would be let go of without a ramp.
        if (DBusConnection* session = dbus_bus_get(DBUS_BUS_SESSION, nullptr)) {
            dbus_connection_set_exit_on_disconnect(session, FALSE);
            dbus_connection_unref(session);
        }
        the_act = [this](std::size_t item, int action) {
            if (item >= shown_.items.size()) return;
            constexpr std::array kActs{ItemAct::Kind::Choose, ItemAct::Kind::More, ItemAct::Kind::Less};  // as kActionNames
            const std::lock_guard lock(acts_mutex_);
            acts_.push_back({kActs[static_cast<std::size_t>(action)], item, shown_.items[item].name});
        };
        the_put = [this](std::size_t item, double number) {
            if (item >= shown_.items.size()) return;
            const std::lock_guard lock(acts_mutex_);
            acts_.push_back({ItemAct::Kind::Put, item, shown_.items[item].name, number});
        };
        focus_ = view_;
        built_ = true;
        built_at_s_ = now_s();
    }

    void follow_focus() {
        const bool focused = focused_;
        const bool heard = built_ && listened_to_;
        if (focused != told_focus_ || heard != heard_) {
            if (heard != heard_) settled_ = false;
            told_focus_ = focused;
            heard_ = heard;
            settles_at_s_ = heard && focused ? std::max(now_s(), built_at_s_) + kSettles_s : 0.0;
            if (built_) show_focus(focused);
        }
        hears_keys_ = heard && the_listener;
        if (!heard || !channel_->wanted()) channel_->set_state(VoiceState::Gone);
        else if (channel_->state() == VoiceState::Gone) channel_->set_state(VoiceState::Opening);
    }

    void show_focus(bool focused) {
        set_state(focus_, ATK_STATE_FOCUSED, false);
        g_signal_emit_by_name(frame_, focused ? "activate" : "deactivate");
        set_state(frame_, ATK_STATE_ACTIVE, focused);
        if (focused) set_state(focus_, ATK_STATE_FOCUSED, true);
    }

    // What has the keyboard within the window. Orca tells by itself what the focus comes to; a message that waited there is not told again.
    void move_focus(HandrailNode* to) {
        if (to == focus_) return;
        if (told_focus_) set_state(focus_, ATK_STATE_FOCUSED, false);
        if (focus_ != view_) atk_object_set_description(&focus_->parent, "");
        focus_ = to;
        if (told_focus_) set_state(focus_, ATK_STATE_FOCUSED, true);
    }

    // Once the reader has had its moment it is told of window and focus again, and then speaks for us; it does so until it goes, wherever the keyboard is:
    // while that is in another window the reader reads there, and a second voice would talk over it.
    void settle() {
        if (heard_ && told_focus_ && !settled_ && now_s() >= settles_at_s_) {
            show_focus(true);
            settled_ = true;
        }
        if (heard_ && settled_ && channel_->wanted()) channel_->set_state(VoiceState::Ready);
    }

    void read() {
        if (!settled_ || !told_focus_) return;
        auto text = channel_->take();
        if (!text) return;
        follow_dialogue();  // what is open was told before the words about it
        if (!told_by_focus_.empty() && (*text == told_by_focus_ || text->ends_with(". " + told_by_focus_))) {
            told_by_focus_.clear();
            return;  // Orca has told it: the focus went there
        }
        if (focus_ != view_) {
            // Of an item that has the keyboard Orca reads each new description as a message, and the name stays its name.
            if (const char* shown = atk_object_get_description(&focus_->parent); shown && *text == shown) *text += ' ';
            return atk_object_set_description(&focus_->parent, text->c_str());
        }
        // Only a name that changes is read.
        if (const char* shown = atk_object_get_name(&view_->parent); shown && *text == shown) *text += ' ';
        atk_object_set_name(&view_->parent, text->c_str());
    }

    static std::string item_name(const ListItem& item) {
        return item.value.empty() ? item.name : phrase("window.item", {{"name", item.name}, {"value", item.value}});
    }

    // The objects of the open list or question: made anew for another one, else kept up to date. The keyboard is with the item one is at, or the question.
    void follow_dialogue() {
        if (!built_) return;
        std::optional<DialogueView> next;
        {
            const std::lock_guard lock(dialogue_mutex_);
            next = std::exchange(next_dialogue_, std::nullopt);
        }
        if (!next) return;
        if (dialogue_ && is_same(shown_, *next)) change_dialogue(*next);
        else {
            move_focus(view_);
            remove_dialogue();
            if (next->kind != DialogueView::Kind::None) add_dialogue(*next);
        }
        shown_ = std::move(*next);
    }

    static bool is_same(const DialogueView& a, const DialogueView& b) {
        if (a.kind != b.kind || a.title != b.title || a.items.size() != b.items.size()) return false;
        return std::equal(a.items.begin(), a.items.end(), b.items.begin(), [](const ListItem& one, const ListItem& other) {
            return one.name == other.name && one.number.has_value() == other.number.has_value();
        });
    }

    // A change of the number is told by that of the name; Orca 43 would say the value twice if it heard of both.
    static void fill_item(HandrailNode& node, const ListItem& item) {
        node.actions = item.adjustable ? 3 : 1;
        node.number = item.number.value_or(ItemNumber{});
        *node.text = item.value;
    }

    void change_dialogue(const DialogueView& next) {
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
        told_by_focus_ = next.where;
        move_focus((*dialogue_->children)[next.at]);
    }

    void add_dialogue(const DialogueView& view) {
        const bool list = view.kind == DialogueView::Kind::List;
        dialogue_ = make_node(list ? handrail_node_get_type() : handrail_entry_get_type(), list ? ATK_ROLE_LIST : ATK_ROLE_ENTRY, view.title.c_str(), frame_,
                              {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_FOCUSABLE, ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
        *dialogue_->text = view.text;
        for (const ListItem& item : view.items)
            fill_item(*make_node(item.number ? handrail_quantity_get_type() : handrail_item_get_type(), ATK_ROLE_LIST_ITEM, item_name(item).c_str(), dialogue_,
                                 {ATK_STATE_SHOWING, ATK_STATE_VISIBLE, ATK_STATE_FOCUSABLE, ATK_STATE_SELECTABLE, ATK_STATE_ENABLED, ATK_STATE_SENSITIVE}),
                      item);
        if (view.at < view.items.size()) atk_state_set_add_state((*dialogue_->children)[view.at]->states, ATK_STATE_SELECTED);
        g_signal_emit_by_name(frame_, "children-changed::add", static_cast<guint>(frame_->children->size() - 1), dialogue_, nullptr);
        if (list && view.at < view.items.size()) {
            told_by_focus_ = view.where;
            move_focus((*dialogue_->children)[view.at]);
        } else if (!list) {
            told_by_focus_ = view.where;
            move_focus(dialogue_);
        }
    }

    void remove_dialogue() {
        if (!dialogue_) return;
        told_by_focus_.clear();
        std::erase(*frame_->children, dialogue_);
        g_signal_emit_by_name(frame_, "children-changed::remove", static_cast<guint>(frame_->children->size()), dialogue_, nullptr);
        for (HandrailNode* item : *dialogue_->children) atk_object_notify_state_change(&item->parent, ATK_STATE_DEFUNCT, true);
        atk_object_notify_state_change(&dialogue_->parent, ATK_STATE_DEFUNCT, true);
        g_object_unref(std::exchange(dialogue_, nullptr));
    }

    void select(std::size_t item, bool on) {
        if (item < dialogue_->children->size()) set_state((*dialogue_->children)[item], ATK_STATE_SELECTED, on);
    }

    void ask_about_keys() {
        for (;;) {
            OfferedKey key;
            {
                const std::lock_guard lock(keys_mutex_);
                if (keys_.empty()) return;
                key = keys_.front();
            }
            bool used = false;
            if (the_listener) {
                AtkKeyEventStruct event{};
                event.type = key.stroke.press ? ATK_KEY_EVENT_PRESS : ATK_KEY_EVENT_RELEASE;
                event.state = key.stroke.state;
                event.keyval = key.stroke.keysym;
                event.string = key.stroke.name.data();
                event.length = static_cast<gint>(key.stroke.name.size());
                event.keycode = static_cast<guint16>(key.stroke.keycode);
                event.timestamp = static_cast<guint32>(1000.0 * key.since_s);
                used = the_listener(&event, the_listeners_data) != 0;
            }
            const std::lock_guard lock(keys_mutex_);
            if (!keys_.empty() && keys_.front().ticket == key.ticket) keys_.pop_front();
            answered_ = key.ticket;
            verdicts_[key.ticket] = used ? KeyVerdict::Readers : KeyVerdict::Ours;
        }
    }

    std::shared_ptr<ReaderChannel> channel_;
    std::thread thread_;
    std::atomic<bool> quit_{false}, focused_{false}, hears_keys_{false};
    std::uint64_t last_ticket_ = 0;  // app thread

    std::mutex keys_mutex_;  // guards the four below
    std::deque<OfferedKey> keys_;
    std::map<std::uint64_t, KeyVerdict> verdicts_;
    std::uint64_t answered_ = 0;

    std::mutex acts_mutex_;
    std::vector<ItemAct> acts_;  // under acts_mutex_

    DialogueView given_;  // app thread
    std::mutex dialogue_mutex_;
    std::optional<DialogueView> next_dialogue_;  // under dialogue_mutex_

    // Accessibility thread.
    DialogueView shown_;
    HandrailNode* dialogue_ = nullptr;  // of frame_; null: nothing is open
    double look_due_s_ = 0.0;
    bool listened_to_ = false, tried_ = false, built_ = false;
    double built_at_s_ = 0.0;
    bool told_focus_ = false, heard_ = false, settled_ = false;
    double settles_at_s_ = 0.0;
    HandrailNode* frame_ = nullptr;  // of the_root
    HandrailNode* view_ = nullptr;
    HandrailNode* focus_ = nullptr;  // has the keyboard while the window has: view_, or what is open
    std::string told_by_focus_;      // words that the reader says by itself, as the focus came to them
};

Accessible::Accessible(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Accessible::~Accessible() = default;

std::unique_ptr<Accessible> Accessible::start(std::shared_ptr<ReaderChannel> channel) {
    return std::unique_ptr<Accessible>(new Accessible(std::make_unique<Impl>(std::move(channel))));
}

void Accessible::set_focus(bool focused) { impl_->set_focus(focused); }
void Accessible::show(const DialogueView& dialogue) { impl_->show(dialogue); }
std::vector<ItemAct> Accessible::take_acts() { return impl_->take_acts(); }
std::uint64_t Accessible::offer(const KeyStroke& stroke) { return impl_->offer(stroke); }
KeyVerdict Accessible::verdict(std::uint64_t ticket) { return impl_->verdict(ticket); }

}  // namespace handrail
