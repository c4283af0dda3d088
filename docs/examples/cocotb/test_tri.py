"""Drives rc_tri with cocotb, and compares every answer with the function of the unit: rayclock.unit.tri.

run.py builds the RTL and starts this test. The same test bench checks your own rc_tri, whatever its latency: it uses
valid and ready only.
"""
import os

import cocotb
import numpy as np
from cocotb.clock import Clock
from cocotb.triggers import FallingEdge, ReadOnly, RisingEdge

import rayclock
from rayclock import unit


def batch(count, config, seed):
    """Returns requests: random triangles, and rays towards a point near each of them."""
    rng = np.random.default_rng(seed)
    reach, far = 1 << (config.coord_bits - 3), (1 << (config.dir_bits - 1)) - 1
    corners = rng.integers(-reach, reach, (3, count, 3))
    o = rng.integers(-reach, reach, (count, 3))
    aim = np.einsum("kij,ik->ij", corners, rng.dirichlet((1, 1, 1), count) * 1.4) - o
    d = np.rint(aim * (far / np.abs(aim).max(axis=1, keepdims=True))).astype(int)
    return unit.requests("tri", config, ray=np.arange(count) % config.contexts, o=o, d=d, a=corners[0], b=corners[1],
                         c=corners[2], prim=np.arange(count))


@cocotb.test()
async def answers_are_those_of_the_function(dut):
    config = rayclock.Config(os.environ.get("CONFIG", "default"))
    requests = batch(int(os.environ.get("COUNT", "500")), config, seed=1)
    values = unit.port_values("tri", requests, config)
    rng = np.random.default_rng(2)
    cocotb.start_soon(Clock(dut.clk_i, 10, "step").start())
    dut.rst_ni.value, dut.req_valid_i.value, dut.req_i.value, dut.rsp_ready_i.value = 0, 0, 0, 0
    for _ in range(4):
        await FallingEdge(dut.clk_i)
    dut.rst_ni.value = 1

    answers, sent, cycles = [], 0, 0
    while len(answers) < len(values):
        await FallingEdge(dut.clk_i)   # inputs change here, and are read at the rising edge
        offers = sent < len(values) and rng.random() < 0.8
        takes = rng.random() < 0.7
        dut.req_valid_i.value = int(offers)
        dut.req_i.value = values[sent] if offers else 0
        dut.rsp_ready_i.value = int(takes)
        await ReadOnly()
        accepted = offers and bool(dut.req_ready_o.value)
        if takes and bool(dut.rsp_valid_o.value):
            answers.append(int(dut.rsp_o.value))
        await RisingEdge(dut.clk_i)
        sent += accepted
        cycles += 1
        assert cycles < 100 * len(values), "the unit does not answer"

    expected = unit.tri(requests, config)
    got = unit.from_port_values("tri", answers, config)
    for i in np.flatnonzero(got != expected)[:1]:
        raise AssertionError(f"request {i}, {requests[i]}: expected {expected[i]}, got {got[i]}")
    hits = int(expected["closer"].sum())
    assert 0 < hits < len(values)
    dut._log.info("%d answers in %d cycles are those of rayclock.unit.tri, %d of them hits", len(values), cycles, hits)
