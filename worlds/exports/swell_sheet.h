// A storey for swell paper: black rises under heat, so walls are thick lines, things thin ones, stairs lines side by
// side, and rooms have two cells of braille that a key explains. What a finger cannot part is kept 3 mm apart, made
// wider, made smaller or left out, and each of these is told in a sentence. Pure functions over plain values; any
// thread. A sheet of A4 takes about a second.
//
// Numbers: 3 mm between what is not joined (1/8 inch) and 6.4 mm (1/4 inch) for the smallest symbol and doorway, as the
// American Printing House advises for tactile graphics; braille 2.5 / 6.0 / 10.0 mm with dots of 1.5 mm, DIN 32976
// medium. Widths of lines are our own choice, two that differ by half.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "worlds/exports/braille.h"
#include "worlds/exports/braille_page.h"
#include "worlds/exports/room_signs.h"
#include "worlds/exports/sheet.h"
#include "worlds/exports/sheet_parts.h"
#include "worlds/exports/wall_ink.h"
#include "worlds/plan/storey.h"

namespace handrail {

inline constexpr double kLeastGap_mm = 3.0, kLeastSymbol_mm = 6.4, kWallLine_mm = 1.5, kThinLine_mm = 1.0;
inline constexpr double kBrailleDot_mm = 1.5, kBraillePitch_mm = 2.5, kBrailleCell_mm = 6.0, kBrailleLine_mm = 10.0;

// What somebody wants of a sheet.
struct SheetWish {
    PaperSize paper = kA4;
    BrailleTable table = BrailleTable::EnUebG1;
    bool coarse = false;  // no things, and no signs of rooms under kCoarseRoom_m2: the key alone names those
    std::vector<std::string> plate_signs = {};  // of a plate whose key this is, by place in Storey::rooms; may be empty
};
inline constexpr double kCoarseRoom_m2 = 6.0;

inline constexpr int kWallPart = 1;  // SheetShape::part of all walls

// The rooms that the storey's second plan shows; see Storey::hidden.
std::string hidden_names(const Storey& storey);

struct SwellSheet {
    SheetPage plan;
    std::vector<SheetPage> key;           // pages of braille: what signs and lines mean, and what was simplified
    std::vector<std::string> key_text;    // the same in print, a line each
    std::vector<std::string> simplified;  // sentences
    std::vector<RoomSign> signs;          // see room_signs; two letters or one where these have no room
    double one_to = 0.0;                  // 75: a scale of 1 to 75
    OnPaper on_paper;                     // where a place of the world is on the plan
    std::vector<std::string> drawn;       // names of the things that stand on it
    // Sentences on what every sheet promises and this one does not keep: 3 mm between what is not joined, a sign in
    // every room or its doors in the key, doors of 6.4 mm, openings where the route graph has them. Empty: it keeps
    // all.
    std::vector<std::string> broken;
    std::optional<SheetPart> part;              // of several sheets
    std::vector<KeyLine> key_lines;             // of which `key`, `key_text` and the text of the plan are made
    std::vector<std::size_t> key_line_of_room;  // its place there; kNoKeyLine where it is on another sheet
};
inline constexpr std::size_t kNoKeyLine = static_cast<std::size_t>(-1);

// Upright or across, whichever is larger. Fails with one sentence where the storey is larger than a sheet at 1 to 1000,
// where there is nothing to draw, and where braille cannot be had.
Result<SwellSheet> swell_sheet(const Storey& storey, const SheetWish& wish);
// One of several. `letters`: of every room the shorter sign that it has on sheets made before, or none; those of this
// sheet are added.
Result<SwellSheet> swell_sheet(const Storey& storey, const SheetWish& wish, const SheetPart& part,
                               std::vector<std::string>& letters);
// Makes the pages of the key of its lines, simplifications and broken promises.
Result<void> write_key(SwellSheet& sheet, BrailleTable table);
// The same on several sheets where one does not keep its promises: at the coarsest scale that gives most rooms their
// sign, at most kMostSheets. Rooms that are too small for it come on more sheets that show their surroundings larger,
// and each key says on which. Where no scale keeps all, the one that keeps most. Takes half a second a sheet.
Result<std::vector<SwellSheet>> swell_sheets(const Storey& storey, const SheetWish& wish);

// A page to be printed and swollen first, and chosen from by touch: dots of 1.2 to 1.8 mm, lines of 0.5 to 2 mm and
// gaps of 2 to 6 mm, each with its size in braille.
Result<SheetPage> calibration_strip(const PaperSize& paper, BrailleTable table);

}  // namespace handrail
