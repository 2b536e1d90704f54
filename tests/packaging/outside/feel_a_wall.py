#!/usr/bin/env python3
"""Feels a wall of a world a tenth of a millimetre deep through the C header, and prints the force in newtons.

    feel_a_wall.py libhandrail.so.0 WORLD
"""
import ctypes
import math
import sys

Three = ctypes.c_double * 3


class Feel(ctypes.Structure):
    _fields_ = [("size", ctypes.c_uint32), ("unused", ctypes.c_uint32)] + [
        (name, ctypes.c_double) for name in (
            "radius_m", "world_m_per_hand_m", "rated_stiffness_n_per_m", "default_stiffness_fraction", "damping_ns_per_m",
            "friction_static", "friction_kinetic", "ceiling_n")]


class Touch(ctypes.Structure):
    _fields_ = [("size", ctypes.c_uint32), ("contacts", ctypes.c_uint32), ("force_n", Three), ("ball_m", Three),
                ("normal", Three), ("feature", ctypes.c_uint32), ("refused", ctypes.c_uint32)]


handrail = ctypes.CDLL(sys.argv[1])
for function in ("handrail_world_read", "handrail_hand_new"):
    getattr(handrail, function).restype = ctypes.c_void_p
handrail.handrail_hand_tick.argtypes = [ctypes.c_void_p, Three, ctypes.c_double, ctypes.POINTER(Touch)]
handrail.handrail_world_start.argtypes = [ctypes.c_void_p, Three]
handrail.handrail_hand_new.argtypes = [ctypes.c_void_p, ctypes.POINTER(Feel)]

error = ctypes.create_string_buffer(400)
world = handrail.handrail_world_read(sys.argv[2].encode(), error, ctypes.c_size_t(len(error)))
if not world:
    sys.exit(error.value.decode())
at, feel, touch = Three(), Feel(), Touch()
handrail.handrail_world_start(world, at)
handrail.handrail_feel_default(ctypes.byref(feel))
hand = handrail.handrail_hand_new(world, ctypes.byref(feel))
touch.size = ctypes.sizeof(Touch)


def tick():
    handrail.handrail_hand_tick(hand, at, 1e-3, ctypes.byref(touch))


at[2] += 1.0
while touch.contacts == 0:
    at[0] += 0.0005
    tick()
at[0] = touch.ball_m[0] + 0.0001
for _ in range(2000):  # the force reaches its full value within the first thousand ticks
    tick()
print(f"{math.sqrt(sum(part * part for part in touch.force_n)):.17g}")
