# SPDX-License-Identifier: GPL-3.0-or-later
"""One module for each group of kinds of claim, with a table KINDS of functions that draw one
claim."""
