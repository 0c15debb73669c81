# SPDX-License-Identifier: GPL-3.0-or-later
"""One module a group of kinds of claim; each has a table KINDS of functions that draw one claim."""
