"""Of its own, so that the page is written where nothing that draws can be imported."""


class NothingToDraw(Exception):
    """The results do not hold what a picture shows: a scene without tissue has no cells to draw."""
