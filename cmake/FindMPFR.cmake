# SPDX-License-Identifier: GPL-3.0-or-later
include(FindPackageHandleStandardArgs)
include(${CMAKE_CURRENT_LIST_DIR}/ImportLibrary.cmake)
import_library(MPFR HEADER mpfr.h LIBRARY mpfr)
