// Tests which rooms a printed storey has and how the sheet names them.
#include "worlds/plan/storey.h"

#include <gtest/gtest.h>

#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/exports/plans.h"

namespace handrail::test {
namespace storey_rooms_test {

TEST(Storeys, have_no_unnamed_roofs_to_which_nothing_leads) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes too long here";
    const NamedStoreys* world = storeys_of("institute.ifczip");
    if (!world) GTEST_SKIP() << needs_real_world("institute.ifczip");
    for (const StoreyRoom& room : world->storeys.at(2).rooms) EXPECT_FALSE(room.shut) << room.name;
}

TEST(Storeys, are_called_the_same_in_the_names_of_rooms_as_in_the_title) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "takes too long here";
    const NamedStoreys* world = storeys_of("institute.ifczip");
    if (!world) GTEST_SKIP() << needs_real_world("institute.ifczip");
    int called = 0;
    for (const Storey& storey : world->storeys)
        for (const StoreyRoom& room : storey.rooms) {
            EXPECT_EQ(room.name.find(", storey "), std::string::npos) << room.name;
            for (const Storey& other : world->storeys) {
                if (!room.name.ends_with(", " + other.name)) continue;
                ++called;
                EXPECT_EQ(other.name, storey.name) << room.name;
            }
        }
    EXPECT_GT(called, 0);
}

}  // namespace storey_rooms_test
}  // namespace handrail::test
