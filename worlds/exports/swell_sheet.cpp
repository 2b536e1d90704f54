#include "worlds/exports/swell_sheet.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "worlds/base/language.h"
#include "worlds/exports/braille_page.h"
#include "worlds/exports/ink.h"
#include "worlds/exports/names.h"
#include "worlds/exports/places.h"
#include "worlds/exports/wall_ink.h"

namespace handrail {
namespace {

using Loops = std::vector<std::vector<Vec2>>;

constexpr double kMargin_mm = 12.0, kHead_mm = 14.0, kFoot_mm = 12.0;
// Kept a little over what is promised, for lines are traced to a tenth of a millimetre.
constexpr double kClear_mm = kLeastGap_mm + 0.2;
constexpr double kHollowFrom_mm = 6.0, kHollowLong_mm = 15.0, kLeastPiece_mm = 4.0, kLeastStair_mm = 3.0;
constexpr int kWalls = 1;  // the part that all walls are

double whole_scale(const Vec2& size_m, const Vec2& room_mm) {
    for (const double one_to :
         {20.0,  25.0,  30.0,  40.0,  50.0,  60.0,  75.0,  90.0,  100.0, 110.0, 125.0, 150.0, 175.0, 200.0,
          225.0, 250.0, 275.0, 300.0, 350.0, 400.0, 450.0, 500.0, 600.0, 700.0, 800.0, 900.0, 1000.0})
        if (size_m.x * 1000.0 / one_to <= room_mm.x && size_m.y * 1000.0 / one_to <= room_mm.y) return one_to;
    return 0.0;
}

// What is made of one sheet, in the order in which things take their places: walls, stairs, base, signs, things.
class SheetMaker {
public:
    SheetMaker(const Storey& storey, BrailleTable table) : storey_(storey), table_(table) {}

    Result<SwellSheet> make(const PaperSize& paper) {
        if (const Result<void> laid = lay_out(paper); !laid) return tl::unexpected(laid.error());
        draw_walls();
        draw_stairs();
        draw_base();
        if (const Result<void> signs = draw_signs(); !signs) return tl::unexpected(signs.error());
        draw_things();
        if (const Result<void> head = draw_frame(); !head) return tl::unexpected(head.error());
        tell();
        return write_key();
    }

private:
    Result<void> lay_out(const PaperSize& paper) {
        const Vec2 size_m = storey_.max_m - storey_.min_m;
        const auto room = [&](bool across) {
            const Vec2 page = across ? Vec2(paper.long_mm, paper.short_mm) : Vec2(paper.short_mm, paper.long_mm);
            return page - Vec2(2.0 * kMargin_mm, 2.0 * kMargin_mm + kHead_mm + kFoot_mm);
        };
        const double upright = whole_scale(size_m, room(false)), across = whole_scale(size_m, room(true));
        if (upright == 0.0 && across == 0.0)
            return fail(phrase("export.too_large", {{"x", size_m.x}, {"y", size_m.y}}));
        const bool turned = upright == 0.0 || (across != 0.0 && across < upright);
        made_.one_to = turned ? across : upright;
        on_paper_.from_m = storey_.min_m;
        on_paper_.mm_per_m = 1000.0 / made_.one_to;
        made_.plan.width_mm = turned ? paper.long_mm : paper.short_mm;
        made_.plan.height_mm = turned ? paper.short_mm : paper.long_mm;
        on_paper_.shift_mm =
            Vec2(kMargin_mm, kMargin_mm + kFoot_mm) + 0.5 * (room(turned) - size_m * on_paper_.mm_per_m);
        return {};
    }

    void draw_walls() {
        walls_ = ink_of_walls(storey_, on_paper_, made_.plan.width_mm, made_.plan.height_mm,
                              {kWallLine_mm, kClear_mm, kLeastSymbol_mm + 0.2, kLeastPiece_mm});
        hollow_ = hollow_out(walls_.ink, kHollowFrom_mm, kWallLine_mm, kHollowLong_mm);
        made_.plan.shapes.push_back({traced_mm(walls_.ink), kWalls});
        places_ = Places(walls_.ink, kClear_mm, {kMargin_mm, kMargin_mm + kFoot_mm},
                         {made_.plan.width_mm - kMargin_mm, made_.plan.height_mm - kMargin_mm - kHead_mm});
        beside_things_ = places_;
        for (const StoreyThing& thing : storey_.things) beside_things_.take(corners_of(on_paper_(thing.box)));
    }

    void draw(Loops loops) {
        places_.take(loops.front());
        beside_things_.take(loops.front());
        made_.plan.shapes.push_back({std::move(loops), ++parts_});
    }

    // --- what is drawn in them

    void draw_stairs() {
        for (const PlanBox& line : stair_lines(storey_, on_paper_, places_, kThinLine_mm, kClear_mm, kLeastStair_mm)) {
            draw({corners_of(line)});
            stairs_ = true;
        }
    }

    void draw_base() {
        if (!storey_.base) return;
        const auto arrow = arrow_of_base(*storey_.base, on_paper_, walls_.ink, places_,
                                         {0.6 * kLeastSymbol_mm, 0.5 * kLeastSymbol_mm});
        if (!arrow) {
            base_ = phrase("export.base_left_out");
            return;
        }
        if (arrow->off_mm > 1.0) base_ = phrase("export.base_moved");
        draw({arrow->loop_mm});
        base_drawn_ = true;
    }

    Result<void> draw_signs() {
        made_.signs = room_signs(storey_);
        for (std::size_t i = 0; i < storey_.rooms.size(); ++i) {
            const Result<BrailleCells> cells = braille_signs(made_.signs[i].sign, table_);
            if (!cells) return tl::unexpected(cells.error());
            const Vec2 half = 0.5 * braille_size_mm(cells->size());
            const std::optional<Vec2> place =
                place_of_sign(storey_, i, on_paper_, walls_.ink, places_, beside_things_, half);
            if (!place) continue;
            made_.signs[i].on_sheet = true;
            const std::vector<Vec2> corners = corners_of(PlanBox{*place, {1.0, 0.0}, half});
            places_.take(corners);
            beside_things_.take(corners);
            lay_braille(made_.plan, *cells, *place + Vec2(-half.x, half.y) + Vec2(0.5, -0.5) * kBrailleDot_mm,
                        ++parts_);
        }
        return {};
    }

    void draw_things() {
        thing_drawn_.assign(storey_.things.size(), false);
        for (std::size_t i = 0; i < storey_.things.size(); ++i) {
            const StoreyThing& thing = storey_.things[i];
            const ThingFit fit = fit_of_thing(thing, on_paper_, places_, kLeastSymbol_mm);
            if (!fit.box) {
                left_out_.push_back(thing.name);
                continue;
            }
            if (fit.shrunk) shrunk_.push_back(thing.name);
            PlanBox inner = *fit.box;
            inner.half_m -= Vec2(kThinLine_mm);
            std::vector<Vec2> hole = corners_of(inner);
            std::reverse(hole.begin(), hole.end());
            draw({corners_of(*fit.box), std::move(hole)});
            thing_drawn_[i] = true;
            made_.drawn.push_back(thing.name);
        }
    }

    // Name of the sheet, north, and a bar to measure by.
    Result<void> draw_frame() {
        SheetPage& page = made_.plan;
        page.title = phrase("export.sheet_title",
                            {{"world", storey_.world}, {"storey", storey_.number}, {"count", storey_.count}});
        const double top = page.height_mm - kMargin_mm, right = page.width_mm - kMargin_mm;
        const Result<BrailleCells> title = braille_of(page.title, table_);
        if (!title) return tl::unexpected(title.error());
        const auto width = static_cast<std::size_t>((right - kMargin_mm - 20.0) / kBrailleCell_mm);
        lay_braille(page, braille_lines(*title, width, 0).front(),
                    Vec2(kMargin_mm, top) + Vec2(0.5, -0.5) * kBrailleDot_mm, ++parts_);
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
        return {};
    }

    void tell() {
        std::vector<std::string>& said = made_.simplified;
        if (walls_.thicker > 0)
            said.push_back(phrase("export.walls_thicker", {{"count", walls_.thicker}, {"mm", kWallLine_mm}}));
        if (walls_.joined > 0) said.push_back(phrase("export.joined", {{"count", walls_.joined}}));
        if (hollow_ > 0) said.push_back(phrase("export.hollow", {{"count", hollow_}}));
        if (walls_.pieces_left_out > 0)
            said.push_back(phrase("export.pieces_left_out", {{"count", walls_.pieces_left_out}}));
        if (walls_.wider > 0)
            said.push_back(phrase("export.doors_wider", {{"count", walls_.wider}, {"mm", kLeastSymbol_mm}}));
        if (!walls_.narrow_doors.empty())
            said.push_back(
                phrase("export.doors_narrow", {{"names", names_list(walls_.narrow_doors)}, {"mm", kLeastSymbol_mm}}));
        if (!base_.empty()) said.push_back(base_);
        std::vector<std::string> unsigned_rooms;
        for (const RoomSign& sign : made_.signs)
            if (!sign.on_sheet) unsigned_rooms.push_back(sign.name);
        if (!unsigned_rooms.empty())
            said.push_back(
                phrase("export.no_sign", {{"count", unsigned_rooms.size()}, {"names", names_list(unsigned_rooms)}}));
        if (!shrunk_.empty()) said.push_back(phrase("export.shrunk", {{"names", names_list(shrunk_)}}));
        if (!left_out_.empty()) said.push_back(phrase("export.left_out", {{"names", names_list(left_out_)}}));
        if (storey_.moving > 0) said.push_back(phrase("export.moving", {{"count", storey_.moving}}));
    }

    // The room whose floor is nearest to a thing.
    std::size_t room_of(const StoreyThing& thing) const {
        for (double far = 0.0; far < 5.0; far += 0.2)
            for (int way = 0; way < 16; ++way) {
                const double turn = way * kPi / 8.0;
                const std::uint32_t room =
                    floor_at(storey_, thing.box.middle_m + Vec2(std::cos(turn), std::sin(turn)) * far);
                if (room != kNothing) return room;
            }
        return 0;
    }

    Result<SwellSheet> write_key() {
        std::vector<KeyLine> text;
        const auto add = [&](std::string line) { text.push_back({{}, std::move(line)}); };
        add(made_.plan.title);
        add(phrase("export.key_scale", {{"one_to", made_.one_to}, {"metres", bar_m_}}));
        add(phrase("export.key_lines"));
        if (base_drawn_) add(phrase("export.key_base"));
        if (stairs_) add(phrase("export.key_stairs"));
        if (!made_.drawn.empty()) add(phrase("export.key_things"));
        std::vector<std::vector<std::string>> in_room(storey_.rooms.size());
        for (std::size_t i = 0; i < storey_.things.size(); ++i)
            if (thing_drawn_[i]) in_room[room_of(storey_.things[i])].push_back(storey_.things[i].name);
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < made_.signs.size(); ++i) order.push_back(i);
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const RoomSign &one = made_.signs[a], &other = made_.signs[b];
            if (one.on_sheet != other.on_sheet) return one.on_sheet;
            return one.on_sheet ? one.sign < other.sign : one.name < other.name;
        });
        for (const std::size_t i : order) {
            const RoomSign& sign = made_.signs[i];
            const std::string name = capitalised(sign.name);
            std::string line = sign.on_sheet ? name + "." : phrase("export.key_room_unsigned", {{"name", name}});
            if (!in_room[i].empty())
                line += " " + phrase("export.key_room_things", {{"names", names_list(in_room[i])}});
            text.push_back({sign.on_sheet ? sign.sign : std::string(), std::move(line)});
        }
        for (const std::string& sentence : made_.simplified) add(sentence);
        for (const KeyLine& line : text) {
            made_.key_text.push_back(line.sign.empty() ? line.text : line.sign + "  " + line.text);
            made_.plan.text += made_.key_text.back() + "\n";
        }
        Result<std::vector<SheetPage>> key = braille_pages(text, table_, made_.plan.width_mm, made_.plan.height_mm,
                                                           phrase("export.key_title", {{"title", made_.plan.title}}));
        if (!key) return tl::unexpected(key.error());
        made_.key = std::move(*key);
        return std::move(made_);
    }

    const Storey& storey_;
    BrailleTable table_;
    SwellSheet made_;
    OnPaper on_paper_;
    double bar_m_ = 5.0;
    int parts_ = kWalls;
    WallInk walls_;
    Places places_;         // where something may be drawn
    Places beside_things_;  // and where no thing will stand
    int hollow_ = 0;
    bool stairs_ = false, base_drawn_ = false;
    std::string base_;
    std::vector<bool> thing_drawn_;
    std::vector<std::string> shrunk_, left_out_;
};

}  // namespace

std::vector<RoomSign> room_signs(const Storey& storey) {
    std::set<std::string> used;
    std::vector<RoomSign> signs;
    for (const StoreyRoom& room : storey.rooms) {
        std::string letters, number;
        for (const char c : room.name)
            if (std::isalpha(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 0x80)
                letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        for (std::size_t i = room.name.size(); i > 0 && std::isdigit(static_cast<unsigned char>(room.name[i - 1])); --i)
            number.insert(number.begin(), room.name[i - 1]);
        if (letters.empty()) letters = "x";
        std::vector<std::string> wished;
        if (!number.empty() && number.size() <= 3) wished.push_back(letters.substr(0, 1) + number);
        for (std::size_t i = 1; i < letters.size(); ++i) wished.push_back({letters[0], letters[i]});
        std::string sign;
        for (const std::string& wish : wished)
            if (sign.empty() && used.insert(wish).second) sign = wish;
        for (int i = 1; sign.empty(); ++i)
            if (const std::string wish = letters.substr(0, 1) + std::to_string(i); used.insert(wish).second)
                sign = wish;
        signs.push_back({sign, room.name, false});
    }
    return signs;
}

Result<SwellSheet> swell_sheet(const Storey& storey, const PaperSize& paper, BrailleTable table) {
    return SheetMaker(storey, table).make(paper);
}

}  // namespace handrail
