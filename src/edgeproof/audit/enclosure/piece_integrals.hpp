// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/integrand.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <optional>
#include <utility>

namespace edgeproof::audit {

struct PieceEnd {
    formula::Expr written;
    Ball at;
    bool of_contacts = false; ///< P1of and bof change their formula there
    Ball angle = {};          ///< on a path
};

/// Integrals over pieces of an interval; on each piece, the integrand is a single formula. It is
/// integrated from the end, or the ends, at which it is singular, in a variable in which it is
/// regular; or over a pole. The result is not finite if the integrand has no bound.
class PieceIntegrals {
public:
    /// `lowest`, `highest`: the ends of the whole interval. `digits`: the accuracy aimed at.
    PieceIntegrals(PieceEnd lowest, PieceEnd highest, long bits, unsigned digits)
        : lowest_(std::move(lowest)), highest_(std::move(highest)), bits_(bits), digits_(digits) {}

    /// `by_angle`: the integrand is a function of a path's angle.
    [[nodiscard]] Box by_ends(Integrand& f, const PieceEnd& from, const PieceEnd& to,
                              bool by_angle) const;
    /// Returns the principal value for a pole inside: the path passes it in the upper half-plane,
    /// and half the residue is added. Throws Error if the pole is not shown to be a simple one.
    [[nodiscard]] Box over_pole(Integrand& f, const PieceEnd& pole, const PieceEnd& from,
                                const PieceEnd& to) const;

private:
    [[nodiscard]] Box from_centre(Integrand& f, const Ball& near, const Ball& far) const;
    [[nodiscard]] std::optional<PieceEnd> singular_end(Integrand& f, const PieceEnd& end,
                                                       const PieceEnd& outermost, int direction,
                                                       const Ball& length, bool by_angle) const;
    [[nodiscard]] Ball distance(const Ball& x, const Ball& y) const;

    PieceEnd lowest_;
    PieceEnd highest_;
    long bits_;
    unsigned digits_;
};

/// Returns the integral of f, in the variable of its centre, along the straight line from v to w.
/// For boxes v and w, the result contains the integral between any two of their points.
[[nodiscard]] Box line_integral(Integrand& f, const Box& v, const Box& w, unsigned digits);

} // namespace edgeproof::audit
