// Opens all settings as lists by topic. The person can hear each setting, change it step by step or type a value. These
// are functions of the context, to which the open lists keep a reference. Call them on the app thread only.
#pragma once

#include "app/core/context/session_context.h"

namespace handrail::core {

// Changes a setting by `by` steps, and returns the new value in words.
std::string step_setting(const SessionContext& context, std::string_view key, int by);
void open_setting_topics(const SessionContext& context, double now_s);

}  // namespace handrail::core
