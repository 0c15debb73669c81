# SPDX-License-Identifier: BSD-3-Clause
"""Families of scenes, and formulas that are true in them."""
from .ledger import family

U = ("1e-30", "1e-12", "1e-6", "1/1000", "1/20", "1/5", "3/7", "49/100")
SIZES = ("3/2", "1e-9", "7e5", "0.02", "1/7", "sqrt(2)", "pi/3")
MODULI = ("7/3", "2.1e11", "1e-12", "64500")
GAM = ("1/40", "1/3", "1/2", "9/10", "999/1000", "1e-6")


def power_law(rng, m=None, u=None, count=1, **more):
    m = m or rng.choice(("0", "1", "2", "3"))
    return family("power-law", count=count, u=u or (rng.choice(U),), m=m, C=rng.choice(("3/7", "1e-6", "2e4",
                                                                                        "1/70")),
                  a=rng.choice(SIZES), Es=rng.choice(MODULI), **more)


def flat(rng, u=None, t=None, **more):
    return family("flat-and-rounded", u=u or (rng.choice(U),),
                  t=t or rng.choice(("a*2/5", "a*4/5", "a*1e-6", "a*(1-1e-6)", "a/3", "a*99/100")),
                  R=rng.choice(("3", "1e-3", "4e6")), a=rng.choice(SIZES), Es=rng.choice(MODULI), **more)


def wedge(rng, u=None, gam=None, **more):
    return family("tilted-wedge", u=u or (rng.choice(U[:7]),), gam=gam or rng.choice(GAM),
                  phi=rng.choice(("pi/16", "1/50", "pi/3")), alpha="2*phi/pi*asin((1-gam)/(1+gam))",
                  a=rng.choice(SIZES), Es=rng.choice(MODULI), **more)


def tilted_flat(rng, u=None, **more):
    return family("tilted-flat-and-rounded", u=u or (rng.choice(U[:7]),), alpha=rng.choice(("pi/16", "1/1000",
                                                                                            "1/10")),
                  t=rng.choice(("R/2", "R/50", "R*2")), R=rng.choice(("2", "1e-3", "4e4")),
                  a=rng.choice(("alpha*R*5/4", "alpha*R*2+t*2", "alpha*R/2")), Es=rng.choice(MODULI), **more)


# g'(x) = x/n + x^3/k: a curved slope whose pressure has a closed form.
def curved(rng, u=None):
    n, k = rng.randint(2, 40), rng.randint(1, 9)
    return family("piecewise-symmetric", u=u or (rng.choice(("1/20", "1/5", "3/7")),), slopes=(f"x/{n} + x^3/{k}",),
                  a=rng.choice(("3/4", "1/7", "3/2")), Es=rng.choice(("7/3", "2.1e11"))), n, k


# Places exactly on the knot x = t (or -t) of a flat-and-rounded profile, and their distance from
# the edge over 2a.
KNOTS = (("a/3", "1/3"), ("a/2", "1/4"), ("a*3/5", "1/5"), ("a/7", "3/7"), ("a*(1-2e-6)", "1e-6"),
         ("a*(1-2e-30)", "1e-30"), ("a/3", "2/3"), ("a*2/5", "7/10"), ("a*99/100", "1/200"))


def on_knot(rng):
    t, u = rng.choice(KNOTS)
    return flat(rng, u=(u,), t=t)


# Formulas: (quantity, formula). {m}: the exponent.
HERTZ = (("p(x)", "Es*C/2*sqrt(a^2-x^2)"), ("P", "Pi/4*Es*C*a^2"), ("P1", "Pi/2*Es*C*a"), ("P2", "Pi/2*Es*C"),
         ("p(0)", "Es*C*a/2"), ("a", "2*sqrt(P/(Pi*Es*C))"), ("b", "2*sqrt(P/(Pi*Es*C))"), ("p(0)", "2*P/(Pi*a)"),
         ("g1(x)", "C*x"), ("right.c0", "Es*C/2*sqrt(2*a)"), ("right.c1", "-Es*C/2*sqrt(2*a)/(4*a)"),
         ("right.c2", "-Es*C/2*sqrt(2*a)/(32*a^2)"), ("left.c3", "-Es*C/2*sqrt(2*a)/(128*a^3)"),
         ("p(a/2)", "Es*C*a*sqrt(3)/4"), ("Pof(a/3)", "P/9"), ("P1of(a/3)", "P1/3"),
         ("right_local(1, x)", "Es*C/2*sqrt(2*a*(a-x))"), ("integral(p(s), s, -a, a)", "Pi/4*Es*C*a^2"),
         ("integral(p(s), s, 0, a)", "P/2"), ("integral(s^2*p(s), s, -a, a)", "P*a^2/4"))
WEDGE = (("p(x)", "Es*C/Pi*log((a+sqrt(a^2-x^2))/abs(x))"), ("P", "Es*C*a"), ("P1", "Es*C"), ("P1", "P/a"),
         ("right.c0", "Es*C/Pi*sqrt(2/a)"), ("right.c1", "5*Es*C/(12*a*Pi)*sqrt(2/a)"), ("a", "P/(Es*C)"),
         ("g1(x)", "C*sgn(x)"), ("p(a/2)", "Es*C/Pi*log(2+sqrt(3))"))
SQUARE = (("p(x)", "Es*C/Pi*(a*sqrt(a^2-x^2) + x^2*log((a+sqrt(a^2-x^2))/abs(x)))"), ("P", "2/3*Es*C*a^3"),
          ("P1", "2*Es*C*a^2"), ("P2", "4*Es*C*a"), ("P3", "4*Es*C"), ("p(0)", "Es*C*a^2/Pi"), ("p(0)",
                                                                                                "3*P/(2*Pi*a)"),
          ("right.c0", "2*Es*C*a^2/Pi*sqrt(2/a)"), ("g1(x)", "C*x*abs(x)"))
CUBE = (("p(x)", "Es*C/4*sqrt(a^2-x^2)*(a^2+2*x^2)"), ("P", "3*Pi/16*Es*C*a^4"), ("P1", "3*Pi/4*Es*C*a^3"),
        ("P2", "9*Pi/4*Es*C*a^2"), ("p(0)", "Es*C*a^3/4"), ("p(0)", "4*P/(3*Pi*a)"), ("g1(x)", "C*x^3"),
        ("right.c0", "3*Es*C*a^3/4*sqrt(2/a)"), ("right.c1", "-19*Es*C*a^2/16*sqrt(2/a)"))
POWER = {"0": WEDGE, "1": HERTZ, "2": SQUARE, "3": CUBE}
FLAT = (("P", "Es*a^2/R*(Pi/4 - asin(t/a)/2 - t/(2*a^2)*sqrt(a^2-t^2))"), ("P1", "Es*a/R*acos(t/a)"),
        ("P2", "Es/R*(acos(t/a) + t/sqrt(a^2-t^2))"), ("right.c0", "sqrt(2*a)*Es/(Pi*R)*acos(t/a)"),
        ("right.c1", "-Es/(2*sqrt(2*a)*Pi*R)*(acos(t/a) + 8*t/(3*sqrt(a^2-t^2)))"), ("left.c0", "right.c0"),
        ("g1(x)", "sgn(x)*max(abs(x)-t, 0)/R"), ("g1(x)", "sgn(x)*(abs(x)-t + abs(abs(x)-t))/(2*R)"),
        ("g1(a)", "(a-t)/R"), ("p(0)", "Es/(Pi*R)*(a*acos(t/a) - t*log((a+sqrt(a^2-t^2))/t))"),
        ("p(t)", "Es/(Pi*R)*(sqrt(a^2-t^2)*acos(t/a) - t*log(a/t))"))
TILTED = (("b", "gam*a"), ("P", "Es*phi*sqrt(gam)*a"), ("P1", "Es*phi*sqrt(gam)"), ("P1", "P/a"), ("b1", "gam"),
          ("p(x)", "Es*phi/Pi*log(abs((1+sqrt(gam*(a-x)/(x+b)))/(1-sqrt(gam*(a-x)/(x+b)))))"),
          ("right.c0", "2*Es*phi*sqrt(gam)/(Pi*sqrt((1+gam)*a))"), ("left.c0", "2*Es*phi/(Pi*sqrt(gam*(1+gam)*a))"),
          ("right.c1", "sqrt(gam)*(3+2*gam)*Es*phi/(3*Pi*((1+gam)*a)^(3/2))"), ("left.c0", "right.c0/gam"),
          ("Pof(a/2)", "P/2"), ("bof(a/3)", "b/3"), ("binv(b/5)", "a/5"), ("g1(x)", "sgn(x)*phi - alpha"))
# Formulas for any contact with P' and b'.
GENERAL = (("right.c0", "2*P1/(Pi*sqrt(a+b))"), ("left.c0", "2*P1/(Pi*b1*sqrt(a+b))"), ("left.c0", "right.c0/b1"),
           ("right.c1", "((3+2*b1)*P1 - 4*(a+b)*P2)/(3*Pi*(a+b)^(3/2))"), ("L", "a+b"), ("bof(a)", "b"),
           ("binv(b)", "a"), ("Pof(a)", "P"), ("P1of(a)", "P1"), ("right_local(1, x)", "right.c0*sqrt(a-x)"),
           ("left_local(2, x)", "left.c0*sqrt(b+x) + left.c1*(b+x)^(3/2)"),
           ("left.c1", "((3*b1^2+2*b1+4*b2*L)*P1 - 4*L*b1*P2)/(3*Pi*b1^3*L^(3/2))"), ("b1*left.c0", "right.c0"),
           ("6*L*b1^2*left.c1", "6*L*right.c1 + (b1-1)*right.c0 + 4*L*b2*left.c0"),
           ("right.c2", "((45 - 16*b2*(a+b) + 24*b1^2 + 60*b1)*P1 - 8*(a+b)*(4*b1+5)*P2 + 32*(a+b)^2*P3)"
            "/(60*Pi*(a+b)^(5/2))"))
# Formulas for symmetric contacts.
SYMMETRIC = (("b", "a"), ("L", "2*a"), ("p(-x)", "p(x)"), ("g1(-x)", "-g1(x)"), ("left.c2", "right.c2"),
             ("left_local(2, -x)", "right_local(2, x)"), ("b1", "1"), ("right.c0", "sqrt(2/a)/Pi*P1"),
             ("right.c1", "2*sqrt(2)/(3*a^(3/2)*Pi)*(5*P1/8 - a*P2)"), ("left.c1", "right.c1"), ("P1", "abs(P1)"),
             ("right.c2", "sqrt(2)/(480*a^(5/2)*Pi)*(129*P1 - 144*a*P2 + 128*a^2*P3)"), ("a", "max(a, b)"),
             ("right.c0", "sqrt(left.c0^2)"))
# Formulas that are exactly zero: (quantity, formula, a scale of its parts).
ZEROS = (("0", "integral(g1(s)/sqrt((a-s)*(s+b)), s, -b, a)", "integral(abs(g1(s))/sqrt((a-s)*(s+b)), s, -b, a)"),
         ("0", "p(a)", "P/a"), ("0", "p(-b)", "P/a"), ("0", "right_local(3, a)", "P/a"), ("0", "a + b - L", "a"),
         ("0", "Pof(a) - P", "P"), ("0", "binv(bof(a)) - a", "a"), ("0", "right.c0 - b1*left.c0", "right.c0"),
         ("0", "p(x) - p(x)*(cos(u/L)^2+sin(u/L)^2)", "p(x)"), ("0", "sgn(a+b-L)", "1"), ("1/2", "step(x+u-a)", "1"),
         ("0", "sqrt(x+u-a)", "sqrt(a)"), ("0", "sgn(Pof(a)-P)", "1"), ("0", "acos(cos(x/L)^2+sin(x/L)^2)", "1"),
         ("0", "sqrt(1-cos(x/L)^2-sin(x/L)^2)", "1"), ("Pi/2", "asin((x+u)/a)", "1"), ("0", "abs(binv(b)-a)", "a"))
SYMMETRIC_ZEROS = (("0", "M", "P*a"), ("0", "a - b", "a"), ("0", "g1(x) + g1(-x)", "g1(a)"), ("0", "b2", "1/a"),
                   ("0", "g1(0)", "g1(a)"), ("0", "integral(s*p(s), s, -b, a)", "P*a"), ("0", "p(x) - p(-x)", "P/a"),
                   ("0", "right.c1 - left.c1", "right.c0/a"), ("0", "b1 - 1", "1"),
                   ("0", "right.c0 - sqrt(2/a)/Pi*P1", "right.c0"),
                   ("0", "sgn(a-b)", "1"), ("0", "sqrt(a-b)", "sqrt(a)"), ("0", "acos(a/b)", "1"), ("Pi/2",
                                                                                                    "asin(b/a)", "1"),
                   ("0", "sgn(p(x)-p(-x))", "1"), ("0", "sgn(right.c0-left.c0)", "1"), ("1/2", "step(M)", "1"),
                   ("0", "min(a-b, 0)", "a"), ("0", "max(a, b) - min(a, b)", "a"), ("0", "log(a/b)", "1"))
SHEARED = (("q(x)", "Q/(Pi*sqrt((a-x)*(x+b))) + sig0*(2*x+b-a)/(8*sqrt((a-x)*(x+b)))"),
           ("right.s0", "(Q/Pi + sig0*L/8)/sqrt(L)"), ("left.s0", "(Q/Pi - sig0*L/8)/sqrt(L)"),
           ("right.s1", "(Q/(2*Pi*L) - 3*sig0/16)/sqrt(L)"), ("left.s1", "(Q/(2*Pi*L) + 3*sig0/16)/sqrt(L)"),
           ("right.s2", "(3*Q/(8*Pi*L^2) - 5*sig0/(64*L))/sqrt(L)"), ("2*L*right.s1", "2*left.s0 - right.s0"),
           ("8*L^2*left.s2", "4*L*left.s1 + left.s0"))


def sheared(rng, of=None, Q=None, sig0=None):
    of = of or rng.choice((wedge, power_law, tilted_flat))
    return of(rng, Q=Q or rng.choice(("3/10", "-7e5", "1e-4", "-2/9")),
              sig0=sig0 or rng.choice(("1/3", "-5e-3", "8e6", "-11")))


def any_scene(rng):
    """A family, its formulas, its zeros."""
    which = rng.choice(("power", "power", "flat", "knot", "wedge", "tilted"))
    if which == "power":
        m = rng.choice(tuple(POWER))
        return power_law(rng, m), POWER[m] + SYMMETRIC + GENERAL, ZEROS + SYMMETRIC_ZEROS
    if which in ("flat", "knot"):
        return (flat if which == "flat" else on_knot)(rng), FLAT + SYMMETRIC + GENERAL, ZEROS + SYMMETRIC_ZEROS
    if which == "wedge":
        return wedge(rng), TILTED + GENERAL, ZEROS
    return tilted_flat(rng), GENERAL, ZEROS
