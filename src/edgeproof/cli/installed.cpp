// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/cli/cli.hpp"

#include "edgeproof/precision/error.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace edgeproof::cli {
namespace {

/// The path of the module that contains all use of MPI, relative to the program's folder; empty:
/// not built.
constexpr std::string_view module_path = EDGEPROOF_MPI_MODULE;

std::size_t number_in(const char* variable) {
    const char* const value = std::getenv(variable);
    std::size_t n = 0;
    if (value != nullptr) {
        const std::string_view text(value);
        std::from_chars(text.data(), text.data() + text.size(), n);
    }
    return n;
}

[[noreturn]] void cannot_share(const std::string& problem, const std::string& instead) {
    throw InputError("started as one of " + std::to_string(launched_count()) + " processes, and " +
                         problem,
                     instead);
}

} // namespace

std::filesystem::path installed(const std::filesystem::path& file) {
    std::error_code failed;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", failed);
    return (self.parent_path() / file).lexically_normal();
}

std::string file_or_shipped(const std::string& given, std::string_view folder) {
    std::error_code failed;
    if (given.empty() || given.find_first_of("./") != std::string::npos ||
        std::filesystem::exists(given, failed)) {
        return given;
    }
    const auto file =
        installed(std::filesystem::path(EDGEPROOF_DATA_FOLDER) / folder / (given + ".toml"));
    return std::filesystem::exists(file, failed) ? file.string() : given;
}

std::vector<std::string> shipped_names(std::string_view folder) {
    std::vector<std::string> names;
    std::error_code failed;
    const auto all = installed(std::filesystem::path(EDGEPROOF_DATA_FOLDER) / folder);
    for (const auto& entry : std::filesystem::directory_iterator(all, failed)) {
        if (entry.path().extension() == ".toml") {
            names.push_back(entry.path().stem().string());
        }
    }
    std::ranges::sort(names);
    return names;
}

std::size_t launched_count() {
    // These variables are set by Open MPI's mpirun; by other launchers (and srun --mpi=pmi2). For
    // srun --mpi=pmix, see below.
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
        if (const std::size_t n = number_in(variable); n > 0) {
            return n;
        }
    }
    const bool by_srun = std::getenv("PMIX_RANK") != nullptr;
    const std::size_t n = by_srun ? number_in("SLURM_STEP_NUM_TASKS") : 1;
    return n > 0 ? n : 1;
}

std::unique_ptr<parallel::Processes> launched_together() {
    if (launched_count() < 2) {
        return nullptr;
    }
    const std::string alone =
        "start it alone, or install its MPI part (Debian package edgeproof-mpi, or a build where "
        "Open MPI is installed)";
    if (module_path.empty()) {
        cannot_share("this edgeproof was built without MPI", alone);
    }
    const std::filesystem::path file = installed(module_path);
    // Open MPI loads further modules, which need its symbols to be global.
    void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (module == nullptr) {
        const char* const why = ::dlerror();
        cannot_share(why == nullptr ? "its MPI part does not load" : why, alone);
    }
    using Make = parallel::Processes* (*)();
    const auto make = reinterpret_cast<Make>(::dlsym(module, "edgeproof_mpi_processes"));
    if (make == nullptr) {
        cannot_share(file.string() + " is not its MPI part", alone);
    }
    std::unique_ptr<parallel::Processes> processes(make());
    if (processes->count() < 2) {
        cannot_share("MPI does not see the others", "start it by mpirun, or by srun --mpi=pmix");
    }
    return processes;
}

} // namespace edgeproof::cli
