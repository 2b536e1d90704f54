#include "audio-cues/plan/cue_planner.h"
