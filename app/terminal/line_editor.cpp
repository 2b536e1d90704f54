#include "app/terminal/line_editor.h"

#include <utility>

#include "worlds/base/contract.h"
#include "worlds/base/text.h"

namespace handrail::terminal {
namespace {

constexpr std::string_view kBackOne = "\b \b";

// Removes the last UTF-8 character.
void drop_last(std::string& text) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) text.pop_back();
    if (!text.empty()) text.pop_back();
}

}  // namespace

std::string LineEditor::open(std::string_view prompt) {
    open_ = true;
    text_.clear();
    return std::string(prompt);
}

std::string LineEditor::close() {
    if (!std::exchange(open_, false)) return {};
    text_.clear();
    return "\n";
}

LineEditor::Reply LineEditor::take(const TerminalInput& input) {
    contract_pre(open_);
    if (input.key == "Escape") {
        const std::string end = close();
        return {end, {}, true, true};
    }
    if (input.key == "Enter") {
        std::string line = text_;
        return {close(), {std::move(line)}, false, true};
    }
    if (input.key == "Backspace") {
        if (text_.empty()) return {{}, {}, false, true};
        drop_last(text_);
        return {std::string(kBackOne), {}, false, true};
    }
    if (input.key == "Control+U") {
        std::string echo;
        for (; !text_.empty(); drop_last(text_)) echo += kBackOne;
        return {std::move(echo), {}, false, true};
    }
    if (input.text.empty()) return {};
    return take_text(input.text);
}

LineEditor::Reply LineEditor::take_text(std::string_view text) {
    Reply reply;
    reply.taken = true;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        const std::string part = one_line(text.substr(begin, end - begin));
        if (text_.size() + part.size() <= kLongest) {
            text_ += part;
            reply.echo += part;
        }
        if (end == text.size()) break;
        begin = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
        reply.lines.push_back(std::exchange(text_, {}));
        reply.echo += '\n';
    }
    // If the pasted text ends in a line end, that line end completes the line, as Enter does.
    if (!reply.lines.empty() && text_.empty()) open_ = false;
    return reply;
}

}  // namespace handrail::terminal
