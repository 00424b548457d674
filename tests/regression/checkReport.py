"""Opens a page of `report` in Chromium at the width of a desk and of a phone, and uses it.

    /usr/bin/python3 tests/regression/checkReport.py PAGE [--no-lumen]

Exit status 0 when nothing was found; every finding is a line. Needs chromium, and Pillow, which matplotlib brings along.
"""

import io
import sys
from pathlib import Path

import chromium
from PIL import Image, ImageChops

WIDTHS = (1280, 390)
FEW_COLOURS = 50  # a blank canvas has a handful: its background is a gradient

findings = []


def expect(holds, what):
    if not holds:
        findings.append(what)


def picture(browser, selector):
    return Image.open(io.BytesIO(browser.screenshot(browser.box(selector)))).convert("RGB")


def differ(one, other):
    """Whether more than a hundredth of the pixels are different."""
    changed = ImageChops.difference(one, other).convert("L").point(lambda value: 255 if value > 8 else 0)
    return changed.histogram()[255] > 0.01 * one.width * one.height


def vivid(image):
    """How many colours a picture has that are no grey."""
    colours = image.getcolors(maxcolors=1 << 24)
    return sum(max(colour) - min(colour) > 40 for _, colour in colours)


def text(browser, selector):
    return browser.value(f"document.querySelector({selector!r})?.textContent ?? ''")


def check_curves(browser, width):
    where = f"at {width} px"
    expect(browser.value("document.querySelectorAll('.panel path.line').length") > 0, f"{where}: there are no curves")
    browser.value("document.querySelector('.panel').scrollIntoView({block: 'center'})")
    readings = []
    for share in (0.3, 0.8):
        left, top, wide, high = browser.value(
            "(() => { const b = document.querySelector('.panel svg').getBoundingClientRect();"
            " return [b.x, b.y, b.width, b.height]; })()"
        )
        browser.pointer(left + share * wide, top + high / 2)
        readings.append([text(browser, ".panel .reading"), text(browser, ".panel:last-child .reading")])
    expect(readings[0][0] != readings[1][0], f"{where}: pointing at a curve reads nothing: {readings}")
    expect(readings[0][1] != readings[1][1], f"{where}: the other panels stay on their day: {readings}")


def check_lumen(browser, width):
    where = f"at {width} px"
    last = picture(browser, "#spaceCanvas")
    expect(vivid(last) > FEW_COLOURS, f"{where}: the lumen is not to be seen")
    maps = picture(browser, ".map canvas")
    expect(vivid(maps) > FEW_COLOURS, f"{where}: the map is blank")
    day = text(browser, "#day")
    browser.value("document.getElementById('slider').focus()")
    browser.key("Home")
    expect(text(browser, "#day") != day, f"{where}: the slider does not change the day from {day}")
    expect(differ(last, picture(browser, "#spaceCanvas")), f"{where}: the slider does not change the lumen")
    expect(differ(maps, picture(browser, ".map canvas")), f"{where}: the slider does not change the map")
    browser.key("End")
    expect(text(browser, "#day") == day, f"{where}: the slider does not come back to day {day}")
    for choice in ("input[value=thickness]", "#cut"):
        before = picture(browser, "#spaceCanvas")
        browser.value(f"document.querySelector({choice!r}).click()")
        browser.drawn()
        expect(differ(before, picture(browser, "#spaceCanvas")), f"{where}: {choice} does not change the lumen")


def main():
    page, with_lumen = Path(sys.argv[1]), "--no-lumen" not in sys.argv
    with chromium.Browser() as browser:
        for width in WIDTHS:
            browser.open(page, width)
            browser.wait("document.body.dataset.drawn === 'yes'")
            browser.drawn()
            reach = browser.value("document.scrollingElement.scrollWidth")
            expect(reach <= width, f"at {width} px: the page is {reach} px wide")
            check_curves(browser, width)
            if with_lumen:
                check_lumen(browser, width)
            for problem in browser.problems:
                findings.append(f"at {width} px: {problem}")
    print("\n".join(findings))
    return 1 if findings else 0


sys.exit(main())
