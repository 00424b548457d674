"""What must not be read into a run: what its model was never held against."""

WHOLE_LESION = 4.0  # length [mm] from which a vessel is more than a piece


def of(run):
    """Sentences about this scene, beside those that hold for all."""
    scene = run.scene
    said = []
    if "cellCycle" in scene:
        if scene.get("injury", {}).get("ielBreaks"):
            said.append(
                "The inner elastic lamina breaks in this scene. There the model grows too little: half as much as with "
                "a whole one, where pigs grow 1.7 times as much."
            )
        if "activation" not in scene or "extracellularMatrix" not in scene:
            said.append(
                "This scene has not both [activation] and [extracellularMatrix]: how much it grows was not calibrated "
                "on animals."
            )
        if "flow" not in scene:
            said.append("There is no flow in this scene: nothing but its neighbours stops a cell.")
        if (length := _millimetres(scene)) is not None and length < WHOLE_LESION:
            said.append(f"The vessel is a piece of {length:g} mm with its ends held, not a lesion.")
    if "flow" in scene and scene.get("scene", {}).get("fidelity") == "draft":
        said.append("The flow has the coarse cells of fidelity draft: on the wall its stress is about a tenth off.")
    if scene.get("flow", {}).get("crossCheck", "none") == "none" and "flow" in scene:
        said.append("No other method has checked the flow of this run (flow.crossCheck).")
    return said


def _millimetres(scene):
    try:
        number, unit = str(scene["vessel"]["length"]).split()
        return float(number) * {"m": 1e3, "cm": 10, "mm": 1, "um": 1e-3}[unit]
    except (KeyError, ValueError):
        return None
