// A storey for swell paper, on which black rises under heat. Walls are thick lines, objects thin ones, and stairs
// parallel lines; rooms have two cells of braille that a key explains. What a finger cannot tell apart is kept 3 mm
// apart, widened, shrunk or left out, and each such change is reported in a sentence. Pure functions over plain values;
// any thread. A sheet of A4 takes about a second.
//
// Numbers: 3 mm between separate things (1/8 inch) and 6.4 mm (1/4 inch) for the smallest symbol and doorway, as the
// American Printing House advises for tactile graphics. Braille 2.5 / 6.0 / 10.0 mm with dots of 1.5 mm, DIN 32976
// medium. The widths of lines are our own choice: two that differ by half.
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

namespace handrail::exports {

inline constexpr double kLeastGap_mm = 3.0, kLeastSymbol_mm = 6.4, kWallLine_mm = 1.5, kThinLine_mm = 1.0;
inline constexpr double kBrailleDot_mm = 1.5, kBraillePitch_mm = 2.5, kBrailleCell_mm = 6.0, kBrailleLine_mm = 10.0;

// What is requested of a sheet.
struct SheetWish {
    PaperSize paper = kA4;
    BrailleTable table = BrailleTable::EnUebG1;
    // No things, and no signs of rooms under kCoarseRoom_m2, whose doors may stay narrow: the key alone names those.
    bool coarse = false;
    std::vector<std::string> plate_signs = {};  // of a plate whose key this is, by place in Storey::rooms; may be empty
};
inline constexpr double kCoarseRoom_m2 = 6.0;

inline constexpr int kWallPart = 1;  // SheetShape::part of all walls

// The names of the rooms that the storey's second plan shows; see Storey::hidden.
std::string hidden_names(const plan::Storey& storey);

struct SwellSheet {
    SheetPage plan;
    std::vector<SheetPage> key;           // pages of braille: meaning of signs and lines, and what was simplified
    std::vector<std::string> key_text;    // the same in print, one line each
    std::vector<std::string> simplified;  // sentences for the report
    std::vector<RoomSign> signs;          // see room_signs; two letters or one if there is no space for these
    double one_to = 0.0;                  // 75 means a scale of 1 to 75
    OnPaper on_paper;                     // converts places of the world to places on the plan
    std::vector<std::string> drawn;       // names of the objects on it
    // Sentences about promises that this sheet does not keep; empty: it keeps all. The promises: 3 mm between separate
    // things, a sign in every room or its doors in the key, doors of 6.4 mm, and openings where the route graph has
    // them.
    std::vector<std::string> broken;
    std::optional<SheetPart> part;              // if there are several sheets
    std::vector<KeyLine> key_lines;             // the source of `key`, `key_text` and the text of the plan
    std::vector<std::size_t> key_line_of_room;  // index in key_lines; kNoKeyLine: the room is on another sheet
};
inline constexpr std::size_t kNoKeyLine = static_cast<std::size_t>(-1);

// In portrait or landscape, whichever gives the larger scale. Fails with one sentence if the storey is larger than a
// sheet at 1 to 1000, if there is nothing to draw, or if braille is not available.
Result<SwellSheet> swell_sheet(const plan::Storey& storey, const SheetWish& wish);
// Makes one of several sheets. `letters`: for every room, the shorter sign that it has on earlier sheets, or nothing;
// the signs of this sheet are added.
Result<SwellSheet> swell_sheet(const plan::Storey& storey, const SheetWish& wish, const SheetPart& part,
                               std::vector<std::string>& letters);
// Makes the pages of the key from its lines, simplifications and broken promises.
Result<void> write_key(SwellSheet& sheet, BrailleTable table);
// The same on several sheets, if a single one does not keep its promises. The sheets have the coarsest scale that gives
// most rooms their sign, and there are at most kMostSheets. Rooms that are too small at that scale appear on more
// sheets, which show their surroundings larger, and each key says on which. If no scale keeps all promises, the one
// that keeps the most is used. Takes half a second for each sheet.
Result<std::vector<SwellSheet>> swell_sheets(const plan::Storey& storey, const SheetWish& wish);

// A page to be printed and swollen first, to choose from by touch. It has dots of 1.2 to 1.8 mm, lines of 0.5 to 2 mm
// and gaps of 2 to 6 mm, each with its size in braille.
Result<SheetPage> calibration_strip(const PaperSize& paper, BrailleTable table);

}  // namespace handrail::exports
