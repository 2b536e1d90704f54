#include "app/core/dialogue/key_sets.h"

#include <array>

namespace handrail::core {
namespace {

constexpr std::array kLeft{
    SetKeys{"forward", "W Up"},
    SetKeys{"back", "S Down"},
    SetKeys{"left", "A Left"},
    SetKeys{"right", "D Right"},
    SetKeys{"workspace-forward", "Control+W"},
    SetKeys{"workspace-back", "Control+S"},
    SetKeys{"workspace-left", "Control+A"},
    SetKeys{"workspace-right", "Control+D"},
    SetKeys{"workspace-up", "Control+T"},
    SetKeys{"workspace-down", "Control+B"},
    SetKeys{"workspace-centre", "N Control+Q"},
    SetKeys{"grab", "M Control+G"},
    SetKeys{"scale-bar", "6 Control+1"},
    SetKeys{"building", "F5 Control+2"},
    SetKeys{"floor", "F6 Control+3"},
    SetKeys{"room", "F7 Control+4"},
    SetKeys{"detail", "F8 Control+5"},
    SetKeys{"name-room", "Control+N Control+R"},
    SetKeys{"ways", "Control+7 Control+X"},
    SetKeys{"keep-way", "Control+8 Control+V"},
    SetKeys{"use", "Enter Control+E"},
    SetKeys{"home", "Home Control+F"},
    SetKeys{"last-place", "Control+0 Control+Z"},
    SetKeys{"stop", "F12 Shift+Grave"},
};

constexpr std::array kRight{
    SetKeys{"where", "F2 1 Control+L"},
    SetKeys{"around", "2 Control+J"},
    SetKeys{"ahead", "3 Control+I"},
    SetKeys{"look", "5 Control+K"},
    SetKeys{"look-back", "Shift+5 Control+U"},
    SetKeys{"what", "E Control+O"},
    SetKeys{"heading", "C Control+P"},
    SetKeys{"forces", "F Grave Control+Enter"},
    SetKeys{"frame", "F4 Control+F7"},
    SetKeys{"building", "F5 Control+F8"},
    SetKeys{"floor", "F6 Control+F9"},
    SetKeys{"verbosity", "V Control+M"},
    SetKeys{"help", "F1 Control+H"},
    SetKeys{"menu", "Tab Control+N"},
    SetKeys{"name-room", "Control+Y"},
    SetKeys{"workspace-forward", "W Control+Home"},
    SetKeys{"workspace-back", "S Control+End"},
    SetKeys{"workspace-left", "A Control+Delete"},
    SetKeys{"workspace-right", "D Control+PageDown"},
};

constexpr std::string_view kLeftHalf =
    " Grave 1 2 3 4 5 Q W E R T A S D F G Z X C V B F1 F2 F3 F4 F5 Tab Escape Space Control Shift Alt ";
constexpr std::string_view kRightHalf =
    " 6 7 8 9 0 Minus Equal Y U I O P LeftBracket RightBracket Backslash H J K L Semicolon Apostrophe N M Comma Period "
    "Slash F6 F7 F8 F9 F10 F11 F12 Up Down "
    "Left Right PageUp PageDown Home End Insert Delete Enter Backspace Space Control Shift Alt ";

}  // namespace

std::span<const SetKeys> keys_for(settings::KeyboardHand hand) {
    if (hand == settings::KeyboardHand::Left) return kLeft;
    if (hand == settings::KeyboardHand::Right) return kRight;
    return {};
}

bool reaches(settings::KeyboardHand hand, std::string_view key_name) {
    if (hand == settings::KeyboardHand::Both) return true;
    const std::string_view half = hand == settings::KeyboardHand::Left ? kLeftHalf : kRightHalf;
    const std::size_t plus = key_name.rfind('+');
    const std::string_view plain = plus == std::string_view::npos ? key_name : key_name.substr(plus + 1);
    for (std::size_t at = half.find(plain); at != std::string_view::npos; at = half.find(plain, at + 1))
        if (!plain.empty() && half[at - 1] == ' ' && half[at + plain.size()] == ' ') return true;
    return false;
}

}  // namespace handrail::core
