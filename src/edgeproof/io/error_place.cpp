// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/error_place.hpp"

#include "edgeproof/precision/error.hpp"

#include <typeinfo>

namespace edgeproof::io {

void rethrow_at(const std::string& file, std::size_t line, std::string_view instead) {
    const auto advice = [&](std::string_view usual) {
        return std::string(instead.empty() ? usual : instead);
    };
    try {
        throw;
    } catch (const InputError& error) {
        if (!error.file().empty()) {
            throw;
        }
        throw InputError(error.problem(), error.instead().empty()
                                              ? advice("write it as the documentation has it")
                                              : error.instead())
            .at(file, line);
    } catch (const BudgetError& error) {
        throw InputError(error.what(), advice("ask for fewer digits, or write simpler numbers"))
            .at(file, line);
    } catch (const DomainError& error) {
        throw InputError(error.what(), advice("give values for which everything has a real value"))
            .at(file, line);
    } catch (const Error& error) {
        if (typeid(error) != typeid(Error)) { // a derived class has a meaning of its own
            throw;
        }
        throw InputError(error.what(),
                         advice("write numbers, x, + - * / ^, and functions such as sqrt and log"))
            .at(file, line);
    }
}

} // namespace edgeproof::io
