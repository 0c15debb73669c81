# SPDX-License-Identifier: BSD-3-Clause
import pathlib

import pytest

import edgeproof


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "slow: more than a few seconds, or of packages seldom there")


@pytest.fixture(scope="session")
def source() -> pathlib.Path:
    """The root of the source tree."""
    return pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def hertz() -> edgeproof.Scene:
    """E* = 1, R = 1, a = 1: p = sqrt(1 - x^2)/2 (Johnson, Contact Mechanics, 4.2)."""
    return edgeproof.Scene(edgeproof.hertz(R=1), a=1, contact_modulus=1)


@pytest.fixture(scope="session")
def curved() -> edgeproof.Scene:
    """A slope without a closed form."""
    return edgeproof.Scene(edgeproof.piecewise([], ["sinh(x)"], symmetric=True), a="1",
                           contact_modulus="1")
