# SPDX-License-Identifier: GPL-3.0-or-later
"""Ledgers whose truth is known by construction."""
