"""beats.png: of a flow that beats, the stress over a beat on the last lumen, unrolled."""

import matplotlib.pyplot as plt
import numpy as np
import results
import style
from lumen import outline
from unrolling import Unrolling, limits

MAPS = {
    "TAWSS": ("mean size over the beat, TAWSS [Pa]", style.WSS_MAP),
    "OSI": ("oscillatory shear index, OSI", style.THICKNESS_MAP),
    "RRT": ("relative residence time, RRT [1/Pa]", style.THICKNESS_MAP),
    "transWSS": ("mean across the flow, transWSS [Pa]", style.WSS_MAP),
}
PANEL = (3.6, 2.7)  # [in]
MOST = 98  # percentile of the values that ends a scale: RRT has no upper bound


def draw(folder, path):
    if results.only_flow_from_file(folder):
        raise results.NothingToDraw("a lumen from a file has no axis to unroll it about")
    day, file = results.frames(folder, "lumen")[-1]
    lumen = results.lumen(file)
    if "TAWSS" not in lumen:
        raise results.NothingToDraw("the flow is steady")
    length = lumen["vertices"][:, 2].max()
    extent = (0, length * 1e3, -180, 180)
    unrolling = Unrolling(lumen, length)
    struts = unrolling.of(lumen["region"])
    style.apply()
    figure, axes = plt.subplots(2, 2, figsize=(2 * PANEL[0], 2 * PANEL[1] + 0.4), sharex=True, sharey=True)
    for axis, (name, (label, colours)) in zip(axes.ravel(), MAPS.items()):
        grid = unrolling.of(np.where(np.isfinite(lumen[name]), lumen[name], np.nan))
        axis.set_facecolor(style.LIGHT)
        axis.grid(False)
        look = {"cmap": colours, "vmin": 0, "vmax": limits([grid], high=MOST)[1], "extent": extent}
        image = axis.imshow(grid, origin="lower", aspect="auto", **look)
        outline(axis, struts, 0.5, extent, "white" if colours == style.WSS_MAP else style.BLACK)
        axis.set_title(label)
        axis.set_yticks([-180, -90, 0, 90, 180])
        figure.colorbar(image, ax=axis, extend="max", pad=0.01)
    for axis in axes[-1]:
        axis.set_xlabel("z [mm]")
    for axis in axes[:, 0]:
        axis.set_ylabel("angle θ [°]")
    style.letter_panels(axes.ravel())
    figure.suptitle(f"{style.day_label(day)}, last beat of the last flow; lines: struts")
    style.save(figure, path)
    plt.close(figure)
