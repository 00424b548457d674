"""view.pvsm: a state of ParaView that shows the vessel cut open, with its cells, its struts and the stress on its lumen.

Written for ParaView 5.11 (Debian 12); what is not said here is ParaView's default. The state names tissue.pvd and
lumen.pvd without a folder, so that results can be moved: ParaView looks for them in the folder that it is started in.
"""

import itertools
import xml.etree.ElementTree as ElementTree

import matplotlib
import numpy as np
import results
import style

VERSION = "5.11.0"
UNKNOWN = "#E6D2C4"  # of stress before the first flow
FRAMES = 4  # whose stresses decide the range of the colours
CLASS = "cell"  # the array made from kind, state and flags: the index into CLASSES
CLASSES = (
    ("Smooth muscle, at rest (G0)", "#C9D7E3"),
    ("Synthetic, at rest (G0)", style.SKY),
    ("New cell, at rest (G0)", style.ORANGE),
    ("In cycle: G1", style.VERMILION),
    ("In cycle: S, G2, M", style.PURPLE),
    ("Inner elastic lamina", style.BLUE),
    ("Outer elastic lamina", style.GREEN),
    ("Stent strut", "#8A8D91"),
)
STRUT = len(CLASSES) - 1
# Later ones win where a cell is several things
FORMULA = (
    "if(kind==3, 7, if(kind==2, 6, if(kind==1, 5, if(state==2, 4, if(state==1, 3, "
    "if(daughter==1, 2, if(synthetic==1, 1, 0)))))))"
)
POINTS, CELLS = 0, 1  # what an array is on
SLICES = 20  # of a bent vessel, through which its axis is found
VESSEL = 1.1  # largest width of what is drawn over the height of the picture: beside it there are legends


def rgb(colour):
    return matplotlib.colors.to_rgb(colour)


class Proxy:
    """An object of ParaView; properties are numbers, texts or other proxies, or lists of these."""

    def __init__(self, group, kind, servers, **properties):
        self.group = group
        self.kind = kind
        self.servers = servers
        self.properties = properties
        self.number = None
        self.layout_of = None


class State:
    """The proxies in the order in which they are made, and their names in ParaView's collections."""

    def __init__(self):
        self.proxies = []
        self.collections = {}

    def add(self, proxy):
        proxy.number = 1000 + 100 * len(self.proxies)
        self.proxies.append(proxy)

    def enter(self, collection, name, proxy):
        """Enters a proxy, a new one or one that was added, under a name in a collection; returns it."""
        if proxy.number is None:
            self.add(proxy)
        self.collections.setdefault(collection, []).append((name, proxy))
        return proxy

    def xml(self):
        root = ElementTree.Element("GenericParaViewApplication")
        manager = ElementTree.SubElement(root, "ServerManagerState", version=VERSION)
        for proxy in self.proxies:
            add_proxy(manager, proxy)
        for collection, items in self.collections.items():
            element = ElementTree.SubElement(manager, "ProxyCollection", name=collection)
            for name, proxy in items:
                ElementTree.SubElement(element, "Item", id=str(proxy.number), name=name)
        ElementTree.indent(root)
        return ElementTree.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def add_proxy(parent, proxy):
    number = str(proxy.number)
    attributes = {"group": proxy.group, "type": proxy.kind, "id": number, "servers": str(proxy.servers)}
    element = ElementTree.SubElement(parent, "Proxy", attributes)
    for name, given in proxy.properties.items():
        values = given if isinstance(given, (list, tuple, np.ndarray)) else [given]
        described = {"name": name, "id": f"{number}.{name}", "number_of_elements": str(len(values))}
        property_ = ElementTree.SubElement(element, "Property", described)
        for index, value in enumerate(values):
            if isinstance(value, Proxy):
                ElementTree.SubElement(property_, "Proxy", value=str(value.number), output_port="0")
            else:
                text = value if isinstance(value, str) else f"{value:.12g}"
                ElementTree.SubElement(property_, "Element", index=str(index), value=text)
    if proxy.layout_of:
        layout = ElementTree.SubElement(element, "Layout", number_of_elements="1")
        ElementTree.SubElement(layout, "Item", direction="0", fraction="0.5", view=str(proxy.layout_of.number))


class Cut:
    """How the vessel is cut, and from where one looks at it: directions are unit vectors, lengths in m."""

    def __init__(self, points, straight):
        """`straight`: where the points (n, 3) [m] are in the straight vessel about the z axis, which is cut along its
        axis, in the plane in which that bends. Without it the lumen lies as it likes, and is cut across the direction
        that it reaches least far in."""
        if straight is None:
            self.origin = 0.5 * (points.min(axis=0) + points.max(axis=0))
            _, self.up, self.normal = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2]
            towards = self.normal
        else:
            self.origin, along, self.up, self.normal = axis_plane(points, straight)
            towards = 4.2 * self.normal + 2.2 * self.up - 2.4 * along
        towards = towards / np.linalg.norm(towards)
        right = np.cross(self.up, towards)
        right /= np.linalg.norm(right)
        above = np.cross(towards, right)
        left = points[(points - self.origin) @ self.normal <= 0] - self.origin
        across, along = left @ right, left @ above
        self.scale = 1.06 * max(0.5 * np.ptp(along), 0.5 * np.ptp(across) / VESSEL)
        middle = 0.5 * (across.min() + across.max()) + 0.15 * self.scale, 0.5 * (along.min() + along.max())
        self.focus = self.origin + middle[0] * right + middle[1] * above
        self.eye = self.focus + 6 * max(np.ptp(across), np.ptp(along)) * towards


def axis_plane(points, straight):
    """The middle of a vessel's axis, and unit vectors along it, across it in the plane in which it bends, and normal to
    that plane: z, y and x where it is straight."""
    z = straight[:, 2]
    if np.allclose(points, straight, atol=1e-9):
        return np.array([0.0, 0.0, 0.5 * z.max()]), np.array([0, 0, 1.0]), np.array([0, 1.0, 0]), np.array([1.0, 0, 0])
    ends = np.linspace(z.min(), z.max(), SLICES + 1)
    axis = []
    for low, high in itertools.pairwise(ends):
        inside = (z >= low) & (z <= high)
        # Where a line about x = y = 0 through the slice has its middle in space
        about = np.column_stack([np.ones(inside.sum()), straight[inside] - [0, 0, 0.5 * (low + high)]])
        axis.append(np.linalg.lstsq(about, points[inside], rcond=None)[0][0])
    axis = np.array(axis)
    along, _, normal = np.linalg.svd(axis - axis.mean(axis=0), full_matrices=False)[2]
    if along @ (axis[-1] - axis[0]) < 0:
        along = -along
    if normal[np.abs(normal).argmax()] < 0:
        normal = -normal
    return axis[len(axis) // 2], along, np.cross(along, normal), normal


class Pipeline:
    """Sources, filters and what is shown of them."""

    def __init__(self, state, cut):
        self.state = state
        self.cut = cut
        self.sources = []
        self.shown = []

    def source(self, name, kind, group="filters", **properties):
        self.sources.append(self.state.enter("sources", name, Proxy(group, kind, 1, **properties)))
        return self.sources[-1]

    def clip(self, name, given):
        plane = Proxy("implicit_functions", "Plane", 21, Origin=self.cut.origin, Normal=self.cut.normal)
        self.state.add(plane)
        clip = self.source(name, "Clip", Input=given, ClipFunction=plane, Invert=1)
        self.state.enter(f"pq_helper_proxies.{clip.number}", "ClipFunction", plane)
        return clip

    def threshold(self, name, given, attributes, array, low, high):
        selected = ["", "", "", str(attributes), array]
        return self.source(
            name, "Threshold", Input=given, SelectInputScalars=selected, LowerThreshold=low, UpperThreshold=high
        )

    def show(self, given, **properties):
        kind = "UnstructuredGridRepresentation"
        shown = Proxy("representations", kind, 21, Input=given, Visibility=1, **properties)
        self.shown.append(self.state.enter("representations", f"{kind}{len(self.shown) + 1}", shown))

    def colours(self, array, opacity, **properties):
        """A map from the values of an array to colours, opaque over the range of `opacity`."""
        points = [opacity[0], 1, 0.5, 0, opacity[1], 1, 0.5, 0]
        function = Proxy("piecewise_functions", "PiecewiseFunction", 21, Points=points, ScalarRangeInitialized=1)
        self.state.enter("piecewise_functions", f"{array}.PiecewiseFunction", function)
        table = Proxy("lookup_tables", "PVLookupTable", 21, ScalarOpacityFunction=function, **properties)
        table.properties.update(ScalarRangeInitialized=1, AutomaticRescaleRangeMode=-1, RescaleOnVisibilityChange=0)
        return self.state.enter("lookup_tables", f"{array}.PVLookupTable", table)

    def legend(self, table, title, **properties):
        black = {name: [0, 0, 0] for name in ("TitleColor", "LabelColor", "ScalarBarOutlineColor")}
        legend = Proxy("representations", "ScalarBarWidgetRepresentation", 21, LookupTable=table, Title=title, **black)
        legend.properties.update(ComponentTitle="", Enabled=1, Visibility=1, **properties)
        self.shown.append(self.state.enter("scalar_bars", f"ScalarBarWidgetRepresentation{len(self.shown) + 1}", legend))

    def day(self, given):
        text = self.source("Day", "TimeToTextConvertor", Input=given, Format="Day {time:.4g}")
        label = Proxy("representations", "TextSourceRepresentation", 21, Input=text, Visibility=1, WindowLocation=4)
        label.properties.update(Color=[0, 0, 0], FontSize=24)
        self.shown.append(self.state.enter("representations", "TextSourceRepresentation1", label))


def named_colours(pipeline, struts):
    """The map of the classes, struts among them where there are any."""
    classes = CLASSES if struts else CLASSES[:STRUT]
    return pipeline.colours(
        CLASS,
        (0, STRUT),
        IndexedLookup=1,
        Annotations=[text for k, (name, _) in enumerate(classes) for text in (str(k), name)],
        IndexedColors=[part for _, colour in classes for part in rgb(colour)],
        IndexedOpacities=[1] * len(classes),
        AnnotationsInitialized=1,
    )


def stress_colours(pipeline, top):
    places = np.linspace(0, 1, 33)
    colours = matplotlib.colormaps[style.WSS_MAP](places)[:, :3]
    return pipeline.colours(
        "WSS",
        (0, top),
        RGBPoints=[number for place, colour in zip(places, colours) for number in (top * place, *colour)],
        ColorSpace=0,
        NanColor=rgb(UNKNOWN),
    )


def spheres(**properties):
    """Points as spheres of their own radius: the array's values are used as they are, in m."""
    return dict(
        Representation="Point Gaussian",
        GaussianRadius=1,
        ScaleByArray=1,
        SetScaleArray=["", "", "", str(POINTS), "radius"],
        UseScaleFunction=0,
        ShaderPreset=1,
        **properties,
    )


def steel():
    """One colour, with highlights."""
    colour = rgb(CLASSES[STRUT][1])
    return {
        "ColorArrayName": ["", "", "", "", ""],
        "AmbientColor": colour,
        "DiffuseColor": colour,
        "Specular": 0.4,
        "SpecularPower": 30,
    }


def add_tissue(pipeline, struts, solid):
    """`solid`: the struts have a surface of their own."""
    reader = pipeline.source("tissue.pvd", "PVDReader", group="sources", FileName="tissue.pvd")
    pipeline.day(reader)
    named = pipeline.source("Cells by name", "Calculator", Input=reader, ResultArrayName=CLASS, Function=FORMULA)
    opened = pipeline.clip("Tissue cut open", named)
    table = named_colours(pipeline, struts)
    cells = pipeline.threshold("Cells", opened, POINTS, CLASS, 0, STRUT - 1)
    pipeline.show(cells, **spheres(ColorArrayName=["", "", "", str(POINTS), CLASS], LookupTable=table))
    if struts and not solid:
        strut = pipeline.threshold("Struts", opened, POINTS, CLASS, STRUT, STRUT)
        pipeline.show(strut, **spheres(**steel()))
    pipeline.legend(table, "Cells", WindowLocation=2, ScalarBarLength=0.42)


def add_struts(pipeline):
    reader = pipeline.source("Strut surface", "XMLPolyDataReader", group="sources", FileName="struts.vtp")
    shaded = pipeline.source("Edges of struts", "PolyDataNormals", Input=reader, FeatureAngle=40, Splitting=1)
    pipeline.show(pipeline.clip("Struts", shaded), Representation="Surface", **steel())


def add_lumen(pipeline, top, struts, labelled):
    reader = pipeline.source("lumen.pvd", "PVDReader", group="sources", FileName="lumen.pvd")
    if not labelled:
        pipeline.day(reader)
    smooth = pipeline.source("Stress on points", "CellDataToPointData", Input=reader, PassCellData=1)
    shaded = pipeline.source("Shading", "PolyDataNormals", Input=smooth, Splitting=0)
    opened = pipeline.clip("Lumen cut open", shaded)
    table = stress_colours(pipeline, top)
    wall = pipeline.threshold("Lumen", opened, CELLS, "region", 0, 0)
    pipeline.show(
        wall, Representation="Surface", ColorArrayName=["", "", "", str(POINTS), "WSS"], LookupTable=table
    )
    if struts:
        faces = pipeline.threshold("Faces of struts", opened, CELLS, "region", 1, 1)
        pipeline.show(faces, Representation="Surface", **steel())
    pipeline.legend(
        table,
        "Wall shear stress [Pa]",
        WindowLocation=5,
        ScalarBarLength=0.33,
        AutomaticLabelFormat=0,
        LabelFormat="%.2g",
        RangeLabelFormat="%.2g",
    )


def add_view(state, pipeline, days):
    cut = pipeline.cut
    view = Proxy(
        "views",
        "RenderView",
        21,
        Representations=pipeline.shown,
        UseColorPaletteForBackground=0,
        BackgroundColorMode=0,
        Background=[1, 1, 1],
        OrientationAxesLabelColor=[0, 0, 0],
        CameraParallelProjection=1,
        CameraPosition=cut.eye,
        CameraFocalPoint=cut.focus,
        CameraViewUp=cut.up,
        CameraParallelScale=cut.scale,
        CenterOfRotation=cut.origin,
        ViewSize=[1280, 800],
        ViewTime=days[-1],
    )
    state.enter("views", "RenderView1", view)
    layout = state.enter("layouts", "Layout #1", Proxy("misc", "ViewLayout", 20))
    layout.layout_of = view
    keeper = Proxy("misc", "TimeKeeper", 16, TimeSources=pipeline.sources, Views=view, Time=days[-1])
    keeper.properties.update(TimeRange=[days[0], days[-1]], TimestepValues=days, TimeLabel="Day")
    state.enter("timekeeper", "TimeKeeper1", keeper)
    cue = Proxy("animation", "TimeAnimationCue", 16, AnimatedProxy=keeper, AnimatedPropertyName="Time")
    cue.properties.update(UseAnimationTime=1, StartTime=0, EndTime=1)
    state.enter("animation", "TimeAnimationCue1", cue)
    scene = Proxy("animation", "AnimationScene", 16, Cues=cue, TimeKeeper=keeper, ViewModules=view)
    scene.properties.update(StartTime=days[0], EndTime=days[-1], AnimationTime=days[-1])
    scene.properties.update(PlayMode=2, NumberOfFrames=len(days))  # 2: goes through the recorded days
    state.enter("animation", "AnimationScene1", scene)


def recorded(folder, series):
    """The frames of a series, none where there is no such series."""
    try:
        return results.frames(folder, series)
    except results.NothingToDraw:
        return []


def largest_stress(lumens):
    """The stress that the colours end at: 98 % of the faces have less [Pa]."""
    shear = np.concatenate([lumen["WSS"] for lumen in lumens])
    shear = shear[np.isfinite(shear)]
    top = np.percentile(shear, 98) if shear.size else 0.0
    return top if top > 0 else 1.0


def write(folder, path):
    """Writes the state for what the folder holds: cells, a lumen or both."""
    tissue, lumen = recorded(folder, "tissue"), recorded(folder, "lumen")
    if not tissue and not lumen:
        raise results.NothingToDraw(f"{folder} has neither cells nor a lumen")
    lumens = [results.lumen(file) for _, file in results.spread(lumen, FRAMES)]
    agents = results.agents(tissue[-1][1]) if tissue else None
    points, straight = (agents["in_space"], agents["position"]) if tissue else (
        lumens[-1]["in_space"], lumens[-1]["vertices"])
    if results.only_flow_from_file(folder):
        straight = None
    solid = (folder / "struts.vtp").exists()
    struts = solid or any((surface["region"] == 1).any() for surface in lumens)
    struts = struts or bool(tissue and (agents["kind"] == results.KINDS["strut"]).any())
    state = State()
    pipeline = Pipeline(state, Cut(points, straight))
    if tissue:
        add_tissue(pipeline, struts, solid)
    if solid:
        add_struts(pipeline)
    if lumen:
        add_lumen(pipeline, largest_stress(lumens), struts, labelled=bool(tissue))
    add_view(state, pipeline, sorted({day for day, _ in tissue + lumen}))
    partial = path.with_name(path.name + ".partial")
    partial.write_text(state.xml(), encoding="utf-8")
    partial.replace(path)
