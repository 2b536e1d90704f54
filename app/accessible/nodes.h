// Defines the objects that represent the window for a screen reader. They are GObject classes, hence the C style.
// AtkUtil calls plain functions, so the objects and functions are global, and only one Accessible may exist at a time.
// Accessibility thread only.
#pragma once

#include <atk/atk.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "app/core/dialogue/dialogue.h"

namespace handrail::accessible {

// An object of the tree. Its data are additional to what AtkObject itself stores.
struct HandrailNode {
    AtkObject parent;
    std::vector<HandrailNode*>* children;  // references that this object owns
    AtkStateSet* states;
    int actions;              // actions of an item: 0 none; 1 press; 3 also increase and decrease
    std::string* text;        // for an entry: the typed text; for a quantity: its value in words
    core::ItemNumber number;  // number of a quantity
};

inline HandrailNode* node_of(gpointer object) { return static_cast<HandrailNode*>(object); }

GType handrail_node_get_type();
GType handrail_frame_get_type();     // a window
GType handrail_item_get_type();      // an item of a list, which can be pressed
GType handrail_quantity_get_type();  // an item that also has a number
// A text entry that screen readers can read but not change. Typed characters go through the program's own keys, and the
// program echoes them.
GType handrail_entry_get_type();

HandrailNode* make_node(GType type, AtkRole role, const char* name, HandrailNode* parent,
                        std::initializer_list<AtkStateType> states);
void set_state(HandrailNode* node, AtkStateType state, bool on);

// Functions that are called when a screen reader acts on an item. `item` is the position of the item in the list. `put`
// receives any number, and the program decides whether it accepts that number.
struct ReaderCalls {
    std::function<void(std::size_t item, int action)> act;  // `action`: 0 press, 1 increase, 2 decrease
    std::function<void(std::size_t item, double number)> put;
};
void answer_reader(ReaderCalls calls);  // sets the functions; empty functions: calls are ignored

// Returns the root of the tree of objects. The first call makes the root, and AtkUtil returns it from then on.
HandrailNode* root_node();
// The function that receives keys. The screen reader registers it; `listens` is null if there is none.
struct KeyListener {
    AtkKeySnoopFunc listens = nullptr;
    gpointer data = nullptr;
};
const KeyListener& key_listener();

}  // namespace handrail::accessible
