// Opens lists to choose from and questions to answer, and announces their first words. App thread only.
#pragma once

#include <functional>
#include <utility>

#include "app/core/context/cues.h"
#include "app/core/dialogue/dialogue.h"

namespace handrail::core {

class Lists {
public:
    explicit Lists(Cues& cues) : cues_(cues) {}

    void open(ListSpec list, double now_s) {
        if (before_open) before_open();
        cues_.answer(dialogue.open(std::move(list)), now_s);
    }
    void ask(TextSpec question, double now_s) {
        if (before_open) before_open();
        cues_.answer(dialogue.ask(std::move(question)), now_s);
    }

    Dialogue dialogue;
    std::function<void()> before_open;  // set by the session: from then on keys go to the list, so the walker stops

private:
    Cues& cues_;
};

}  // namespace handrail::core
