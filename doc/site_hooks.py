"""For mkdocs: what lies outside doc/ is named in the site, where the files have a link."""
import re

OUTSIDE = re.compile(r"\[([^\]]+)\]\((\.\./)+([^)]+)\)")


def on_page_markdown(markdown, **_):
    """Called by mkdocs for each page."""
    return OUTSIDE.sub(r"\1 (`\3`)", markdown)
