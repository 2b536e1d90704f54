// Exploring as a learner, with the learner's settings, marks and recordings instead of the user's own. App thread.
#pragma once

#include "app/main/command_line.h"

namespace handrail::program {

// Changes the call to that of the learner it names; a call that names none stays as it is. Fails if there is no such
// learner, if the file cannot be read, or if a recording is requested to which the learner has not agreed.
Result<void> begin_as_learner(ExploreCall& call);
// Does the same for a lesson that is taught. A lesson that is only printed or checked needs just the name, as order and
// protocol are drawn from it. The name is spelt as the learner has it; the learner need not exist yet.
Result<void> begin_as_learner(LessonCall& call);

// The call that continues after a session in which another learner was chosen, in the same world. `asked` is the call
// before it was changed to that of a learner.
ExploreCall as_somebody_else(ExploreCall asked, ExploreEnd end);

}  // namespace handrail::program
