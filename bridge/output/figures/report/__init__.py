"""report.html: a run on one page that explains itself, or several runs side by side.

Needs nothing but Python; with numpy and VTK the lumen can be turned on the page.
"""

from report.comparison_page import write as write_comparison
from report.group import is_study
from report.run_page import write

__all__ = ["is_study", "write", "write_comparison"]
