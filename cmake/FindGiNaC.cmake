# SPDX-License-Identifier: GPL-3.0-or-later
# CLN, on which GiNaC stands, comes with its shared library.
include(FindPackageHandleStandardArgs)
include(${CMAKE_CURRENT_LIST_DIR}/ImportLibrary.cmake)
import_library(GiNaC HEADER ginac/ginac.h LIBRARY ginac)
