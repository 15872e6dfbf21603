# SPDX-License-Identifier: BSD-3-Clause
"""Planes in depth images and organized point clouds, by evolving principal component clustering.

    import epcc
    result = epcc.segment(depth, epcc.PinholeCamera(width, height, fx, fy, cx, cy))
    result.labels  # H x W int32: 0 for no plane, else k for planes[k - 1]
    result.planes  # list of Plane, the one of most pixels first

Lengths are metres; coordinates are the camera's, x right, y down, z forward, or those of the cloud that was given.
"""
from . import _epcc
from ._epcc import *  # noqa: F403  (all that the module has; __init__.pyi lists it)
from ._epcc import __version__

__all__ = [name for name in vars(_epcc) if not name.startswith("_")]
