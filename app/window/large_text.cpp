#include "app/window/large_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "worlds/base/contract.h"

namespace handrail::window {
namespace {

constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 255), kBlack = IM_COL32(0, 0, 0, 255);
constexpr std::size_t kMostTitleLines = 2;

float width_of(ImFont& font, float line_px, std::string_view text) {
    return font.CalcTextSizeA(line_px, 1e9F, 0.0F, text.data(), text.data() + text.size()).x;
}

void put(ImDrawList& list, ImFont& font, float line_px, ImVec2 at, ImU32 colour, std::string_view text) {
    list.AddText(&font, line_px, at, colour, text.data(), text.data() + text.size());
}

// Shortens the text so that it fits on one line. Adds three dots if something is left out.
std::string cut_short(ImFont& font, float line_px, const std::string& text, float wrap_px) {
    if (width_of(font, line_px, text) <= wrap_px) return text;
    const auto lines = wrapped_lines(font, line_px, text, std::max(line_px, wrap_px - width_of(font, line_px, " ...")));
    return std::string(lines.front()) + " ...";
}

std::string words_of(const core::ListItem& item) {
    return item.value.empty() ? item.name : fmt::format("{}, {}", item.name, item.value);
}

void draw_arrow(ImDrawList& list, ImVec2 middle, float half_px, bool up) {
    const float tip = up ? -half_px : half_px;
    // The corners are clockwise as seen, as ImGui requires for smooth borders.
    if (up)
        list.AddTriangleFilled({middle.x, middle.y + tip}, {middle.x + half_px, middle.y - tip},
                               {middle.x - half_px, middle.y - tip}, kWhite);
    else
        list.AddTriangleFilled({middle.x, middle.y + tip}, {middle.x - half_px, middle.y - tip},
                               {middle.x + half_px, middle.y - tip}, kWhite);
}

}  // namespace

std::vector<std::string_view> wrapped_lines(ImFont& font, float line_px, const std::string& text, float wrap_px) {
    std::vector<std::string_view> lines;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
#if IMGUI_VERSION_NUM >= 19200  // from this version on, fonts have no fixed size
        const char* stop = font.CalcWordWrapPosition(line_px, at, end, wrap_px);
#else
        const char* stop = font.CalcWordWrapPositionA(line_px / font.FontSize, at, end, wrap_px);
#endif
        if (stop == at) ++stop;  // not even one letter fits, so put one letter on the line in any case
        const char* newline = std::find(at, stop, '\n');
        lines.emplace_back(at, static_cast<std::size_t>(newline - at));
        at = newline < stop ? newline + 1 : stop;
        while (at < end && *at == ' ') ++at;
    }
    return lines;
}

ListWindow list_window(std::span<const std::size_t> lines, std::size_t at, std::size_t room_lines) {
    if (lines.empty()) return {};
    contract_pre(at < lines.size());
    ListWindow window{at, 1};
    std::size_t used = lines[at];
    // Add neighbours of the current item on alternate sides, beginning with the next item, until none fits on either
    // side.
    for (bool more = true; more;) {
        more = false;
        if (const std::size_t after = window.first + window.count;
            after < lines.size() && used + lines[after] <= room_lines) {
            used += lines[after];
            ++window.count;
            more = true;
        }
        if (window.first > 0 && used + lines[window.first - 1] <= room_lines) {
            used += lines[--window.first];
            ++window.count;
            more = true;
        }
    }
    return window;
}

void draw_dialogue(ImDrawList& list, ImFont& font, const core::DialogueView& dialogue, ImVec2 min_px, ImVec2 max_px,
                   float line_px) {
    if (dialogue.kind == core::DialogueView::Kind::None || max_px.x - min_px.x < 3.0F * line_px ||
        max_px.y - min_px.y < 2.0F * line_px)
        return;
    const bool is_list = dialogue.kind == core::DialogueView::Kind::List;
    list.AddRectFilled(min_px, max_px, kBlack);
    const float margin = line_px / 6.0F, pointer_px = 0.8F * line_px;
    const float left = min_px.x + margin, right = max_px.x - margin;
    const std::string place = is_list && !dialogue.items.empty()
                                  ? fmt::format("{}/{}", dialogue.at + 1, dialogue.items.size())
                                  : std::string();
    const float place_px = place.empty() ? 0.0F : width_of(font, line_px, place) + line_px;

    // Draw the title. The title of a question is cut so that space for the answer remains.
    float y = min_px.y + margin;
    const std::size_t most_title =
        is_list ? kMostTitleLines : static_cast<std::size_t>(std::max(1.0F, (max_px.y - y) / line_px - 2.0F));
    const auto title = wrapped_lines(font, line_px, dialogue.title, std::max(line_px, right - left - place_px));
    for (std::size_t i = 0; i < std::min(title.size(), most_title); ++i, y += line_px)
        put(list, font, line_px, {left, y}, kWhite,
            i + 1 == most_title && i + 1 < title.size() ? std::string(title[i]) + " ..." : std::string(title[i]));
    if (!place.empty()) put(list, font, line_px, {right - place_px + line_px, min_px.y + margin}, kWhite, place);
    y += margin;
    list.AddRectFilled({left, y}, {right, y + std::max(2.0F, line_px / 16.0F)}, kWhite);
    y += 2.0F * margin;

    if (!is_list) {
        // Draw the typed text in a frame, with a bar after the last letter.
        const float text_px = right - left - 4.0F * margin, frame_px = std::max(2.0F, line_px / 16.0F);
        std::string_view end = dialogue.text;
        while (!end.empty() && width_of(font, line_px, end) > text_px) {
            end.remove_prefix(1);
            while (!end.empty() && (static_cast<unsigned char>(end.front()) & 0xC0U) == 0x80U) end.remove_prefix(1);
        }
        list.AddRect({left, y}, {right, y + line_px + 2.0F * margin}, kWhite, 0.0F, 0, frame_px);
        put(list, font, line_px, {left + margin, y + margin}, kWhite, end);
        const float caret = left + 1.5F * margin + width_of(font, line_px, end);
        list.AddRectFilled({caret, y + margin}, {caret + 2.0F * frame_px, y + margin + line_px}, kWhite);
        return;
    }

    const float wrap_px = std::max(line_px, right - left - 2.0F * pointer_px);
    const auto room = static_cast<std::size_t>(std::max(1.0F, (max_px.y - margin - y) / line_px));
    std::vector<std::size_t> lines(dialogue.items.size(), 1);
    std::vector<std::string_view> chosen;
    std::string chosen_words;
    if (dialogue.at < dialogue.items.size()) {
        chosen_words = words_of(dialogue.items[dialogue.at]);
        chosen = wrapped_lines(font, line_px, chosen_words, wrap_px);
        if (chosen.size() > room) chosen.resize(room);
        lines[dialogue.at] = std::max<std::size_t>(1, chosen.size());
    }
    const ListWindow window = list_window(lines, std::min(dialogue.at, dialogue.items.size() - 1), room);
    if (window.first > 0) draw_arrow(list, {right - 0.5F * pointer_px, y + 0.5F * line_px}, 0.3F * line_px, true);
    for (std::size_t i = window.first; i < window.first + window.count; ++i) {
        const float high = static_cast<float>(lines[i]) * line_px;
        if (i == dialogue.at) {
            list.AddRectFilled({left, y}, {right - 1.5F * pointer_px, y + high}, kWhite);
            const float middle = y + 0.5F * line_px, half = 0.28F * line_px;
            list.AddTriangleFilled({left + 0.2F * pointer_px, middle - half}, {left + 0.85F * pointer_px, middle},
                                   {left + 0.2F * pointer_px, middle + half}, kBlack);
            for (std::size_t n = 0; n < chosen.size(); ++n)
                put(list, font, line_px, {left + pointer_px, y + static_cast<float>(n) * line_px}, kBlack, chosen[n]);
        } else {
            put(list, font, line_px, {left + pointer_px, y}, kWhite,
                cut_short(font, line_px, words_of(dialogue.items[i]), wrap_px));
        }
        y += high;
    }
    if (window.first + window.count < dialogue.items.size())
        draw_arrow(list, {right - 0.5F * pointer_px, y - 0.5F * line_px}, 0.3F * line_px, false);
}

}  // namespace handrail::window
