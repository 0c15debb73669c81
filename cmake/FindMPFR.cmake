# SPDX-License-Identifier: BSD-3-Clause
include(FindPackageHandleStandardArgs)
include(${CMAKE_CURRENT_LIST_DIR}/ImportLibrary.cmake)
import_library(MPFR HEADER mpfr.h LIBRARY mpfr)
