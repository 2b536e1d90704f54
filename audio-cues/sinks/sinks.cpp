#include "audio-cues/plan/sinks.h"
