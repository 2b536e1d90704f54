// The objects of the window's tree for a screen reader. They are GObject classes, hence the C style, and AtkUtil calls
// plain functions. Accessibility thread only; one Accessible at a time.
#pragma once

#include <atk/atk.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "app/core/dialogue/dialogue.h"

namespace handrail::accessible {

// An object of the tree: plain data in addition to what AtkObject itself keeps.
struct HandrailNode {
    AtkObject parent;
    std::vector<HandrailNode*>* children;  // owned references
    AtkStateSet* states;
    int actions;              // of an item: 0 none, 1 press, 3 also increase and decrease
    std::string* text;        // for an entry: the typed text; for a quantity: its value in words
    core::ItemNumber number;  // for a quantity
};

inline HandrailNode* node_of(gpointer object) { return static_cast<HandrailNode*>(object); }

GType handrail_node_get_type();
GType handrail_frame_get_type();     // a window
GType handrail_item_get_type();      // an item of a list, which can be pressed
GType handrail_quantity_get_type();  // an item that also has a number
// A text entry, read-only: typed characters go through the program's own keys, and the program echoes them.
GType handrail_entry_get_type();

HandrailNode* make_node(GType type, AtkRole role, const char* name, HandrailNode* parent,
                        std::initializer_list<AtkStateType> states);
void set_state(HandrailNode* node, AtkStateType state, bool on);

// Called when a reader acts on an item, which is given by its place in the list. The program decides whether it accepts
// a number.
struct ReaderCalls {
    std::function<void(std::size_t item, int action)> act;  // 0 press, 1 increase, 2 decrease
    std::function<void(std::size_t item, double number)> put;
};
void answer_reader(ReaderCalls calls);  // empty functions: calls are ignored

// The root of the tree, made once and kept. AtkUtil returns it from then on.
HandrailNode* root_node();
// The function that receives keys: the screen reader's, if it has registered one.
struct KeyListener {
    AtkKeySnoopFunc listens = nullptr;
    gpointer data = nullptr;
};
const KeyListener& key_listener();

}  // namespace handrail::accessible
