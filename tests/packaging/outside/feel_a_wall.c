/* The same through the C header, from C. */
#include <handrail.h>
#include <math.h>
#include <stdio.h>

int main(int count, char** words) {
    char error[400];
    double at[3];
    handrail_feel feel;
    handrail_touch touch = {sizeof touch, 0, {0}, {0}, {0}, 0, 0};
    handrail_world* world = handrail_world_read(count == 2 ? words[1] : "", error, sizeof error);
    if (!world || !handrail_world_start(world, at)) return puts(world ? "No start." : error), 1;
    handrail_feel_default(&feel);
    handrail_hand* hand = handrail_hand_new(world, &feel);
    at[2] += 1.0;
    while (touch.contacts == 0) {
        at[0] += 0.0005;
        handrail_hand_tick(hand, at, 1e-3, &touch);
    }
    at[0] = touch.ball_m[0] + 0.0001;
    for (int tick = 0; tick < 2000; ++tick) handrail_hand_tick(hand, at, 1e-3, &touch);
    printf("%.17g\n", sqrt(touch.force_n[0] * touch.force_n[0] + touch.force_n[1] * touch.force_n[1] +
                           touch.force_n[2] * touch.force_n[2]));
    handrail_hand_free(hand);
    handrail_world_free(world);
    return 0;
}
