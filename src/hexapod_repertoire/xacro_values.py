"""Values of a xacro file: ${expressions} and $(substitutions), with names that are looked up in scopes."""
import ast
import math
import operator
import os
import pathlib
import re
from typing import Any, Callable, Dict, Optional

import yaml

OPERATORS = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv, ast.Mod: operator.mod, ast.Pow: operator.pow,
    ast.USub: operator.neg, ast.UAdd: operator.pos, ast.Not: operator.not_,
    ast.Eq: operator.eq, ast.NotEq: operator.ne, ast.Lt: operator.lt, ast.LtE: operator.le,
    ast.Gt: operator.gt, ast.GtE: operator.ge, ast.Is: operator.is_, ast.IsNot: operator.is_not,
    ast.In: lambda item, items: item in items, ast.NotIn: lambda item, items: item not in items}
NAMES: Dict[str, Any] = {
    **{name: value for name, value in vars(math).items() if not name.startswith("_")},
    "abs": abs, "bool": bool, "dict": dict, "float": float, "int": int, "len": len, "list": list,
    "max": max, "min": min, "radians": math.radians, "range": range, "round": round, "str": str,
    "sum": sum, "True": True, "False": False, "true": True, "false": False, "None": None}
# What may be called on a text or a mapping.
METHODS = {str: {"endswith", "find", "format", "lower", "replace", "split", "startswith", "strip",
                 "upper"}, dict: {"get", "items", "keys", "values"}}
PLACE = re.compile(r"\$\$(?=[{(])|\$\{((?:[^{}]|\{[^{}]*\})*)\}|\$\(([^()]*(?:\([^()]*\)[^()]*)*)\)")
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$")
LONGEST_TEXT = 100_000
HIGHEST_POWER = 1000


class XacroError(RuntimeError):
    """What is wrong with a xacro file, in a sentence."""


class Scope:
    """Names of a file or of a macro that is being expanded; a property is worked out when used."""

    def __init__(self, parent: Optional["Scope"] = None) -> None:
        self.parent = parent
        self._values: Dict[str, Any] = {}
        self._pending: Dict[str, Callable[[], Any]] = {}

    def set(self, name: str, value: Any) -> None:
        """Gives a name a value."""
        self._pending.pop(name, None)
        self._values[name] = value

    def set_later(self, name: str, work_out: Callable[[], Any]) -> None:
        """Gives a name what `work_out` says when somebody asks."""
        self._values.pop(name, None)
        self._pending[name] = work_out

    def __contains__(self, name: str) -> bool:
        return (name in self._values or name in self._pending or
                (self.parent is not None and name in self.parent))

    def get(self, name: str) -> Any:
        """The value of a name, of the innermost scope that has it."""
        if name in self._pending:
            work_out = self._pending.pop(name)
            self._values[name] = work_out()
        if name in self._values:
            return self._values[name]
        if self.parent is not None:
            return self.parent.get(name)
        raise XacroError(f"'{name}' is not defined")

    def top(self) -> "Scope":
        """The outermost scope."""
        return self if self.parent is None else self.parent.top()


class Evaluator:
    """Works out texts. `find_package` finds the folder of a package; `arguments` are $(arg ..)."""

    def __init__(self, arguments: Dict[str, Any],
                 find_package: Callable[[str], pathlib.Path]) -> None:
        self.arguments = arguments
        self.folder = pathlib.Path(".")
        self._find_package = find_package

    def value(self, text: str, scope: Scope) -> Any:
        """What a text stands for: a number or an object where it is nothing but one expression."""
        whole = PLACE.fullmatch(text.strip())
        if whole and whole.group(1) is not None:
            return self._expression(whole.group(1), scope)
        return typed(self.text(text, scope))

    def text(self, text: str, scope: Scope) -> str:
        """A text with everything in it worked out."""
        def replace(match: "re.Match[str]") -> str:
            if match.group(1) is not None:
                return as_text(self._expression(match.group(1), scope))
            if match.group(2) is not None:
                return as_text(self._substitution(self.text(match.group(2), scope), scope))
            return "$"
        return PLACE.sub(replace, text)

    def condition(self, text: str, scope: Scope) -> bool:
        """Whether the value of an if is true."""
        value = self.value(text, scope)
        if isinstance(value, (bool, int, float)):
            return bool(value)
        raise XacroError(f"the condition '{text}' is '{value}'; expected true, false or a number")

    def _substitution(self, text: str, scope: Scope) -> Any:
        words = text.split()
        verb, rest = (words[0] if words else ""), words[1:]
        if verb == "eval":
            return self._expression(text.strip()[len("eval"):], scope)
        if verb == "arg" and len(rest) == 1:
            if rest[0] not in self.arguments:
                raise XacroError(f"the argument '{rest[0]}' has no value; give it as {rest[0]}:=..")
            return self.arguments[rest[0]]
        if verb == "find" and len(rest) == 1:
            return self._find_package(rest[0])
        if verb == "env" and len(rest) == 1 and rest[0] in os.environ:
            return os.environ[rest[0]]
        if verb == "optenv" and rest:
            return os.environ.get(rest[0], " ".join(rest[1:]))
        if verb in ("cwd", "dirname"):
            return self.folder
        raise XacroError(f"$({text}) is not known here")

    def _expression(self, text: str, scope: Scope) -> Any:
        try:
            # Substitutions in an expression come first, also those in its texts.
            plain = self.text(text, scope) if "$(" in text else text
            return self._node(ast.parse(plain.strip(), mode="eval").body, scope)
        except XacroError as problem:
            raise XacroError(f"{problem} (in ${{{text}}})") from None
        except (ArithmeticError, AttributeError, LookupError, SyntaxError, TypeError, ValueError,
                RecursionError) as problem:
            raise XacroError(f"${{{text}}} cannot be worked out: {problem}") from None

    def _node(self, node: ast.AST, scope: Scope) -> Any:
        def work_out(part: ast.AST) -> Any:
            return self._node(part, scope)
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.Name):
            return self._name(node.id, scope)
        if isinstance(node, ast.UnaryOp):
            return OPERATORS[type(node.op)](work_out(node.operand))
        if isinstance(node, ast.BinOp):
            return binary(node.op, work_out(node.left), work_out(node.right))
        if isinstance(node, ast.BoolOp):
            is_or = isinstance(node.op, ast.Or)
            value = None
            for part in node.values:
                value = work_out(part)
                if bool(value) == is_or:
                    break
            return value
        if isinstance(node, ast.Compare):
            sides = [work_out(part) for part in [node.left, *node.comparators]]
            return all(OPERATORS[type(operation)](left, right)
                       for operation, left, right in zip(node.ops, sides, sides[1:]))
        if isinstance(node, ast.IfExp):
            return work_out(node.body if work_out(node.test) else node.orelse)
        if isinstance(node, (ast.List, ast.Tuple)):
            return [work_out(part) for part in node.elts]
        if isinstance(node, ast.Dict):
            return {work_out(key): work_out(value) for key, value in zip(node.keys, node.values)}
        if isinstance(node, ast.Subscript):
            index = node.slice
            return work_out(node.value)[work_out(getattr(index, "value", index)
                                                 if type(index).__name__ == "Index" else index)]
        if isinstance(node, ast.Attribute):
            return self._attribute(node, scope)
        if isinstance(node, ast.Call) and not any(word.arg is None for word in node.keywords):
            return work_out(node.func)(*[work_out(part) for part in node.args],
                                       **{word.arg: work_out(word.value) for word in node.keywords})
        raise XacroError(f"{type(node).__name__} is not understood")

    def _name(self, name: str, scope: Scope) -> Any:
        if name in scope:
            return scope.get(name)
        if name in ("load_yaml", "xacro"):
            return self._load_yaml if name == "load_yaml" else {"load_yaml": self._load_yaml}
        if name == "arg":
            return self.arguments.__getitem__
        if name in NAMES:
            return NAMES[name]
        raise XacroError(f"'{name}' is not defined")

    def _attribute(self, node: ast.Attribute, scope: Scope) -> Any:
        if isinstance(node.value, ast.Name) and node.value.id in ("math", "python") and \
                node.value.id not in scope:
            return NAMES[node.attr]
        owner = self._node(node.value, scope)
        if isinstance(owner, dict) and node.attr in owner:
            return owner[node.attr]
        for kind, methods in METHODS.items():
            if isinstance(owner, kind) and node.attr in methods:
                return getattr(owner, node.attr)
        raise XacroError(f"'.{node.attr}' is not known")

    def _load_yaml(self, file: Any) -> Any:
        path = self.folder / str(file)
        try:
            return yaml.safe_load(path.read_text(encoding="utf-8"))
        except (OSError, UnicodeError, yaml.YAMLError) as problem:
            raise XacroError(f"{path} cannot be read: {problem}") from None


def binary(operation: ast.operator, left: Any, right: Any) -> Any:
    """left operation right; of no more than a description ever needs."""
    if isinstance(operation, ast.Pow) and abs(right) > HIGHEST_POWER:
        raise XacroError(f"the power {right} is too high")
    if isinstance(operation, ast.Mult) and any(
            isinstance(side, (str, list)) and isinstance(other, int) and
            len(side) * other > LONGEST_TEXT for side, other in ((left, right), (right, left))):
        raise XacroError("the text is too long")
    return OPERATORS[type(operation)](left, right)


def typed(text: str) -> Any:
    """A number or a truth where the text is one."""
    stripped = text.strip()
    if NUMBER.match(stripped):
        return int(stripped) if re.match(r"[+-]?\d+$", stripped) else float(stripped)
    return {"true": True, "false": False}.get(stripped.lower(), text)


def as_text(value: Any) -> str:
    """A value as it stands in a URDF."""
    if isinstance(value, bool):
        return str(value).lower() if value in (True, False) else str(value)
    return repr(value) if isinstance(value, float) else str(value)
