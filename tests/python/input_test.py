"""Input that makes no sense raises an Error with one sentence, before anything large is allocated."""
import os
import resource
import unittest

import numpy as np

import rayclock
from rayclock import unit
from support import OCTAHEDRON, Case

VERTICES, INDICES = OCTAHEDRON
RAY = [[0, 0, 5, 0, 0, -1.0]]


class Rays(Case):
    def traced(self, rays, **options):
        return rayclock.simulate("tetra:3", rays=rays, **options)

    def test_wrong_shapes_and_types_are_refused(self):
        self.refused("rays: the shape must be n x 6 or 7 or 8 or 9, not 6", self.traced, RAY[0])
        self.refused("not 1 x 5", self.traced, [RAY[0][:5]])
        self.refused("not 1 x 1 x 6", self.traced, [RAY])
        self.refused("not a single number", self.traced, 3.0)
        self.refused("different lengths|Python objects", self.traced, [[1, 2], [3]])
        self.refused("Python objects", self.traced, np.array(RAY, object))
        self.refused("float32 or float64, not int64", self.traced, np.array(RAY).astype(int))
        self.refused("not complex128", self.traced, np.array(RAY, complex))
        self.refused("not float16", self.traced, np.array(RAY, np.float16))
        self.refused("not float128", self.traced, np.array(RAY, np.longdouble))
        self.refused("not <U", self.traced, np.array(RAY).astype(str))
        self.refused("shape", self.traced, np.zeros(3, [("o", "f8", 3), ("d", "f8", 3)]))

    def test_faulty_rays_are_named(self):
        rays = np.repeat(RAY, 5, axis=0)
        rays[3, 4] = np.nan
        self.refused("ray 3 has a coordinate that is NaN or infinite", self.traced, rays)
        rays[3] = 0
        self.refused("ray 3 has the direction 0", self.traced, rays)
        self.refused("there are no rays", self.traced, np.zeros((0, 6)))
        self.refused("ray 0 has t_min 2.* above t_max 1", self.traced, [RAY[0] + [2, 1]])
        self.refused("outside: .* is not clip or refuse", self.traced, RAY, outside="keep")

    def test_too_many_rays_are_refused_before_they_are_converted(self):
        billion = np.broadcast_to(np.float32(1), (10**9, 6))
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        self.refused("1000000000 rows are too many", self.traced, billion)
        self.refused("the largest number is 33554432", self.traced, billion[:40_000_000])
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 100_000)

    def test_an_option_of_pictures_is_refused(self):
        self.refused("size has no meaning here", self.traced, RAY, size=(8, 8))
        self.refused("depth has no meaning here", self.traced, RAY, depth=2)
        self.refused("any_hit needs rays", rayclock.simulate, "tetra:3", any_hit=True)


    def test_trace_refuses_what_simulate_refuses(self):
        self.refused("the shape must be n x 6 or 7 or 8 or 9, not 6", rayclock.trace, "tetra:3", RAY[0])
        self.refused("there are no rays", rayclock.trace, "tetra:3", np.zeros((0, 6)))
        self.refused("ray 0 has the direction 0", rayclock.trace, "tetra:3", np.zeros((1, 6)))
        self.refused("engine: 'gpu' is not reference, model or rtl", rayclock.trace, "tetra:3", RAY, engine="gpu")
        self.refused("'keep' is not clip or refuse", rayclock.trace, "tetra:3", RAY, outside="keep")
        self.refused("needs source=stream", rayclock.trace, "tetra:3", RAY, config=rayclock.Config(source="camera"))
        self.refused("threads", rayclock.trace, "tetra:3", RAY, threads=-1)


class Scenes(Case):
    def test_wrong_arrays_are_refused(self):
        self.refused("vertices: the shape must be n x 3, not 6 x 2", rayclock.Scene, VERTICES[:, :2], INDICES)
        self.refused("indices: the numbers must be whole numbers, not float64", rayclock.Scene, VERTICES, INDICES * 1.0)
        self.refused("indices: -1 does not fit in uint32", rayclock.Scene, VERTICES, INDICES - 1)
        self.refused("vertices: an array of Python objects", rayclock.Scene, VERTICES.astype(object), INDICES)
        self.refused("scene", rayclock.Scene, VERTICES, INDICES + 1)
        self.refused("scene", rayclock.Scene, VERTICES, INDICES[:0])
        self.refused("scene", rayclock.Scene, VERTICES + np.inf, INDICES)
        self.refused("normals: there must be 6", rayclock.Scene, VERTICES, INDICES, normals=VERTICES[:3])
        self.refused("material: the shape must be 8, not 3", rayclock.Scene, VERTICES, INDICES, material=[0, 1, 2])
        self.refused("scene", rayclock.Scene, VERTICES, INDICES, material=[7] * 8)
        self.refused("too many", rayclock.Scene, np.broadcast_to(1.0, (2**32, 3)), INDICES)
        self.refused("colour: .* is not three numbers", rayclock.Scene, VERTICES, INDICES,
                     materials=[rayclock.Material(colour=1)])
        self.refused("eye", rayclock.Scene, VERTICES, INDICES, camera=rayclock.Camera(eye=(1, 2)))

    def test_wrong_names_are_refused(self):
        self.refused("gear", rayclock.load_scene, "gear")
        self.refused("no such file", rayclock.load_scene, "missing.obj")
        self.refused("3 is not a Scene or the name of one", rayclock.simulate, 3)
        self.refused("is not a Config or the name of one", rayclock.simulate, "tetra:3", {"node_sets": 3})


class Options(Case):
    def test_wrong_options_are_refused(self):
        def run(**options):
            rayclock.simulate("tetra:3", **options)

        self.refused("size: .* is not", run, size="big")
        self.refused("size: 3 is not", run, size=3)
        self.refused("16384", run, size=(10**6, 10))
        self.refused("clock", run, clock="fast")
        self.refused("clock: None is not", run, clock=None)
        self.refused("clock", run, clock=[])
        self.refused("clock", run, clock=-1)
        self.refused("clock", run, clock=float("nan"))
        self.refused("depth must lie in 0..15, not 99", run, depth=99)
        self.refused("depth: 1.5 is not a whole number", run, depth=1.5)
        self.refused("engine: 'gpu' is not model or rtl", run, engine="gpu")
        self.refused("seed must lie in", run, seed=0)
        self.refused("fov: 'x' is not a number", run, fov="x")
        self.refused("eye: .* is not three numbers", run, eye=(1, 2))
        self.refused("frames", run, frames=0)
        self.refused("kind: 'sun' is not one of camera", rayclock.make_rays, "tetra:3", kind="sun")
        self.refused("bounce must lie in 1..16, not 0", rayclock.make_rays, "tetra:3", bounce=0)


class Units(Case):
    def test_wrong_batches_are_refused(self):
        good = unit.requests("tri", d=[0, 0, 1 << 18])
        self.refused("no field is called x", unit.tri, x=3)
        self.refused("o must have the shape n x 3, not 2", unit.tri, o=[1, 2])
        self.refused("d must be whole numbers, not float64", unit.tri, d=[0, 0, 1.0])
        self.refused("row 0: o = 131072 does not fit in the chip's 18 bits", unit.tri, o=[0, 0, 1 << 17])
        self.refused("row 0: ray = 64 does not fit in the chip's 6 bits", unit.tri, ray=64)
        self.refused("does not fit in int32", unit.tri, o=[0, 0, 1 << 31])
        self.refused("needs structure=kd or octree", unit.treelet, unit.requests("tri"))
        self.refused("requests are a structured array", unit.tri, [1, 2])
        self.refused("the fields must be ray", unit.tri, np.zeros(3, [("o", "i4", 3)]))
        self.refused("requests are n x 21 numbers, not 3 x 4", unit.tri, np.zeros((3, 4), int))
        self.refused("not both", unit.tri, good, o=[0, 0, 0])
        self.refused("have one dimension", unit.tri, good.reshape(1, 1))
        room = np.zeros(1, unit.response_dtype("tri"))
        for wrong in ([0], np.zeros(2, room.dtype), np.zeros(1), np.frombuffer(bytes(room.nbytes), room.dtype)):
            self.refused("out must be a writable array in C order of 1 rows", unit.tri, good, out=wrong)
        self.refused("in C order of 2 rows", unit.tri, good.repeat(2), out=room.repeat(4)[::2])
        whole = np.zeros(room.nbytes + good.nbytes, np.uint8)
        self.refused("out shares memory", unit.tri, whole[:good.nbytes].view(good.dtype),
                     out=whole[8:8 + room.nbytes].view(room.dtype))
        self.refused("another field has 2", unit.tri, o=np.zeros((2, 3), int), d=np.zeros((3, 3), int))
        self.assertEqual(len(unit.tri(good[:0])), 0)


if __name__ == "__main__":
    unittest.main()
