# SPDX-License-Identifier: MIT
"""Versions, names, and whether this build computes the pinned bits."""
from __future__ import annotations

from ._library import lib, text_of

__all__ = ["method_name", "selftest", "selftestf",
           "status_string", "version"]


def version() -> str:
    """The library's version, such as "1.2.3".  coin_version_string()"""
    text: str = lib.coin_version_string().decode()
    return text


def status_string(status: int) -> str:
    """What a status means.  coin_status_string()"""
    return text_of(status)


def method_name(method: int) -> str:
    """A method's name, "rk4" for RK4; ValueError if there is no such method.
    coin_method_name()"""
    name = lib.coin_method_name(method)
    if name is None:
        raise ValueError(f"no method {method}")
    text: str = name.decode()
    return text


def selftest() -> None:
    """Raises unless this build computes the pinned bits.  coin_selftest()"""
    lib.coin_selftest()


def selftestf() -> None:
    """selftest() of the functions in floats.  coinf_selftest()"""
    lib.coinf_selftest()
