# SPDX-License-Identifier: BSD-3-Clause
"""Contact pressures near an edge, to any number of digits, each with a bound.

    import edgeproof
    scene = edgeproof.Scene(profile=edgeproof.hertz(R="100"), a="1", contact_modulus="1")
    p = scene.pressure(u="1e-3", digits=50)
    print(p.text, p.bound, p.proved, p.route)

Scenes      read_scene(file), Scene(profile=..., a=... or P=..., contact_modulus=..., ...)
Profiles    hertz, wedge, sphere, cone, power_law, flat_and_rounded, tilted_wedge,
            tilted_flat_and_rounded, piecewise; profile.revolved() is a body of revolution
Values      Value: .text, .bound, .proved, .route, float(v), v.fraction(), v.decimal(), v.mpmath();
            + - * / and comparisons keep the bounds
Formulas    verify(ledger): compares printed claims with the mechanics
Programs    check(answers, recipe=...): compares other programs' numbers with the exact values
Meshes      compare(scene, result): compares x and p of a mesh with the exact contact
Design      design(file): the parameter in a range for which an approximation reaches farthest
Relations   relations(quantities): polynomials in multipliers that vanish along every profile
Errors      Error, InputError and DomainError (both ValueError), BudgetError, UndecidedError

Numbers are given as str ("0.4", "pi/16", "3/2"), int, fractions.Fraction, decimal.Decimal,
mpmath.mpf or numpy scalars, and are exact. A float is exactly its binary64 number: 0.1 is
0.1000000000000000055511151231257827..., "0.1" is one tenth.
"""

try:
    from ._edgeproof import Value, __version__
except ImportError as error:
    from ._missing import explanation

    raise ImportError(explanation(error)) from None
from . import _value  # noqa: F401: completes Value
from .audit import Audit, Claim, verify
from .comparison import Comparison, compare
from .conformance import Agreement, check, questions
from .errors import BudgetError, DomainError, Error, InputError, UndecidedError
from .multipliers import Relations, relations
from .optimum import Design, design
from .profiles import (
    Number,
    Profile,
    cone,
    flat_and_rounded,
    hertz,
    piecewise,
    power_law,
    sphere,
    tilted_flat_and_rounded,
    tilted_wedge,
    wedge,
)
from .results import Result, Row, Rows
from .scene import Scene, read_scene

__all__ = [
    "Agreement", "Audit", "BudgetError", "Claim", "Comparison", "Design", "DomainError", "Error",
    "InputError", "Number", "Profile", "Relations", "Result", "Row", "Rows", "Scene",
    "UndecidedError", "Value", "__version__", "check", "compare", "cone", "design", "flat_and_rounded", "hertz", "piecewise", "power_law", "questions", "read_scene", "relations",
    "sphere", "tilted_flat_and_rounded", "tilted_wedge", "verify", "wedge",
]
