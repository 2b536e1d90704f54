// All settings as lists by topic: each can be heard, stepped or typed. Functions of what the context contains; the
// lists that they open keep a reference to it. App thread only.
#pragma once

#include "app/core/context/session_context.h"

namespace handrail::core {

// One step up or down; returns the new value in words.
std::string step_setting(const SessionContext& context, std::string_view key, int by);
void open_setting_topics(const SessionContext& context, double now_s);

}  // namespace handrail::core
