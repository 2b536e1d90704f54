#include "worlds/exports/route_card.h"

#include <sstream>

#include "worlds/base/text.h"

namespace handrail::exports {

std::string card_text(const std::vector<CardRoute>& ways) {
    std::string text;
    for (const CardRoute& way : ways) {
        if (!text.empty()) text += "\n";
        for (const std::string& sentence : way) {
            std::istringstream words(sentence);
            std::size_t used = 0;
            for (std::string word; words >> word;) {
                const std::size_t width = characters_of(word).size();
                if (used > 0 && used + 1 + width > kCardCells) {
                    text += "\n  ";
                    used = 2;
                } else if (used > 0) {
                    text += ' ';
                    ++used;
                }
                text += word;
                used += width;
            }
            text += "\n";
        }
    }
    return text;
}

Result<std::string> card_brf(const std::vector<CardRoute>& ways, BrailleTable table) {
    std::string text;
    for (const CardRoute& way : ways) {
        if (!text.empty()) text += '\f';
        std::size_t line = 0;
        for (const std::string& sentence : way) {
            const Result<BrailleCells> cells = braille_of(sentence, table);
            if (!cells) return tl::unexpected(cells.error());
            for (const BrailleCells& cut : braille_lines(*cells, kCardCells, 2)) {
                if (line == kCardLines) {
                    text += '\f';
                    line = 0;
                }
                text += brf_of(cut) + "\r\n";
                ++line;
            }
        }
    }
    return text;
}

}  // namespace handrail::exports
