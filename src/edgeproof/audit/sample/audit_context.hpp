// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/claim.hpp"
#include "edgeproof/audit/ledger/family.hpp"
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/audit/ledger/outcome.hpp"
#include "edgeproof/contact/profile/edge.hpp"

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeproof::audit {

/// A scene, a place in it, and values for the names of `vary`: one sample of a claim.
struct Sample {
    SceneSpec scene;
    std::optional<formula::Exact> fraction; ///< u as a fraction of the contact's length
    contact::Edge edge = contact::Edge::right;
    std::map<std::string, formula::Exact, std::less<>> variables;
    [[nodiscard]] std::string text() const;
};

/// What takes quadratures at every sample is held to 100 digits at all of them, and to more, where
/// they are asked for, at some that are spread evenly over the others.
struct ManyDigits {
    static constexpr unsigned everywhere = 100;
    static constexpr std::size_t samples = 6;
};

/// 0, 1, ..., n - 1, but before all others `first` of them (all, if there are no more) that are
/// spread evenly, the two ends among them.
[[nodiscard]] std::vector<std::size_t> spread_first(std::size_t n, std::size_t first);

/// What a check may ask for beside the claim.
class AuditContext {
public:
    AuditContext(const Ledger& ledger, unsigned digits) : ledger_(ledger), digits_(digits) {}

    [[nodiscard]] const Ledger& ledger() const noexcept { return ledger_; }
    /// D: the digits that were asked for.
    [[nodiscard]] unsigned digits() const noexcept { return digits_; }
    /// Digits that a claim must agree to to be confirmed: D - 5.
    [[nodiscard]] unsigned digits_needed() const noexcept { return digits_needed(digits_); }
    /// The same of digits that a check is content with.
    [[nodiscard]] static unsigned digits_needed(unsigned of) noexcept { return of - 5; }
    /// The scenes of the family that the claim's `over` names.
    [[nodiscard]] std::vector<SceneSpec> scenes(const Claim& claim) const;
    /// Scenes, places (from the claim's `edge`; in `points` per scene) and values of `vary`.
    [[nodiscard]] std::vector<Sample> samples(const Claim& claim) const;

    /// What several claims need and is expensive: made once a run, by whoever asks first; the
    /// others wait. The key says all that the result depends on.
    template <class T>
    [[nodiscard]] std::shared_ptr<const T> once(const std::string& key,
                                                const std::function<T()>& make) const {
        Slot& slot = slot_of(key);
        const std::lock_guard lock(slot.mutex);
        if (!slot.value) {
            slot.value = std::make_shared<const T>(make());
        }
        return std::static_pointer_cast<const T>(slot.value);
    }

    /// What belongs to one thread at a time and is expensive to make: one that was given back, or a
    /// new one. It goes back when the last pointer to it does; the context must outlive it.
    template <class T>
    [[nodiscard]] std::shared_ptr<T> borrow(const std::string& key,
                                            const std::function<std::unique_ptr<T>()>& make) const {
        std::shared_ptr<void> kept = take(key);
        if (!kept) {
            kept = std::shared_ptr<T>(make());
        }
        T* const object = static_cast<T*>(kept.get());
        return {object, [this, key, kept = std::move(kept)](T*) mutable {
                    give_back(key, std::move(kept));
                }};
    }

private:
    struct Slot {
        std::mutex mutex;
        std::shared_ptr<const void> value;
    };
    [[nodiscard]] Slot& slot_of(const std::string& key) const {
        const std::lock_guard lock(slots_mutex_);
        return slots_[key];
    }
    [[nodiscard]] std::shared_ptr<void> take(const std::string& key) const;
    void give_back(const std::string& key, std::shared_ptr<void> object) const;
    const Ledger& ledger_;
    unsigned digits_;
    mutable std::mutex lent_mutex_;
    mutable std::map<std::string, std::vector<std::shared_ptr<void>>, std::less<>> idle_;
    mutable std::mutex slots_mutex_;
    mutable std::map<std::string, Slot, std::less<>> slots_;
};

} // namespace edgeproof::audit
