// Opens the list of presets for walking and speech. A function of the context for the app thread only.
#pragma once

#include "app/core/context/session_context.h"

namespace handrail::core {

void open_presets(const SessionContext& context, double now_s);

}  // namespace handrail::core
