// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/enclosure/enclosed_sample.hpp"
#include "edgeproof/audit/ledger/judgement.hpp"
#include "edgeproof/audit/sample/audit_context.hpp"

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace edgeproof::audit {

/// Returns the family and the text of a scene or of a sample: "hertz: a = 3/2, m = 1".
[[nodiscard]] inline std::string full_text(const SceneSpec& scene) {
    return scene.family + ": " + scene.text();
}
[[nodiscard]] inline std::string full_text(const Sample& sample) {
    return sample.scene.family + ": " + sample.text();
}

/// Returns the reason why a formula is proved to have no value at a sample, if it is one of these:
/// a division by an expression that is zero (by symbols), or its logarithm or negative power; a
/// root, a logarithm or an inverse function of a number outside its domain; pressure or full-stick
/// traction at a place outside the contact; the law of a contact (b, its inverse, P, P') at a size
/// that is not positive; an integrand that is not integrable at an end. Integrals are checked at
/// some places within their limits, too. Returns nothing where balls do not prove it.
[[nodiscard]] std::optional<std::string> no_value_of(const Expr& e, const Sample& sample,
                                                     long bits);

/// The samples of a claim that its `where` certainly admits. Keeps their enclosures. Not
/// thread-safe: one thread may use an object at a time.
class ClaimSamples {
public:
    ClaimSamples(const Claim& claim, const AuditContext& context);

    [[nodiscard]] const std::vector<Sample>& all() const noexcept { return samples_; }
    /// The number of samples that `where` does not certainly admit.
    [[nodiscard]] std::size_t left_out() const noexcept { return left_out_; }
    [[nodiscard]] std::size_t scenes() const;
    /// `integral_digits`: as in EnclosedSample.
    [[nodiscard]] const EnclosedSample& enclosed(std::size_t sample, long bits,
                                                 unsigned integral_digits) const;

private:
    std::vector<Sample> samples_;
    mutable std::map<std::tuple<std::size_t, long, unsigned>, EnclosedSample> enclosed_;
    std::size_t left_out_ = 0;
};

/// True if `where` of the claim (if it has one) certainly holds at a sample.
[[nodiscard]] bool is_admitted(const Claim& claim, const Sample& sample);

/// Returns a text such as "17.3" for digits in evidence, limited to a useful maximum.
[[nodiscard]] std::string digits_text(double digits);
/// Returns a value rounded for evidence.
[[nodiscard]] std::string value_text(const Real& value, unsigned digits);

} // namespace edgeproof::audit
