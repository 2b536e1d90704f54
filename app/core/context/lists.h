// Opens lists of choices and questions to the person, and announces their first words. Use it on the app thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "app/core/context/cues.h"
#include "app/core/dialogue/dialogue.h"

namespace handrail::core {

class Lists {
public:
    explicit Lists(Cues& cues) : cues_(cues) {}

    void open(ListSpec list, double now_s) {
        if (before_open) before_open();
        if (takes_) return void(taken_ = std::move(list));
        if (const auto name = std::exchange(awaited_, std::nullopt))
            if (const auto at = entry_called(list, *name); at && list.chosen) return list.chosen(*at);
        cues_.answer(dialogue.open(std::move(list)), now_s);
    }
    void request_text(TextSpec question, double now_s) {
        if (before_open) before_open();
        cues_.answer(dialogue.request_text(std::move(question)), now_s);
    }

    // Returns the list that `opens` opens, without opening or announcing it, because the person has already said what
    // to choose in it. Returns no value if `opens` opens no list.
    std::optional<ListSpec> take(const std::function<void()>& opens) {
        takes_ = true;
        opens();
        takes_ = false;
        return std::exchange(taken_, std::nullopt);
    }

    // The next list that opens is one that the owner opens later. Chooses this name in it, or opens it if the name is
    // not in it.
    void choose_when_opened(std::string name) { awaited_ = std::move(name); }

    Dialogue dialogue;
    // The session sets this function. It is called before a list opens, and stops the walker because keys then go to
    // the list.
    std::function<void()> before_open;

private:
    Cues& cues_;
    bool takes_ = false;
    std::optional<ListSpec> taken_;
    std::optional<std::string> awaited_;
};

}  // namespace handrail::core
