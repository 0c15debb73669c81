// SPDX-License-Identifier: GPL-3.0-or-later
/// All that Edgeproof knows of MPI: a module of its own, loaded only where the program was started
/// as one of several processes (cli/installed.cpp), so that alone it does not even link to MPI.
#include "edgeproof/parallel/distributed_work.hpp"
#include "edgeproof/precision/error.hpp"

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

#include <memory>

namespace edgeproof {
namespace {

void check(int code, const char* what) {
    if (code != MPI_SUCCESS) {
        throw Error(std::string("MPI failed to ") + what);
    }
}

class MpiProcesses : public parallel::Processes {
public:
    MpiProcesses() {
        int provided = MPI_THREAD_SINGLE;
        check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided), "start");
        MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
        if (provided < MPI_THREAD_FUNNELED) {
            MPI_Finalize();
            throw Error("this MPI does not support threads");
        }
        check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "return a rank");
        check(MPI_Comm_size(MPI_COMM_WORLD, &size_), "return a size");
    }
    ~MpiProcesses() override { MPI_Finalize(); }

    [[nodiscard]] std::size_t number() const override { return static_cast<std::size_t>(rank_); }
    [[nodiscard]] std::size_t count() const override { return static_cast<std::size_t>(size_); }
    void send(std::size_t to, const std::string& text) override {
        check(MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, static_cast<int>(to),
                       tag, MPI_COMM_WORLD),
              "send a message");
    }
    std::optional<Message> receive() override {
        int here = 0;
        MPI_Status status;
        check(MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &here, &status), "look for messages");
        if (here == 0) {
            return {};
        }
        int size = 0;
        check(MPI_Get_count(&status, MPI_CHAR, &size), "return the size of a message");
        Message message{static_cast<std::size_t>(status.MPI_SOURCE),
                        std::string(static_cast<std::size_t>(size), '\0')};
        check(MPI_Recv(message.text.data(), size, MPI_CHAR, status.MPI_SOURCE, tag, MPI_COMM_WORLD,
                       &status),
              "receive a message");
        return message;
    }

private:
    static constexpr int tag = 1;
    int rank_ = 0;
    int size_ = 1;
};

} // namespace
} // namespace edgeproof

/// The processes that this one was started with. Throws Error.
extern "C" edgeproof::parallel::Processes* edgeproof_mpi_processes() {
    return std::make_unique<edgeproof::MpiProcesses>().release();
}
