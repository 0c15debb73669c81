# SPDX-License-Identifier: BSD-3-Clause
"""Figures and conditions about the distance within which n terms meet a tolerance."""
from mpmath import mp, mpf

from .. import scenes
from ..ledger import Claim
from ..oracle import scene_of, value
from .conditions import sized_family
from .formulas import _decimal, _plain

POINTS = 300


def first_exit(scene, edge, terms, tolerance, upto):
    """The least fraction of the contact at which the error exceeds the tolerance; None if there is
    none up to `upto`."""
    L = scene.a + scene.b

    def error(u):
        x = scene.a - u * L if edge == "right" else -scene.b + u * L
        return abs(scene.local(edge, terms, x) / scene.p(x) - 1) - tolerance
    below = mpf(0)
    for k in range(1, POINTS + 1):
        above = upto * k / POINTS * (1 - mpf(10) ** -15)
        if error(above) > 0:
            for _ in range(100):
                middle = (below + above) / 2
                below, above = (below, middle) if error(middle) > 0 else (middle, above)
            return above
        below = above
    return None


def _scene(rng):
    which = rng.choice(("power", "power", "flat", "wedge"))
    if which == "power":
        return scenes.power_law(rng, rng.choice(("1", "0", "2", "3")))
    if which == "flat":
        return scenes.flat(rng, t=rng.choice(("a/3", "a*2/5", "a*4/5")))
    return scenes.wedge(rng, gam=rng.choice(("1/3", "1/2")))


def draw_extent(rng, digits):
    while True:
        at = _scene(rng)
        terms = rng.randint(1, 3)
        tolerance = rng.choice(("1/100", "1/20", "1e-3", "1e-6"))
        edge = "right"
        with mp.workdps(40):
            scene = scene_of(at)
            reach = first_exit(scene, edge, terms, value(tolerance, scene.names()), mpf(1) / 2)
            if reach is None or reach > mpf(49) / 100:
                continue
            base = rng.choice(("a", "a+b"))
            number = reach * (scene.a + scene.b) / value(base, scene.names())
            size = 0
            while number * 10**size < 1:
                size += 1
            places = size + rng.choice((1, 2, 4, 8))
            units = _plain(number, places)
        if units is None:
            continue
        off = rng.choice((0, 0, 0, 1, -1, 2, -2, 7, 40))
        if units + off <= 0:
            continue
        truth = "true" if off == 0 else "imprecise" if abs(off) == 1 else "false"
        keys = {"quoted": _decimal(units + off, places), "of": f"exit({terms}, {tolerance})/({base})", "edge": edge}
        return Claim("compare", keys, at, truth, at.profile, f"it is {mp.nstr(number, 15)}", group="exit")


def draw_size_extent(rng, digits):
    while True:
        claim = _size_extent(rng)
        if claim is not None:
            return claim


def _size_extent(rng):
    """The reach of a wedge or a parabola is the same fraction at every size."""
    shape = rng.choice(("hertz", "wedge"))
    at = sized_family(rng, shape)
    terms, tolerance = rng.randint(1, 3), rng.choice(("1/100", "1/20"))
    edge = rng.choice(("right", "left")) if shape == "wedge" else "right"
    with mp.workdps(40):
        like = scenes.family("power-law", m="1", C="1", a="1", Es="1") if shape == "hertz" else at
        scene = scene_of(like)
        apex = (scene.a if edge == "right" else scene.b) / (scene.a + scene.b) if shape == "wedge" else mpf(1)
        reach = first_exit(scene, edge, terms, value(tolerance, scene.names()), apex)
        if reach is None:
            return None
        base = rng.choice(("side", "whole"))
        number = reach * ((scene.a + scene.b) / (scene.a if edge == "right" else scene.b) if base == "side" else 1)
        if base == "side" and number > 1:
            return None  # the whole side is within the tolerance
        places = rng.choice((2, 3, 5))
        units = _plain(number, places)
    off = rng.choice((0, 0, 3, -2, 12)) if units > 2 else rng.choice((0, 3))
    side = "(a+b)" if base == "whole" else "a" if edge == "right" else "b"
    keys = {"edge": edge, "of": f"exit({terms}, {tolerance})/{side}", "sizes": ["1/10", "1", "10"],
            "quoted": _decimal(units + off, places)}
    return Claim("compare", keys, at, not off, shape, f"it is {mp.nstr(number, 15)}",
                 group="exit at sizes")


KINDS = {"exit": draw_extent, "exit at sizes": draw_size_extent}
