// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/python/without_gil.hpp"

#include <chrono>
#include <csignal>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace py = pybind11;

namespace edgeproof::python {
namespace {

struct sigaction pythons_own; ///< the action that ours calls after its own work

extern "C" void on_ctrl_c(int signal, siginfo_t* info, void* context) {
    request_interruption(signal);
    if ((pythons_own.sa_flags & SA_SIGINFO) != 0) {
        pythons_own.sa_sigaction(signal, info, context);
    } else {
        pythons_own.sa_handler(signal);
    }
}

bool in_main_thread() { return ::syscall(SYS_gettid) == ::getpid(); }

bool is_ours(const struct sigaction& action) {
    return (action.sa_flags & SA_SIGINFO) != 0 && action.sa_sigaction == on_ctrl_c;
}

} // namespace

InterruptedByCtrlC::InterruptedByCtrlC() {
    struct sigaction now = {};
    if (!in_main_thread() || sigaction(SIGINT, nullptr, &now) != 0 || is_ours(now) ||
        ((now.sa_flags & SA_SIGINFO) == 0 &&
         (now.sa_handler == SIG_DFL || now.sa_handler == SIG_IGN))) {
        return;
    }
    pythons_own = now;
    struct sigaction ours = now;
    ours.sa_flags |= SA_SIGINFO;
    ours.sa_sigaction = on_ctrl_c;
    active_ = sigaction(SIGINT, &ours, nullptr) == 0;
}

InterruptedByCtrlC::~InterruptedByCtrlC() {
    if (!active_) {
        return;
    }
    struct sigaction now = {};
    if (sigaction(SIGINT, nullptr, &now) == 0 &&
        is_ours(now)) { // it has not been replaced meanwhile
        sigaction(SIGINT, &pythons_own, nullptr);
    }
    withdraw_interruption();
}

void Callback::operator()(std::size_t done, std::size_t total) {
    if (callback_.is_none()) {
        return;
    }
    const py::gil_scoped_acquire held;
    try {
        callback_(done, total);
    } catch (py::error_already_set&) {
        const std::lock_guard lock(mutex_);
        if (!raised_) {
            raised_ = std::current_exception();
            request_interruption(SIGINT);
        }
    }
}

void Callback::rethrow() {
    const std::lock_guard lock(mutex_);
    if (raised_) {
        withdraw_interruption();
        std::rethrow_exception(std::exchange(raised_, nullptr));
    }
}

void after_interruption() {
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
    const py::gil_scoped_release released;
    while (interruption_requested() != 0) { // the request is for another thread
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

} // namespace edgeproof::python
