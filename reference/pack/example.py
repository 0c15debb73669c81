# SPDX-License-Identifier: BSD-3-Clause
"""Hertz's line contact to 50 digits, as an example of a code that answers some of the pack."""
import decimal
from decimal import Decimal

decimal.getcontext().prec = 80
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803")


def answer(question):
    if question["kind"] != "power-law" or question["m"] != 1:
        return None
    modulus = Decimal(question["E"])
    curvature = Decimal(question["C"])
    if question["a"] is None:
        a = (4 * Decimal(question["P"]) / (PI * modulus * curvature)).sqrt()
    else:
        a = Decimal(question["a"])
    k = modulus * curvature / 2  # p = k sqrt(a^2 - x^2)
    quantity = question["quantity"]
    if quantity == "p":
        # In a product, so that no digit of a small u is lost.
        u = Decimal(question["u"])
        with decimal.localcontext() as context:
            context.prec = 1500
            return k * (u * (2 * a - u)).sqrt()
    if quantity == "c_0":
        return k * (2 * a).sqrt()
    if quantity == "c_1":
        return -k * (2 * a).sqrt() / (4 * a)
    if quantity == "c_2":
        return -k * (2 * a).sqrt() / (32 * a * a)
    if quantity == "P":
        return k * PI * a * a / 2
    if quantity in ("a", "b"):
        return a
    return None
