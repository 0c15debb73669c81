# SPDX-License-Identifier: GPL-3.0-or-later
# CLN, on which GiNaC stands, comes with it; GiNaC's numbers hold CLN's, so that whoever uses them
# links it as well.
include(FindPackageHandleStandardArgs)
include(${CMAKE_CURRENT_LIST_DIR}/ImportLibrary.cmake)
import_library(GiNaC HEADER ginac/ginac.h LIBRARY ginac)
find_library(CLN_LIBRARY cln REQUIRED)
mark_as_advanced(CLN_LIBRARY)
set_property(TARGET GiNaC::GiNaC APPEND PROPERTY INTERFACE_LINK_LIBRARIES ${CLN_LIBRARY})
