// All settings as lists, by topic: each heard, stepped or typed. Functions of what the context holds; the lists that
// they open keep a reference to it. App thread only.
#pragma once

#include "app/core/context/session_context.h"

namespace handrail {

// One step up or down; what it is then.
std::string step_setting(const SessionContext& context, std::string_view key, int by);
void open_setting_topics(const SessionContext& context, double now_s);

}  // namespace handrail
