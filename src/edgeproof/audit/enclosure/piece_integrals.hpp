// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/integrand.hpp"
#include "edgeproof/formula/expr.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/ball/complex_box.hpp"

#include <optional>
#include <utility>

namespace edgeproof::audit {

/// One end of a piece.
struct PieceEnd {
    formula::Expr written;
    Ball at;
    bool of_contacts = false; ///< where P1of and bof change their formula
    Ball angle = {};          ///< on a path
};

/// Integrals over pieces of an interval, on each of which the integrand is one formula: from the
/// end, or the ends, at which it is singular, in a variable in which it is not; or over a pole.
/// Not finite where the integrand has no bound.
class PieceIntegrals {
public:
    /// `lowest`, `highest`: the ends of the whole interval. `digits`: aimed at.
    PieceIntegrals(PieceEnd lowest, PieceEnd highest, long bits, unsigned digits)
        : lowest_(std::move(lowest)), highest_(std::move(highest)), bits_(bits), digits_(digits) {}

    /// `by_angle`: the integrand is one of a path's angle.
    [[nodiscard]] Box by_ends(Integrand& f, const PieceEnd& from, const PieceEnd& to,
                              bool by_angle) const;
    /// The principal value, the pole being inside: over it in the upper half-plane, half the
    /// residue added. Throws Error where it is not shown to be a simple one.
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

} // namespace edgeproof::audit
