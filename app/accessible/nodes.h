// The objects of the window's tree as a screen reader sees them: GObject classes, so in C's manner, and what AtkUtil
// asks through plain functions. Accessibility thread only, one Accessible at a time.
#pragma once

#include <atk/atk.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "app/core/dialogue/dialogue.h"

namespace handrail {

// An object of the tree. Plain data beside what AtkObject keeps itself.
struct HandrailNode {
    AtkObject parent;
    std::vector<HandrailNode*>* children;  // owned references
    AtkStateSet* states;
    int actions;        // of an item: 0 none, 1 pressed, 3 also more and less
    std::string* text;  // of an entry: what is typed; of a quantity: its value in words
    ItemNumber number;  // of a quantity
};

inline HandrailNode* node_of(gpointer object) { return static_cast<HandrailNode*>(object); }

GType handrail_node_get_type();
GType handrail_frame_get_type();     // a window
GType handrail_item_get_type();      // of a list, to be pressed
GType handrail_quantity_get_type();  // an item that is a quantity as well
GType handrail_entry_get_type();     // of text, read only: what is typed goes through the program's own keys, and is
                                     // echoed by it

HandrailNode* make_node(GType type, AtkRole role, const char* name, HandrailNode* parent,
                        std::initializer_list<AtkStateType> states);
void set_state(HandrailNode* node, AtkStateType state, bool on);

// What a reader does with an item, by its place in the list. A number that it sets is the program's to judge.
struct ReaderCalls {
    std::function<void(std::size_t item, int action)> act;  // 0 press, 1 increase, 2 decrease
    std::function<void(std::size_t item, double number)> put;
};
void answer_reader(ReaderCalls calls);  // empty functions: nobody answers

// The root of the tree, made once and kept; AtkUtil asks for it from then on.
HandrailNode* root_node();
// Who hears keys: the reader, where it has asked for them.
struct KeyListener {
    AtkKeySnoopFunc listens = nullptr;
    gpointer data = nullptr;
};
const KeyListener& key_listener();

}  // namespace handrail
