// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/interruption.hpp"

#include <pybind11/pybind11.h>

#include <cstddef>
#include <exception>
#include <mutex>
#include <utility>

namespace edgeproof::python {

/// While it lives, SIGINT requests an interruption besides what Python does with it; in the main
/// thread, where Python handles signals, and only if Python handles this one. To be made and
/// destroyed with the GIL held. At its end the request is taken back.
class InterruptedByCtrlC {
public:
    InterruptedByCtrlC();
    ~InterruptedByCtrlC();
    InterruptedByCtrlC(const InterruptedByCtrlC&) = delete;
    InterruptedByCtrlC& operator=(const InterruptedByCtrlC&) = delete;

private:
    bool active_ = false;
};

/// After work that ended by Interrupted, with the GIL held: throws what Python makes of the signal
/// (KeyboardInterrupt as a rule). Returns where that is nothing, or where the signal was for the
/// work of another thread, once the request is withdrawn: the work can be done again.
void after_interruption();

/// A Python function that is told (done, total), from any thread, or None. What it raises ends the
/// work.
class Progress {
public:
    explicit Progress(pybind11::object callback) : callback_(std::move(callback)) {}
    void operator()(std::size_t done, std::size_t total);
    /// With the GIL held: throws what the function has raised.
    void rethrow();

private:
    pybind11::object callback_;
    std::mutex mutex_;
    std::exception_ptr raised_;
};

/// f() without the GIL, so that other Python threads run. Ctrl-C ends it at its next look
/// (check_interruption) with KeyboardInterrupt.
template <class F> auto without_gil(const F& f, Progress* progress = nullptr) {
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

} // namespace edgeproof::python
