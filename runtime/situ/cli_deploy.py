"""Versions of what a robot runs: ``situ deploy``, ``situ rollback`` and ``situ history``."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.blackboard.client import Board
    from situ.blackboard.protocol import Role
    from situ.blackboard.replies import Deployment, Turn
    from situ.decide.deployment import Waits
    from situ.document.project import Project

LINES = 40
"""Lines of what changes that are told."""
POLL = 0.2
"""Seconds between two questions how far it is."""


def add(commands: Any) -> None:
    deploy = _command(
        commands,
        "deploy",
        "have a running robot run this project from its next safe point on",
        "The robot checks it, waits until no action runs, and keeps the states that it is in. It "
        "goes back by itself if that fails within the first minute. Exit status 1 where the robot "
        "does not take it.",
    )
    deploy.add_argument("project", metavar="PROJECT", help="a project, or one of its files")
    deploy.add_argument(
        "--spds",
        action="store_true",
        help="only its situated priority description script; all else stays as the robot has it",
    )
    deploy.set_defaults(run=_deploy)
    _waits(deploy)

    back = _command(
        commands,
        "rollback",
        "have a running robot run a former version again",
        "As situ deploy, with a version that the robot has still got.",
    )
    back.add_argument(
        "version",
        metavar="N",
        nargs="?",
        type=int,
        help="which one, 0 for what situ run was given; the one that ran before unless given",
    )
    back.set_defaults(run=_rollback)
    _waits(back)

    told = _command(
        commands,
        "history",
        "list the versions that a running robot has had",
        "Who deployed what and when, how it ended, what can be gone back to, and which Situ the "
        "robot itself runs.",
    )
    told.add_argument("--json", action="store_true", help="for a program to read")
    told.set_defaults(run=_history)


def _command(commands: Any, name: str, about: str, more: str) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        name, help=about, description=f"{about.capitalize()}. {more}"
    )
    parser.add_argument("--to", required=True, metavar="ENDPOINT", help="the robot's address")
    parser.add_argument(
        "--keys",
        metavar="DIR",
        help="the folder with your keys, where the robot lets in only whom it knows",
    )
    return parser


def _waits(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--force-after",
        type=_seconds,
        metavar="S",
        help="do not wait longer than S seconds for the actions that run; as long as it takes "
        "unless given",
    )
    parser.add_argument(
        "--wait", action="store_true", help="until its first minute is over, not until it runs"
    )


def _seconds(text: str) -> float:
    """A time on the command line."""
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0 <= value < 1e9:
        raise argparse.ArgumentTypeError("a number of seconds, 0 or more, is needed")
    return value


def _connect(args: argparse.Namespace, role: Role) -> Board:
    from situ.blackboard import client

    return client.connect(args.to, role=role, keys=args.keys)


def _deploy(args: argparse.Namespace) -> int:
    with _connect(args, "operator") as board:
        files, main = _only_spds(args.project, board) if args.spds else _whole(args.project)
        for line in _changes(args.project, board, files, main):
            print(line)
        size = sum(map(len, files.values()))
        print(f"{len(files)} file{'s' * (len(files) != 1)}, {size / 1000:,.0f} kB", flush=True)
        begun = board.deploy(files, main, force_after=args.force_after)
        return _follow(board, begun, args.wait)


def _rollback(args: argparse.Namespace) -> int:
    with _connect(args, "operator") as board:
        begun = board.rollback(args.version, force_after=args.force_after)
        return _follow(board, begun, args.wait)


# -- what is sent ---------------------------------------------------------------


def _whole(path: str) -> tuple[dict[str, bytes], str]:
    from situ.document.export import deployable
    from situ.document.folder import PROJECT_FILE
    from situ.document.ready import load_ready

    project = load_ready(path)
    files = deployable(project)
    return files, PROJECT_FILE if project.toml is not None else next(iter(files))


def _only_spds(path: str, board: Board) -> tuple[dict[str, bytes], None]:
    from situ.document import codec, deployed
    from situ.document.export import without_editor
    from situ.document.folder import load
    from situ.errors import ProjectError

    mine, problems = load(path)
    errors = [str(one) for one in problems if one.severity == "error"]
    if mine is None or mine.spds is None or errors:
        raise ProjectError(errors[0] if errors else f"{path}: there is no script (SPDS) in it")
    texts = board.documents().files
    theirs, _ = deployed.read(texts)
    if theirs is None or theirs.spds_file is None:
        raise ProjectError(f"{path}: the robot runs no script (SPDS): deploy the whole project")
    data = codec.write(without_editor(mine.spds))
    # With its applications and modules, not with those beside the script here.
    _, problems = deployed.read({**texts, theirs.spds_file: data.decode()})
    errors = [str(one) for one in problems if one.severity == "error"]
    if errors:
        raise ProjectError(f"with what the robot runs: {errors[0]}")
    return {theirs.spds_file: data}, None


def _changes(path: str, board: Board, files: dict[str, bytes], main: str | None) -> list[str]:
    """What the robot would do differently, in plain words; its media are left to the robot. Raises
    ProjectError where it is another project: the robot would not take it; or one document of a
    whole one: all others would be gone."""
    from situ.cli_diff import told
    from situ.document.diff import compare
    from situ.document.folder import PROJECT_FILE
    from situ.errors import ProjectError

    robots = board.documents().files
    if main not in (None, PROJECT_FILE) and PROJECT_FILE in robots:
        raise ProjectError(
            f"{path}: is one document, and this robot runs a whole project: deploy the folder with "
            f"its {PROJECT_FILE} (a script alone: --spds)"
        )
    texts = {path: data.decode() for path, data in files.items() if path.endswith(_TEXTS)}
    before, after = _read(robots), _read({**robots, **texts} if main is None else texts)
    if before is None or after is None:
        return []
    if before.name != after.name:
        raise ProjectError(
            f"{path}: is the project {after.name}, and this robot runs {before.name}: deploy it to "
            "its own robot, or give it that name"
        )
    changes = [change for change in compare(before, after) if change.behaviour]
    same = "The robot will act the same" + ("." if main is None else "; its media may differ.")
    lines = told(changes) if changes else [same]
    return lines if len(lines) <= LINES else [*lines[:LINES], f"and {len(lines) - LINES} more"]


_TEXTS = (".xml", ".toml", ".po")


def _read(texts: dict[str, str]) -> Project | None:
    from situ.document.folder import load_texts

    project, _ = load_texts(texts)
    return project


# -- how it goes on -------------------------------------------------------------


def _follow(board: Board, begun: Deployment, wait: bool) -> int:
    """Tells how far it is, until it runs, or ``wait``: until its first minute is over."""
    number, state, said = begun.asked, begun, ""
    try:
        while not _ended(state, begun, wait):
            line = _told(state)
            if line not in ("", said):
                print(line, flush=True)
                said = line
            board.sleep(POLL)
            state = board.progress()
    except KeyboardInterrupt:
        if state.version != number:
            back = f"situ rollback {state.version} takes it back"
            print(f"situ: version {number} goes on without this: {back}", file=sys.stderr)
        raise
    if state.asked != number:
        return _elsewhere(board, number, state)
    if state.stands == "refused":
        lines = [f"version {number} is refused; version {begun.version} runs on", *state.problems]
        return _failed(lines)
    if state.stands == "returned":
        return _failed([f"version {state.version} runs again: {' '.join(state.problems)}"])
    print(f"version {number} counts: its first minute is over" if wait else _told(state))
    if state.restart:
        print(f"when the robot is started again, these count too: {', '.join(state.restart)}")
    return 0


def _ended(state: Deployment, begun: Deployment, wait: bool) -> bool:
    if state.asked != begun.asked:
        # Where another one was refused this one waits on.
        return state.stands != "refused" or not state.waits
    if state.stands == "running":
        return not wait or state.minute is None
    return state.stands not in ("checking", "waiting")


def _told(state: Deployment) -> str:
    if state.stands == "checking":
        return f"the robot checks version {state.asked}"
    if state.stands == "waiting":
        forced = "" if state.forced is None else "; at the latest when its time is over"
        return f"checked; waiting for {', '.join(map(_waited, state.waits)) or 'a moment'}{forced}"
    if state.stands != "running":
        return ""
    if state.former is None:
        return f"version {state.asked} runs"
    back = f"back to version {state.former} by itself if it fails in its first minute"
    return f"version {state.asked} runs; {back}"


def _waited(one: Waits) -> str:
    name = "" if one.name is None else f" {one.name}"
    return f"{one.action}{name} of state {one.state} of {one.application}"


def _elsewhere(board: Board, number: int | None, state: Deployment) -> int:
    """The robot was started again meanwhile, or somebody else asked for another version."""
    told = board.history()
    at = [i for i, turn in enumerate(told.turns) if turn.version == number]
    last = told.turns[at[-1] + 1 :] if at else ()
    if last and last[0].did == "returned":
        return _failed([f"version {told.version} runs again: {last[0].why}"])
    if told.version == number:
        print(f"version {number} runs")
        return 0
    why = "the robot was started again"
    if state.asked is not None:
        why = f"version {state.asked} was asked for after it"
    return _failed([f"version {told.version} runs, not version {number}: {why}; see situ history"])


def _failed(lines: list[str]) -> int:
    for line in lines:
        print(f"situ: {line}", file=sys.stderr)
    return 1


# -- what there was -------------------------------------------------------------


def _history(args: argparse.Namespace) -> int:
    import msgspec

    with _connect(args, "viewer") as board:
        told, itself = board.history(), board.situ
    if args.json:
        shown = {"version": told.version, "kept": told.kept, "situ": itself, "turns": told.turns}
        print(msgspec.json.format(msgspec.json.encode(shown), indent=2).decode())
        return 0
    for turn in told.turns:
        for line in _turn(turn):
            print(line)
    kept = [str(number) for number in told.kept if number != told.version]
    back = f"; {', '.join(kept)} can be gone back to" if kept else ""
    print(f"version {told.version} runs{back}")
    if itself is not None:
        print(f"the robot itself runs Situ {itself}")
    return 0


def _turn(turn: Turn) -> list[str]:
    from datetime import datetime

    when = datetime.fromtimestamp(turn.time).strftime("%Y-%m-%d %H:%M:%S")
    did = {
        "deployed": f"version {turn.version} deployed by {turn.who}",
        "rolled back": f"back to version {turn.version} by {turn.who}",
        "returned": f"back to version {turn.version} by itself",
        "refused": f"version {turn.version} of {turn.who} refused",
        "given": f"version {turn.version} runs, what lies in the project's own folder",
    }[turn.did]
    why = f": {turn.why}" if turn.why else ""
    return [f"{when}  {did}{why}", *(f"    {line}" for line in turn.changed)]
