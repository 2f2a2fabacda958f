#!/usr/bin/python3
"""doc/options.md holds what the nodes themselves say of their options."""
import os
import subprocess
import sys

NODES = ("learner", "planner", "executor", "simulated_robot", "repertoire_server", "browser")
INTRODUCTION = """# Options of the nodes

Private parameters of each node, as `<node> --help` prints them. Unknown keys, wrong types and values
out of range end a node with exit code 2 and a sentence for each.
"""


def document(binaries):
    """The text that doc/options.md should have."""
    text = INTRODUCTION
    for node in NODES:
        table = subprocess.run([os.path.join(binaries, node), "--help"], check=True,
                               stdout=subprocess.PIPE, universal_newlines=True).stdout
        text += "\n## %s\n\n%s" % (node, table)
    return text


def test_document_says_what_the_nodes_say():
    path = os.path.join(os.path.dirname(__file__), "..", "..", "doc", "options.md")
    with open(path, encoding="utf-8") as stream:
        assert stream.read() == document(os.environ["HEXAPOD_BINARIES"]), (
            "write doc/options.md anew: options_test.py BINARIES > doc/options.md")


if __name__ == "__main__":
    sys.stdout.write(document(sys.argv[1]))
