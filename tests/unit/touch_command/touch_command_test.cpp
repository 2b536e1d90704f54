// Tests the contract of `handrail touch`: its input, its output and what it refuses.
#include <sstream>

#include "app/main/commands.h"
#include "haptic/device/device_spec.h"
#include "tests/support/map_text.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/vec.h"

namespace handrail::test {
namespace touch_command_test {

struct Row {
    std::vector<std::string> cells;
    double number(std::size_t i) const { return std::stod(cells.at(i)); }
    Vec3 position() const { return {number(1), number(2), number(3)}; }
    Vec3 proxy() const { return {number(4), number(5), number(6)}; }
    Vec3 force() const { return {number(7), number(8), number(9)}; }
    int contacts() const { return std::stoi(cells.at(10)); }
    const std::string& feature() const { return cells.at(11); }
    const std::string& fault() const { return cells.at(12); }
};

// Parses CSV as RFC 4180 defines it, except that each row must be one line. No name in the tests contains a line break.
std::vector<Row> rows_of(const std::string& csv) {
    std::vector<Row> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "t,x,y,z,px,py,pz,fx,fy,fz,contacts,feature,fault,tick_ns\r");
    while (std::getline(lines, line)) {
        EXPECT_TRUE(line.ends_with('\r')) << line;
        line.pop_back();
        Row row;
        std::string cell;
        bool quoted = false;
        for (std::size_t i = 0; i <= line.size(); ++i) {
            if (i == line.size() || (line[i] == ',' && !quoted)) {
                row.cells.push_back(std::exchange(cell, {}));
            } else if (line[i] == '"') {
                if (quoted && i + 1 < line.size() && line[i + 1] == '"') cell += line[i++];
                else quoted = !quoted;
            } else {
                cell += line[i];
            }
        }
        EXPECT_EQ(row.cells.size(), 14U) << line;
        rows.push_back(std::move(row));
    }
    return rows;
}

// The world of the tests is a table with its top at z = 0. The table measures 128 x 128 x 32 units, so it is 4 m wide
// at 1/32 m per unit.
class TouchCommand : public testing::Test {
protected:
    TemporaryFolder folder_;
    TouchArguments arguments_;
    std::string error_;

    void SetUp() override {
        arguments_.world =
            folder_.write("table.map", entity("worldspawn") + entity("func_wall", key("name", "Table, round"),
                                                                     box_brush(-64, -64, -32, 64, 64, 0)));
        arguments_.out_csv = folder_.path() / "out.csv";
    }
    int run(const std::string& csv) {
        arguments_.path_csv = folder_.write("in.csv", csv);
        std::ostringstream out, err;
        const int status = run_touch(arguments_, out, err);
        error_ = err.str();
        EXPECT_EQ(out.str(), "");
        EXPECT_EQ(status == 0, error_.empty()) << error_;
        return status;
    }
    std::vector<Row> rows(const std::string& csv) {
        EXPECT_EQ(run(csv), 0) << error_;
        return rows_of(content_of(arguments_.out_csv));
    }
    // Returns a path that moves down at 0.1 m/s to `depth` below the table's top and then stays there for `hold` rows.
    static std::string press(double depth, int hold = 50) {
        std::string csv = "t,x,y,z\n";
        int i = 0;
        for (double z = 0.02; z > -depth; z -= 1e-4) csv += fmt::format("{},0,0,{}\n", i++ * 1e-3, z);
        while (hold-- > 0) csv += fmt::format("{},0,0,{}\n", i++ * 1e-3, -depth);
        return csv;
    }
};

TEST_F(TouchCommand, writes_one_row_per_input_row_and_follows_exactly_before_contact) {
    const std::vector<Row> out = rows("t,x,y,z\r\n0,0,0,0.1\r\n\r\n0.001,1e-3,0.0,0.30000000000000004\r\n\n5,-0,0.5,1");
    ASSERT_EQ(out.size(), 3U);
    EXPECT_EQ(out[0].cells, (std::vector<std::string>{"0", "0", "0", "0.1", "0", "0", "0.1", "0", "0", "0", "0", "", "",
                                                      out[0].cells[13]}));
    EXPECT_EQ(out[1].cells[3], "0.30000000000000004");
    EXPECT_EQ(out[1].cells[6], "0.30000000000000004");
    EXPECT_EQ(out[1].cells[1], "0.001");
    EXPECT_EQ(out[2].cells[1], "0") << "no negative zero";
    EXPECT_EQ(content_of(arguments_.out_csv).find("-0,"), std::string::npos);
    const std::string csv = content_of(arguments_.out_csv);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\r'), 4) << "RFC 4180 ends lines with both";
}

TEST_F(TouchCommand, presses_back_with_800_newtons_per_metre_and_names_the_touched_thing) {
    const Row last = rows(press(0.003)).back();
    EXPECT_NEAR(last.force().z, 800.0 * 0.008, 1e-9);
    EXPECT_NEAR(last.proxy().z, 0.005, 1e-9);
    EXPECT_EQ(last.contacts(), 1);
    EXPECT_EQ(last.feature(), "Table, round");
    EXPECT_EQ(last.fault(), "");
}

// A crate of 1 kg, half a metre wide, stands on a floor. The hand pushes one of its sides and moves on to 20 cm beyond
// where that side was.
TEST_F(TouchCommand, pushes_free_bodies_in_virtual_time_with_bit_identical_results) {
    const auto world = [](const std::string& free) {
        return entity("worldspawn", "", room_brushes(-128, -128, 0, 128, 128, 96)) +
               entity("info_player_start", key("origin", "-64 -64 24")) +
               entity("thing", key("name", "Crate") + free + key("material", "wood"), box_brush(-8, -8, 0, 8, 8, 16));
    };
    arguments_.scale_world_m_per_hand_m = 20.0;
    std::string push = "t,x,y,z\n";
    for (int i = 0; i < 1200; ++i) push += fmt::format("{},{},0,0.2\n", i * 1e-3, -0.45 + std::min(i, 1000) * 4e-4);
    const auto pushed = [&](const std::string& free) {
        arguments_.world = folder_.write("crate.map", world(free));
        std::vector<Row> out = rows(push);
        for (Row& row : out) row.cells.pop_back();  // removes the column with the duration of the tick
        return out;
    };
    const std::vector<Row> fixed = pushed(""), first = pushed(key("free", "1") + key("mass", "1"));
    ASSERT_EQ(fixed.size(), first.size());
    // The side of a fixed crate must stop the proxy. A free crate must move along, and the hand must feel the crate's
    // friction.
    const double side_m = fixed.back().proxy().x;
    EXPECT_NEAR(side_m, -0.25 - 0.005, 0.01);
    EXPECT_GT(first.back().proxy().x, side_m + 0.15);
    EXPECT_GT(glm::length(fixed.back().force()), glm::length(first.back().force()));
    EXPECT_TRUE(std::any_of(first.begin(), first.end(), [](const Row& row) { return row.feature() == "Crate, wood"; }));
    const std::vector<Row> again = pushed(key("free", "1") + key("mass", "1"));
    for (std::size_t i = 0; i < first.size(); ++i) ASSERT_EQ(again[i].cells, first[i].cells) << "row " << i;
}

// If rows are far apart in time, the command must still end. At the time of the later row, the pushed body must have
// come to rest.
TEST_F(TouchCommand, terminates_for_rows_a_year_apart_with_moving_bodies) {
    arguments_.world =
        folder_.write("crate.map", entity("worldspawn", "", room_brushes(-128, -128, 0, 128, 128, 96)) +
                                       entity("info_player_start", key("origin", "-64 -64 24")) +
                                       entity("thing", key("name", "Crate") + key("free", "1") + key("mass", "1"),
                                              box_brush(-8, -8, 0, 8, 8, 16)));
    EXPECT_EQ(rows("t,x,y,z\n0,-0.5,0,0.2\n0.001,-0.4,0,0.2\n31557600,-0.4,0,0.2\n").size(), 3U);
}

TEST_F(TouchCommand, accepts_radius_stiffness_scale_and_map_scale) {
    arguments_.radius_m = 0.0;
    arguments_.stiffness_n_per_m = 500.0;
    EXPECT_NEAR(rows(press(0.002)).back().proxy().z, 1e-5, 1e-12);
    EXPECT_NEAR(rows(press(0.002)).back().force().z, 500.0 * 0.00201, 1e-9);
    arguments_.scale_world_m_per_hand_m = 10.0;
    EXPECT_NEAR(rows(press(0.002)).back().force().z, 50.0 * 0.00201, 1e-9);
    arguments_.scale_world_m_per_hand_m = 1.0;
    arguments_.radius_m = 0.005;
    arguments_.common.map_scale_m_per_unit = 1.0 / 64.0;
    // At this scale, the table extends 1 m from its middle to its edge. Beyond the edge, the hand must feel nothing.
    EXPECT_EQ(rows("t,x,y,z\n0,1.5,0,0.01\n0.001,1.5,0,0.009\n0.002,1.5,0,-0.1\n").back().force(), Vec3(0.0));
}

TEST_F(TouchCommand, rubs_with_the_given_friction_and_damping) {
    arguments_.friction_kinetic = 0.4;  // also sets the static friction
    std::string csv = press(0.0);
    for (int i = 1; i <= 400; ++i) csv += fmt::format("{},{},0,0\n", 1.0 + i * 1e-3, i * 1e-4);
    Row last = rows(csv).back();
    EXPECT_NEAR(last.force().x, -0.4 * last.force().z, 1e-6);
    arguments_.friction_kinetic.reset();
    last = rows(csv).back();
    EXPECT_EQ(last.force().x, 0.0);
    arguments_.damping_ns_per_m = 10.0;
    const std::vector<Row> damped = rows(press(0.05, 0));
    EXPECT_NEAR(damped.back().force().z, 800.0 * (damped.back().proxy().z - damped.back().position().z) + 10.0 * 0.1,
                1e-3);
}

TEST_F(TouchCommand, marks_bad_rows_and_resumes_the_force_afterwards) {
    std::string csv = press(0.003, 10);
    csv += "1,nan,0,0\n1.001,0,-inf,0\n1.002,0,0,2e6\n1.003,0,0,1e999\n1.004,0,0,-0.003\n";
    const std::vector<Row> out = rows(csv);
    const std::size_t n = out.size();
    EXPECT_EQ(out[n - 5].fault(), "not_finite");
    EXPECT_EQ(out[n - 5].cells[1], "nan");
    EXPECT_EQ(out[n - 4].fault(), "not_finite");
    EXPECT_EQ(out[n - 4].cells[2], "-inf");
    EXPECT_EQ(out[n - 3].fault(), "out_of_range");
    EXPECT_EQ(out[n - 2].fault(), "out_of_range");
    for (std::size_t i = n - 5; i < n - 1; ++i) {
        EXPECT_EQ(out[i].force(), Vec3(0.0));
        EXPECT_EQ(out[i].contacts(), 0);
        EXPECT_EQ(out[i].feature(), "");
        EXPECT_EQ(out[i].proxy(), out[n - 6].proxy());
    }
    EXPECT_EQ(out[n - 1].fault(), "");
    EXPECT_EQ(out[n - 1].force(), out[n - 6].force());
    const std::vector<Row> from_the_start = rows("t,x,y,z\n0,nan,nan,nan\n1,0,0,1\n");
    EXPECT_EQ(from_the_start[0].proxy(), Vec3(0.0));
    EXPECT_EQ(from_the_start[1].proxy(), Vec3(0, 0, 1));
}

TEST_F(TouchCommand, ignores_a_solid_around_the_start_without_reporting_a_fault) {
    const std::vector<Row> out = rows("t,x,y,z\n0,0,0,-0.5\n0.001,0.001,0,-0.5\n0.002,0.001,0,-0.499\n");
    for (const Row& row : out) {
        EXPECT_EQ(row.force(), Vec3(0.0));
        EXPECT_EQ(row.proxy(), row.position());
        EXPECT_EQ(row.fault(), "");
    }
}

TEST_F(TouchCommand, applies_stiffness_rating_peak_force_and_jump_check_of_a_device) {
    const DeviceSpec* spec = find_device_spec("sim-t");
    ASSERT_NE(spec, nullptr);
    arguments_.device = "SIM-T";
    Row last = rows(press(0.001)).back();
    EXPECT_NEAR(last.force().z, std::min(0.8 * spec->rated_stiffness_n_per_m * 0.006, spec->peak_force_n), 1e-9);
    last = rows(press(0.1)).back();
    EXPECT_NEAR(last.force().z, spec->peak_force_n, 1e-12);
    // A spike in the path gives one row with a fault. A real jump also gives one; in the next row, the command accepts
    // the new place.
    const std::vector<Row> spike = rows("t,x,y,z\n0,0,0,1\n1,0,0,1.06\n2,0,0,1.001\n3,0.03,0,1\n4,0.031,0,1\n");
    EXPECT_EQ(spike[1].fault(), "jump");
    EXPECT_EQ(spike[1].proxy(), Vec3(0, 0, 1));
    EXPECT_EQ(spike[2].fault(), "");
    EXPECT_EQ(spike[3].fault(), "jump");
    EXPECT_EQ(spike[4].fault(), "");
    EXPECT_EQ(spike[4].proxy(), Vec3(0.031, 0, 1));
    arguments_.scale_world_m_per_hand_m = 4.0;
    EXPECT_EQ(rows("t,x,y,z\n0,0,0,1\n1,0,0,1.06\n").back().fault(), "");
    arguments_.scale_world_m_per_hand_m = 1.0;
    for (const std::optional<std::string>& ideal :
         {std::optional<std::string>("ideal"), std::optional<std::string>()}) {
        arguments_.device = ideal;
        EXPECT_EQ(rows("t,x,y,z\n0,0,0,1\n1,0,0,9\n").back().fault(), "") << "the ideal device may jump";
    }
}

TEST_F(TouchCommand, follows_a_long_jump_in_free_space_at_once) {
    const std::vector<Row> out = rows("t,x,y,z\n0,0,0,1\n1,500,-300,4000\n2,0,0,2\n");
    EXPECT_EQ(out[1].proxy(), Vec3(500, -300, 4000));
    EXPECT_EQ(out[2].proxy(), Vec3(0, 0, 2));
    EXPECT_EQ(out[2].force(), Vec3(0.0));
}

TEST_F(TouchCommand, refuses_an_unknown_device_and_lists_the_known_ones) {
    arguments_.device = "spoon";
    EXPECT_EQ(run("t,x,y,z\n0,0,0,0\n"), 2);
    EXPECT_THAT(error_, testing::HasSubstr("falcon"));
    EXPECT_THAT(error_, testing::HasSubstr("sim-t"));
    EXPECT_FALSE(std::filesystem::exists(arguments_.out_csv));
}

TEST_F(TouchCommand, refuses_bad_headers_cells_and_times_by_line_and_writes_nothing) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {"", "line 1"},
        {"x,y,z,t\n0,0,0,0\n", "line 1"},
        {"0,0,0,0\n", "line 1"},
        {"t,x,y,z\n0,0,0,0\n1,2,3\n", "line 3"},
        {"t,x,y,z\n0,0,0,0,0\n", "line 2"},
        {"t,x,y,z\r\n\r\n0,0,soft,0\r\n", "line 3"},
        {"t,x,y,z\n0,0,,0\n", "line 2"},
        {"t,x,y,z\n0,0,0,0\n0,1,1,1\n", "line 3"},
        {"t,x,y,z\n1,0,0,0\n0.5,1,1,1\n", "line 3"},
        {"t,x,y,z\nnan,0,0,0\n", "line 2"},
        {"t,x,y,z\n0,0,0,0\ninf,0,0,0\n", "line 3"},
        {"t,x,y,z\n0,0x10,0,0\n", "line 2"},
    };
    for (const auto& [csv, place] : bad) {
        EXPECT_EQ(run(csv), 1) << csv;
        EXPECT_THAT(error_, testing::HasSubstr(place)) << csv;
        EXPECT_FALSE(std::filesystem::exists(arguments_.out_csv)) << csv;
    }
}

TEST_F(TouchCommand, keeps_an_older_result_if_it_fails) {
    folder_.write("out.csv", "kept");
    EXPECT_EQ(run("nonsense"), 1);
    EXPECT_EQ(content_of(arguments_.out_csv), "kept");
    arguments_.world = folder_.path() / "missing.map";
    EXPECT_EQ(run("t,x,y,z\n0,0,0,0\n"), 1);
    EXPECT_THAT(error_, testing::HasSubstr("missing.map"));
    EXPECT_EQ(content_of(arguments_.out_csv), "kept");
}

TEST_F(TouchCommand, gives_the_same_output_twice_except_for_the_elapsed_time) {
    const auto without_time = [](const std::vector<Row>& all) {
        std::vector<std::vector<std::string>> cells;
        for (const Row& row : all) cells.emplace_back(row.cells.begin(), row.cells.end() - 1);
        return cells;
    };
    const std::string csv = press(0.004);
    EXPECT_EQ(without_time(rows(csv)), without_time(rows(csv)));
}

}  // namespace touch_command_test
}  // namespace handrail::test
