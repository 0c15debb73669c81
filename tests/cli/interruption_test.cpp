// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/inputs.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/support/namespaces.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

using namespace edgeproof::test;

// SIGINT and SIGTERM end every subcommand at any time, each with its own exit status; no incomplete
// file and no child process is left.

namespace {

using Clock = std::chrono::steady_clock;

/// The design allows two seconds, but machines that run tests are loaded.
constexpr std::chrono::seconds longest_end{20};

struct LongRun {
    std::string name;
    std::string arguments;
    std::string file;                ///< the content of its input file `in`
    std::set<std::string> kept = {}; ///< files that may remain
};

std::string scene(const std::string& profile, const std::string& ask,
                  const std::string& load = "a = \"1\"") {
    return "[profile]\n" + profile + "[load]\n" + load + "\ncontact_modulus = \"1\"\n[ask]\n" + ask;
}

std::string tilted(const std::string& ask) {
    return scene("kind = \"tilted-flat-and-rounded\"\nalpha = \"1/100\"\nt = \"2/5\"\nR = \"1\"\n",
                 ask);
}

/// Returns a convex slope of straight pieces.
std::string knots(int count) {
    std::string knots;
    std::string slopes;
    for (int i = 0; i < count; ++i) {
        const std::string k = std::to_string(i - count / 2);
        knots += (i == 0 ? "\"" : ", \"") + k + "/" + std::to_string(count) + "\"";
    }
    for (int i = 0; i <= count; ++i) {
        slopes += std::string(i == 0 ? "" : ", ") + "\"x\"";
    }
    return scene("kind = \"piecewise\"\nknots = [" + knots + "]\nslopes = [" + slopes + "]\n",
                 "u = [\"1/10\"]\n");
}

const std::string slipping =
    scene("kind = \"power-law\"\nm = \"1\"\nC = \"1/100\"\n", "u = [\"1/9\"]\n", "P = \"240\"") +
    "[shear]\nQ = \"70\"\nfriction = \"0.6\"\n";

const std::string optimum =
    scene("kind = \"power-law\"\nm = { from = \"0\", to = \"2\" }\nC = \"1\"\n",
          "[design]\nmaximise = \"first_exit\"\nterms = 1\ntolerance = \"1%\"\n");

std::string recipe_of_answers(int contacts) { return tilted_recipe(contacts, 20); }

std::vector<LongRun> long_runs() {
    const std::string many_u = "u = { from = \"1e-12\", to = \"0.9\", per_decade = 200 }\n";
    const std::string nested =
        "integral(integral(integral(exp(s*t*w)*Es, s, 0, 1), t, 0, x), w, 0, 1)";
    std::vector<LongRun> all{
        {"nested integrals", "verify in", hertz_head + hertz_claim("nested", nested)},
        {"nested integrals, files", "verify in --out new/folder --digits 200",
         hertz_head + hertz_claim("nested", nested)},
        {"an expansion inside a formula", "check --ledger in",
         hertz_head + hertz_claim("far", "right_local(400, x)")},
        {"100,000 knots", "pressure in --out t.csv", knots(100'000)},
        {"20,000 digits", "pressure in --digits 20000", tilted("terms = 3\n" + many_u)},
        {"100,000 digits", "pressure in --digits 100000", tilted("terms = 3\n" + many_u)},
        {"coefficients", "expand in --terms 400 --digits 3000", tilted("u = [\"1/9\"]\n")},
        {"extent", "extent in --digits 50000",
         tilted("terms = [2, 3, 4]\ntolerance = \"0.01\"\nu = [\"1/9\"]\n")},
        {"a verbose run", "pressure in --verbose --digits 20000", tilted(many_u)},
        {"table", "table in", tilted_recipe(3000, 1000)},
        {"table in parts", "table in --part 1/2 --out t.csv --threads 1",
         tilted_recipe(3000, 1000)},
        {"costs", "cost --digits 5000 --points 40 --out costs", ""},
        {"a program that hangs",
         "check in --exec 'echo $$ >child; exec sleep 1000'",
         recipe_of_answers(3),
         {"child"}},
        {"a program that ignores signals",
         "check in --exec 'trap \"\" INT TERM HUP; echo $$ >child; sleep 1000; sleep 1000'",
         recipe_of_answers(3),
         {"child"}},
        {"input that does not come", "check -", ""},
        {"partial slip", "slip in --digits 20000 --tolerance 1%", slipping},
        {"an optimum", "design in --digits 1000 --gap 1e-300 --out d.csv", optimum},
        {"results that do not come", "compare in /dev/stdin", tilted("u = [\"1/9\"]\n")},
    };
    return all;
}

/// A run of the program that can be interrupted; its output goes to files.
class Running {
public:
    explicit Running(const LongRun& what) {
        if (!what.file.empty()) {
            folder_.write("in", what.file);
        }
        std::filesystem::create_directory(aside_.path() / "tmp");
        const std::string command =
            "cd '" + folder_.path().string() + "' && TMPDIR='" + (aside_.path() / "tmp").string() +
            "' exec '" + program().string() + "' " + what.arguments + " >'" +
            (aside_.path() / "out").string() + "' 2>'" + (aside_.path() / "err").string() + "'";
        const char* const arguments[] = {"sh", "-c", command.c_str(), nullptr};
        int ends[2];
        REQUIRE(::pipe2(ends, O_CLOEXEC) == 0); // a standard input without data
        pid_ = ::fork();
        if (pid_ == 0) {
            ::dup2(ends[0], STDIN_FILENO);
            ::execv("/bin/sh", const_cast<char* const*>(arguments));
            ::_exit(127);
        }
        ::close(ends[0]);
        input_ = ends[1];
    }
    ~Running() {
        ::close(input_);
        if (pid_ > 0) {
            ::kill(pid_, SIGKILL);
            ::waitpid(pid_, nullptr, 0);
        }
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    void send(int signal) const { ::kill(pid_, signal); }
    /// Waits until the run takes signals: its executable is the program or the one of the tests of
    /// itself, no longer a fork of this one, and its first thread has blocked SIGINT, but not all
    /// signals, as fork() and pthread_create() do for a while.
    void wait_for_begin() const {
        const std::filesystem::path process = "/proc/" + std::to_string(pid_);
        const auto in = [](unsigned long long set, int signal) {
            return (set & (1ULL << (signal - 1))) != 0;
        };
        for (const auto last = Clock::now() + longest_end; Clock::now() < last;) {
            std::error_code none_yet;
            const auto running = std::filesystem::read_symlink(process / "exe", none_yet);
            const std::string status = file_text(process / "status");
            const std::size_t at = status.find("SigBlk:");
            if (!none_yet && running.filename().string().starts_with("edgeproof") &&
                at != std::string::npos) {
                const auto blocked = std::stoull(status.substr(at + 7), nullptr, 16);
                if (in(blocked, SIGINT) && !in(blocked, SIGUSR1)) {
                    return;
                }
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        FAIL_CHECK("the run did not begin");
    }
    /// Returns its exit status; -1: it was killed because it did not end; -2: a signal ended it.
    int end(Clock::time_point last) {
        int status = 0;
        while (::waitpid(pid_, &status, WNOHANG) == 0) {
            if (Clock::now() > last) {
                return -1;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        pid_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -2;
    }
    [[nodiscard]] std::string err() const { return file_text(aside_.path() / "err"); }
    [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }
    [[nodiscard]] std::set<std::string> files() const { return names(folder_.path()); }
    [[nodiscard]] std::set<std::string> temporary_files() const {
        return names(aside_.path() / "tmp");
    }

private:
    static std::set<std::string> names(const std::filesystem::path& folder) {
        std::set<std::string> all;
        for (const auto& e : std::filesystem::recursive_directory_iterator(folder)) {
            if (!e.is_directory()) {
                all.insert(std::filesystem::relative(e.path(), folder).string());
            }
        }
        return all;
    }

    Folder folder_;
    Folder aside_;
    pid_t pid_ = -1;
    int input_ = -1;
};

/// True if a process runs; a zombie does not.
bool runs(const std::string& pid) {
    const std::string status = file_text("/proc/" + pid + "/stat");
    const std::size_t name_end = status.rfind(')');
    return name_end != std::string::npos && status.size() > name_end + 2 &&
           status[name_end + 2] != 'Z';
}

/// Interrupts each of the runs after a time, several at once, because they mostly wait.
void interrupt_all(const std::vector<LongRun>& all, std::chrono::milliseconds after,
                   const std::function<int(std::size_t)>& signal_of, std::size_t at_a_time = 4) {
    for (std::size_t begin = 0; begin < all.size(); begin += at_a_time) {
        const std::size_t end = std::min(begin + at_a_time, all.size());
        std::vector<std::unique_ptr<Running>> some;
        for (std::size_t i = begin; i < end; ++i) {
            some.push_back(std::make_unique<Running>(all[i]));
        }
        for (const auto& run : some) {
            run->wait_for_begin();
        }
        std::this_thread::sleep_for(after);
        for (std::size_t i = begin; i < end; ++i) {
            some[i - begin]->send(signal_of(i));
        }
        const auto last = Clock::now() + longest_end;
        for (std::size_t i = begin; i < end; ++i) {
            Running& run = *some[i - begin];
            CAPTURE(all[i].name);
            CAPTURE(after.count());
            CHECK(run.end(last) == 128 + signal_of(i));
            const std::string err = run.err();
            CAPTURE(err);
            CHECK(lines(err).size() == 1);
            CHECK(err.rfind("interrupted", 0) == 0);
            for (const std::string& file : run.files()) {
                CAPTURE(file);
                CHECK((file == "in" || all[i].kept.contains(file)));
            }
            CHECK(run.temporary_files().empty());
            if (all[i].kept.contains("child") && run.files().contains("child")) {
                CHECK_FALSE(runs(lines(file_text(run.folder() / "child")).at(0)));
            }
        }
    }
}

} // namespace

TEST_CASE("every subcommand is interrupted at any place: its own exit status, no files left") {
    interrupt_all(long_runs(), std::chrono::milliseconds(200),
                  [](std::size_t i) { return i % 2 == 0 ? SIGINT : SIGTERM; });
}

TEST_CASE("a second signal ends the program at once, and the exit status names the first") {
    const std::vector<LongRun> all = long_runs();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [](const LongRun& r) { return r.name == "100,000 digits"; });
    REQUIRE(found != all.end());
    Running run(*found);
    run.wait_for_begin();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    run.send(SIGINT);
    run.send(SIGTERM);
    const auto last = Clock::now() + longest_end;
    CHECK(run.end(last) == 130);
}

TEST_CASE("two signals close to each other: one line, whichever thread comes first") {
    // The work checks for an interruption some ten thousand times a second.
    const LongRun run{"pressure", "pressure in --digits 1000",
                      tilted("edges = [\"right\"]\nu = { from = \"1e-12\", to = \"0.9\", "
                             "per_decade = 2000 }\n")};
    for (int us = 0; us < 600; us += 6) {
        CAPTURE(us);
        Running running(run);
        running.wait_for_begin();
        std::this_thread::sleep_for(std::chrono::milliseconds(us % 20));
        running.send(SIGINT);
        for (const auto last = Clock::now() + std::chrono::microseconds(us); Clock::now() < last;) {
        }
        running.send(SIGINT);
        CHECK(running.end(Clock::now() + longest_end) == 130);
        CHECK(lines(running.err()).size() == 1);
    }
}

TEST_SUITE("slow") {
    TEST_CASE("every subcommand is interrupted at many moments, by each signal") {
        for (const int ms : {0, 5, 20, 60, 150, 1000, 3000}) {
            for (const int signal : {SIGINT, SIGTERM}) {
                interrupt_all(long_runs(), std::chrono::milliseconds(ms),
                              [signal](std::size_t) { return signal; });
            }
        }
    }
}
