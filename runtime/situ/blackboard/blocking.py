"""The client that blocks where it waits (see ``client``)."""

from __future__ import annotations

import contextlib
import logging
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any, Generic, TypeVar

from situ.blackboard import sending
from situ.blackboard.authority import Asked
from situ.blackboard.calls import Call
from situ.blackboard.dialog import Dialog
from situ.blackboard.driving import Driving
from situ.blackboard.feeds import Change, Feed
from situ.blackboard.notices import Message
from situ.blackboard.protocol import DebugVerb, Need, Offer
from situ.blackboard.replies import Addresses, Deployment, Entry, Files, ModuleStates, Turns
from situ.blackboard.serving import ServiceRequest
from situ.decide.expected import Expectation
from situ.errors import BlackboardError, Refused, Unreachable

T = TypeVar("T")
F = TypeVar("F", bound=Feed[Any])

PATIENCE = 5.0
"""Seconds that a request waits for its answer."""

_log = logging.getLogger("situ.blackboard")


class Board:
    """The blackboard, blocking; every method may be called from any thread, and from callbacks.

    A program that forks connects anew in the child.
    """

    def __init__(self, driver: Driving, timeout: float = PATIENCE) -> None:
        self._driver = driver
        self._dialog = driver.line.dialog
        self._timeout = timeout
        dialog = self._dialog
        try:
            driver.until(lambda: dialog.connected or dialog.ended, timeout)
            if dialog.problem is not None and not dialog.connected:
                raise dialog.problem
            if not dialog.connected:
                raise self._unreachable(dialog.unreachable())
        except BaseException:
            driver.shut()
            raise
        driver.start(self.close)

    # -- what stands on the board --------------------------------------------

    def set(
        self,
        tag: str | Mapping[str, Any],
        value: Any = None,
        *,
        versions: Mapping[str, int] | None = None,
    ) -> dict[str, int]:
        """Writes one tag, or all of a mapping at once; None deletes. Gives the new versions.

        versions: nothing is written unless each of these tags is at that version (0: is
        missing); else Refused. Values are JSON values.
        """
        tags = tag if isinstance(tag, Mapping) else {tag: value}
        return self._ask(lambda dialog: dialog.set(tags, versions))

    def get(self, name: str) -> Any:
        """The value of a tag, or of a name that reaches into one; None where it is missing.

        A tag that is watched is not asked for: it is as last heard.
        """
        entry = self._dialog.known(name)
        if entry is not None:
            return entry.value
        return self._ask(lambda dialog: dialog.get(name))

    def entries(self, *names: str) -> dict[str, Entry]:
        """The entries of tags and patterns, with version, writer and time."""
        return self._ask(lambda dialog: dialog.entries(names))

    def watch(
        self, pattern: str, callback: Callable[[Change], None] | None = None
    ) -> Following[Change]:
        """What stands there now, then every change, in order; ends with the board.

        Without ``callback`` to be iterated over; with it, it is called for each change
        from a thread in the background, one at a time.
        """
        return self._follow(lambda dialog: dialog.watch(pattern, callback), self._dialog.unwatch)

    def trace(
        self, since: int | None = None, callback: Callable[[dict[str, Any]], None] | None = None
    ) -> Following[dict[str, Any]]:
        """Trace events from seq ``since`` on (None: from now), as plain objects; as ``watch``."""
        return self._follow(lambda dialog: dialog.trace(since, callback), self._dialog.untrace)

    # -- what happens --------------------------------------------------------

    def messages(
        self, pattern: str, callback: Callable[[Message], None] | None = None
    ) -> Following[Message]:
        """The messages that applications send (``topic``, ``value``, ``application``) from here
        on; as ``watch``, but not without a gap.

        pattern: of topics, ``*`` for one part between slashes, ``**`` for any number. What is
        sent while the connection is away is lost: what must arrive stands at a tag.
        """
        return self._follow(
            lambda dialog: dialog.messages(pattern, callback), self._dialog.unlisten
        )

    def publish(self, event: str, application: str | None = None) -> None:
        """An event for an application, or (None) for every one."""
        self._ask(lambda dialog: dialog.publish(event, application))

    def debug(self, verb: DebugVerb, **fields: Any) -> None:
        """What an operator may do to running applications: the request ``verb`` with its fields
        (docs/protocol.md); ``source`` is a breakpoint's ``from``."""
        self._ask(lambda dialog: dialog.debug(verb, **fields))

    def use(self, component: str, *value: Any) -> None:
        """What a person does to a component of the screen shown; no value for a button."""
        self._ask(lambda dialog: dialog.use(component, *value))

    def touch(self) -> None:
        """A touch on no component."""
        self._ask(lambda dialog: dialog.touch())

    def requests(
        self, *names: str, callback: Callable[[ServiceRequest], None] | None = None
    ) -> Following[ServiceRequest]:
        """What applications ask of this module (``service url="board:MODULE/NAME"``) by these
        names; as ``watch``. Each is to be answered, by ``answer`` or ``fail``.

        Raises Refused where this is no module.
        """
        return self._follow(
            lambda dialog: dialog.serve(names, callback, self._do), self._dialog.unserve
        )

    def serve(self, name: str, function: Callable[[dict[str, Any]], Any]) -> None:
        """Answers the requests of this name one after the other, until the board is closed.

        function: gets the params; what it gives is the result, what it raises the error. The
        session is kept while it takes its time.
        """
        with self.requests(name) as requests:
            for request in requests:
                answered(request, function)

    def authority(self, *resources: str, optional: Iterable[str] = ()) -> Authority:
        """Asks for resources for the time of a ``with``; see ``Authority``."""
        return Authority(self, resources, tuple(optional))

    # -- who and what is there -----------------------------------------------

    def modules(self) -> ModuleStates:
        """Declared and connected modules, and what is wanted."""
        return self._ask(lambda dialog: dialog.modules())

    def documents(self) -> Files:
        """The project's files as the robot runs them."""
        return self._ask(lambda dialog: dialog.documents())

    def deploy(
        self,
        files: Mapping[str, bytes],
        main: str | None = None,
        *,
        force_after: float | None = None,
    ) -> Deployment:
        """Sends a project, as ``situ.document.export.deployable`` makes it, to be run: checked by
        the robot, then from the next safe point on (``progress`` tells when), or at the latest
        after ``force_after`` seconds. Operators only; Refused says why it can not come.

        main: the file that the project is read from. None: the files go into the version that
        runs, and all its others stay.
        """
        staged = self._ask(lambda dialog: sending.stage(dialog, files, main))
        for piece in sending.pieces(files, staged.wanted):
            self._ask(partial(sending.send, piece=piece))
        return self._ask(lambda dialog: sending.deploy(dialog, force_after))

    def rollback(
        self, version: int | None = None, *, force_after: float | None = None
    ) -> Deployment:
        """Goes back to a version, None: the one that ran before; as ``deploy``."""
        return self._ask(lambda dialog: sending.rollback(dialog, version, force_after))

    def progress(self) -> Deployment:
        """How far the version is that was asked for last, and which one runs."""
        return self._ask(sending.progress)

    def history(self) -> Turns:
        """What happened to the robot's versions, and which can be gone back to."""
        return self._ask(sending.history)

    def expected(self) -> dict[str, Expectation]:
        """What each application expects now, by its name."""
        return self._ask(lambda dialog: dialog.expected())

    def disclose(
        self,
        description: str = "",
        requires: Iterable[Need] = (),
        provides: Iterable[Offer] = (),
    ) -> None:
        """Tells what this module requires and provides, if ``connect`` did not."""
        self._ask(lambda dialog: dialog.disclose(description, requires, provides))

    @property
    def connected(self) -> bool:
        """Whether the core is there; it comes back by itself."""
        return self._dialog.connected

    @property
    def stopped(self) -> bool:
        """Whether the core has ended, by its own word, and not come back."""
        return self._dialog.stopped

    @property
    def addresses(self) -> Addresses:
        """As the core announced them: ``requests``, ``notifications`` and ``http``."""
        assert self._dialog.welcome is not None
        return self._dialog.welcome.addresses

    @property
    def situ(self) -> str | None:
        """The version of Situ that the core runs; None: one from before it was told."""
        return self._dialog.situ

    def clock(self) -> float:
        """Seconds that only go forward; in a test (``situ.testing``) those of its robot."""
        return self._driver.line.clock()

    def sleep(self, seconds: float) -> None:
        """Waits so long, by ``clock``; not longer than until the board is closed."""
        self._driver.until(lambda: False, seconds)

    def close(self) -> None:
        """Ends the session at once: what the module held passes on. May be called twice."""
        if self._driver.closed:
            return
        with contextlib.suppress(BlackboardError):
            if self._dialog.connected:
                self._ask(lambda dialog: dialog.bye(), patience=1.0)
        self._driver.shut()

    def __enter__(self) -> Board:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        state = "closed" if self._driver.closed else told(self._dialog)
        return f"<{type(self).__name__} {self._driver.line.endpoint}, {state}>"

    # -- waiting -------------------------------------------------------------

    def _ask(self, begin: Callable[[Dialog], Call[T]], patience: float | None = None) -> T:
        driver = self._driver
        driver.check()
        with driver.lock:
            if driver.closed:
                raise Unreachable("the connection is closed")
            call = begin(self._dialog)
        if not driver.until(lambda: call.finished, patience or self._timeout):
            with driver.lock:
                self._dialog.lost(call)
        if isinstance(call.error, Unreachable):
            raise self._unreachable(call.error)
        return call.result()

    def _do(self, act: Callable[[], None]) -> None:
        driver = self._driver
        driver.check()
        if driver.closed:
            return
        with driver.lock:
            act()
        driver.wake()

    def _follow(
        self,
        begin: Callable[[Dialog], F],
        stop: Callable[[F], None],
    ) -> Following[Any]:
        driver = self._driver
        driver.check()
        with driver.lock:
            if driver.closed:
                raise Unreachable("the connection is closed")
            feed = begin(self._dialog)
        following = Following[Any](self, feed, stop)
        if not driver.until(lambda: feed.ready or feed.error is not None, self._timeout):
            following.close()
            raise self._unreachable(self._dialog.unreachable())
        if feed.error is not None:
            following.close()
            raise feed.error
        return following

    def _unreachable(self, error: Unreachable) -> Unreachable:
        return Unreachable(f"{self._driver.line.endpoint}: {error}")


def told(dialog: Dialog) -> str:
    """Who somebody is and whether the core is there, in a few words."""
    who = dialog.person
    name = f"module {who.module}" if who.module is not None else who.role
    return f"{name}, {'connected' if dialog.connected else 'not connected'}"


def answered(request: ServiceRequest, function: Callable[[dict[str, Any]], Any]) -> None:
    """Does what is asked, and answers."""
    try:
        result = function(request.params)
    except Exception as error:
        _log.exception("%s failed", request.request)
        request.fail(str(error) or type(error).__name__)
    else:
        request.answer(result)


class Following(Generic[T]):
    """What comes, one after the other: iterate over it, or ``close`` it where it calls back."""

    def __init__(self, board: Board, feed: Feed[T], stop: Callable[[Any], None]) -> None:
        self._board = board
        self._feed = feed
        self._stop = stop

    def next(self, within: float | None = None) -> T | None:
        """The next one; None when ``within`` seconds are over (None: waits for ever), or
        it or the board was closed."""
        feed = self._feed
        if not len(feed):
            self._board._driver.until(lambda: len(feed) > 0 or feed.ended, within)
        with self._board._driver.lock:
            return feed.take()

    def __iter__(self) -> Iterator[T]:
        while (item := self.next()) is not None:
            yield item

    def close(self) -> None:
        """Nothing more comes. May be called twice."""
        if self._board._driver.closed:
            return
        with self._board._driver.lock:
            self._stop(self._feed)
        self._board._driver.wake()

    def __enter__(self) -> Following[T]:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self._feed!r}>"


class Authority(Asked):
    """A request for resources: from entering the ``with`` until leaving it.

    Authority comes and goes with situations and priorities, without asking again; what
    is commanded moves the robot only while it is held.
    """

    def __init__(self, board: Board, resources: tuple[str, ...], optional: tuple[str, ...]) -> None:
        super().__init__(board._dialog, resources, optional)
        self._board = board

    def __enter__(self) -> Authority:
        try:
            self._board._ask(lambda _: self._begin())
        except Refused:
            self._refused()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        board, driver = self._board, self._board._driver
        if driver.closed:
            return
        with driver.lock:
            given_back = self._end()
        # Where the connection is away it is held no longer; the core is told when it is back.
        driver.until(lambda: given_back.finished or not board.connected, board._timeout)

    def wait(self, within: float | None = None) -> bool:
        """Waits until it is held; False when ``within`` seconds are over before."""
        self._check()
        return self._board._driver.until(lambda: self.held, within)

    def wait_lost(self, within: float | None = None) -> bool:
        """Waits until it is not held; False when ``within`` seconds are over before."""
        return self._board._driver.until(lambda: not self.held, within)

    def command(self, value: Any, valid: float | None = None, resource: str | None = None) -> None:
        """Commands a resource. valid: seconds it is good for; None: until it is lost.

        While the connection is away nothing is commanded, now or later, and nothing
        raised: authority is lost with it (``held``) and comes back by itself.
        resource: which one; may be left out where only one was asked for.
        """
        self._board._ask(lambda dialog: dialog.command(self._named(resource), value, valid))
