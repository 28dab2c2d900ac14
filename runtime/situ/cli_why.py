"""``situ why``: the chain of causes of an event, and what stood in the way of one."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from situ.cli_simulate import above_zero

if TYPE_CHECKING:
    from situ.document.project import Project
    from situ.rehearse.recording import Recording


def add(commands: Any) -> None:
    parser = commands.add_parser(
        "why",
        help="what led to an event of a trace, or what kept one from happening",
        description="With SEQ: the chain of causes from the outside input to that event. With "
        "--not: what stood in the way of an event that did not come, with the values then; that "
        "needs the project. With --script the scenario is played anew, and no trace is needed.",
    )
    parser.add_argument(
        "trace",
        metavar="TRACE",
        nargs="?",
        help="a trace of situ simulate or situ trace (.jsonl), or a recording (.mcap)",
    )
    parser.add_argument("seq", metavar="SEQ", nargs="?", help="the number of an event")
    parser.add_argument("--project", metavar="P", help="the project that ran")
    parser.add_argument("--script", metavar="S.jsonl", help="the scenario to play anew")
    parser.add_argument(
        "--not",
        dest="wanted",
        metavar="JSON",
        help='the event that did not come: \'{"kind":"enter","state":"5"}\'',
    )
    parser.add_argument("--at", type=float, metavar="T", help="when, in seconds; with --not")
    parser.add_argument(
        "--auto-finish", type=above_zero, metavar="S", help="as it was played; with --script"
    )
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="with --script")
    parser.add_argument("--json", action="store_true", help="the chain, or the reasons, as JSON")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    from situ.document.ready import load_ready
    from situ.errors import UsageError

    if args.script is not None and args.trace is not None and args.seq is None:
        # The trace is left out: what stands in its place is the number.
        args.trace, args.seq = (None, args.trace) if args.trace.isdigit() else (args.trace, None)
    if (args.seq is None) == (args.wanted is None):
        raise UsageError("why wants the SEQ of an event, or --not and --at; see situ why --help")
    if args.wanted is not None and (args.at is None or args.project is None):
        raise UsageError("--not needs --at and --project: when it should have come, and where")
    if args.script is not None and args.project is None:
        raise UsageError("--script needs --project: the project to play it in")
    if args.trace is None and args.script is None:
        raise UsageError("why wants a TRACE, or --script with --project to play it anew")
    project = load_ready(args.project) if args.project is not None else None
    recording = _recording(args, project)
    if args.seq is not None:
        return _chain(args, project, recording)
    assert project is not None
    return _why_not(args, project, recording)


def _recording(args: argparse.Namespace, project: Project | None) -> Recording:
    from situ.rehearse import scenario
    from situ.rehearse.recording import read, record

    if args.script is None:
        return read(args.trace)
    assert project is not None
    names = [application.name for application in project.applications.values()]
    lines = scenario.load(args.script, names)
    return record(project, lines, args.seed, args.auto_finish)[0]


def _chain(args: argparse.Namespace, project: Project | None, recording: Recording) -> int:
    from situ.errors import UsageError
    from situ.rehearse.telling import Teller
    from situ.rehearse.why import chain

    if not args.seq.isdigit():
        raise UsageError(f"SEQ is the number of an event, not {args.seq}")
    found = chain(recording.events, int(args.seq))
    if args.json:
        _print_json(found)
        return 0
    teller = Teller(project)
    first = found[0]
    for event in found:
        note = f"  ({teller.origin(event)})" if event is first else ""
        print(f"{teller.line(event)}{note}")
    return 0


def _why_not(args: argparse.Namespace, project: Project, recording: Recording) -> int:
    import msgspec

    from situ.errors import UsageError
    from situ.rehearse.reason import lines
    from situ.rehearse.telling import Teller, moment
    from situ.rehearse.why import why_not

    try:
        wanted = msgspec.json.decode(args.wanted, type=dict[str, Any])
    except (msgspec.DecodeError, UnicodeEncodeError) as error:
        raise UsageError(f"--not: {args.wanted}: not a JSON object: {error}") from None
    answer = why_not(project, recording, wanted, args.at)
    if args.json:
        _print_json(answer)
        return 0
    if answer.happened is not None:
        print("It did happen: " + Teller(project).line(answer.happened))
        return 0
    already = all(one.code == "already" for one in answer.reasons[:1])
    if answer.ends is not None:
        ends = moment(answer.ends)
        print(f"What is recorded ends at {ends}: the rest is so if nothing happened since.")
    at = moment(answer.at)
    print(f"By {at} it had happened:" if already else f"Not at {at}:")
    for line in lines(answer.reasons):
        print(line)
    return 0


def _print_json(value: Any) -> None:
    import msgspec

    print(msgspec.json.format(msgspec.json.encode(value), indent=2).decode())
