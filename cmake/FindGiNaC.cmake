# SPDX-License-Identifier: GPL-3.0-or-later
# GiNaC depends on CLN, and its numbers contain CLN's, so that users of GiNaC link CLN as well.
include(FindPackageHandleStandardArgs)
include(${CMAKE_CURRENT_LIST_DIR}/ImportLibrary.cmake)
import_library(GiNaC HEADER ginac/ginac.h LIBRARY ginac)
find_library(CLN_LIBRARY cln REQUIRED)
mark_as_advanced(CLN_LIBRARY)
set_property(TARGET GiNaC::GiNaC APPEND PROPERTY INTERFACE_LINK_LIBRARIES ${CLN_LIBRARY})
