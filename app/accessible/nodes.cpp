#include "app/accessible/nodes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "worlds/base/contract.h"

namespace handrail::accessible {

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
// An item that a reader can also read and set as a number.
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

namespace {

// Reports the whole window as the extent of every object, because nobody points into it.
void node_extents(AtkComponent*, gint* x, gint* y, gint* width, gint* height, AtkCoordType) {
    *x = *y = 0;
    *width = 960;
    *height = 720;
}
void node_component_init(gpointer interface, gpointer) {
    static_cast<AtkComponentIface*>(interface)->get_extents = node_extents;
}
void frame_window_init(gpointer, gpointer) {}

ReaderCalls the_calls;
constexpr std::array kActionNames{"press", "increase", "decrease"};

gint node_index(AtkObject* object);
gboolean item_act(AtkAction* object, gint action) {
    const gint index = node_index(static_cast<AtkObject*>(static_cast<gpointer>(object)));
    if (index < 0 || action < 0 || action >= node_of(object)->actions || !the_calls.act) return FALSE;
    the_calls.act(static_cast<std::size_t>(index), action);
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

// Returns the number of an item and its text. A reader may set any number; the item then stores the nearest value that
// it accepts.
void quantity_now(AtkValue* object, gdouble* now, gchar** words) {
    if (now) *now = node_of(object)->number.now;
    if (words) *words = g_strdup(node_of(object)->text->c_str());
}
AtkRange* quantity_range(AtkValue* object) {
    return atk_range_new(node_of(object)->number.least, node_of(object)->number.most, nullptr);
}
gdouble quantity_step(AtkValue* object) { return node_of(object)->number.step; }
void quantity_put(AtkValue* object, gdouble number) {
    if (const gint index = node_index(static_cast<AtkObject*>(static_cast<gpointer>(object)));
        index >= 0 && the_calls.put)
        the_calls.put(static_cast<std::size_t>(index), number);
}
void quantity_value_init(gpointer interface, gpointer) {
    auto* value = static_cast<AtkValueIface*>(interface);
    value->get_value_and_text = quantity_now;
    value->get_range = quantity_range;
    value->get_increment = quantity_step;
    value->set_value = quantity_put;
}

// Returns the typed text. A reader can read this text but not change it, because typed characters go through the
// program's own keys, and the program echoes them.
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

}  // namespace

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"  // GLib's macros contain casts in the style of C
G_DEFINE_TYPE_WITH_CODE(HandrailNode, handrail_node, ATK_TYPE_OBJECT,
                        G_IMPLEMENT_INTERFACE(ATK_TYPE_COMPONENT, node_component_init))
G_DEFINE_TYPE_WITH_CODE(HandrailFrame, handrail_frame, handrail_node_get_type(),
                        G_IMPLEMENT_INTERFACE(ATK_TYPE_WINDOW, frame_window_init))
G_DEFINE_TYPE_WITH_CODE(HandrailItem, handrail_item, handrail_node_get_type(),
                        G_IMPLEMENT_INTERFACE(ATK_TYPE_ACTION, item_action_init))
G_DEFINE_TYPE_WITH_CODE(HandrailQuantity, handrail_quantity, handrail_item_get_type(),
                        G_IMPLEMENT_INTERFACE(ATK_TYPE_VALUE, quantity_value_init))
G_DEFINE_TYPE_WITH_CODE(HandrailEntry, handrail_entry, handrail_node_get_type(),
                        G_IMPLEMENT_INTERFACE(ATK_TYPE_TEXT, entry_text_init))
#pragma GCC diagnostic pop

void handrail_node_init(HandrailNode* node) {
    node->children = new std::vector<HandrailNode*>;
    node->states = atk_state_set_new();
    node->actions = 0;
    node->text = new std::string;
    node->number = {};
}

namespace {

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

}  // namespace

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

HandrailNode* make_node(GType type, AtkRole role, const char* name, HandrailNode* parent,
                        std::initializer_list<AtkStateType> states) {
    HandrailNode* node = node_of(g_object_new(type, nullptr));
    atk_object_set_role(&node->parent, role);
    atk_object_set_name(&node->parent, name);
    // Set an empty description now, because the first description of an object causes no notification.
    atk_object_set_description(&node->parent, "");
    for (const AtkStateType state : states) atk_state_set_add_state(node->states, state);
    if (parent) {
        atk_object_set_parent(&node->parent, &parent->parent);
        parent->children->push_back(node);
    }
    return node;
}

void set_state(HandrailNode* node, AtkStateType state, bool on) {
    contract_pre(node);
    if (on) atk_state_set_add_state(node->states, state);
    else atk_state_set_remove_state(node->states, state);
    atk_object_notify_state_change(&node->parent, state, on);
}

void answer_reader(ReaderCalls calls) { the_calls = std::move(calls); }

// ---- functions that AtkUtil calls ----

namespace {

KeyListener the_listener;

AtkObject* util_root() { return &root_node()->parent; }
const gchar* util_toolkit() { return "handrail"; }
const gchar* util_version() { return "1"; }
guint util_add_listener(AtkKeySnoopFunc listener, gpointer data) {
    the_listener = {listener, data};
    return 1;
}
void util_remove_listener(guint) { the_listener.listens = nullptr; }

HandrailNode* make_root() {
    auto* util = static_cast<AtkUtilClass*>(g_type_class_ref(ATK_TYPE_UTIL));
    util->get_root = util_root;
    util->get_toolkit_name = util_toolkit;
    util->get_toolkit_version = util_version;
    util->add_key_event_listener = util_add_listener;
    util->remove_key_event_listener = util_remove_listener;
    return make_node(handrail_node_get_type(), ATK_ROLE_APPLICATION, "Handrail", nullptr,
                     {ATK_STATE_ENABLED, ATK_STATE_SENSITIVE});
}

}  // namespace

HandrailNode* root_node() {
    static HandrailNode* const root = make_root();
    return root;
}
const KeyListener& key_listener() { return the_listener; }

}  // namespace handrail::accessible
