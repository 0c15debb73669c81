# SPDX-License-Identifier: BSD-3-Clause
"""Ledgers whose truth is known by construction."""
