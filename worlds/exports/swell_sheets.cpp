#include <algorithm>
#include <limits>
#include <map>

#include "worlds/base/language.h"
#include "worlds/exports/names.h"
#include "worlds/exports/swell_sheet.h"

namespace handrail::exports {
namespace {

// kWithOneCell: at the chosen scale, at least this share of the rooms has space for one cell of braille. kMostLetters:
// at most this many rooms of a sheet have a single letter as their sign, because only 25 letters are usable.
constexpr double kWithOneCell = 0.7;
constexpr std::size_t kMostLetters = 20;
constexpr int kScalesTried = 2;  // number of scales to try if the first one breaks promises that do not concern signs
constexpr int kMostLarger = 10;  // most larger sheets to try for rooms that are too small on the other sheets
// A room that needs a scale of 1 to 50 or larger for one braille cell gets no larger sheet. Otherwise, a shaft half a
// metre wide would get a sheet to itself.
constexpr double kFinestLarger = 50.0;
constexpr double kAroundSmall_m = 2.0;  // margin around the rooms on a larger sheet
// Space needed on either side of a sign, for its clearance and for thickened walls.
constexpr double kNextToSign_mm = 3.7;

Vec2 needed_mm(std::size_t cells) { return braille_size_mm(cells) + Vec2(2.0 * kNextToSign_mm); }

// Makes the sheets of one storey. First come sheets of one scale that cover the storey, then larger sheets of the rooms
// that are too small on the first sheets.
class SheetsMaker {
public:
    SheetsMaker(const plan::Storey& storey, const SheetOptions& options)
        : storey_(storey),
          options_(options),
          scales_(kSheetScales.begin(), kSheetScales.end()),
          for_one_cell_(scales_needed(storey, scales_, needed_mm(1))),
          for_sign_(for_whole_signs()) {}

    // Returns an empty list if every scale needs too many sheets.
    Result<std::vector<SwellSheet>> make() {
        std::size_t least = std::numeric_limits<std::size_t>::max();
        std::vector<SwellSheet> best;
        int tried = 0;
        for (std::size_t scale = first_scale() + 1; scale-- > 0 && tried < kScalesTried && least > 0;) {
            std::vector<SheetPart> parts = parts_of(storey_, options_.paper, scales_[scale]);
            if (parts.empty()) break;
            ++tried;
            const Result<std::size_t> broken_here = draw(parts, least);
            if (!broken_here) return tl::unexpected(broken_here.error());
            const std::size_t broken = *broken_here;
            if (broken >= least) continue;
            least = broken;
            best = sheets_;
            best_letters_ = letters_;
        }
        sheets_ = std::move(best);
        letters_ = std::move(best_letters_);
        if (sheets_.empty()) return std::move(sheets_);
        if (Result<void> added = add_larger(); !added) return tl::unexpected(added.error());
        if (Result<void> ended = write_keys(); !ended) return tl::unexpected(ended.error());
        return std::move(sheets_);
    }

private:
    bool needs_sign(std::size_t room) const {
        return !storey_.rooms[room].shut && !storey_.rooms[room].elsewhere &&
               !(options_.coarse && storey_.rooms[room].area_m2 < kCoarseRoom_m2);
    }

    // Returns, for each room, the scale at which its sign fits. A sign with a number needs only the space of two cells,
    // because two letters can replace it.
    std::vector<double> for_whole_signs() const {
        std::vector<double> needed(storey_.rooms.size(), 0.0);
        std::map<std::size_t, std::vector<double>> of_cells;
        const std::vector<RoomSign> signs = room_signs(storey_);
        for (std::size_t i = 0; i < needed.size(); ++i) {
            const Result<BrailleCells> cells = braille_signs(signs[i].sign, options_.table);
            if (!cells) continue;  // the makers of the sheets report this error, so it is ignored here
            const std::size_t most = std::min<std::size_t>(cells->size(), 2);
            std::vector<double>& known = of_cells[most];
            if (known.empty()) known = scales_needed(storey_, scales_, needed_mm(most));
            needed[i] = known[i];
        }
        return needed;
    }

    // Returns the number of rooms that have space for only one letter at that scale.
    std::size_t letters_at(std::size_t scale) const {
        std::size_t letters = 0;
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i)
            letters += needs_sign(i) && for_one_cell_[i] >= scales_[scale] && for_sign_[i] < scales_[scale] ? 1 : 0;
        return letters;
    }

    // Returns the coarsest scale at which the given share of the rooms has enough space.
    double needed_by(const std::vector<double>& of_room, double share) const {
        std::vector<double> needed;
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i)
            if (needs_sign(i) && storey_.rooms[i].kind != navigation::RoomKind::Stairs && of_room[i] > 0.0)
                needed.push_back(of_room[i]);
        std::sort(needed.begin(), needed.end());
        const auto last = static_cast<double>(needed.size()) - 1.0;
        return needed.empty() ? scales_.back() : needed[static_cast<std::size_t>(last * (1.0 - share))];
    }

    // Returns the scale to try first. It starts with the coarsest scale that most rooms need and that needs no more
    // than kMostSheets. Then it goes on to the finest scale with the same number of sheets.
    std::size_t first_scale() const {
        const double most = needed_by(for_one_cell_, kWithOneCell);
        std::size_t scale = 0;
        while (scale + 1 < scales_.size() && scales_[scale + 1] <= most) ++scale;
        const auto sheets_at = [&](std::size_t at) { return parts_of(storey_, options_.paper, scales_[at]).size(); };
        while (scale + 1 < scales_.size() && sheets_at(scale) == 0) ++scale;
        while (scale > 0 && letters_at(scale) > kMostLetters * sheets_at(scale) && sheets_at(scale - 1) > 0) --scale;
        const std::size_t sheets = sheets_at(scale);
        while (scale > 0 && sheets > 0 && sheets_at(scale - 1) == sheets) --scale;
        return scale;
    }

    // Draws the sheets and returns how many promises they break. Stops as soon as the number reaches `most`.
    Result<std::size_t> draw(const std::vector<SheetPart>& parts, std::size_t most) {
        sheets_.clear();
        letters_.clear();
        std::size_t broken = 0;
        for (const SheetPart& part : parts) {
            Result<SwellSheet> sheet = swell_sheet(storey_, options_, part, letters_);
            if (!sheet) return tl::unexpected(sheet.error());
            broken += sheet->broken.size();
            sheets_.push_back(std::move(*sheet));
            if (broken >= most) break;
        }
        return broken;
    }

    bool is_known(std::size_t room) const {
        return std::any_of(sheets_.begin(), sheets_.end(),
                           [&](const SwellSheet& sheet) { return sheet.signs[room].is_known(); });
    }

    std::vector<std::size_t> unknown() const {
        std::vector<std::size_t> rooms;
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i)
            if (needs_sign(i) && !is_known(i)) rooms.push_back(i);
        return rooms;
    }

    // Adds larger sheets. Neighbouring rooms that need about the same scale are on one sheet. If a sign still does not
    // fit, tries a finer scale once more.
    Result<void> add_larger() {
        std::vector<std::size_t> at_scale(storey_.rooms.size(), 0), tried(storey_.rooms.size(), 0);
        for (std::size_t i = 0; i < at_scale.size(); ++i)
            while (at_scale[i] + 1 < scales_.size() && scales_[at_scale[i] + 1] < for_one_cell_[i]) ++at_scale[i];
        for (int larger = 0; larger < kMostLarger && static_cast<int>(sheets_.size()) < kMostSheets; ++larger) {
            std::vector<std::size_t> rooms = unknown();
            std::erase_if(rooms,
                          [&](std::size_t room) { return for_one_cell_[room] <= kFinestLarger || tried[room] >= 2; });
            if (rooms.empty()) break;
            const std::size_t first = *std::max_element(
                rooms.begin(), rooms.end(), [&](std::size_t a, std::size_t b) { return at_scale[a] < at_scale[b]; });
            std::erase_if(rooms, [&](std::size_t room) { return at_scale[room] + 1 < at_scale[first]; });
            const std::size_t scale = at_scale[first] - (at_scale[first] > 0 ? 1 : 0);
            const auto [part, shown] = larger_part(first, rooms, scales_[scale]);
            Result<SwellSheet> sheet = swell_sheet(storey_, options_, part, letters_);
            if (!sheet) return tl::unexpected(sheet.error());
            bool helped = false;
            for (const std::size_t room : shown) {
                helped = helped || sheet->signs[room].is_known();
                ++tried[room];
                at_scale[room] -= at_scale[room] > 0 ? 1 : 0;
            }
            if (helped && sheet->broken.empty()) sheets_.push_back(std::move(*sheet));
        }
        return {};
    }

    struct LargerPart {
        SheetPart part;
        std::vector<std::size_t> rooms;
    };

    LargerPart larger_part(std::size_t first, std::vector<std::size_t> rooms, double one_to) const {
        const Vec2 around(kAroundSmall_m), middle = storey_.rooms[first].middle_m;
        const auto far = [&](std::size_t room) { return glm::distance(storey_.rooms[room].middle_m, middle); };
        std::sort(rooms.begin(), rooms.end(),
                  [&](std::size_t a, std::size_t b) { return a == first || (b != first && far(a) < far(b)); });
        const auto fits = [&](const Vec2& size) {
            return std::any_of(std::begin(kWays), std::end(kWays), [&](bool across) {
                const Vec2 page = room_on_page(options_.paper, across, true) * (one_to / 1000.0);
                return size.x <= page.x && size.y <= page.y;
            });
        };
        LargerPart made;
        Vec2 low = storey_.rooms[first].min_m - around, high = storey_.rooms[first].max_m + around;
        const Vec2 page = room_on_page(options_.paper, high.x - low.x > high.y - low.y, true) * (one_to / 1000.0);
        // If a room is longer than a page, the sheet shows its middle.
        low = glm::max(low, middle - 0.5 * page);
        high = glm::min(high, middle + 0.5 * page);
        made.rooms.push_back(first);
        for (const std::size_t room : rooms) {
            const Vec2 both_low = glm::min(low, storey_.rooms[room].min_m - around),
                       both_high = glm::max(high, storey_.rooms[room].max_m + around);
            if (room == first || !fits(both_high - both_low)) continue;
            low = both_low, high = both_high;
            made.rooms.push_back(room);
        }
        made.part.min_m = glm::max(low, storey_.min_m);
        made.part.max_m = glm::min(high, storey_.max_m);
        made.part.one_to = one_to;
        made.part.number = static_cast<int>(sheets_.size()) + 1;
        made.part.larger = true;
        return made;
    }

    // Writes the keys after all sheets are drawn, because only then it is known which rooms have a sign on another
    // sheet and which on none.
    Result<void> write_keys() {
        for (SwellSheet& sheet : sheets_) {
            sheet.part->count = static_cast<int>(sheets_.size());
            sheet.key_lines.insert(sheet.key_lines.begin() + 1,
                                   {{}, phrase("export.key_sheets", {{"count", sheets_.size()}})});
            for (std::size_t& line : sheet.key_line_of_room) line += line == kNoKeyLine ? 0 : 1;
        }
        for (SwellSheet& sheet : sheets_)
            for (std::size_t i = 0; i < storey_.rooms.size(); ++i)
                if (sheet.key_line_of_room[i] != kNoKeyLine && !sheet.signs[i].is_known()) name_elsewhere(sheet, i);
        std::vector<std::vector<std::string>> lacking(sheets_.size());
        for (const std::size_t room : unknown()) {
            std::size_t shows = 0;
            while (shows + 1 < sheets_.size() && sheets_[shows].key_line_of_room[room] == kNoKeyLine) ++shows;
            lacking[shows].push_back(storey_.rooms[room].name);
        }
        for (std::size_t i = 0; i < sheets_.size(); ++i) {
            if (!lacking[i].empty())
                sheets_[i].broken.push_back(
                    phrase("export.no_sign", {{"count", lacking[i].size()}, {"names", names_list(lacking[i])}}));
            if (Result<void> written = write_key(sheets_[i], options_.table); !written) return written;
        }
        return {};
    }

    void name_elsewhere(SwellSheet& sheet, std::size_t room) const {
        const auto other = std::find_if(sheets_.begin(), sheets_.end(),
                                        [&](const SwellSheet& one) { return one.signs[room].on_sheet; });
        if (other == sheets_.end()) return;
        const std::string name = capitalised(storey_.rooms[room].name),
                          without = phrase("export.key_room_unsigned", {{"name", name}});
        std::string& text = sheet.key_lines[sheet.key_line_of_room[room]].text;
        if (text.compare(0, without.size(), without) != 0) return;
        text.replace(0, without.size(),
                     phrase("export.key_room_elsewhere", {{"name", name}, {"sheet", other->part->number}}));
    }

    static constexpr bool kWays[] = {false, true};

    const plan::Storey& storey_;
    const SheetOptions& options_;
    // scales_: all scales; for each room, the scale that it needs for one cell and for its sign: see scales_needed.
    std::vector<double> scales_, for_one_cell_, for_sign_;
    std::vector<SwellSheet> sheets_;
    std::vector<std::string> letters_, best_letters_;
};

}  // namespace

Result<std::vector<SwellSheet>> swell_sheets(const plan::Storey& storey, const SheetOptions& options) {
    Result<SwellSheet> one = swell_sheet(storey, options);
    if (one && one->broken.empty()) return std::vector<SwellSheet>{std::move(*one)};
    Result<std::vector<SwellSheet>> sheets = SheetsMaker(storey, options).make();
    if (!sheets || !sheets->empty()) return sheets;
    if (!one) return tl::unexpected(one.error());
    return std::vector<SwellSheet>{std::move(*one)};
}

}  // namespace handrail::exports
