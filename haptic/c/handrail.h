/* Handrail's touch for C, and for every language that calls C: a world from a file, a hand in it, a force for each
 * tick.
 *
 * Lengths in metres, forces in newtons, time in seconds; x east, y north, z up. Stable: what stands here keeps its
 * meaning for as long as HANDRAIL_API_VERSION is 1; structs grow at their end only, told apart by their `size`.
 *
 * Reading and freeing allocate and may take seconds: any thread but the servo's. handrail_hand_tick never allocates,
 * locks, throws or reads a clock: one thread at a time for each hand. Two hands may share a world. Same calls, same
 * forces, bit for bit. */
#ifndef HANDRAIL_H
#define HANDRAIL_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define HANDRAIL_API __attribute__((visibility("default")))
#else
#define HANDRAIL_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define HANDRAIL_API_VERSION 1
#define HANDRAIL_NO_FEATURE 0xffffffffU

typedef struct handrail_world handrail_world;
typedef struct handrail_hand handrail_hand;

/* How a hand feels. Filled by handrail_feel_default(), then changed. */
typedef struct handrail_feel {
    uint32_t size;                     /* sizeof(handrail_feel) */
    uint32_t unused;                   /* 0 */
    double radius_m;                   /* of the ball, in the world; 0 to 1000 */
    double world_m_per_hand_m;         /* the scale; above 0, up to 1e6 */
    double rated_stiffness_n_per_m;    /* what the device bears, for each metre of the hand; 0 to 1e6 */
    double default_stiffness_fraction; /* of surfaces that name none; 0 to 1 */
    double damping_ns_per_m;           /* of the hand's speed, along the normal; 0 to 1000 */
    double friction_static;            /* of surfaces that name none; no less than the next; up to 10 */
    double friction_kinetic;           /* 0 to 10 */
    double ceiling_n; /* the strongest force that is let out: the device's, or a person's choice; >= 0 */
} handrail_feel;

/* What a hand feels on a tick. */
typedef struct handrail_touch {
    uint32_t size;     /* sizeof(handrail_touch), set by the caller */
    uint32_t contacts; /* surfaces that hold the ball: 0 to 3 */
    double force_n[3]; /* on the hand, after ramp and ceiling: what a motor may be given */
    double ball_m[3];  /* the middle of the ball, in the world */
    double normal[3];  /* of the surface that presses most, away from it; zeros without contact */
    uint32_t feature;  /* whose surface that is, for handrail_world_name(); HANDRAIL_NO_FEATURE without contact */
    uint32_t
        refused; /* 1: the place was no number, or farther than 1e6 m: no force on this tick, and a ramp after it */
} handrail_touch;

/* What happens to the force from the next tick on. */
enum handrail_flow {
    HANDRAIL_RUN = 0,  /* comes in within one second, then in full */
    HANDRAIL_FADE = 1, /* goes within 75 ms */
    HANDRAIL_CUT = 2   /* none on the very next tick */
};

/* HANDRAIL_API_VERSION of the library that is loaded. */
HANDRAIL_API uint32_t handrail_api_version(void);

/* Reads any file that Handrail reads, told by its ending: .map, .ifc, .osm, .glb, .obj, .ply, .stl ... NULL where it
 * cannot be read: then `error` holds one English sentence, cut to fit. `error` may be NULL. */
HANDRAIL_API handrail_world* handrail_world_read(const char* path, char* error, size_t error_size);
/* The same from the text of a .map. */
HANDRAIL_API handrail_world* handrail_world_from_map(const char* text, size_t length, char* error, size_t error_size);
/* NULL is allowed. Hands in it go on. */
HANDRAIL_API void handrail_world_free(handrail_world* world);
/* Where people start: the ground under their feet. 0: the world names no such place, and `place_m` is unchanged. */
HANDRAIL_API int handrail_world_start(const handrail_world* world, double place_m[3]);
/* The name of a feature, as the file has it, cut to fit; returns its whole length. */
HANDRAIL_API size_t handrail_world_name(const handrail_world* world, uint32_t feature, char* name, size_t name_size);

HANDRAIL_API void handrail_feel_default(handrail_feel* feel);
/* A hand that has not been anywhere yet. NULL where the feel is out of range or of an unknown size. */
HANDRAIL_API handrail_hand* handrail_hand_new(const handrail_world* world, const handrail_feel* feel);
HANDRAIL_API void handrail_hand_free(handrail_hand* hand);
/* 1: taken from the next tick on. 0: out of range, and the hand feels as before. On the thread of its ticks. */
HANDRAIL_API int handrail_hand_set_feel(handrail_hand* hand, const handrail_feel* feel);
HANDRAIL_API void handrail_hand_set_flow(handrail_hand* hand, enum handrail_flow flow);
/* One tick: the hand is at place_m in the world, dt_s (above 0, up to 1; 1e-3 for a servo) after the tick before. */
HANDRAIL_API void handrail_hand_tick(handrail_hand* hand, const double place_m[3], double dt_s, handrail_touch* touch);

#ifdef __cplusplus
}
#endif

#endif
