// Simulates a person at the keyboard and mixes everything that they hear. The program and the voice take realistic time
// in virtual time.
#pragma once

#include "tests/support/names.h"
#include "tests/unit/heard/sounding.h"
#include "tests/unit/heard/typist.h"

namespace handrail::test {

class Recorded : public Sounding, public Typing {
public:
    Recorded() : Typing(audio(), *this, {2.0, 2.5, 2.0, 3.0, 2.0, 6.0, 2.0, 4.0}, [this] { mix_ms(); }) {}
};

}  // namespace handrail::test
