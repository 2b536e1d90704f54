// Starts a session as a learner, with the learner's settings, marks and recordings instead of the user's own. App
// thread.
#pragma once

#include "app/main/command_line.h"

namespace handrail::program {

// Changes `call` so that it uses the data of the learner whom it names. If `call` names nobody, it does not change.
// Fails if there is no such learner, if the learner's file cannot be read, or if the call requests a recording to which
// the learner has not agreed.
Result<void> begin_as_learner(ExploreCall& call);
// Changes `call` in the same way for a lesson that is taught. A lesson that is only printed needs just the learner's
// name, because the order of tasks and the protocol depend on it. The function then spells the name as the learner
// does; the learner need not exist yet. A lesson that is only checked does not change.
Result<void> begin_as_learner(LessonCall& call);

// Returns the call that continues in the same world after a session in which the person chose another learner.
// `requested` is the original call, before begin_as_learner changed it.
ExploreCall as_somebody_else(ExploreCall requested, ExploreEnd end);

}  // namespace handrail::program
