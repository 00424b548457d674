"""The documentation's site, made by docs/build from pages that GitHub shows as well."""

project = "restenosisFoam"
html_title = "restenosisFoam"
root_doc = "README"
extensions = ["myst_parser"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4  # those of GitHub
highlight_language = "text"

html_theme = "furo"
html_static_path = ["../../build/sitePages/assets"]
html_css_files = ["katex.min.css", "site.css"]
html_copy_source = html_show_sphinx = html_show_copyright = False
html_math_renderer = "texOnly"
BLUE, SKY = "#0072b2", "#56b4e9"  # of the figures: bridge/output/figures/style.py
html_theme_options = {
    "light_css_variables": {"color-brand-primary": BLUE, "color-brand-content": BLUE},
    "dark_css_variables": {"color-brand-primary": SKY, "color-brand-content": SKY},
}


def tex_writer(element, opening, closing):
    """A visitor that leaves an equation as it is written, for docs/site/setEquations.js to set."""
    from docutils.nodes import SkipNode

    def visit(writer, node):
        tex = writer.encode(node.astext())
        writer.body.append(f'<{element} class="equation">{opening}{tex}{closing}</{element}>')
        raise SkipNode

    return visit, None


def setup(app):
    app.add_html_math_renderer("texOnly", tex_writer("span", r"\(", r"\)"), tex_writer("div", r"\[", r"\]"))
