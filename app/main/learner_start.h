// Exploring as a learner: the learner's own settings, marks and recordings instead of one's own. App thread.
#pragma once

#include "app/main/command_line.h"

namespace handrail {

// Turns the call into that of the learner it names; nothing where it names none. Fails where there is no such learner,
// the file cannot be read, or a recording is asked for that the learner has not agreed to.
Result<void> begin_as_learner(ExploreCall& call);
// Likewise of a lesson that is taught; printed or checked it only wants the name, of a learner who may not be there
// yet, as order and protocol are drawn from the name as the learner has it.
Result<void> begin_as_learner(LessonCall& call);

// The call that goes on with who was chosen in the session that ended so, in the world one was in. asked: as it was
// before it became that of a learner.
ExploreCall as_somebody_else(ExploreCall asked, ExploreEnd end);

}  // namespace handrail
