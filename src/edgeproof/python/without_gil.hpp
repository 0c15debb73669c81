// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/edgeproof.hpp"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <exception>
#include <mutex>
#include <utility>

namespace edgeproof::python {

/// During its life, SIGINT also requests an interruption, in addition to Python's own action. This
/// applies only in the main thread, where Python handles signals, and only if Python handles this
/// one. Must be made and destroyed with the GIL held. Its end withdraws the request.
class InterruptedByCtrlC {
public:
    InterruptedByCtrlC();
    ~InterruptedByCtrlC();
    InterruptedByCtrlC(const InterruptedByCtrlC&) = delete;
    InterruptedByCtrlC& operator=(const InterruptedByCtrlC&) = delete;

private:
    bool active_ = false;
};

/// Called, with the GIL held, after work that ended by Interrupted: throws the exception that
/// Python raises for the signal (usually KeyboardInterrupt). If there is none, or if the signal was
/// for the work of another thread, it returns when the request is withdrawn, and the work can be
/// repeated.
void after_interruption();

/// Calls a Python function (or None) with (done, total), from any thread. An exception of the
/// function ends the work.
class Callback {
public:
    explicit Callback(pybind11::object callback) : callback_(std::move(callback)) {}
    void operator()(std::size_t done, std::size_t total);
    /// Throws the function's exception, if there was one. Needs the GIL.
    void rethrow();

private:
    pybind11::object callback_;
    std::mutex mutex_;
    std::exception_ptr raised_;
};

/// Runs f() without the GIL, so that other Python threads run. Ctrl-C ends it at its next check
/// (check_interruption) with KeyboardInterrupt.
template <class F> auto without_gil(const F& f, Callback* progress = nullptr) {
    for (;;) {
        try {
            const InterruptedByCtrlC signals;
            const pybind11::gil_scoped_release released;
            return f();
        } catch (const Interrupted&) {
        }
        if (progress != nullptr) {
            progress->rethrow();
        }
        after_interruption();
    }
}

/// Returns a function, or a member function, that runs without the GIL.
template <class Result, class... Arguments> auto apart(Result (*function)(Arguments...)) {
    return [function](Arguments... arguments) {
        return without_gil([&] { return function(arguments...); });
    };
}
template <class Result, class T, class... Arguments>
auto apart(Result (T::*function)(Arguments...) const) {
    return [function](const T& self, Arguments... arguments) {
        return without_gil([&] { return (self.*function)(arguments...); });
    };
}

/// Runs f(progress) like without_gil(f). `progress` calls the function, and throws its exception.
template <class F> auto with_progress(pybind11::object callback, const F& f) {
    Callback progress(std::move(callback));
    auto found = without_gil([&] { return f(Progress(std::ref(progress))); }, &progress);
    progress.rethrow();
    return found;
}

} // namespace edgeproof::python
