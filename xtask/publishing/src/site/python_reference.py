"""Prints the public names of a package as a page of Markdown: signatures and numpydoc docstrings, read without importing it."""

import ast
import re
import runpy
import sys
from pathlib import Path

package = Path(sys.argv[1])


def public_names() -> list[str]:
    for node in ast.parse((package / "__init__.py").read_text()).body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return ast.literal_eval(node.value)
    raise SystemExit("the package has no __all__")


def definitions() -> dict[str, ast.AST]:
    """Returns classes and functions by name; a source with a docstring wins over the stub."""
    found: dict[str, ast.AST] = {}
    for path in sorted(package.glob("*.py*"), key=lambda path: path.suffix != ".pyi"):
        for node in ast.parse(path.read_text()).body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                found[node.name] = node
    return found


def fields(name: str) -> list[ast.arg]:
    """Returns the fields that a class of the package and its bases declare."""
    if name not in known:
        return []
    own = [ast.arg(field.target.id, field.annotation) for field in known[name].body if isinstance(field, ast.AnnAssign)]
    return [field for base in known[name].bases for field in fields(ast.unparse(base))] + own


def options(node: ast.FunctionDef) -> list[ast.arg]:
    """Returns the options of the groups that a function takes by its decorator."""
    groups = [group for decorator in node.decorator_list if isinstance(decorator, ast.Call) for group in decorator.args]
    return list({field.arg: field for group in groups for field in fields(group.id)}.values())


def docstring(node: ast.FunctionDef) -> str:
    """Returns a docstring with the entries that it shares with other functions, and those of its results."""
    text = ast.get_docstring(node) or ""
    if not any("documented" in ast.unparse(one) or "with_options" in ast.unparse(one) for one in node.decorator_list):
        return text
    arguments = [*node.args.args, *node.args.kwonlyargs, *options(node)]
    results = [
        shared["result_entry"](
            result,
            ast.get_docstring(known[result]),
            [field.arg for field in fields(result) if ast.unparse(field.annotation).endswith("Array")],
        )
        for result in ast.unparse(node.returns).split(" | ")
    ]
    return shared["completed"](text, [argument.arg for argument in arguments], results)


def signature(node: ast.FunctionDef, name: str) -> str:
    arguments = node.args
    keyword = zip(arguments.kwonlyargs, arguments.kw_defaults)
    with_defaults = len(arguments.args) - len(arguments.defaults)
    listed = []
    for at, argument in enumerate(arguments.args):
        default = arguments.defaults[at - with_defaults] if at >= with_defaults else None
        listed.append(typed(argument, default))
    if arguments.vararg:
        listed.append("*" + typed(arguments.vararg, None))
    elif arguments.kwonlyargs:
        listed.append("*")
    listed += [typed(argument, default) for argument, default in keyword]
    listed += [typed(option, ast.Constant(None)) for option in options(node)]
    listed = [entry for entry in listed if entry not in ("self", "cls")]
    result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    line = f"{name}({', '.join(listed)}){result}"
    return line if len(line) < 100 else f"{name}(\n    " + ",\n    ".join(listed) + f",\n){result}"


def typed(argument: ast.arg, default: ast.expr | None) -> str:
    text = argument.arg + (f": {ast.unparse(argument.annotation)}" if argument.annotation else "")
    return text if default is None else f"{text} = {ast.unparse(default)}"


def prose(line: str) -> str:
    line = re.sub(r":(?:func|class|meth|attr|mod):`~?([^`]+)`", r"`\1`", line)
    return line.replace("``", "`")


def markdown(docstring: str) -> str:
    """Turns numpydoc into Markdown: sections become bold lines, their entries lists, examples code."""
    lines, out, section = docstring.splitlines(), [], ""
    at = 0
    while at < len(lines):
        line = lines[at]
        if at + 1 < len(lines) and line and set(lines[at + 1]) == {"-"}:
            if section == "Examples":
                out.append("```")
            section = line
            out += ["", f"**{section}**", ""]
            if section == "Examples":
                out.append("```python")
            at += 2
            continue
        if section == "Examples" or not section:
            out.append(line if section else prose(line))
        elif line and not line.startswith(" "):
            out.append(f"* **{line}**" if section in ("Parameters", "Attributes", "Raises", "Returns") else prose(line))
        else:
            out.append("  " + prose(line.strip()) if line else "")
        at += 1
    if section == "Examples":
        out.append("```")
    return "\n".join(out)


known = definitions()
shared = runpy.run_path(str(package / "_options.py"))
print("# Python\n\nEvery public name of the package `truearea`, from its signatures and docstrings.")
functions_first = sorted(public_names(), key=lambda name: isinstance(known.get(name), ast.ClassDef))
for name in functions_first:
    node = known.get(name)
    if node is None:
        continue
    print(f"\n## {name}\n")
    if isinstance(node, ast.FunctionDef):
        print(f"```python\n{signature(node, name)}\n```\n")
    text = docstring(node) if isinstance(node, ast.FunctionDef) else ast.get_docstring(node)
    if text:
        print(markdown(text))
    if isinstance(node, ast.ClassDef):
        for member in node.body:
            if isinstance(member, ast.FunctionDef) and not member.name.startswith("_"):
                print(f"\n### {name}.{member.name}\n\n```python\n{signature(member, member.name)}\n```\n")
                print(markdown(docstring(member)))
            elif isinstance(member, ast.Assign) and ast.unparse(member.value).startswith("Fact["):
                print(f"\n### {name}.{member.targets[0].id}\n\n{prose(ast.literal_eval(member.value.args[0]))}")
