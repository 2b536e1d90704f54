// Checks the layout of the window, the contrast of its colours, and which lines of the last messages are shown.
#include "app/window/window_layout.h"

#include <imgui.h>

#include <random>

#include "app/window/large_text.h"
#include "app/window/palette.h"
#include "app/window/plan_labels.h"
#include "app/window/window.h"
#include "tests/support/names.h"

namespace handrail::test {
namespace window_layout_test {

constexpr PixelSize kSizes[] = {{800, 600}, {1280, 720}, {1920, 1080}, {3840, 2160}, {600, 900}, {400, 300}};

bool inside(const PixelBox& box, PixelSize size) {
    return box.min_px.x >= 0.0 && box.min_px.y >= 0.0 && box.max_px.x <= size.width && box.max_px.y <= size.height;
}

bool meet(const PixelBox& a, const PixelBox& b) {
    return a.min_px.x < b.max_px.x && b.min_px.x < a.max_px.x && a.min_px.y < b.max_px.y && b.min_px.y < a.max_px.y;
}

TEST(WindowLayout, puts_no_text_over_a_picture_at_any_size) {
    for (const PixelSize size : kSizes)
        for (const double text_size : {0.5, 1.0, 1.5})
            for (const Pictures pictures : {Pictures::Both, Pictures::Plan, Pictures::FirstPerson}) {
                const WindowLayout layout = lay_out_window(size, pictures, text_size);
                SCOPED_TRACE(fmt::format("{} by {}, text {}", size.width, size.height, text_size));
                for (const PixelBox& box : {layout.pictures, layout.status, layout.messages}) {
                    EXPECT_TRUE(inside(box, size));
                    EXPECT_FALSE(is_empty(box));
                }
                EXPECT_FALSE(meet(layout.pictures, layout.status));
                EXPECT_FALSE(meet(layout.pictures, layout.messages));
                EXPECT_FALSE(meet(layout.status, layout.messages));
                EXPECT_EQ(is_empty(layout.plan), pictures == Pictures::FirstPerson);
                EXPECT_EQ(is_empty(layout.first_person), pictures == Pictures::Plan);
                EXPECT_FALSE(!is_empty(layout.plan) && !is_empty(layout.first_person) &&
                             meet(layout.plan, layout.first_person));
                EXPECT_GE(layout.pictures.max_px.y, (kLeastPicturesPart - 0.01) * size.height);
                // Two lines of the status, two lines of the newest message and four older ones fit.
                EXPECT_GE(layout.status.max_px.y - layout.status.min_px.y, 2.0 * layout.small_px - 1e-6);
                EXPECT_GE(layout.messages.max_px.y - layout.messages.min_px.y,
                          2.0 * layout.line_px + 4.0 * layout.small_px - 1e-6);
            }
}

TEST(WindowLayout, makes_text_as_large_as_the_person_wants) {
    const auto line = [](double text_size) { return lay_out_window({1280, 720}, Pictures::Both, text_size).line_px; };
    EXPECT_EQ(line(1.0), 60.0F);
    EXPECT_EQ(line(0.5), 30.0F);
    EXPECT_GT(line(1.5), 80.0F);
}

TEST(WindowLayout, puts_pictures_one_above_the_other_in_a_high_window) {
    const WindowLayout wide = lay_out_window({1280, 720}, Pictures::Both, 1.0);
    EXPECT_LT(wide.first_person.max_px.x, wide.plan.min_px.x);
    const WindowLayout high = lay_out_window({600, 1400}, Pictures::Both, 1.0);
    EXPECT_LT(high.first_person.max_px.y, high.plan.min_px.y);
}

// ---- colours ----

constexpr settings::ColourSet kSets[] = {settings::ColourSet::Dark, settings::ColourSet::Light,
                                         settings::ColourSet::HighContrast, settings::ColourSet::ColourSafe};

TEST(Contrast, is_that_of_the_guidelines) {
    EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21.0, 1e-9);
    EXPECT_NEAR(contrast({255, 255, 255}, {255, 255, 255}), 1.0, 1e-9);
    EXPECT_NEAR(contrast({119, 119, 119}, {255, 255, 255}), 4.48, 0.01);  // the guidelines' well-known border of grey
}

TEST(Palettes, separate_neighbouring_faces_of_the_plan_by_three_to_one) {
    for (const settings::ColourSet set : kSets) {
        const Palette& p = palette_of(set);
        SCOPED_TRACE(static_cast<int>(set));
        EXPECT_GE(contrast(p.ground, p.text), 7.0);
        struct Face {
            const char* name;
            Rgb filling, outline;
            bool outlined;
        };
        const Face faces[] = {{"outside", p.outside, {}, false},
                              {"inside", p.inside, {}, false},
                              {"wall", p.wall, {}, false},
                              {"object", p.object, p.object_outline, true},
                              {"door", p.door, p.door_outline, true},
                              {"mover", p.door, p.mover_outline, true}};
        const auto set_apart = [](const Face& a, const Face& b) {
            const auto outline = [](const Face& own, const Face& other) {
                return own.outlined && contrast(own.outline, own.filling) >= 3.0 &&
                       contrast(own.outline, other.filling) >= 3.0;
            };
            return contrast(a.filling, b.filling) >= 3.0 || outline(a, b) || outline(b, a);
        };
        for (const Face& a : faces)
            for (const Face& b : faces) {
                if (&a >= &b) continue;
                // With high contrast, walls and outlines of rooms are between inside and outside.
                if (set == settings::ColourSet::HighContrast && b.filling == p.inside && a.filling == p.outside &&
                    !a.outlined && !b.outlined)
                    continue;
                // The outlines of doors and movers, which are both open in the middle, have different signs.
                if (a.outlined && b.outlined) continue;
                EXPECT_TRUE(set_apart(a, b)) << a.name << " and " << b.name << ": " << contrast(a.filling, b.filling);
            }
        for (const auto& [name, line] : {std::pair("low", p.low), std::pair("liquid", p.liquid),
                                         std::pair("path", p.path), std::pair("room outline", p.room_outline)})
            EXPECT_GE(contrast(line, p.inside), 3.0) << name;
        // These have a border in the colour of the ground.
        for (const auto& [name, sign] :
             {std::pair("route", p.route), std::pair("hand path", p.hand_path), std::pair("beacon", p.beacon),
              std::pair("mark", p.mark), std::pair("walker", p.walker), std::pair("hand", p.hand),
              std::pair("touching", p.touching), std::pair("force", p.force)})
            EXPECT_GE(contrast(sign, p.ground), 3.0) << name;
    }
}

// ---- messages ----

class Letters : public ::testing::Test {
protected:
    Letters() : context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        font_ = ImGui::GetIO().Fonts->AddFontDefault();
        ImGui::GetIO().Fonts->Build();
    }
    ~Letters() override { ImGui::DestroyContext(context_); }

    std::vector<TextLine> lines(const std::vector<std::string>& messages) {
        return message_lines(*font_, messages, layout_);
    }
    double height(const std::vector<TextLine>& lines) const {
        double high = 0.0;
        for (const TextLine& line : lines) high += line.high_px;
        return high;
    }

    ImGuiContext* context_;
    ImFont* font_ = nullptr;
    const WindowLayout layout_ = lay_out_window({960, 720}, Pictures::Both, 1.0);
};

class Messages : public Letters {};
class Names : public Letters {};

TEST_F(Messages, show_the_last_five_completely_if_they_are_short) {
    const auto shown = lines({"one", "two", "three", "four", "five"});
    ASSERT_EQ(shown.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const char* words[] = {"five", "four", "three", "two", "one"};
        EXPECT_EQ(shown[i].text, words[i]);
        EXPECT_EQ(shown[i].high_px, i == 0 ? layout_.line_px : layout_.small_px);
    }
    EXPECT_TRUE(lines({}).empty());
}

TEST_F(Messages, fill_the_box_and_never_more_than_it) {
    for (const int words : {1, 4, 8, 16, 30, 60, 400})
        for (std::size_t count = 1; count <= 5; ++count) {
            std::string text;
            for (int i = 0; i < words; ++i) text += "corridor ";
            const auto shown = lines(std::vector<std::string>(count, text));
            EXPECT_LE(height(shown), layout_.messages.max_px.y - layout_.messages.min_px.y + 1e-6) << words;
            for (const TextLine& line : shown)
                EXPECT_LE(font_->CalcTextSizeA(line.high_px, 1e9F, 0.0F, line.text.c_str()).x,
                          layout_.messages.max_px.x - layout_.messages.min_px.x)
                    << line.text;
        }
}

TEST_F(Messages, show_a_long_newest_message_completely_before_older_ones) {
    std::string text;
    for (int i = 0; i < 30; ++i) text += "corridor ";
    const auto shown = lines({"older", text});
    std::string newest;
    for (const TextLine& line : shown)
        if (line.text != "older") newest += line.text + " ";
    EXPECT_EQ(std::count(newest.begin(), newest.end(), 'd'), 30);
    EXPECT_EQ(shown.front().high_px, layout_.small_px);
    // Three dots show that more words follow.
    std::string endless;
    for (int i = 0; i < 400; ++i) endless += "corridor ";
    EXPECT_TRUE(lines({"older", endless}).back().text.ends_with(" ..."));
}

TEST_F(Messages, of_the_status_get_smaller_letters_before_they_are_cut) {
    const std::string text =
        "Hand 2.7 metres, 25 degrees right, 0.1 newtons, force on: East wall, plaster; Floor, stone";
    const float wide_px = font_->CalcTextSizeA(30.0F, 1e9F, 0.0F, text.c_str()).x;
    EXPECT_EQ(status_px(*font_, text, wide_px + 1.0F, 30.0F), 30.0F);
    EXPECT_NEAR(status_px(*font_, text, 0.8F * wide_px, 30.0F), 24.0F, 0.1F);
    EXPECT_NEAR(status_px(*font_, text, 0.1F * wide_px, 30.0F), 18.0F, 0.1F);
}

// ---- names on the plan ----

TEST_F(Names, on_the_plan_never_cover_each_other_or_a_sign) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> across(0.0F, 600.0F), down(0.0F, 400.0F);
    const PixelBox inside{Vec2(0.0), Vec2(600.0, 400.0)};
    for (int round = 0; round < 200; ++round) {
        std::vector<window::Label> labels;
        for (int i = 0; i < 60; ++i)
            labels.push_back({i % 3 ? "Room " + std::to_string(i) : "Assembly hall on the ground floor",
                              {across(random), down(random)},
                              i == 0});
        std::vector<LabelBox> signs;
        for (int i = 0; i < 5; ++i) {
            const ImVec2 at(across(random), down(random));
            signs.push_back({at, {at.x + 30.0F, at.y + 30.0F}});
        }
        const auto placed = place_labels(*font_, labels, signs, inside, 5.0F);
        EXPECT_GE(placed.size(), 10U);
        for (std::size_t i = 0; i < placed.size(); ++i) {
            EXPECT_GE(placed[i].box.from.x, 0.0F);
            EXPECT_LE(placed[i].box.to.y, 400.0F);
            EXPECT_GE(placed[i].text_px, 15.0F);
            for (const LabelBox& sign : signs) EXPECT_FALSE(placed[i].box.meets(sign));
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(placed[i].box.meets(placed[j].box));
        }
    }
    // Without neighbours, a name is in the largest letters and in the middle of its place.
    const auto alone = place_labels(*font_, {{"Kitchen", {300.0F, 200.0F}}}, {}, inside, 5.0F);
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_EQ(alone[0].text_px, 25.0F);
    EXPECT_NEAR(alone[0].box.from.x + alone[0].box.to.x, 600.0F, 1e-3F);
}

// ---- the place of the window ----

TEST(WindowPlace, is_read_as_it_is_written) {
    const WindowPlace place{100, -50, 1280, 720};
    EXPECT_EQ(window_place_text(place), "1280x720+100+-50");
    EXPECT_EQ(window_place(window_place_text(place)), place);
    for (const char* wrong : {"", "1280", "1280x720", "1280x720+1", "0x720+1+1", "1280x720+1+1 ", "ax720+1+1",
                              "99999999999x1+1+1", "1280x-720+1+1", "2000000x720+1+1"})
        EXPECT_FALSE(window_place(wrong)) << wrong;
}

}  // namespace window_layout_test
}  // namespace handrail::test
