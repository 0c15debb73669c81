// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/linear_error.hpp"

namespace edgeproof::contact {
namespace {

/// The error for one box, by the closed form of linear_error.hpp (docs/pressure.md).
class LinearOverBox : public ErrorOverBox {
public:
    LinearOverBox(LinearContact<Jet> contact, std::optional<Jet> a, std::optional<Jet> P,
                  const LinearEdges<Ball>& edges, LinearError<Ball> balls, bool symmetric,
                  const ErrorQuestion& question)
        : contact_(std::move(contact)), a_(std::move(a)), P_(std::move(P)), edges_(edges),
          balls_(std::move(balls)), symmetric_(symmetric), question_(question) {}
    [[nodiscard]] Ball at(const Ball& u) const override { return balls_.error(u); }
    [[nodiscard]] Jet jet(const Ball& u) const override {
        if (!jets_) {
            jets_.emplace(contact_, differentiated_edges(contact_, edges_, symmetric_, a_, P_),
                          question_);
        }
        return jets_->error(Jet::variable(u, 0));
    }
    [[nodiscard]] Ball length() const override {
        return balls_.fraction ? Ball(1, balls_.bits) : balls_.length;
    }

private:
    LinearContact<Jet> contact_;
    std::optional<Jet> a_;
    std::optional<Jet> P_;
    LinearEdges<Ball> edges_;
    LinearError<Ball> balls_;
    mutable std::optional<LinearError<Jet>> jets_; ///< made on first use
    bool symmetric_;
    const ErrorQuestion& question_;
};

class LinearSlopeFamily : public ErrorFamily {
public:
    LinearSlopeFamily(ParametricSlope slope, ParametricLoad load, ErrorQuestion question)
        : slope_(std::move(slope)), load_(std::move(load)), question_(std::move(question)) {}
    [[nodiscard]] std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const override {
        std::vector<Ball> middles;
        for (const Ball& x : parameters) {
            middles.emplace_back(x.midpoint(), x.bits());
        }
        const ParameterValues<Ball> value(question_.names, parameters);
        const ParameterValues<Ball> in_middle(question_.names, middles);
        const ParameterValues<Jet> jets(question_.names, parameters);
        const LinearContact<Ball> contact = linear_contact(slope_, load_.contact_modulus, value);
        const auto given = [](const std::optional<formula::Expr>& e, const auto& at) {
            return e ? std::optional(at(*e)) : std::nullopt;
        };
        const auto edges =
            solve_edges(contact, linear_contact(slope_, load_.contact_modulus, in_middle),
                        slope_.symmetric, given(load_.a, value), given(load_.P, value));
        if (!edges) {
            return std::make_unique<UnknownOverBox>(value.bits());
        }
        return std::make_unique<LinearOverBox>(linear_contact(slope_, load_.contact_modulus, jets),
                                               given(load_.a, jets), given(load_.P, jets), *edges,
                                               LinearError<Ball>(contact, *edges, question_),
                                               slope_.symmetric, question_);
    }

    [[nodiscard]] EvaluationCost cost() const override {
        const auto n = static_cast<double>(question_.terms);
        return {(load_.P ? 800 : 130) + n * n * n, 10, 130};
    }

private:
    ParametricSlope slope_;
    ParametricLoad load_;
    ErrorQuestion question_;
};

} // namespace

std::unique_ptr<ErrorFamily> linear_slope_errors(const ParametricSlope& slope,
                                                 const ParametricLoad& load,
                                                 const ErrorQuestion& question) {
    return std::make_unique<LinearSlopeFamily>(slope, load, question);
}

} // namespace edgeproof::contact
