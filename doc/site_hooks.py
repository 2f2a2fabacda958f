"""For mkdocs: what lies outside doc/ is named in the site, where the files have a link; what
run_commands.py is told of a block of commands is not shown."""
import re

OUTSIDE = re.compile(r"\[([^\]]+)\]\((\.\./)+([^)]+)\)")
MARKED = re.compile(r"^```sh \w+$", re.MULTILINE)


def on_page_markdown(markdown, **_):
    """Called by mkdocs for each page."""
    return MARKED.sub("```sh", OUTSIDE.sub(r"\1 (`\3`)", markdown))
