"""Pictures of a run, small enough to stand in a page."""

import base64
import io

WIDEST = 1600  # pixels
QUALITY = 82


def embedded(path):
    """A picture as a data URL: WebP where Pillow is installed, which matplotlib brings along, else as it is."""
    try:
        from PIL import Image
    except ImportError:
        return _url("png", path.read_bytes())
    with Image.open(path) as picture:
        picture = picture.convert("RGB")
        picture.thumbnail((WIDEST, WIDEST))
        data = io.BytesIO()
        picture.save(data, "WEBP", quality=QUALITY, method=4)
    return _url("webp", data.getvalue())


def _url(kind, data):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode('ascii')}"
