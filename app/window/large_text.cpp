#include "app/window/large_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/window/drawn_colour.h"
#include "worlds/base/contract.h"

namespace handrail::window {
namespace {

constexpr std::size_t kMostTitleLines = 2;

float width_of(ImFont& font, float line_px, std::string_view text) {
    return font.CalcTextSizeA(line_px, 1e9F, 0.0F, text.data(), text.data() + text.size()).x;
}

void put(ImDrawList& list, ImFont& font, float line_px, ImVec2 at, ImU32 colour, std::string_view text) {
    list.AddText(&font, line_px, at, colour, text.data(), text.data() + text.size());
}

// Shortens the text so that it fits on one line. Adds three dots if something is left out.
std::string cut_short(ImFont& font, float line_px, const std::string& text, float wrap_px) {
    if (text.empty() || width_of(font, line_px, text) <= wrap_px) return text;
    const auto lines = wrapped_lines(font, line_px, text, std::max(line_px, wrap_px - width_of(font, line_px, " ...")));
    return std::string(lines.front()) + " ...";
}

std::string words_of(const core::ListItem& item) {
    return item.value.empty() ? item.name : fmt::format("{}, {}", item.name, item.value);
}

void draw_arrow(ImDrawList& list, ImVec2 middle, float half_px, bool up, ImU32 colour) {
    const float tip = up ? -half_px : half_px;
    // The corners are clockwise as seen, as ImGui requires for smooth borders.
    if (up)
        list.AddTriangleFilled({middle.x, middle.y + tip}, {middle.x + half_px, middle.y - tip},
                               {middle.x - half_px, middle.y - tip}, colour);
    else
        list.AddTriangleFilled({middle.x, middle.y + tip}, {middle.x - half_px, middle.y - tip},
                               {middle.x + half_px, middle.y - tip}, colour);
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

std::vector<TextLine> message_lines(ImFont& font, const std::vector<std::string>& messages,
                                    const WindowLayout& layout) {
    constexpr std::size_t kMostLarge = 2;
    std::vector<TextLine> shown;
    if (messages.empty()) return shown;
    const Vec2 size_px = layout.messages.max_px - layout.messages.min_px;
    const float wrap_px = std::max(layout.line_px, static_cast<float>(size_px.x));
    float left_px = static_cast<float>(size_px.y);
    const auto add = [&](const std::string& text, float high_px, std::size_t most) {
        const auto lines = wrapped_lines(font, high_px, text, wrap_px);
        const std::size_t count = std::min(lines.size(), most);
        for (std::size_t i = 0; i < count; ++i) {
            const bool cut = i + 1 == count && count < lines.size();
            const std::string rest(lines[i].data(), text.data() + text.size());
            shown.push_back({cut ? cut_short(font, high_px, rest, wrap_px) : std::string(lines[i]), high_px});
            left_px -= high_px;
        }
    };
    const auto rows_left = [&] { return static_cast<std::size_t>(std::max(0.0F, left_px / layout.small_px)); };
    const std::string& newest = messages.back();
    if (wrapped_lines(font, layout.line_px, newest, wrap_px).size() <= kMostLarge)
        add(newest, layout.line_px, kMostLarge);
    else add(newest, layout.small_px, rows_left());
    for (std::size_t older = messages.size() - 1; older-- > 0;) {
        const std::size_t rows = rows_left();
        if (rows == 0) break;
        add(messages[older], layout.small_px, rows > older ? rows - older : 1);
    }
    return shown;
}

void draw_messages(ImDrawList& list, ImFont& font, const std::vector<std::string>& messages, const WindowLayout& layout,
                   const Palette& palette) {
    ImVec2 at(static_cast<float>(layout.messages.min_px.x), static_cast<float>(layout.messages.min_px.y));
    for (const TextLine& line : message_lines(font, messages, layout)) {
        put(list, font, line.high_px, at, colour_of(palette.text), line.text);
        at.y += line.high_px;
    }
}

float status_px(ImFont& font, const std::string& text, float wide_px, float small_px) {
    constexpr float kLeastPart = 0.6F;
    const float all_px = width_of(font, small_px, text);
    return all_px <= wide_px ? small_px : std::max(kLeastPart, wide_px / all_px) * small_px;
}

void draw_status(ImDrawList& list, ImFont& font, std::span<const std::string> texts, const WindowLayout& layout,
                 const Palette& palette) {
    const auto left = static_cast<float>(layout.status.min_px.x), right = static_cast<float>(layout.status.max_px.x);
    float y = static_cast<float>(layout.status.min_px.y);
    // A line between the status and the messages, and one between the status and the pictures.
    for (const double edge : {0.5 * (layout.pictures.max_px.y + layout.status.min_px.y),
                              0.5 * (layout.status.max_px.y + layout.messages.min_px.y)})
        list.AddLine({left, static_cast<float>(edge)}, {right, static_cast<float>(edge)}, colour_of(palette.text));
    const float wide_px = std::max(layout.small_px, right - left);
    for (const std::string& text : texts) {
        const float high_px = status_px(font, text, wide_px, layout.small_px);
        if (!text.empty())
            put(list, font, high_px, {left, y}, colour_of(palette.text), cut_short(font, high_px, text, wide_px));
        y += layout.small_px;
    }
}

void draw_dialogue(ImDrawList& list, ImFont& font, const core::DialogueView& dialogue, ImVec2 min_px, ImVec2 max_px,
                   float line_px, const Palette& palette) {
    if (dialogue.kind == core::DialogueView::Kind::None || max_px.x - min_px.x < 3.0F * line_px ||
        max_px.y - min_px.y < 2.0F * line_px)
        return;
    const ImU32 text_colour = colour_of(palette.text), ground_colour = colour_of(palette.ground);
    const bool is_list = dialogue.kind == core::DialogueView::Kind::List;
    list.AddRectFilled(min_px, max_px, ground_colour);
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
        put(list, font, line_px, {left, y}, text_colour,
            i + 1 == most_title && i + 1 < title.size() ? std::string(title[i]) + " ..." : std::string(title[i]));
    if (!place.empty()) put(list, font, line_px, {right - place_px + line_px, min_px.y + margin}, text_colour, place);
    y += margin;
    list.AddRectFilled({left, y}, {right, y + std::max(2.0F, line_px / 16.0F)}, text_colour);
    y += 2.0F * margin;

    if (!is_list) {
        // Draw the typed text in a frame, with a bar after the last letter.
        const float text_px = right - left - 4.0F * margin, frame_px = std::max(2.0F, line_px / 16.0F);
        std::string_view end = dialogue.text;
        while (!end.empty() && width_of(font, line_px, end) > text_px) {
            end.remove_prefix(1);
            while (!end.empty() && (static_cast<unsigned char>(end.front()) & 0xC0U) == 0x80U) end.remove_prefix(1);
        }
        list.AddRect({left, y}, {right, y + line_px + 2.0F * margin}, text_colour, 0.0F, 0, frame_px);
        put(list, font, line_px, {left + margin, y + margin}, text_colour, end);
        const float caret = left + 1.5F * margin + width_of(font, line_px, end);
        list.AddRectFilled({caret, y + margin}, {caret + 2.0F * frame_px, y + margin + line_px}, text_colour);
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
    if (window.first > 0)
        draw_arrow(list, {right - 0.5F * pointer_px, y + 0.5F * line_px}, 0.3F * line_px, true, text_colour);
    for (std::size_t i = window.first; i < window.first + window.count; ++i) {
        const float high = static_cast<float>(lines[i]) * line_px;
        if (i == dialogue.at) {
            list.AddRectFilled({left, y}, {right - 1.5F * pointer_px, y + high}, text_colour);
            const float middle = y + 0.5F * line_px, half = 0.28F * line_px;
            list.AddTriangleFilled({left + 0.2F * pointer_px, middle - half}, {left + 0.85F * pointer_px, middle},
                                   {left + 0.2F * pointer_px, middle + half}, ground_colour);
            for (std::size_t n = 0; n < chosen.size(); ++n)
                put(list, font, line_px, {left + pointer_px, y + static_cast<float>(n) * line_px}, ground_colour,
                    chosen[n]);
        } else {
            put(list, font, line_px, {left + pointer_px, y}, text_colour,
                cut_short(font, line_px, words_of(dialogue.items[i]), wrap_px));
        }
        y += high;
    }
    if (window.first + window.count < dialogue.items.size())
        draw_arrow(list, {right - 0.5F * pointer_px, y - 0.5F * line_px}, 0.3F * line_px, false, text_colour);
}

}  // namespace handrail::window
