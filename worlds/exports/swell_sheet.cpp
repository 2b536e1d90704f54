#include "worlds/exports/swell_sheet.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <set>

#include "worlds/base/language.h"
#include "worlds/exports/braille_page.h"
#include "worlds/exports/floor_edges.h"
#include "worlds/exports/ink.h"
#include "worlds/exports/names.h"
#include "worlds/exports/openings.h"
#include "worlds/exports/places.h"
#include "worlds/exports/sheet_title.h"
#include "worlds/exports/wall_ink.h"
#include "worlds/navigation/walk_space.h"

namespace handrail::exports {
namespace {

using Loops = std::vector<std::vector<Vec2>>;

constexpr double kMargin_mm = kSheetMargin_mm;
// Distance that is kept while drawing. It is a little more than the promised kLeastGap_mm, because lines are traced
// with an error of about a tenth of a millimetre.
constexpr double kClear_mm = kLeastGap_mm + 0.2;
constexpr double kHollowFrom_mm = 6.0, kHollowLong_mm = 9.0, kLeastPiece_mm = 4.0, kLeastStair_mm = 3.0;

constexpr double kMark_mm = 4.0;
constexpr double kLeastEdge_m = 2.0;  // floor edges without a wall are not reported if they are shorter than this

double whole_scale(const Vec2& size_m, const Vec2& room_mm) {
    for (const double one_to : kSheetScales)
        if (size_m.x * 1000.0 / one_to <= room_mm.x && size_m.y * 1000.0 / one_to <= room_mm.y) return one_to;
    return 0.0;
}

// Makes one sheet. The items are drawn in the order in which they get their space: walls, stairs, base, signs, objects.
class SheetMaker {
public:
    SheetMaker(const plan::Storey& storey, const SheetOptions& options, std::optional<SheetPart> part,
               std::vector<std::string>& letters)
        : storey_(storey), options_(options), table_(options.table), letters_(letters) {
        made_.part = std::move(part);
        letters_.resize(storey.rooms.size());
    }

    Result<SwellSheet> make() {
        if (const Result<void> laid = made_.part ? lay_out_part() : lay_out(options_.paper); !laid)
            return tl::unexpected(laid.error());
        draw_walls();
        made_.signs = room_signs(storey_);
        if (const Result<void> signs = draw_signs_of_tight_rooms(); !signs) return tl::unexpected(signs.error());
        draw_stairs();
        draw_base();
        if (const Result<void> signs = draw_signs(); !signs) return tl::unexpected(signs.error());
        if (const Result<void> letters = draw_short_signs(); !letters) return tl::unexpected(letters.error());
        draw_edges();
        draw_things();
        if (const Result<void> head = draw_frame(); !head) return tl::unexpected(head.error());
        made_.on_paper = on_paper_;
        find_by_doors();
        report();
        list_key();
        return std::move(made_);
    }

private:
    Result<void> lay_out(const PaperSize& paper) {
        const Vec2 size_m = storey_.max_m - storey_.min_m;
        // Returns the space for the plan. A title of two lines leaves less space.
        const auto room_below_title = [&](bool across) {
            const auto title = title_lines(storey_, std::nullopt, table_, across ? paper.long_mm : paper.short_mm);
            const double more_mm = title && title->size() > 1 ? kBrailleLine_mm : 0.0;
            return room_on_page(paper, across, false) - Vec2(0.0, more_mm);
        };
        const Vec2 room_upright = room_below_title(false), room_across = room_below_title(true);
        const double upright = whole_scale(size_m, room_upright), across = whole_scale(size_m, room_across);
        if (upright == 0.0 && across == 0.0)
            return fail(phrase("export.too_large", {{"x", size_m.x}, {"y", size_m.y}}));
        const bool turned = upright == 0.0 || (across != 0.0 && across < upright);
        made_.one_to = turned ? across : upright;
        on_paper_.from_m = storey_.min_m;
        on_paper_.mm_per_m = 1000.0 / made_.one_to;
        made_.plan.width_mm = turned ? paper.long_mm : paper.short_mm;
        made_.plan.height_mm = turned ? paper.short_mm : paper.long_mm;
        const Vec2 room = turned ? room_across : room_upright;
        low_mm_ = {kMargin_mm, kMargin_mm + kSheetFoot_mm};
        high_mm_ = low_mm_ + room;
        on_paper_.shift_mm = low_mm_ + 0.5 * (room - size_m * on_paper_.mm_per_m);
        present_.assign(storey_.rooms.size(), true);
        return {};
    }

    Result<void> lay_out_part() {
        const SheetPart& part = *made_.part;
        const Vec2 size_mm = (part.max_m - part.min_m) * (1000.0 / part.one_to);
        const bool turned = size_mm.x > room_on_page(options_.paper, false, true).x + 1e-6;
        made_.one_to = part.one_to;
        made_.plan.width_mm = turned ? options_.paper.long_mm : options_.paper.short_mm;
        made_.plan.height_mm = turned ? options_.paper.short_mm : options_.paper.long_mm;
        on_paper_.from_m = part.min_m;
        on_paper_.mm_per_m = 1000.0 / part.one_to;
        on_paper_.shift_mm = Vec2(kMargin_mm, kMargin_mm + kSheetFoot_mm + kPartFoot_mm) +
                             0.5 * (room_on_page(options_.paper, turned, true) - size_mm);
        low_mm_ = on_paper_.shift_mm;
        high_mm_ = low_mm_ + size_mm;
        present_.assign(storey_.rooms.size(), false);
        const plan::StoreyFloor& floor = storey_.floor;
        for (std::size_t i = 0; i < floor.room.size(); ++i) {
            const auto wide = static_cast<std::size_t>(floor.wide);
            const Vec2 at = storey_.min_m + (Vec2(i % wide, i / wide) + Vec2(0.5)) * floor.cell_m;
            if (floor.room[i] != navigation::kNothing && at.x >= part.min_m.x && at.y >= part.min_m.y &&
                at.x <= part.max_m.x && at.y <= part.max_m.y)
                present_[floor.room[i]] = true;
        }
        return {};
    }

    bool is_beyond(int x, int y) const {
        const Vec2 at = Vec2(x + 0.5, y + 0.5) * kInkPixel_mm;
        return at.x < low_mm_.x || at.y < low_mm_.y || at.x > high_mm_.x || at.y > high_mm_.y;
    }

    // Returns the walls, and treats everything outside the part shown as wall. A finger that leaves the part is on
    // another sheet, so rooms must not be joined there.
    Ink walls_within_part() const {
        Ink walls = walls_.ink;
        if (!made_.part) return walls;
        for (int y = 0; y < walls.high; ++y)
            for (int x = 0; x < walls.wide; ++x)
                if (is_beyond(x, y)) walls.black[walls.at(x, y)] = 1;
        return walls;
    }

    bool shown(const Vec2& at_m) const {
        const Vec2 at = on_paper_(at_m);
        return at.x >= low_mm_.x && at.y >= low_mm_.y && at.x <= high_mm_.x && at.y <= high_mm_.y;
    }

    void draw_walls() {
        const WallLook look{kWallLine_mm, kClear_mm, kLeastSymbol_mm + 0.2, kLeastPiece_mm};
        walls_ = ink_of_walls(storey_, on_paper_, made_.plan.width_mm, made_.plan.height_mm, look);
        mended_ = mend_openings(walls_.ink, storey_, on_paper_, look);
        if (made_.part) whole_ = rooms_on(walls_.ink, storey_, on_paper_);
        cut_off(walls_.ink, low_mm_, high_mm_, kLeastPiece_mm);
        hollow_ = hollow_out(walls_.ink, kHollowFrom_mm, kWallLine_mm, kHollowLong_mm);
        rooms_ = rooms_on(walls_within_part(), storey_, on_paper_);
        if (!made_.part) whole_ = rooms_;
        rungs_ = stair_rungs(storey_, on_paper_, rooms_, Places(walls_.ink, kClear_mm, low_mm_, high_mm_), walls_.ink,
                             kThinLine_mm, kClear_mm, kLeastStair_mm);
        cut_off(walls_.ink, low_mm_, high_mm_, kLeastPiece_mm);
        made_.plan.shapes.push_back({traced_mm(walls_.ink), kWallPart});
        places_ = Places(walls_.ink, kClear_mm, low_mm_, high_mm_);
        things_apart_ = places_;
        for (const plan::StoreyThing& thing : storey_.things) things_apart_.take(corners_of(on_paper_(thing.box)));
    }

    void draw(Loops loops) {
        places_.take(loops.front());
        things_apart_.take(loops.front());
        made_.plan.shapes.push_back({std::move(loops), ++parts_});
    }

    void draw_stairs() {
        stairs_ = stair_lines(storey_, on_paper_, rooms_, places_, kThinLine_mm, kClear_mm, kLeastStair_mm);
        for (const plan::PlanBox& line : stairs_.lines) draw({corners_of(line)});
        const auto add = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
        add(stairs_.lines, rungs_.lines);
        add(stairs_.drawn, rungs_.drawn);
        add(stairs_.of_others, rungs_.of_others);
    }

    void draw_edges() {
        const EdgeInk ink = edge_lines(storey_, on_paper_, whole_, places_, kThinLine_mm, kClear_mm + 0.2);
        for (const plan::PlanBox& line : ink.lines) draw({corners_of(line)});
        for (const std::uint32_t room : ink.rooms) edges_.push_back(storey_.rooms[room].name);
        for (const std::uint32_t room :
             rooms_with_open_edges(whole_, storey_, kLeastEdge_m * on_paper_.mm_per_m,
                                   [&](const Vec2& mm) { return shown(on_paper_.world(mm)); }))
            if (std::find(ink.rooms.begin(), ink.rooms.end(), room) == ink.rooms.end())
                undrawn_edges_.push_back(storey_.rooms[room].name);
    }

    std::optional<BaseArrow> arrow_in(const Places& places) const {
        if (!storey_.base || !shown(storey_.base->place_m)) return std::nullopt;
        return arrow_of_base(*storey_.base, on_paper_, walls_.ink, places,
                             {0.6 * kLeastSymbol_mm, 0.5 * kLeastSymbol_mm});
    }

    void draw_base() {
        if (!storey_.base) return;
        if (!shown(storey_.base->place_m)) {
            // If there are several sheets, another sheet may show the base, so nothing is reported then.
            if (!made_.part) base_ = phrase("export.base_outside");
            return;
        }
        const auto arrow = arrow_in(places_);
        if (!arrow) {
            base_ = phrase("export.base_left_out");
            return;
        }
        if (arrow->off_mm > 1.0) base_ = phrase("export.base_moved");
        base_room_ = room_at_mm((arrow->loop_mm[0] + arrow->loop_mm[1] + arrow->loop_mm[2]) / 3.0);
        draw({arrow->loop_mm});
        base_drawn_ = true;
    }

    std::optional<Vec2> place_of(std::size_t room, const BrailleCells& cells, const Places& free) const {
        return place_of_sign(storey_, room, on_paper_, rooms_, free, things_apart_, 0.5 * braille_size_mm(cells.size()),
                             sign_boxes_);
    }

    void draw_sign(std::size_t room, const BrailleCells& cells, const Vec2& place) {
        const Vec2 half = 0.5 * braille_size_mm(cells.size());
        made_.signs[room].on_sheet = true;
        made_.signs[room].at_mm = place;
        made_.signs[room].half_mm = half;
        sign_boxes_.push_back({place, {1.0, 0.0}, half});
        const std::vector<Vec2> corners = corners_of(sign_boxes_.back());
        places_.take(corners);
        things_apart_.take(corners);
        lay_braille(made_.plan, cells, place + Vec2(-half.x, half.y) + Vec2(0.5, -0.5) * kBrailleDot_mm, ++parts_);
    }

    // Calls `each(room, cells)`, with the cells of the sign, for every room that needs a sign and has none yet.
    template <class Each>
    Result<void> for_unsigned(Each each) {
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i) {
            if (!present_[i] || made_.signs[i].on_sheet || is_left_to_key(i)) continue;
            const Result<BrailleCells> cells = braille_signs(made_.signs[i].sign, table_);
            if (!cells) return tl::unexpected(cells.error());
            each(i, *cells);
        }
        return {};
    }

    // Draws the signs of small rooms before their stairs and the base, which might otherwise leave no space. Lines of
    // stairs can be shorter, and the arrow at the base can be a little off, but a sign cannot shrink.
    Result<void> draw_signs_of_tight_rooms() {
        Places others = places_;
        const StairInk stairs =
            stair_lines(storey_, on_paper_, rooms_, others, kThinLine_mm, kClear_mm, kLeastStair_mm);
        const auto arrow = arrow_in(others);
        if (stairs.lines.empty() && rungs_.lines.empty() && !arrow) return {};
        if (arrow) others.take(arrow->loop_mm);
        return for_unsigned([&](std::size_t room, const BrailleCells& cells) {
            const auto has_lines = [&](const StairInk& ink) {
                return std::find(ink.drawn.begin(), ink.drawn.end(), room) != ink.drawn.end();
            };
            if (has_lines(stairs) || has_lines(rungs_)) return;
            const Vec2 half = 0.5 * braille_size_mm(cells.size());
            if (place_of_sign(storey_, room, on_paper_, rooms_, others, others, half, sign_boxes_)) return;
            if (const auto place = place_of(room, cells, places_)) draw_sign(room, cells, *place);
        });
    }

    Result<void> draw_signs() {
        return for_unsigned([&](std::size_t room, const BrailleCells& cells) {
            if (const auto place = place_of(room, cells, places_)) draw_sign(room, cells, *place);
        });
    }

    // Returns two letters that no room of the storey uses. They may fit if the room's own sign does not: a sign with a
    // number needs at least three cells.
    std::string free_pair(std::size_t room) const {
        std::set<std::string> used(letters_.begin(), letters_.end());
        for (const RoomSign& sign : room_signs(storey_)) used.insert(sign.sign);
        return letters_[room].size() == 2 ? letters_[room] : free_letters(storey_.rooms[room].name, used);
    }

    // Returns a single letter, which may fit if two cells do not. It is the room's letter on an earlier sheet, else a
    // letter of its name, else any letter that no room of the sheet uses. The letter "a" is never used, because it is a
    // single dot.
    std::string free_letter(std::size_t room) const {
        std::string preferred = letters_[room].size() == 1 ? letters_[room] : std::string();
        for (const char c : storey_.rooms[room].name)
            if (const int low = std::tolower(static_cast<unsigned char>(c)); low > 'a' && low <= 'z')
                preferred += static_cast<char>(low);
        preferred += "bcdefghijklmnopqrstuvwxyz";
        const std::size_t free = preferred.find_first_not_of(taken_letters_);
        return free == std::string::npos ? std::string() : preferred.substr(free, 1);
    }

    // Draws a shorter sign than the room's own if there is space for it. Returns whether it drew the sign.
    Result<bool> draw_short(std::size_t room, const std::string& sign) {
        const Result<BrailleCells> cells = braille_signs(sign, table_);
        if (!cells) return tl::unexpected(cells.error());
        const auto place =
            !sign.empty() && cells->size() == sign.size() ? place_of(room, *cells, places_) : std::nullopt;
        if (!place) return false;
        draw_sign(room, *cells, *place);
        made_.signs[room].sign = letters_[room] = sign;
        return true;
    }

    Result<void> draw_short_signs() {
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i) {
            if (!present_[i] || made_.signs[i].on_sheet || is_left_to_key(i) || is_known_by_lines(i)) continue;
            const Result<BrailleCells> own = braille_signs(made_.signs[i].sign, table_);
            if (!own) return tl::unexpected(own.error());
            Result<bool> drawn = own->size() > 2 ? draw_short(i, free_pair(i)) : Result<bool>(false);
            if (drawn && !*drawn) {
                const std::string letter = free_letter(i);
                drawn = draw_short(i, letter);
                if (drawn && *drawn) taken_letters_ += letter;
            }
            if (!drawn) return tl::unexpected(drawn.error());
        }
        return {};
    }

    // Returns whether two rooms are pieces of one staircase. Pieces of stairs that lead to the same room are adjacent,
    // so a finger feels them as one staircase.
    bool are_flights(std::size_t a, std::size_t b) const {
        return storey_.rooms[a].kind == navigation::RoomKind::Stairs &&
               storey_.rooms[b].kind == navigation::RoomKind::Stairs;
    }

    // Lists the rooms to which the doors of a room without a sign lead. A corridor may be too narrow for any sign; the
    // key then names these rooms if that identifies the corridor.
    void find_by_doors() {
        for (const std::uint32_t flight : stairs_.drawn) made_.signs[flight].by_lines = true;
        std::vector<std::set<std::string>> leads_to(storey_.rooms.size()), all(storey_.rooms.size());
        for (const plan::StoreyPortal& portal : storey_.portals) {
            if (!shown(portal.place_m)) continue;
            for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
                const RoomSign& other = made_.signs[portal.rooms[1 - side]];
                all[portal.rooms[side]].insert(other.name);
                if (other.is_known()) leads_to[portal.rooms[side]].insert(other.name);
            }
        }
        const auto has_no_sign = [&](std::size_t i) { return present_[i] && !made_.signs[i].is_known(); };
        const std::vector<RoomSign> signs = made_.signs;
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i) {
            if (!has_no_sign(i)) continue;
            made_.signs[i].leads_to.assign(all[i].begin(), all[i].end());
            bool alone = !leads_to[i].empty();
            for (std::size_t j = 0; j < storey_.rooms.size(); ++j)
                alone = alone && (j == i || !present_[j] || signs[j].is_known() || leads_to[j] != leads_to[i] ||
                                  are_flights(i, j));
            if (alone) made_.signs[i].doors_to.assign(leads_to[i].begin(), leads_to[i].end());
        }
    }

    void draw_things() {
        thing_drawn_.assign(storey_.things.size(), false);
        thing_room_.assign(storey_.things.size(), navigation::kNothing);
        for (std::size_t i = 0; i < storey_.things.size(); ++i) {
            const plan::StoreyThing& thing = storey_.things[i];
            if (options_.coarse || !shown(thing.box.middle_m)) continue;
            const ThingFit fit = fit_of_thing(thing, on_paper_, places_, kLeastSymbol_mm);
            if (!fit.box) {
                left_out_.push_back(thing.name);
                continue;
            }
            if (fit.shrunk) shrunk_.push_back(thing.name);
            plan::PlanBox inner = *fit.box;
            inner.half_m -= Vec2(kThinLine_mm);
            std::vector<Vec2> hole = corners_of(inner);
            std::reverse(hole.begin(), hole.end());
            draw({corners_of(*fit.box), std::move(hole)});
            thing_drawn_[i] = true;
            thing_room_[i] = room_at_mm(fit.box->middle_m);
            made_.drawn.push_back(thing.name);
        }
    }

    std::optional<int> number() const { return made_.part ? std::optional(made_.part->number) : std::nullopt; }

    // Draws the title of the sheet, an arrow to the north, and a scale bar.
    Result<void> draw_frame() {
        SheetPage& page = made_.plan;
        page.title = sheet_title(storey_, number());
        const double top = page.height_mm - kMargin_mm, right = page.width_mm - kMargin_mm;
        const auto title = title_lines(storey_, number(), table_, page.width_mm);
        if (!title) return tl::unexpected(title.error());
        Vec2 first_dot = Vec2(kMargin_mm, top) + Vec2(0.5, -0.5) * kBrailleDot_mm;
        for (const BrailleCells& line : *title) {
            lay_braille(page, line, first_dot, ++parts_);
            first_dot.y -= kBrailleLine_mm;
        }
        page.shapes.push_back(
            {{{{right - kLeastSymbol_mm, top - 10.0}, {right, top - 10.0}, {right - 0.5 * kLeastSymbol_mm, top}}},
             ++parts_});
        for (const double metres : {50.0, 20.0, 10.0, 5.0, 2.0, 1.0}) {
            bar_m_ = metres;
            if (metres * on_paper_.mm_per_m <= 55.0) break;
        }
        const double length = bar_m_ * on_paper_.mm_per_m, left = kMargin_mm, low = kMargin_mm;
        page.shapes.push_back({{{{left, low},
                                 {left + kWallLine_mm, low},
                                 {left + kWallLine_mm, low + 2.25},
                                 {left + length - kWallLine_mm, low + 2.25},
                                 {left + length - kWallLine_mm, low},
                                 {left + length, low},
                                 {left + length, low + 6.0},
                                 {left + length - kWallLine_mm, low + 6.0},
                                 {left + length - kWallLine_mm, low + 3.75},
                                 {left + kWallLine_mm, low + 3.75},
                                 {left + kWallLine_mm, low + 6.0},
                                 {left, low + 6.0}}},
                               ++parts_});
        const Result<BrailleCells> words = braille_of(phrase("export.bar", {{"metres", bar_m_}}), table_);
        if (!words) return tl::unexpected(words.error());
        lay_braille(page, *words, {left + length + 5.0, low + 6.0 - 0.5 * kBrailleDot_mm}, ++parts_);
        return made_.part ? draw_marks() : Result<void>{};
    }

    // Draws short lines at the edges in the middle of shared strips. Next to the plan, draws the numbers of the
    // neighbouring sheets.
    Result<void> draw_marks() {
        const SheetPart& part = *made_.part;
        const double off = kClear_mm + 0.5 * kMark_mm;
        std::vector<plan::PlanBox> taken;
        const auto mark = [&](const Vec2& at, bool upright) {
            const Vec2 half =
                upright ? Vec2(0.5 * kThinLine_mm, 0.5 * kMark_mm) : Vec2(0.5 * kMark_mm, 0.5 * kThinLine_mm);
            const plan::PlanBox box{at, {1.0, 0.0}, half};
            // The mark of another neighbouring sheet is already at this place.
            if (is_near_any(box, taken, kClear_mm)) return;
            taken.push_back(box);
            made_.plan.shapes.push_back({{corners_of(box)}, ++parts_});
        };
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}})
            for (const NextSheet& next : part.next[side]) {
                const Vec2 middle = on_paper_(Vec2(next.shared_m));
                if (side < 2) {
                    mark({middle.x, low_mm_.y - off}, true);
                    mark({middle.x, high_mm_.y + off}, true);
                } else {
                    mark({low_mm_.x - off, middle.y}, false);
                    mark({high_mm_.x + off, middle.y}, false);
                }
            }
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}})
            for (const NextSheet& next : part.next[side])
                if (Result<void> drawn = draw_number(side, next, taken); !drawn) return drawn;
        return {};
    }

    // Places the number of a neighbouring sheet next to its mark. For neighbours to the west and east: outside the
    // plan, above or below the mark if the neighbour is in the northern or the southern half. For neighbours to the
    // north and south: above and below the plan. If there is no space, only the key names the sheet.
    Result<void> draw_number(std::size_t side, const NextSheet& next, std::vector<plan::PlanBox>& taken) {
        const Result<BrailleCells> cells = braille_of(std::to_string(next.number), table_);
        if (!cells) return tl::unexpected(cells.error());
        const Vec2 half = 0.5 * braille_size_mm(cells->size());
        const Vec2 at = on_paper_(side < 2 ? Vec2(next.shared_m, next.along_m) : Vec2(next.along_m, next.shared_m));
        const bool above = side == 2 || (side < 2 && at.y >= 0.5 * (low_mm_.y + high_mm_.y));
        const double y = above ? high_mm_.y + kClear_mm + half.y : low_mm_.y - kClear_mm - half.y;
        const double beside = 0.5 * kThinLine_mm + kClear_mm + 0.1 + half.x;
        const double x = side == 0 ? at.x - beside : side == 1 ? at.x + beside : at.x;
        constexpr double kUnprinted_mm = 6.0;
        for (double aside = 0.0; aside < 40.0; aside += 1.0)
            for (const double way : {-1.0, 1.0}) {
                const plan::PlanBox box{{x + way * aside, y}, {1.0, 0.0}, half};
                if (box.middle_m.x - half.x < kUnprinted_mm ||
                    box.middle_m.x + half.x > made_.plan.width_mm - kUnprinted_mm)
                    continue;
                if ((side < 2 && aside > 0.0) || is_near_any(box, taken, kClear_mm)) continue;
                taken.push_back(box);
                lay_braille(made_.plan, *cells, box.middle_m + Vec2(-half.x, half.y) + Vec2(0.5, -0.5) * kBrailleDot_mm,
                            ++parts_);
                return {};
            }
        return {};
    }

    // Returns whether only the key names the room. On a coarse plan, small rooms have no signs; stairs are recognised
    // by their lines.
    bool is_left_to_key(std::size_t room) const {
        return options_.coarse && storey_.rooms[room].area_m2 < kCoarseRoom_m2;
    }
    bool needs_sign(std::size_t room) const {
        return present_[room] && !is_left_to_key(room) && !storey_.rooms[room].shut && !storey_.rooms[room].elsewhere;
    }
    bool is_known_by_lines(std::size_t room) const {
        return std::find(stairs_.drawn.begin(), stairs_.drawn.end(), room) != stairs_.drawn.end();
    }

    void report() {
        std::vector<std::string>& said = made_.simplified;
        if (walls_.thicker > 0)
            said.push_back(phrase("export.walls_thicker", {{"count", walls_.thicker}, {"mm", kWallLine_mm}}));
        if (walls_.joined > 0) said.push_back(phrase("export.joined", {{"count", walls_.joined}}));
        if (hollow_ > 0) said.push_back(phrase("export.hollow", {{"count", hollow_}}));
        if (walls_.pieces_left_out > 0)
            said.push_back(phrase("export.pieces_left_out", {{"count", walls_.pieces_left_out}}));
        if (walls_.wider > 0)
            said.push_back(phrase("export.doors_wider", {{"count", walls_.wider}, {"mm", kLeastSymbol_mm}}));
        if (!mended_.closed.empty()) {
            std::vector<std::string> closed;
            for (const auto& rooms : mended_.closed) closed.push_back(both(rooms));
            said.push_back(phrase("export.closed", {{"names", names_list(closed)}}));
        }
        if (const std::vector<std::string> flights = undrawn_flights(); !flights.empty())
            said.push_back(phrase("export.stairs_left_out", {{"names", names_list(flights)}}));
        if (!undrawn_edges_.empty()) said.push_back(phrase("export.edges", {{"names", names_list(undrawn_edges_)}}));
        if (!base_.empty()) said.push_back(base_);
        keep_promises();
        if (!shrunk_.empty()) said.push_back(phrase("export.shrunk", {{"names", names_list(shrunk_)}}));
        if (!left_out_.empty()) said.push_back(phrase("export.left_out", {{"names", names_list(left_out_)}}));
        if (storey_.moving > 0) said.push_back(phrase("export.moving", {{"count", storey_.moving}}));
    }

    // Returns the names of the flights on the sheet that have neither lines nor a sign. For a flight of another storey,
    // it returns the room to which that flight leads. Flights above each other share their lines.
    std::vector<std::string> undrawn_flights() const {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i)
            if (storey_.rooms[i].kind == navigation::RoomKind::Stairs && present_[i] && !made_.signs[i].on_sheet &&
                !is_known_by_lines(i))
                names.push_back(storey_.rooms[i].name);
        for (std::uint32_t i = 0; i < storey_.stairs_of_others.size(); ++i) {
            const plan::StoreyStairs& flight = storey_.stairs_of_others[i];
            if (flight.loops_m.empty() ||
                std::find(stairs_.of_others.begin(), stairs_.of_others.end(), i) != stairs_.of_others.end())
                continue;
            const Vec2 middle = plan::box_around(plan::convex_hull(flight.loops_m.front())).middle_m;
            const bool above =
                std::any_of(storey_.rooms.begin(), storey_.rooms.end(), [&](const plan::StoreyRoom& room) {
                    return room.kind == navigation::RoomKind::Stairs && middle.x >= room.min_m.x &&
                           middle.y >= room.min_m.y && middle.x <= room.max_m.x && middle.y <= room.max_m.y;
                });
            if (shown(middle) && !above) names.push_back(storey_.rooms[flight.room].name);
        }
        return names;
    }

    // Returns the routes to other storeys. Flights with lines and drops are not included.
    std::vector<std::string> exits() const {
        std::vector<std::string> names;
        for (const plan::StoreyExit& exit : storey_.exits) {
            if (!shown(exit.place_m)) continue;
            std::string name =
                phrase("export.exit", {{"one", storey_.rooms[exit.room].name},
                                       {"other", exit.to},
                                       {"lift", exit.kind == navigation::PassageKind::Lift ? "yes" : "no"}});
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
        }
        return names;
    }

    std::string both(const std::array<std::uint32_t, 2>& rooms) const {
        return phrase("export.two_rooms",
                      {{"one", storey_.rooms[rooms[0]].name}, {"other", storey_.rooms[rooms[1]].name}});
    }

    // Reports doors that are too narrow. On a coarse plan, the doors of small rooms may be as narrow as their walls
    // make them, so these doors do not break a promise.
    void list_narrow_doors() {
        std::vector<std::size_t> broken, small;
        for (const std::size_t place : walls_.narrow_gaps) {
            const plan::StoreyGap& gap = storey_.gaps[place];
            if (!shown(gap.place_m)) continue;
            const bool of_small = std::any_of(gap.rooms.begin(), gap.rooms.end(), [&](std::uint32_t room) {
                return room != navigation::kNothing && is_left_to_key(room);
            });
            (of_small ? small : broken).push_back(place);
        }
        const auto add = [&](const std::vector<std::size_t>& gaps, std::vector<std::string>& said) {
            if (!gaps.empty())
                said.push_back(
                    phrase("export.doors_narrow", {{"names", gap_names(storey_, gaps)}, {"mm", kLeastSymbol_mm}}));
        };
        add(broken, made_.broken);
        add(small, made_.simplified);
    }

    // Checks the finished sheet against its promises and stores those that it breaks.
    void keep_promises() {
        std::vector<std::string> unsigned_rooms;
        for (std::size_t i = 0; i < made_.signs.size(); ++i)
            if (needs_sign(i) && !made_.signs[i].is_known()) unsigned_rooms.push_back(made_.signs[i].name);
        // If there are several sheets, another sheet may have the room's sign: see swell_sheets.
        if (!unsigned_rooms.empty() && !made_.part)
            made_.broken.push_back(
                phrase("export.no_sign", {{"count", unsigned_rooms.size()}, {"names", names_list(unsigned_rooms)}}));
        list_narrow_doors();
        if (const GapCheck gaps = check_gaps(made_.plan, kLeastGap_mm); !gaps.narrow_mm.empty())
            made_.broken.push_back(phrase("export.too_near"));
        std::vector<std::string> lacking, leaking;
        const OpeningCheck openings = check_openings(whole_, storey_, on_paper_);
        for (const WrongOpening& wrong : openings.lacking)
            if (shown(on_paper_.world(wrong.at_mm))) lacking.push_back(both(wrong.rooms));
        for (const WrongOpening& wrong : openings.leaking)
            if (shown(on_paper_.world(wrong.at_mm))) leaking.push_back(both(wrong.rooms));
        if (!lacking.empty()) made_.broken.push_back(phrase("export.lacking", {{"names", names_list(lacking)}}));
        if (!leaking.empty()) made_.broken.push_back(phrase("export.leaking", {{"names", names_list(leaking)}}));
    }

    // Returns the room at a place of the sheet; kNothing outside all rooms.
    std::uint32_t room_at_mm(const Vec2& at_mm) const {
        const int x = static_cast<int>(at_mm.x / kInkPixel_mm), y = static_cast<int>(at_mm.y / kInkPixel_mm);
        const std::uint32_t room = rooms_.holds(x, y) ? rooms_.room[rooms_.at(x, y)] : navigation::kNothing;
        return room < storey_.rooms.size() ? room : navigation::kNothing;
    }

    void list_key() {
        std::vector<KeyLine>& text = made_.key_lines;
        const auto add = [&](std::string line) { text.push_back({{}, std::move(line)}); };
        add(made_.plan.title);
        add(phrase("export.key_scale", {{"one_to", made_.one_to}, {"metres", bar_m_}}));
        add(phrase("export.key_lines"));
        if (made_.part) {
            constexpr std::array kGoesOn{"export.goes_on_west", "export.goes_on_east", "export.goes_on_north",
                                         "export.goes_on_south"};
            if (made_.part->larger) add(phrase("export.key_larger"));
            bool goes_on = false;
            for (std::size_t side = 0; side < 4; ++side)
                for (const NextSheet& next : made_.part->next[side]) {
                    add(phrase(kGoesOn[side], {{"sheet", next.number}}));
                    goes_on = true;
                }
            if (goes_on) add(phrase("export.key_marks", {{"metres", kShared_mm / on_paper_.mm_per_m}}));
        }
        if (base_drawn_)
            add(base_room_ == navigation::kNothing
                    ? phrase("export.key_base")
                    : phrase("export.key_base_in", {{"room", storey_.rooms[base_room_].name}}));
        if (!stairs_.lines.empty()) add(phrase("export.key_stairs"));
        if (!stairs_.of_others.empty()) {
            std::vector<std::string> rooms;
            for (const std::uint32_t flight : stairs_.of_others)
                rooms.push_back(storey_.rooms[storey_.stairs_of_others[flight].room].name);
            add(phrase("export.key_stairs_of_others", {{"names", names_list(rooms)}}));
        }
        if (!edges_.empty()) add(phrase("export.key_edges", {{"names", names_list(edges_)}}));
        if (const std::vector<std::string> names = exits(); !names.empty())
            add(phrase("export.key_exits", {{"names", names_list(names)}}));
        if (!storey_.hidden.empty()) add(phrase("export.key_hidden", {{"names", hidden_names(storey_)}}));
        if (storey_.upper) add(phrase("export.key_upper"));
        if (!made_.drawn.empty()) add(phrase("export.key_things"));
        std::vector<std::vector<std::string>> in_room(storey_.rooms.size());
        std::vector<std::string> outside;
        for (std::size_t i = 0; i < thing_room_.size(); ++i) {
            if (!thing_drawn_[i]) continue;
            (thing_room_[i] == navigation::kNothing ? outside : in_room[thing_room_[i]])
                .push_back(storey_.things[i].name);
        }
        made_.key_line_of_room.assign(storey_.rooms.size(), kNoKeyLine);
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < made_.signs.size(); ++i)
            if (present_[i]) order.push_back(i);
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const RoomSign &one = made_.signs[a], &other = made_.signs[b];
            if (one.on_sheet != other.on_sheet) return one.on_sheet;
            return one.on_sheet ? one.sign < other.sign : one.name < other.name;
        });
        for (const std::size_t i : order) {
            const RoomSign& sign = made_.signs[i];
            const std::string name = capitalised(sign.name);
            const std::vector<std::string>& doors = sign.doors_to.empty() ? sign.leads_to : sign.doors_to;
            std::string line =
                sign.on_sheet && storey_.rooms[i].shut ? phrase("export.key_room_signed_shut", {{"name", name}})
                : sign.on_sheet                        ? name + "."
                : is_known_by_lines(i)                 ? phrase("export.key_room_by_lines", {{"name", name}})
                : !doors.empty() ? phrase("export.key_room_by_doors", {{"name", name}, {"names", names_list(doors)}})
                : storey_.rooms[i].shut ? phrase("export.key_room_shut", {{"name", name}})
                                        : phrase("export.key_room_unsigned", {{"name", name}});
            if (i < options_.plate_signs.size() && !options_.plate_signs[i].empty() &&
                !(sign.on_sheet && sign.sign == options_.plate_signs[i]))
                line += " " + phrase("export.key_room_on_plate", {{"sign", options_.plate_signs[i]}});
            if (!in_room[i].empty())
                line += " " + phrase("export.key_room_things", {{"names", names_list(in_room[i])}});
            made_.key_line_of_room[i] = text.size();
            text.push_back({sign.on_sheet ? sign.sign : std::string(), std::move(line)});
        }
        if (!outside.empty()) add(phrase("export.key_outside_things", {{"names", names_list(outside)}}));
    }

    const plan::Storey& storey_;
    const SheetOptions& options_;
    BrailleTable table_;
    std::vector<std::string>& letters_;  // for each room: its shorter sign, see swell_sheet
    std::string taken_letters_;          // letters of the one-letter signs on this sheet
    std::vector<plan::PlanBox> sign_boxes_;
    Vec2 low_mm_{0.0}, high_mm_{0.0};  // corners of the plan on the page
    std::vector<bool> present_;        // for each room: whether part of its floor is on the sheet
    SwellSheet made_;
    OnPaper on_paper_;
    double bar_m_ = 5.0;
    int parts_ = kWallPart;
    WallInk walls_;
    Places places_;        // free space for signs
    Places things_apart_;  // the same as places_, but objects take no space
    int hollow_ = 0;
    MendedOpenings mended_;
    // Names of rooms whose floor ends without a wall: those where lines show it, and those where no lines fit.
    std::vector<std::string> edges_, undrawn_edges_;
    plan::RoomGrid rooms_;
    plan::RoomGrid whole_;     // like rooms_, but the edges of one of several sheets do not end rooms
    StairInk stairs_, rungs_;  // stairs_: finally all lines; rungs_: the lines that reach into walls
    bool base_drawn_ = false;
    std::uint32_t base_room_ = navigation::kNothing;
    std::string base_;
    std::vector<bool> thing_drawn_;
    std::vector<std::uint32_t> thing_room_;  // for each object: the room in which it is drawn
    std::vector<std::string> shrunk_, left_out_;
};

}  // namespace

std::string hidden_names(const plan::Storey& storey) {
    std::vector<std::string> names;
    for (const std::uint32_t room : storey.hidden) names.push_back(storey.rooms[room].name);
    return names_list(names);
}

Result<void> write_key(SwellSheet& sheet, BrailleTable table) {
    std::vector<KeyLine> lines = sheet.key_lines;
    for (const std::vector<std::string>* sentences : {&sheet.broken, &sheet.simplified})
        for (const std::string& sentence : *sentences) lines.push_back({{}, sentence});
    sheet.key_text.clear();
    sheet.plan.text.clear();
    for (const KeyLine& line : lines) {
        sheet.key_text.push_back(line.sign.empty() ? line.text : line.sign + "  " + line.text);
        sheet.plan.text += sheet.key_text.back() + "\n";
    }
    Result<std::vector<SheetPage>> key = braille_pages(lines, table, sheet.plan.width_mm, sheet.plan.height_mm,
                                                       phrase("export.key_title", {{"title", sheet.plan.title}}));
    if (!key) return tl::unexpected(key.error());
    sheet.key = std::move(*key);
    return {};
}

Result<SwellSheet> swell_sheet(const plan::Storey& storey, const SheetOptions& options) {
    std::vector<std::string> letters;
    Result<SwellSheet> sheet = SheetMaker(storey, options, std::nullopt, letters).make();
    if (!sheet) return sheet;
    if (const Result<void> written = write_key(*sheet, options.table); !written) return tl::unexpected(written.error());
    return sheet;
}

Result<SwellSheet> swell_sheet(const plan::Storey& storey, const SheetOptions& options, const SheetPart& part,
                               std::vector<std::string>& letters) {
    return SheetMaker(storey, options, part, letters).make();
}

}  // namespace handrail::exports
