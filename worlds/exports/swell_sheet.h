// Draws a storey for swell paper, on which black rises under heat. Walls are thick lines, objects thin ones, and stairs
// parallel lines. Rooms have two cells of braille that a key explains. Items that a finger could not tell apart are
// moved 3 mm apart, widened, shrunk or left out; a sentence reports each such change. Pure functions over plain values;
// any thread may call them. A sheet of A4 costs about a second.
//
// Numbers: 3 mm between separate things (1/8 inch) and 6.4 mm (1/4 inch) for the smallest symbol and doorway, as the
// American Printing House advises for tactile graphics. Braille 2.5 / 6.0 / 10.0 mm with dots of 1.5 mm, DIN 32976
// medium. We chose the widths of the two kinds of lines: one is half as wide again as the other.
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

// The options of a sheet.
struct SheetOptions {
    PaperSize paper = kA4;
    BrailleTable table = BrailleTable::EnUebG1;
    // Leaves out objects and the signs of rooms smaller than kCoarseRoom_m2. Only the key names such rooms, and their
    // doors may stay narrow.
    bool coarse = false;
    // For each entry of Storey::rooms: its sign on the plate, if this sheet is the key to a plate; otherwise empty.
    std::vector<std::string> plate_signs = {};
};
inline constexpr double kCoarseRoom_m2 = 6.0;

inline constexpr int kWallPart = 1;  // number of the part (SheetShape::part) to which all walls belong

// Returns the names of the rooms that only the storey's second plan shows; see Storey::hidden.
std::string hidden_names(const plan::Storey& storey);

struct SwellSheet {
    SheetPage plan;
    // Pages of braille with the meaning of signs and lines, and with sentences about what was simplified.
    std::vector<SheetPage> key;
    std::vector<std::string> key_text;    // the same key in print, one line each
    std::vector<std::string> simplified;  // sentences for the report about what was simplified
    // As room_signs returns them; a sign that does not fit is replaced by two letters or one.
    std::vector<RoomSign> signs;
    double one_to = 0.0;             // scale: 75 means 1 to 75
    OnPaper on_paper;                // converts places of the world to places on the plan
    std::vector<std::string> drawn;  // names of the objects on the sheet
    // Sentences about promises that this sheet does not keep; empty if it keeps all. The promises are 3 mm between
    // separate things, a sign in every room or its doors in the key, doors of 6.4 mm, and openings where the route
    // graph has them.
    std::vector<std::string> broken;
    std::optional<SheetPart> part;   // the part of the storey that the sheet shows, if there are several sheets
    std::vector<KeyLine> key_lines;  // the lines from which `key`, `key_text` and the description of the plan are made
    // For each room: index in key_lines; kNoKeyLine: the room is on another sheet.
    std::vector<std::size_t> key_line_of_room;
};
inline constexpr std::size_t kNoKeyLine = static_cast<std::size_t>(-1);

// Makes a single sheet, in portrait or landscape, whichever gives the larger scale. Fails with one sentence if the
// storey does not fit on a sheet at 1 to 1000, if there is nothing to draw, or if braille is not available.
Result<SwellSheet> swell_sheet(const plan::Storey& storey, const SheetOptions& options);
// Makes one of several sheets. `letters` contains, for every room, the shorter sign that it has on earlier sheets, or
// an empty string. The function adds the shorter signs of this sheet.
Result<SwellSheet> swell_sheet(const plan::Storey& storey, const SheetOptions& options, const SheetPart& part,
                               std::vector<std::string>& letters);
// Makes the pages of the key from its lines and from the sentences about simplifications and broken promises.
Result<void> write_key(SwellSheet& sheet, BrailleTable table);
// Makes a single sheet, or several sheets if a single one does not keep its promises. The sheets have the coarsest
// scale at which most rooms have space for a sign, and there are at most kMostSheets. Rooms that are too small at that
// scale also appear on further sheets, which show their surroundings at a larger scale; each key names these sheets. If
// no scale keeps all promises, the one that keeps most of them is used. Costs half a second for each sheet.
Result<std::vector<SwellSheet>> swell_sheets(const plan::Storey& storey, const SheetOptions& options);

// Makes a page with samples. It is printed and swollen first, so that people can choose the dots, lines and gaps that
// they feel best. It has dots of 1.2 to 1.8 mm, lines of 0.5 to 2 mm and gaps of 2 to 6 mm, each with its size in
// braille.
Result<SheetPage> calibration_strip(const PaperSize& paper, BrailleTable table);

}  // namespace handrail::exports
