"""Expands xacro files to URDF: properties, macros, blocks, conditions, includes and arguments.

For machines without the program xacro. Files of its older versions are understood, too: macros that
are used before they are defined, and tags without the prefix. What it does not know (xacro:element,
xacro:attribute, namespaces of includes) is refused by name.
"""
import pathlib
from typing import Any, Callable, Dict, List
from xml.dom import minidom
from xml.parsers.expat import ExpatError

from hexapod_repertoire.xacro_macros import Block, Macro, Parameter, package_finder, parameters_of
from hexapod_repertoire.xacro_values import Evaluator, Scope, XacroError

PREFIX = "xacro:"
DEEPEST = 60  # macros within macros
# Tags that older files write without the prefix, and what tells them from others of that name.
BARE = {"property": "name", "macro": "name", "include": "filename", "insert_block": "name",
        "if": "value", "unless": "value"}
# A macro of such a name is only called with the prefix.
URDF_TAGS = frozenset(
    "axis box capsule child collision color cylinder dynamics gazebo geometry inertia inertial joint "
    "limit link mass material mesh mimic origin parent robot sensor sphere texture transmission "
    "visual".split())


def elements(nodes: List[minidom.Node]) -> List[minidom.Element]:
    """Those of the nodes that are elements."""
    return [node for node in nodes if node.nodeType == node.ELEMENT_NODE]


def macro_name(node: minidom.Element) -> str:
    """Of a macro's definition."""
    name = node.getAttribute("name")
    return name[len(PREFIX):] if name.startswith(PREFIX) else name


class Expander:
    """One expansion."""

    def __init__(self, evaluator: Evaluator) -> None:
        self._evaluator = evaluator
        self._macros: Dict[str, Macro] = {}
        self._depth = 0
        self._document = minidom.Document()

    def expand(self, file: pathlib.Path) -> str:
        """The URDF of a file."""
        root = self._parse(file)
        scope = Scope()
        result = self._document.createElement(root.tagName)
        for name, value in root.attributes.items():
            if not name.startswith("xmlns:"):
                result.setAttribute(name, self._evaluator.text(value, scope))
        self._evaluator.folder = file.parent
        for node in self._file(root, scope):
            result.appendChild(node)
        return result.toxml() + "\n"

    @staticmethod
    def _parse(file: pathlib.Path) -> minidom.Element:
        try:
            return minidom.parse(str(file)).documentElement
        except (OSError, ExpatError) as problem:
            raise XacroError(f"{file} cannot be read: {problem}") from None

    def _all(self, nodes: List[minidom.Node], scope: Scope) -> List[minidom.Node]:
        """What becomes of nodes, in their order."""
        made: List[minidom.Node] = []
        for node in nodes:
            if node.nodeType == node.TEXT_NODE:
                if node.data.strip():
                    made.append(self._document.createTextNode(
                        self._evaluator.text(node.data, scope)))
            elif node.nodeType == node.ELEMENT_NODE:
                made += self._element(node, scope)
        return made

    def _file(self, root: minidom.Element, scope: Scope) -> List[minidom.Node]:
        """What becomes of a file, whose macros may be used above their definition."""
        for node in elements(root.childNodes):
            if self._verb(node) == "macro" and macro_name(node) not in self._macros:
                self._define(node, scope)
        return self._all(root.childNodes, scope)

    def _verb(self, node: minidom.Element) -> str:
        """What a tag asks for, or "" where it is none of xacro's."""
        tag = node.tagName
        if tag.startswith(PREFIX):
            return tag[len(PREFIX):]
        is_bare = tag in BARE and node.hasAttribute(BARE[tag])
        return tag if is_bare or (tag in self._macros and tag not in URDF_TAGS) else ""

    def _element(self, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        verb = self._verb(node)
        if not verb:
            result = self._document.createElement(node.tagName)
            for name, value in node.attributes.items():
                if not name.startswith("xmlns:"):
                    result.setAttribute(name, self._evaluator.text(value, scope))
            for child in self._all(node.childNodes, scope):
                result.appendChild(child)
            return [result]
        known: Dict[str, Callable[[minidom.Element, Scope], List[minidom.Node]]] = {
            "property": self._property, "arg": self._argument, "macro": self._define,
            "include": self._include, "insert_block": self._insert, "if": self._if,
            "unless": self._if}
        try:
            if verb in known:
                return known[verb](node, scope)
            if verb == "call":
                verb = self._evaluator.text(node.getAttribute("macro"), scope)
            if verb not in self._macros:
                raise XacroError(f"<xacro:{verb}> is no macro that was defined before, and nothing "
                                 "that is known here")
            return self._call(verb, node, scope)
        except XacroError as problem:
            if "\n" in str(problem):
                raise
            raise XacroError(f"<{node.tagName} {node.getAttribute('name')}>:\n{problem}") from None

    def _property(self, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        name = self._evaluator.text(node.getAttribute("name"), scope)
        target = {"global": scope.top(), "parent": scope.parent or scope}.get(
            node.getAttribute("scope"), scope)
        if node.hasAttribute("default"):
            if name not in scope:
                target.set(name, self._evaluator.value(node.getAttribute("default"), scope))
        elif not node.hasAttribute("value"):
            target.set(name, Block(node.childNodes, scope))
        elif target is scope and node.getAttribute("lazy_eval") != "false":
            value, folder = node.getAttribute("value"), self._evaluator.folder
            target.set_later(name, lambda: self._value_in(folder, value, scope))
        else:
            target.set(name, self._evaluator.value(node.getAttribute("value"), scope))
        return []

    def _value_in(self, folder: pathlib.Path, text: str, scope: Scope) -> Any:
        here, self._evaluator.folder = self._evaluator.folder, folder
        try:
            return self._evaluator.value(text, scope)
        finally:
            self._evaluator.folder = here

    def _argument(self, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        if node.hasAttribute("default"):
            self._evaluator.arguments.setdefault(
                node.getAttribute("name"), self._evaluator.value(node.getAttribute("default"), scope))
        return []

    def _define(self, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        self._macros[macro_name(node)] = Macro(parameters_of(node.getAttribute("params")),
                                   list(node.childNodes), scope, self._evaluator.folder)
        return []

    def _include(self, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        if node.hasAttribute("ns"):
            raise XacroError("an include with a namespace (ns) is not known here")
        file = self._evaluator.folder / self._evaluator.text(node.getAttribute("filename"), scope)
        if not file.exists() and node.getAttribute("optional") == "true":
            return []
        here = self._evaluator.folder
        self._evaluator.folder = file.parent
        try:
            return self._nested(lambda: self._file(self._parse(file), scope))
        finally:
            self._evaluator.folder = here

    def _insert(self, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        name = self._evaluator.text(node.getAttribute("name"), scope)
        block = scope.get(name)
        if not isinstance(block, Block):
            raise XacroError(f"'{name}' is no block")
        return self._nested(lambda: self._all(block.nodes, block.scope))

    def _if(self, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        is_true = self._evaluator.condition(node.getAttribute("value"), scope)
        wanted = self._verb(node) == "if"
        return self._all(node.childNodes, scope) if is_true == wanted else []

    def _call(self, name: str, node: minidom.Element, scope: Scope) -> List[minidom.Node]:
        macro = self._macros[name]
        inner = Scope(macro.scope)
        given = {key: value for key, value in node.attributes.items()
                 if not (node.tagName == PREFIX + "call" and key == "macro")}
        blocks = elements(node.childNodes)
        for parameter in macro.parameters:
            if parameter.stars:
                if not blocks:
                    raise XacroError(f"the block '{parameter.name}' is missing")
                block = blocks.pop(0)
                inner.set(parameter.name, Block(
                    [block] if parameter.stars == 1 else list(block.childNodes), scope))
            elif parameter.name in given:
                inner.set(parameter.name,
                          self._evaluator.value(given.pop(parameter.name), scope))
            else:
                inner.set(parameter.name, self._default(parameter, scope, inner))
        if given:
            raise XacroError(f"the macro has no parameter {', '.join(sorted(given))}")
        here, self._evaluator.folder = self._evaluator.folder, macro.folder
        try:
            return self._nested(lambda: self._all(macro.body, inner))
        finally:
            self._evaluator.folder = here

    def _default(self, parameter: Parameter, caller: Scope, inner: Scope) -> Any:
        text = parameter.default
        if text is None:
            raise XacroError(f"the parameter '{parameter.name}' is missing")
        if text.startswith("^"):
            if parameter.name in caller:
                return caller.get(parameter.name)
            if not text.startswith("^|"):
                raise XacroError(f"the parameter '{parameter.name}' is missing")
            text = text[2:]
        return self._evaluator.value(text, inner)

    def _nested(self, work: Callable[[], List[minidom.Node]]) -> List[minidom.Node]:
        self._depth += 1
        if self._depth > DEEPEST:
            raise XacroError("macros or includes are nested without end")
        try:
            return work()
        finally:
            self._depth -= 1


def expand(file: pathlib.Path, arguments: Dict[str, str], mesh_path: str = "") -> str:
    """The URDF text of a xacro file.

    Args:
        arguments: values of its $(arg ..), by name.
        mesh_path: folder in which packages are looked for first, or "".

    Raises:
        XacroError: with what is wrong and where.
    """
    evaluator = Evaluator(dict(arguments), package_finder(file.parent, mesh_path))
    try:
        return Expander(evaluator).expand(file)
    except RecursionError:
        raise XacroError("it is nested too deep") from None
