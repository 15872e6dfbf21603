# SPDX-License-Identifier: BSD-3-Clause
# In Python: labels over depth as a picture, planes as text. Needs epcc and matplotlib: 08_python.py [OUT.png]
import sys

import matplotlib

matplotlib.use("Agg")  # a picture in a file, without a screen
import matplotlib.pyplot as plt
import numpy as np

import epcc

# %% A depth image: a numpy array, float32 in metres or uint16 in millimetres. Here the corner of a room.
camera = epcc.PinholeCamera(width=320, height=240, fx=200.0, fy=200.0, cx=159.5, cy=119.5)
rows, columns = np.mgrid[0 : camera.height, 0 : camera.width]
down, right = (rows - camera.cy) / camera.fy, (columns - camera.cx) / camera.fx
# A wall 3 m ahead, a floor 1 m below, a wall 1.5 m to the right.
z = 1.0 / np.maximum(np.maximum(1.0 / 3.0, down / 1.0), right / 1.5)
noise = 0.001 * z**2 * np.random.RandomState(0).standard_normal(z.shape)
depth = (z + noise).astype(np.float32)

# %% Segment it.
result = epcc.segment(depth, camera)
for plane in result.planes:
    a, b, c, d = plane.coefficients  # a x + b y + c z + d = 0; x right, y down, z forward, metres
    rms = 1000 * plane.rms
    print(f"{plane.pixel_count} pixels, normal ({a:.2f} {b:.2f} {c:.2f}), {d:.2f} m away, rms {rms:.0f} mm")
print(f"sensor: sigma at 2 m {1000 * result.sensor.sigma_z(2.0):.1f} mm")

# %% Labels over depth, with the outlines of the planes.
figure, (left, middle) = plt.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True)
shown = left.imshow(depth, cmap="gray")
left.set_title("depth")
figure.colorbar(shown, ax=left, label="m", shrink=0.8)
middle.imshow(depth, cmap="gray")
middle.imshow(np.ma.masked_equal(result.labels, 0), cmap="tab10", vmin=1, vmax=10, alpha=0.6, interpolation="nearest")
for plane_contours in result.all_contours():
    for contour in plane_contours:
        if abs(contour.signed_area) < 100:
            continue  # specks that the noise leaves
        closed = np.vstack([contour.points, contour.points[:1]])
        middle.plot(closed[:, 0], closed[:, 1], "k-", linewidth=0.8)
for label in range(1, len(result.planes) + 1):
    row, column = np.argwhere(result.labels == label).mean(axis=0)
    middle.text(column, row, str(label), ha="center", va="center", fontweight="bold")
middle.set_title(f"{len(result.planes)} planes")
for axes in (left, middle):
    axes.set_axis_off()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "planes.png", dpi=110)

# Prints:
#   48255 pixels, normal (0.00 0.00 -1.00), 3.00 m away, rms 9 mm
#   15783 pixels, normal (-0.00 -1.00 -0.00), 1.00 m away, rms 2 mm
#   12405 pixels, normal (-1.00 -0.00 -0.00), 1.50 m away, rms 4 mm
#   sensor: sigma at 2 m 3.9 mm
