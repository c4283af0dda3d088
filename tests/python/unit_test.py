"""The functions of the units on batches: values, forms of arrays, and speed."""
import re
import time
import unittest
from fractions import Fraction

import numpy as np

import rayclock
from rayclock import _rayclock, unit
from support import Case


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def crossing(o, d, a, b, c):
    """Returns t, u and v of the ray's line and the triangle as fractions, or None. None of them is 0."""
    e1, e2, s = ([x - y for x, y in zip(p, q)] for p, q in ((b, a), (c, a), (o, a)))
    det = dot(cross(d, e2), e1)
    if det == 0:
        return None
    u, v = Fraction(dot(cross(d, e2), s), det), Fraction(-dot(cross(d, e1), s), det)
    t = Fraction(dot(e2, cross(s, e1)), det)
    return (t, u, v) if u > 0 and v > 0 and u + v < 1 and t > 0 else None


def hard_batch(count, config):
    """Returns requests whose rays often hit."""
    rng = np.random.default_rng(7)
    reach, far = 1 << (config.coord_bits - 3), (1 << (config.dir_bits - 1)) - 1
    corners = rng.integers(-reach, reach, (3, count, 3))
    o = rng.integers(-reach, reach, (count, 3))
    weights = rng.dirichlet((1, 1, 1), count)
    towards = np.einsum("kij,ik->ij", corners, weights) - o
    d = np.rint(towards * (far / np.abs(towards).max(axis=1, keepdims=True))).astype(int)
    return unit.requests("tri", config, ray=np.arange(count) % config.contexts, o=o, d=d, a=corners[0], b=corners[1],
                         c=corners[2], prim=np.arange(count))


class Values(Case):
    def test_tri_decides_and_measures_as_fractions_do(self):
        config = rayclock.Config()
        batch = hard_batch(4000, config)
        answers = unit.tri(batch, config)
        hits = 0
        for q, r in zip(batch.tolist(), answers):
            found = crossing(*(list(map(int, q[i])) for i in (1, 2, 3, 4, 5)))
            self.assertEqual(bool(r["closer"]), found is not None)
            self.assertEqual(r["ray"], q[0])
            if found is None:
                continue
            hits += 1
            t, u, v = found
            scaled = t * 2 ** (config.dir_bits - 1 + config.t_frac_bits)
            most = 2 ** (config.coord_bits + 2 + config.t_frac_bits) - 1
            self.assertEqual(r["t"], min(-(-scaled.numerator // scaled.denominator), most))
            self.assertEqual(r["u"], int(u * 2**config.bary_bits))
            self.assertEqual(r["v"], int(v * 2**config.bary_bits))
            self.assertEqual(Fraction(int(r["num"]), int(r["det"])), t)
        self.assertGreater(hits, 3000)

    def test_a_batch_has_the_answers_of_its_rows(self):
        batch = hard_batch(10_000, rayclock.Config())
        answers = unit.tri(batch)
        self.assertEqual(unit.tri(batch, threads=1).tobytes(), answers.tobytes())
        for i in (0, 4095, 4096, 9999):
            self.assertEqual(unit.tri(batch[i:i + 1])[0], answers[i])

    def test_all_forms_of_an_array_have_the_same_answers(self):
        batch = hard_batch(100, rayclock.Config())
        answers = unit.tri(batch).tobytes()
        plain = np.hstack([batch[f].reshape(100, -1) for f in batch.dtype.names])
        for form in (plain, plain.astype("f8").astype("i4"), np.asfortranarray(plain), plain.astype(">i8"),
                     batch.astype(batch.dtype.newbyteorder(">")), np.repeat(batch, 2)[::2]):
            self.assertEqual(unit.tri(form).tobytes(), answers)
        by_name = {f: batch[f] for f in ("ray", "o", "d", "a", "b", "c", "prim")}
        self.assertEqual(unit.tri(**by_name).tobytes(), answers)
        out = np.zeros(len(batch), unit.response_dtype("tri"))
        self.assertIs(unit.tri(batch, out=out), out)
        self.assertEqual(out.tobytes(), answers)

    def test_ports_hold_what_rows_hold(self):
        for name, config in [("tri", rayclock.Config()), ("tri", rayclock.Config(shading=1, spheres=1)),
                             ("box", rayclock.Config()), ("treelet", rayclock.Config(structure="kd")),
                             ("xform", rayclock.Config(levels=2))]:
            fields = unit.request_fields(name, config)
            rows = np.zeros(50, unit.request_dtype(name, config))
            rng = np.random.default_rng(3)
            for f in fields:
                bits = min(f.bits, 62)
                low, high = (-(1 << (bits - 1)), 1 << (bits - 1)) if f.signed else (0, 1 << bits)
                rows[f.name] = rng.integers(low, high, rows[f.name].shape)
                if f.bits > 64:   # the upper half
                    rows[f.name][:, 1] = rng.integers(0, 1 << (f.bits - 65), len(rows))
            values = unit.port_values(name, rows, config)
            self.assertEqual(unit.from_port_values(name, values, config, response=False).tobytes(), rows.tobytes())
            at = sum(f.bits * max(f.numbers, 1) for f in fields)
            self.assertLess(max(values), 1 << at)
            for f in fields:   # the first field is the most significant, element 0 of an array the least
                for i in range(max(f.numbers, 1)):
                    low = at - f.bits * (max(f.numbers, 1) - i)
                    want = rows[f.name][0] if f.numbers == 0 else rows[f.name][0][i]
                    if np.ndim(want) == 0:
                        self.assertEqual(values[0] >> low & ((1 << f.bits) - 1), int(want) & ((1 << f.bits) - 1))
                at -= f.bits * max(f.numbers, 1)
            self.assertEqual(at, 0)

    def test_every_unit_answers_in_a_machine_that_has_it(self):
        structures = re.search("Values: (.*);", rayclock.Config.structure.__doc__)[1].split(", ")
        answered = set()
        for config in [rayclock.Config(structure=s) for s in structures] + [rayclock.Config(levels=2)]:
            for name in unit.names():
                try:
                    rows = unit.requests(name, config)
                except rayclock.Error as error:
                    self.assertRegex(str(error), "has no unit")
                    continue
                if name not in ("xform",):   # a map of zeros has no direction
                    self.assertEqual(len(getattr(unit, name)(rows, config)), 1)
                answered.add(name)
        self.assertEqual(answered, set(unit.names()))
        with self.assertRaises(AttributeError):
            unit.trj


class Speed(Case):
    def test_a_million_requests_take_at_most_twice_the_loop_in_cpp(self):
        config = rayclock.Config()
        batch = hard_batch(1_000_000, config)
        made = np.zeros(len(batch), unit.response_dtype("tri", config))
        for out in (None, made):   # compared with a loop into a new vector, and into an existing one
            ratios = []
            for _ in range(5):
                begin = time.perf_counter()
                unit.tri(batch, config, out=out)
                seconds = time.perf_counter() - begin
                ratios.append(seconds / _rayclock.unit_loop_seconds("tri", batch, config, out is None))
            print("unit.tri, share of the C++ loop:", " ".join(f"{r:.2f}" for r in ratios))
            self.assertLess(min(ratios), 2)


if __name__ == "__main__":
    unittest.main()
