// A session in our house whose rooms are known. For tests of what a person does there.
#pragma once

#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail::test {

struct InTheHouse : AppSession {
    InTheHouse() {
        app.apply(WorldEntered{make_ready(our_world("house.map"))}, 0.0);
        run(0.1);
        request(Command::Exits);  // after this query, the session knows the rooms of the world
        run(0.1);
        said.clear();
    }
};

}  // namespace handrail::test
