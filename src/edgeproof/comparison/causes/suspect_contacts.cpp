// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/comparison/causes/suspect_contacts.hpp"

#include "edgeproof/precision/error.hpp"

namespace edgeproof::comparison {

const ExactContact* SuspectContacts::with(const std::string& mistake,
                                          const std::function<void(scene::Scene&)>& change) {
    const auto known = solved_.find(mistake);
    if (known != solved_.end()) {
        return known->second.get();
    }
    std::unique_ptr<ExactContact> contact;
    try {
        scene::Scene other = scene_;
        change(other);
        contact = std::make_unique<ExactContact>(other);
    } catch (const Error&) { // the changed scene has no contact
    }
    return solved_.emplace(mistake, std::move(contact)).first->second.get();
}

} // namespace edgeproof::comparison
