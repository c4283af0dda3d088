"""simulate() reports what the program reports, whatever else runs."""
import _thread
import copy
import pickle
import tempfile
import threading
import time
import unittest

import numpy as np

import rayclock
from rayclock import _rayclock
from support import OCTAHEDRON, Case, program, without_times

RAY = [[0, 0, 5, 0, 0, -1.0]]


class Pictures(Case):
    def same(self, report, *words):
        expected = program("simulate", *words)
        self.assertEqual(list(report.to_dict()), list(expected))
        self.assertEqual(without_times(report.to_dict()), without_times(expected))

    def test_a_picture_has_the_reports_of_the_program(self):
        report = rayclock.simulate("gears:4", size=(96, 72), clock=66)
        self.same(report, "gears:4", "--size", "96x72", "--clock", "66")
        self.assertEqual(report.picture.shape, (72, 96, 3))
        self.assertEqual(report.picture.dtype, np.float32)
        self.assertEqual(report.hits.shape, (72, 96))
        self.assertEqual(np.count_nonzero(report.hits["primitive"] != 2**32 - 1) > 1000, True)

    def test_a_finished_picture_uses_native_spheres_as_the_program_does(self):
        config = rayclock.Config("default", contexts=32)
        report = rayclock.simulate(rayclock.load_scene("balls:2"), config, size="64x48", depth=3, aa=2, clock=[66, 90.5])
        self.same(report, "balls:2", "--size", "64x48", "--set", "contexts=32", "--depth", "3", "--aa", "2",
                  "--clock", "66,90.5")

    def test_a_film_has_the_reports_of_the_program(self):
        report = rayclock.simulate("crowd:2", rayclock.Config(levels=2), size=(48, 32), clock=66, frames=3, fps=25)
        self.same(report, "crowd:2", "--set", "levels=2", "--size", "48x32", "--clock", "66", "--frames", "3",
                  "--fps", "25")

    def test_the_view_is_that_of_the_program(self):
        report = rayclock.simulate("teapot:4", size=(48, 32), clock=66, eye=(3, 2.5, 4), at=(0, 0.5, 0), fov=30,
                                   reference=False)
        self.same(report, "teapot:4", "--size", "48x32", "--clock", "66", "--eye", "3,2.5,4", "--at", "0,0.5,0",
                  "--fov", "30", "--no-reference")

    def test_a_scene_from_arrays_has_the_digest_of_its_file(self):
        vertices, indices = OCTAHEDRON
        with tempfile.NamedTemporaryFile("w", suffix=".obj") as file:
            file.writelines("v %r %r %r\n" % tuple(v) for v in vertices.tolist())
            file.writelines("f %d %d %d\n" % tuple(t + 1) for t in indices)
            file.flush()
            expected = program("simulate", file.name, "--size", "64x48", "--clock", "66")
        for form in (vertices, vertices.astype("f4"), vertices.astype(">f8"), np.asfortranarray(vertices),
                     vertices.astype(int)):
            report = rayclock.simulate(rayclock.Scene(form, indices.astype("u2")), size=(64, 48), clock=66)
            self.assertEqual(report.digest, expected["digest"])

    def test_two_threads_at_once_have_the_results_of_each_alone(self):
        scenes = ["gears:3", "teapot:6", "tetra:5", "rings:2"]
        alone = [rayclock.simulate(s, size=(64, 48), clock=66).digest for s in scenes]
        found = [None] * len(scenes)

        def work(i):
            found[i] = rayclock.simulate(scenes[i], size=(64, 48), clock=66).digest

        threads = [threading.Thread(target=work, args=(i,)) for i in range(len(scenes))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, alone)

    def test_other_threads_run_during_a_simulation(self):
        ticks, ended = [], threading.Event()

        def tick():
            while not ended.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        rayclock.simulate("gears:8", size=(320, 240), clock=66)
        ended.set()
        thread.join()
        self.assertGreater(len(ticks), 20)

    def test_ctrl_c_ends_a_simulation_soon(self):
        scene = rayclock.load_scene("gears:4")
        trees = [dict(scene="gears:8", config=rayclock.Config(structure=name), size=(8, 8)) for name in ("kd", "bsp")]
        for options in (dict(size=(4096, 4096)), dict(size=(2048, 2048), depth=5, aa=4), dict(size=(4096, 4096), clock=66),
                        *trees):
            pressed = []

            def press():
                pressed.append(time.perf_counter())
                _thread.interrupt_main()

            timer = threading.Timer(1.5, press)
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                rayclock.simulate(**{"scene": scene, **options})
            self.assertLess(time.perf_counter() - pressed[0], 3)   # half a second on an idle machine
            while _rayclock.continuing_work() and time.perf_counter() - pressed[0] < 5:
                time.sleep(0.05)
            self.assertEqual(_rayclock.continuing_work(), 0, options)   # the builders stop as well
        self.assertEqual(rayclock.simulate("tetra:3", size=(32, 24)).partial, False)

    def test_a_table_has_a_row_for_each_clock(self):
        try:
            import pandas   # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        report = rayclock.simulate("tetra:4", size=(32, 24), clock=[33, 66])
        table = report.to_pandas()
        self.assertEqual(list(table["mhz"]), [33, 66])
        self.assertEqual(list(table["cycles"]), [c["cycles"] for c in report.clocks])
        self.assertIn("trav", report.accounts().index)


class Explore(Case):
    def test_a_sweep_has_the_report_of_the_program(self):
        report = rayclock.sweep("teapot:4", {"pipelines": [1, 2], "dram": ["ddr3", "sdr"], "clock": [66, 200]},
                                rayclock.Config(contexts=32), size=(48, 32), fresh=True)
        expected = program("sweep", "teapot:4", "--axis", "pipelines=1,2", "--axis", "dram=ddr3,sdr", "--axis",
                           "clock=66,200", "--set", "contexts=32", "--size", "48x32", "--clock", "66", "--no-netlist")
        self.assertEqual(list(report.to_dict()), list(expected))
        self.assertEqual(without_times(report.to_dict()), without_times(expected))
        self.refused("node_setz", rayclock.sweep, "tetra:2", {"node_setz": [1, 2]})
        self.refused("is not a list of values", rayclock.sweep, "tetra:2", {"node_sets": 16})
        with self.assertRaisesRegex(TypeError, "sizes"):
            rayclock.sweep("tetra:2", {"node_sets": [16]}, sizes=3)

    def test_an_explanation_has_the_report_of_the_program(self):
        report = rayclock.explain("balls:2", (30, 20), size=(64, 48), depth=2)
        expected = program("explain", "balls:2", "30,20", "--size", "64x48", "--depth", "2")
        self.assertEqual(list(report.to_dict()), list(expected))
        self.assertEqual(without_times(report.to_dict()), without_times(expected))
        self.assertIn("0 camera", str(report))
        self.refused("outside the picture", rayclock.explain, "tetra:2", (64, 0), size=(64, 48))

    def test_rays_of_an_array_are_swept_and_explained_like_those_of_a_file(self):
        rays = rayclock.make_rays("teapot:4", kind="diffuse", size=(16, 12))
        with tempfile.TemporaryDirectory() as folder:
            path = folder + "/rays.npy"
            np.save(path, rays)
            swept = program("sweep", "teapot:4", "--rays", path, "--axis", "pipelines=1,2", "--clock", "66",
                            "--no-netlist")
            explained = program("explain", "teapot:4", "--rays", path, "--ray", "17")
        report = rayclock.sweep("teapot:4", {"pipelines": [1, 2]}, rays=rays, fresh=True)
        self.assertEqual(list(report.to_dict()), list(swept))
        self.assertIsNone(report.frame)
        self.assertEqual(report.sweep["stream"].pop("file"), "rays")
        self.assertTrue(swept["sweep"]["stream"].pop("file").endswith("rays.npy"))
        self.assertEqual(without_times(report.to_dict()), without_times(swept))

        story = rayclock.explain("teapot:4", rays=rays, ray=17)
        self.assertEqual(story.ray, 17)
        self.assertEqual(list(story.to_dict()), list(explained))
        self.assertEqual(story.stream.pop("file"), "rays")
        explained["stream"].pop("file")
        self.assertEqual(without_times(story.to_dict()), without_times(explained))
        self.assertIn("ray 17, closest hit", str(story))

        self.refused("size has no meaning", rayclock.sweep, "teapot:4", {"pipelines": [1]}, rays=rays, size=(8, 8))
        self.refused("any_hit needs rays", rayclock.sweep, "teapot:4", {"pipelines": [1]}, any_hit=True)
        self.refused("pixel has no meaning", rayclock.explain, "teapot:4", (1, 1), rays=rays, ray=0)
        self.refused("ray must lie in 0..", rayclock.explain, "teapot:4", rays=rays, ray=len(rays))
        self.refused("ray: None", rayclock.explain, "teapot:4", rays=rays)
        self.refused("ray needs rays", rayclock.explain, "teapot:4", (1, 1), ray=0)
        self.refused("pixel: None", rayclock.explain, "teapot:4")


class Streams(Case):
    def test_a_stream_has_the_hits_and_the_report_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            path, hits = folder + "/rays.npy", folder + "/hits.npy"
            program("rays", "gears:3", "--kind", "ao", "--size", "48x36", "-o", path)
            expected = program("simulate", "gears:3", "--rays", path, "--hits", hits)
            rays = np.load(path)
            self.assertTrue(np.array_equal(rayclock.make_rays("gears:3", kind="ao", size=(48, 36)), rays, equal_nan=True))
            report = rayclock.simulate("gears:3", rays=rays)
            self.assertEqual(list(report.to_dict()), list(expected))
            expected["stream"]["file"] = "rays"
            self.assertEqual(without_times(report.to_dict()), without_times(expected))
            wanted = np.load(hits)
            self.assertEqual(report.hits.dtype, wanted.dtype)
            self.assertEqual(report.hits.tobytes(), wanted.tobytes())

    def test_camera_rays_have_the_hits_of_the_picture(self):
        scene = rayclock.load_scene("teapot:6")
        picture = rayclock.simulate(scene, size=(48, 36), clock=66)
        stream = rayclock.simulate(scene, rays=rayclock.make_rays(scene, size=(48, 36)), clock=66)
        self.assertEqual(stream.hits["primitive"].tolist(), picture.hits["primitive"].ravel().tolist())

    def test_an_array_in_c_order_is_read_where_it_lies(self):
        rays = rayclock.make_rays("tetra:4", size=(32, 24))
        plain = rayclock.simulate("tetra:4", rays=rays)
        for form in (np.asfortranarray(rays), rays.astype(">f8"), np.repeat(rays, 2, axis=0)[::2],
                     np.hstack([rays, rays])[:, :6]):
            self.assertEqual(rayclock.simulate("tetra:4", rays=form).digest, plain.digest)

    def test_hits_are_not_copied(self):
        hits = rayclock.simulate("tetra:4", rays=rayclock.make_rays("tetra:4", size=(8, 8))).hits
        self.assertFalse(hits.flags.owndata)
        del hits


    def test_trace_has_the_hits_of_a_simulation_without_their_cycles(self):
        for kind in ("camera", "ao"):
            rays = rayclock.make_rays("gears:3", kind=kind, size=(48, 36))
            wanted = rayclock.simulate("gears:3", rays=rays, clock=66, judge=False).hits
            self.assertGreater(wanted["cycle"].max(), 0)
            wanted = wanted.copy()
            wanted["cycle"] = 0
            hits = rayclock.trace("gears:3", rays)
            self.assertEqual(hits.dtype, wanted.dtype)
            self.assertEqual(hits.tobytes(), wanted.tobytes())
            self.assertFalse(hits.flags.owndata)
            self.assertEqual(rayclock.trace("gears:3", rays, threads=1).tobytes(), wanted.tobytes())
            config = rayclock.Config(structure="kd", coord_bits=14)
            coarse = rayclock.simulate("gears:3", config, rays=rays, clock=66, judge=False).hits
            self.assertEqual(rayclock.trace("gears:3", rays, config=config)["primitive"].tolist(),
                             coarse["primitive"].tolist())
            reference = rayclock.trace("gears:3", rays, engine="reference")
            self.assertGreater((reference["primitive"] == wanted["primitive"]).mean(), 0.99)
        any_hit = rayclock.trace("gears:3", rays[:, :6], True)
        closest = rayclock.trace("gears:3", rays[:, :6])
        self.assertEqual(any_hit["hit"].tolist(), closest["hit"].tolist())
        self.assertTrue((any_hit["primitive"] == 2**32 - 1).all())

    def test_trace_lets_other_threads_run_and_ctrl_c_stops_it(self):
        rays = np.repeat(rayclock.make_rays("gears:4", size=(256, 192)), 40, axis=0)
        ticks, pressed = [], []

        def press():
            for _ in range(10):
                time.sleep(0.05)
                ticks.append(time.perf_counter())
            pressed.append(time.perf_counter())
            _thread.interrupt_main()

        thread = threading.Thread(target=press)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                rayclock.trace("gears:4", rays)
        self.assertLess(time.perf_counter() - pressed[0], 3)
        thread.join()
        self.assertEqual(len(ticks), 10)

    def test_notes_about_a_stream_are_warnings(self):
        rays = rayclock.make_rays("tetra:3", size=(8, 6))
        rays[:, :3] *= 3
        rays[0, :3] += 50   # a second origin: the lattice would cover a single one
        for call in (rayclock.simulate, rayclock.trace):
            with self.assertWarnsRegex(rayclock.Note, "rays begin outside the lattice, and their part outside it"):
                call("tetra:3", rays=rays)
            with self.assertWarnsRegex(rayclock.Note, "surf_sets has no effect with source=stream"):
                call("tetra:3", rays=RAY, config=rayclock.Config(surf_sets=8))

    def test_a_stream_that_would_be_empty_is_refused(self):
        self.refused("^tetra:3: the stream would be empty", rayclock.make_rays, "tetra:3", kind="diffuse", size=(8, 6),
                     eye=(9, 9, 9), at=(18, 18, 18))


class Configs(Case):
    def test_a_parameter_is_an_attribute_with_a_description(self):
        config = rayclock.Config()
        for name in rayclock.Config.parameters:
            self.assertIn(name, dir(config))
            self.assertGreater(len(getattr(rayclock.Config, name).__doc__), 40)
        config.node_sets = 128
        config.structure = "kd"
        config.shading = True
        self.assertEqual((config.node_sets, config.structure, config.shading), (128, "kd", True))
        self.assertEqual(repr(config), "Config('default', node_sets=128, structure='kd', shading=1)")

    def test_copies_are_equal_and_independent(self):
        config = rayclock.Config("small", node_sets=32)
        for other in (copy.copy(config), copy.deepcopy(config), pickle.loads(pickle.dumps(config)), config.replace()):
            self.assertEqual(other, config)
            other.node_sets = 16
            self.assertNotEqual(other, config)
        self.assertEqual(config.replace(contexts=16).contexts, 16)

    def test_wrong_values_are_refused_with_a_sentence(self):
        self.refused("node_sets", rayclock.Config, node_sets=3)
        self.refused("node_sets: 1.5 is not a whole number or a name", rayclock.Config, node_sets=1.5)
        self.refused("node_setz.*node_sets", rayclock.Config, node_setz=3)
        self.refused("smal", rayclock.Config, "smal")
        self.refused("structure", setattr, rayclock.Config(), "structure", "tree")
        self.refused("bits", rayclock.simulate, "tetra:3", rayclock.Config(coord_bits=20, dir_bits=24))
        with self.assertRaises(AttributeError):
            rayclock.Config().node_setz


if __name__ == "__main__":
    unittest.main()
