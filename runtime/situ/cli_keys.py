"""``situ keys``: whom a robot lets in, and what they may do (docs/security.md)."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.blackboard.identity import KeyRole
    from situ.blackboard.keys import KnownKey
    from situ.document.project import Project

ROLES: tuple[KeyRole, ...] = ("viewer", "module", "operator", "service")


def add(commands: Any) -> None:
    keys = commands.add_parser(
        "keys",
        help="keys and roles: whom a robot lets in",
        description="Makes and lists the keys of a robot, and of those that it knows.",
    )
    kinds = keys.add_subparsers(dest="kind", metavar="WHAT", required=True)

    new = _command(kinds, "new", _new, "make a robot's keys; it then lets in only whom it knows")
    new.add_argument("--json", action="store_true", help="for a program to read")

    give = _command(kinds, "add", _add, "let somebody in: a module, a person, a service")
    give.add_argument("name", metavar="NAME", help="a module's own name, or a person's")
    give.add_argument("--role", choices=ROLES, required=True, help="what he may be at most")
    give.add_argument(
        "--write",
        action="append",
        default=[],
        metavar="PATTERN",
        help="tags that a module may set beside those that it provides: face.*; may be repeated",
    )
    how = give.add_mutually_exclusive_group()
    how.add_argument("--public", metavar="KEY", help="his public key, where he has one already")
    how.add_argument(
        "--to", type=Path, metavar="DIR", help="his folder is made here; NAME.keys unless given"
    )
    how.add_argument(
        "--token", action="store_true", help="a token for the WebSocket door, not a folder"
    )
    _address(give)
    give.add_argument("--json", action="store_true", help="for a program to read")

    known = _command(kinds, "list", _list, "list whom the robot lets in")
    known.add_argument("--json", action="store_true", help="for a program to read")

    remove = _command(kinds, "remove", _remove, "let somebody in no longer")
    remove.add_argument("name", metavar="NAME")

    lab = _command(kinds, "lab", _lab, "set up a robot and its computers: a folder for each")
    lab.usage = "%(prog)s [--project PROJECT] [--robot ADDRESS] [--json] DIR [NAME[:ROLE] ...]"
    lab.add_argument(
        "rest",
        nargs="*",
        metavar="DIR, NAME[:ROLE]",
        help="the folder, which is made; then modules, or others with their role: ann:operator; "
        "the project's modules unless given",
    )
    _address(lab, action=_Among, nargs="+")
    lab.add_argument("--json", action="store_true", help="for a program to read")


def _command(kinds: Any, name: str, run: Any, about: str) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = kinds.add_parser(
        name, help=about, description=f"{about[:1].upper()}{about[1:]}."
    )
    parser.add_argument(
        "--project", default=".", metavar="PROJECT", help="the robot's project; the folder here"
    )
    if name != "lab":
        parser.add_argument("--state", type=Path, metavar="DIR", help="as of situ run")
        parser.add_argument(
            "--keys", type=Path, metavar="DIR", help="the robot's keys, instead of those two"
        )
    parser.set_defaults(run=run)
    return parser


class _Among(argparse.Action):
    """Of what follows ``--robot`` addresses are addresses, and all else is what it would be without
    it: names may stand before and after an option."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: Any,
        option_string: str | None = None,
    ) -> None:
        robots = [value for value in values if "://" in value]
        if not robots:
            parser.error(f"--robot {values[0]}: an address is needed, as tcp://10.0.0.5:5570")
        namespace.robot = [*namespace.robot, *robots]
        others = [value for value in values if "://" not in value]
        namespace.others = [*getattr(namespace, "others", ()), *others]


def _address(parser: argparse.ArgumentParser, **how: Any) -> None:
    parser.add_argument(
        "--robot",
        **{"action": "append", **how},
        default=[],
        metavar="ADDRESS",
        help="where the robot is asked: tcp://10.0.0.5:5570; may be repeated; "
        "the project's endpoint unless given",
    )


def _new(args: argparse.Namespace) -> int:
    from situ.blackboard.keys import new_robot

    folder = _folder(args)
    public = new_robot(folder).public
    if args.json:
        _print({"folder": str(folder), "public": public})
    else:
        print(f"{folder}: the robot's keys; nobody is let in yet, situ keys add lets somebody in")
        print(f"public key  {public}")
    return 0


def _add(args: argparse.Namespace) -> int:
    import secrets

    from situ.blackboard import keys

    folder = _folder(args)
    robot = keys.RobotKeys(folder).public.decode()
    said: dict[str, Any] = {"name": args.name, "role": args.role}
    write = tuple(args.write)
    if args.public is not None:
        keys.add_known(folder, args.name, keys.KnownKey(args.public, args.role, write))
        print(f"{args.name} is let in as {args.role}; the robot's public key is {robot}")
        return 0
    if args.token:
        token = secrets.token_urlsafe(24)
        public = keys.token_keys(token)[0].decode()
        keys.add_known(folder, args.name, keys.KnownKey(public, args.role, write, door=True))
        if args.json:
            _print({**said, "token": token})
        else:
            print(f"{args.name} is let in as {args.role} with this token, which is kept nowhere:")
            print(token)
        return 0
    target = args.to or Path(f"{args.name}.keys")
    name, addresses = _robot(args)
    pair = keys.new_pair(args.name)
    entry = keys.KnownKey(pair.public, args.role, write)
    keys.check_known(folder, args.name, entry)
    keys.new_client(target, pair, name, keys.RobotKey(robot, addresses, args.role))
    keys.add_known(folder, args.name, entry)
    if args.json:
        _print({**said, "folder": str(target), "public": pair.public})
    else:
        print(f"{args.name} is let in as {args.role} with the keys in {target}: take them there")
    return 0


def _list(args: argparse.Namespace) -> int:
    from situ.blackboard.keys import RobotKeys, read_known

    folder = _folder(args)
    robot = RobotKeys(folder).public.decode()
    known = read_known(folder)
    if args.json:
        rows = [{"name": name, **_fields(entry)} for name, entry in known.items()]
        _print({"robot": robot, "known": rows})
        return 0
    print(f"robot  {robot}")
    for name, entry in known.items():
        writes = f"  writes {', '.join(entry.write)}" if entry.write else ""
        door = "  by a token" if entry.door else ""
        print(f"{name}  {entry.role}  {entry.public}{writes}{door}")
    return 0


def _remove(args: argparse.Namespace) -> int:
    from situ.blackboard.keys import remove_known

    remove_known(_folder(args), args.name)
    print(f"{args.name} is let in no longer")
    return 0


def _lab(args: argparse.Namespace) -> int:
    from situ.blackboard import keys
    from situ.errors import UsageError

    given = [*args.rest, *getattr(args, "others", ())]
    if not given:
        raise UsageError("say which folder is to be made: situ keys lab DIR NAME …")
    out, names = Path(given[0]), given[1:]
    project = _load(args.project)
    declared = _modules(project)
    people: dict[str, KeyRole] = {}
    for one in names or declared:
        name, colon, said = one.partition(":")
        role = next((role for role in ROLES if role == said), None)
        if colon and role is None:
            raise UsageError(f"{one}: there is no role {said!r}: {', '.join(ROLES)}")
        if not colon and name not in declared:
            raise UsageError(
                f"{name} is no module of {project.name}: say its role, as {name}:operator"
            )
        if name in people:
            raise UsageError(f"{name} is given twice; everybody has one key")
        people[name] = role or "module"
    if not people:
        raise UsageError(f"{project.name} has no modules: say who is to be let in")
    if out.exists() and any(out.iterdir()):
        raise UsageError(f"{out}: there is something already; give another folder")
    robot = out / "robot"
    pairs = {name: keys.new_pair(name) for name in people}
    # What a module provides it may set without being told so here.
    known = {name: keys.KnownKey(pairs[name].public, role) for name, role in people.items()}
    for name, entry in known.items():
        keys.check_known(robot, name, entry)
    public = keys.new_robot(robot).public
    addresses = tuple(args.robot) or (project.endpoint,)
    for name, role in people.items():
        keys.add_known(robot, name, known[name])
        key = keys.RobotKey(public, addresses, role)
        keys.new_client(out / name, pairs[name], project.name, key)
    if args.json:
        made = {name: str(out / name) for name in people}
        _print({"robot": str(robot), "public": public, "known": made})
        return 0
    print(f"{robot}  goes to the robot: its state folder's keys, or situ run --keys")
    for name, role in people.items():
        provides = declared.get(name, ()) if role == "module" else ()
        writes = f", writes {', '.join(provides)}" if provides else ""
        print(f"{out / name}  goes to {name} ({role}{writes}): ~/.config/situ/keys")
    return 0


def _modules(project: Project) -> dict[str, tuple[str, ...]]:
    """The project's modules, with the tags that they provide."""
    found: dict[str, tuple[str, ...]] = {}
    if project.spds is not None:
        found.update((module.name, ()) for module in project.spds.modules)
    if project.modules is not None:
        for module in project.modules.modules:
            found[module.name] = tuple(one.data for one in module.provides)
    for application in project.applications.values():
        found.pop(application.name, None)
    return found


def _folder(args: argparse.Namespace) -> Path:
    from situ.engine.folder import state_folder

    if args.keys is not None:
        return Path(args.keys)
    if args.state is not None:
        return Path(args.state) / "keys"
    return state_folder(None, _load(args.project)) / "keys"


def _robot(args: argparse.Namespace) -> tuple[str, tuple[str, ...]]:
    """The robot's name, and where it is asked."""
    if args.robot:
        return "robot", tuple(args.robot)
    project = _load(args.project)
    return project.name, (project.endpoint,)


def _load(project: str) -> Project:
    from situ.document.ready import load_ready

    return load_ready(project)


def _fields(entry: KnownKey) -> dict[str, Any]:
    from msgspec import structs

    return structs.asdict(entry)


def _print(value: Any) -> None:
    import msgspec

    sys.stdout.write(msgspec.json.encode(value).decode() + "\n")
