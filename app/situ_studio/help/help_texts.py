"""What the help says beside the tables: its pages, and a sentence for each command and panel.

Kinds, fields and most commands explain themselves where they stand in their tables; ``help_topics``
joins all. Texts are shown through ``helped``; packaging/texts.py gathers them for translators.
"""

from __future__ import annotations

from msgspec import Struct
from PySide6.QtCore import QCoreApplication

from situ_studio.actions import Command


class Page(Struct, frozen=True):
    """A page of the help. text: its paragraphs, divided by empty lines.

    about: the topics that it explains, as ``help_topics`` calls them.
    """

    id: str
    title: str
    text: str
    about: tuple[str, ...]

    @property
    def paragraphs(self) -> tuple[str, ...]:
        """Each in one line, as translators get it."""
        return tuple(" ".join(part.split()) for part in self.text.split("\n\n"))


class Panel(Struct, frozen=True):
    """One panel of the window, or one item of the status bar."""

    title: str
    text: str


def helped(text: str) -> str:
    """A text of this file in the user's language."""
    return QCoreApplication.translate("help", text) if text else ""


def explained(command: Command) -> str:
    """What a command does, in a sentence."""
    tip = QCoreApplication.translate("actions", command.tip) if command.tip else ""
    return tip or helped(COMMANDS.get(command.id, ""))


PAGES: tuple[Page, ...] = (
    Page(
        "first",
        "First steps",
        """
        A project is a folder. Its applications say what the robot shows, says and waits
        for; its script says which of the robot's modules may move it in which situation.

        Begin with an example or a template from the welcome page: a copy is made, so
        nothing can be spoilt. Click a card and look at its form at the right. Change a
        text, press Enter, and take it back with Ctrl+Z: every change is one step with a
        name, and all of them can be undone.

        What stops the robot from doing what you mean is listed under Problems while you
        draw. Save with Ctrl+S; what you have not saved yet is kept aside, and offered again
        after a crash.

        The tutorial (Help, Tutorial) draws a robot that measures the blood pressure from
        nothing in a quarter of an hour.
        """,
        (
            "panel/project", "panel/problems", "command/welcome", "command/save",
            "command/undo", "command/tutorial",
        ),
    ),
    Page(
        "application",
        "States and what leads on",
        """
        An application is a graph of states. In a state the robot shows a screen, does its
        actions from first to last, and waits for an event: a touch, a spoken answer, a
        message, the end of an action, or a timeout.

        The first expected event that fits is taken. It may depend on a condition, do
        actions on the way, and lead to another state, back to the one before (#back), or
        into the same one anew (#again). Without a target the state stays.

        Drag from the dot at the right of a card to another card to lead there, or to the
        empty ground for a new state. Drop a card on an arrow to put it between. “In every
        state” holds what is part of all of them, such as a Home button.

        States that belong together can become a part: an application of its own that one
        state runs. A double click goes into it.
        """,
        (
            "kind/application", "kind/state", "kind/event", "kind/timeout",
            "kind/always", "kind/part", "kind/note", "kind/frame",
            "command/lead_to", "command/part.make",
        ),
    ),
    Page(
        "screen",
        "Screens",
        """
        What a state shows is drawn to scale on the robot's screen: texts, buttons, images,
        movies, fields to type into, and lists. A state without a screen keeps the one that
        was shown before.

        Places and sizes are in percent, so that a screen fits every display. Components
        snap to the grid and to each other; hold Alt to place them freely. Later ones lie in
        front of earlier ones.

        A tag in braces, such as {user.name}, shows a value of the blackboard and follows
        its changes. A touch on a button raises its event, for which the state must wait.
        Keep buttons at least 12 mm high: people with unsteady hands have to hit them.
        """,
        (
            "kind/screen", "kind/text", "kind/button", "kind/image", "kind/movie",
            "kind/input", "kind/list",
        ),
    ),
    Page(
        "actions",
        "What the robot says and does",
        """
        Actions are done when a state is entered, or on the way to another one. They start
        from first to last without waiting for each other, unless “Wait for it” is on.

        Speech and movement can end well or badly; give the names of the events that are
        raised then, and let the state expect them. When a state is left, what it still says
        or moves is stopped.

        Other actions write to the blackboard: set a value, add to a number, append to a
        list, take from one. Services ask a web address, a module or a file, and keep the
        answer. Launch begins another application.
        """,
        (
            "kind/speech", "kind/robot", "kind/sound", "kind/service",
            "kind/message", "kind/launch", "kind/set", "kind/add", "kind/append",
            "kind/take", "kind/clear", "kind/repeat",
        ),
    ),
    Page(
        "conditions",
        "Values and conditions",
        """
        The blackboard holds what is known: each value stands at a tag, such as user.name or
        sound.loud. Modules, services, touches and actions write there; screens, speech and
        conditions read.

        A condition is one test, or a group of which all, any or none must hold. A test that
        has no value to look at does not hold; “exists” asks just that. Take care with “is
        not”: it does not hold either while there is no value.

        In a script a test can look at time too. “Within” holds while the value was set less
        than so many seconds ago; “for” holds once it has been so without a break.
        """,
        (
            "kind/condition", "kind/data", "panel/blackboard",
        ),
    ),
    Page(
        "script",
        "Situations and priorities",
        """
        A script decides who may move the robot. Data is looked at by conditions; the first
        situation from the top whose conditions hold is the current one; it gives each
        module a priority. Of the modules that ask for the same part of the robot, the one
        with the highest priority gets it.

        A situation may take over another one's priorities and change some. A module without
        a priority gets nothing in that situation. The last situation has no conditions, so
        that there always is one.

        “Stays” keeps a situation for a while, so that the robot is not fickle; “Until”
        keeps it until something holds; “Ends” ends it at the latest then.

        The same script can be seen as a drawing or as a matrix of situations and modules.
        Give the robot a situation that stops it, and put it first.
        """,
        (
            "kind/script", "kind/situation", "kind/entry", "kind/module",
            "kind/data", "kind/condition", "kind/information", "panel/authority",
        ),
    ),
    Page(
        "problems",
        "Problems and how to mend them",
        """
        While you draw, the project is looked through. An error is something that can not
        work: a transition to nowhere, two states with one number, an unknown module. A
        warning is something that is probably not meant: a state that can not be reached, a
        button that nobody waits for, a speech longer than its timeout.

        Click a problem to go there; F8 goes from one to the next. Where a mend is offered,
        one click does it, and undo takes it back. The form of what is wrong says it again
        above its fields.

        The menu of a problem, and Ctrl+. for what is selected, mend all of a kind at once, or
        accept a warning that you know and mean: it is told no more.

        A file with errors that could not be read whole is shown, but not changed, until the
        errors are mended: else what they name would be lost.
        """,
        (
            "panel/problems", "status/errors", "status/warnings",
            "command/next_problem", "command/mend",
        ),
    ),
    Page(
        "live",
        "Following a robot",
        """
        Connect to a robot by its address. Its state and its situation glow in the drawings,
        and the tables below the canvas show what is on the blackboard, who holds which part
        of the robot, and what happened.

        The status bar says honestly what is seen: “no robot”, how far behind the picture
        is, or for how long nothing has been heard. What is shown after a robot was lost is
        old, and is shown as old.

        Why? (F7, and the menus of cards, arrows and rows) shows what led to it: one event a
        row, from the input that began it, with the values then. A click on a row goes to that
        moment and to the card.

        Why not? (Shift+F7) shows what kept it from happening at the moment that is seen: an
        input that did not come, a condition or a guard, a priority, a suspension.

        Following changes nothing on the robot. Where its documents differ from yours, that
        is told, since the drawing may not be what the robot does.

        Deploy has the robot run what is open here, from its next safe point on. What it will
        do differently is told before in words. If it fails in its first minute the robot goes
        back by itself; Roll back does so at any time.

        The drawing moves along with the robot (Follow where it is). On a card stands how often
        it came there, how long it stayed, and behind the clock how often the time ran out
        before anybody went on.

        An operator may do more: a breakpoint (F9) pauses an application at a state, before a
        transition, or in a situation, with a condition (Shift+F9) only while that holds; what
        was set in a project is offered to the next robot. Step does the next thing that waits;
        an event is raised, a value set, the robot sent to a state. Who did it stands in the
        trace.

        Compare, in the timeline, puts another recording below the run that is shown. F4 goes
        to where they part next, and says what each robot did; when it did it does not count.
        Count recordings tells over many runs how often people came to each state, how long,
        and where they gave up: in the panel Field, and on the drawings.
        """,
        (
            "command/deploy", "command/versions", "command/operate.break",
            "command/operate.while", "panel/breakpoints", "command/follow",
            "command/connect", "panel/blackboard", "panel/authority", "panel/trace",
            "command/recording.compare", "command/recording.next_difference",
            "command/recording.count", "panel/field",
            "panel/why", "command/why", "command/why_not",
            "status/link",
        ),
    ),
    Page(
        "rehearsal",
        "Rehearsing without a robot",
        """
        Rehearse (F5) runs the project as it is drawn, here, from its start. Touch the robot's
        screen, let people say what it listens for, turn data, let modules ask: the drawings
        and tables show what comes of it, as they do with a robot.

        Speech and movements end by themselves after a while; for a service you say how it
        ended. The clock goes as fast as the one on the wall, ten times as fast, or from one
        thing that happens to the next.

        What the robot says is shown with how long it still lasts. With Sound it is heard too, at
        1 ×, where espeak-ng is installed.

        An edit does not change what runs. Take in lets it go on with the changes, by the rules of a
        deploy: at the next moment at which no action runs, from the state in which it is. What
        then goes wrong within a minute is gone back from; Go back does so at any time. Start again
        runs it from the start.

        What was done can be saved as a scenario, with what shall happen again. All of them are run
        from the panel Scenarios; what they came through can be painted on the drawings.
        """,
        ("command/rehearse", "command/rehearse.pause", "command/rehearse.step",
         "command/rehearse.take", "command/rehearse.back", "command/rehearse.save",
         "command/rehearse.end", "command/scenarios.run",
         "panel/rehearsal", "panel/scenarios"),
    ),
    Page(
        "window",
        "Panels, keys and finding things",
        """
        Panels are dragged by their headings: to another side, or out of the window. The
        right button on a heading closes them; View, Panels brings them back, and Reset
        layout puts all where they were.

        Everything works without a mouse. F6 goes from panel to panel, Tab from field to
        field, arrows from card to card; letters go to the card whose name begins so; Enter
        renames. The outline has all that the drawing has, as rows for the keyboard and for
        screen readers.

        Ctrl+K finds any command, state or situation by a few letters, Ctrl+F every text of
        the project. F1 explains what you are at; Shift+F1 explains what you click next.
        Keys are changed in the preferences.
        """,
        (
            "panel/palette", "panel/inspector", "panel/outline", "command/find",
            "command/find_in_project", "command/preferences",
            "command/reset_layout",
        ),
    ),
)  # fmt: skip

COMMANDS: dict[str, str] = {
    "new": "An empty project in a folder of its own.",
    "new_window": "Another window, for another project.",
    "open": "Shows the project of a folder.",
    "welcome": "Examples, templates and the projects of before; this one stays open.",
    "save": "Writes all that was changed into the project's files.",
    "print": "Shows the drawing as it comes on paper, on one page or several.",
    "close_tab": "The document stays in the project.",
    "reopen_tab": "Shows the document again that was closed last.",
    "close_window": "Asks first where something is not saved.",
    "quit": "Closes all windows; asks first where something is not saved.",
    "undo": "Takes the last change back, also after saving.",
    "redo": "Does again what was taken back.",
    "cut": "Takes what is selected away and keeps it to be pasted.",
    "copy": "Keeps what is selected to be pasted, in other projects too.",
    "paste": "Puts in what was cut or copied; numbers and names that are taken become new ones.",
    "duplicate": "Puts another one of what is selected beside it.",
    "delete": "Takes what is selected away, with the arrows that lead there.",
    "rename": "Another name for what is selected, in its place.",
    "select_all": "Selects all cards.",
    "find": "A few letters of a command, state or situation are enough.",
    "find_next": "Goes to the next place that was found.",
    "find_previous": "Goes to the place before that was found.",
    "find_here": "Only the rows of the outline in which a word stands.",
    "view.graph": "Cards and arrows.",
    "view.outline": "The same as rows of a table, for keyboard and screen reader.",
    "zoom_in": "Everything larger.",
    "zoom_out": "Everything smaller.",
    "zoom_100": "Cards as large as they are drawn.",
    "zoom_fit": "The whole drawing at once.",
    "zoom_selection": "What is selected as large as there is room for.",
    "go_start": "Selects the state in which the application starts.",
    "go_target": "Selects the state to which the selected transition leads.",
    "next_exit": "Selects the next one, without the mouse.",
    "previous_exit": "Selects the one before, without the mouse.",
    "next_problem": "Goes where the next problem is.",
    "previous_problem": "Goes where the problem before is.",
    "next_tab": "The document of the tab at the right.",
    "previous_tab": "The document of the tab at the left.",
    "context_menu": "The menu that the right button opens.",
    "part.leave": "Shows the application again in which the part is used.",
    "theme.system": "Light or dark, as the computer is set.",
    "theme.light": "Dark letters on light ground.",
    "theme.dark": "Light letters on dark ground.",
    "language.system": "The computer's language, if the studio speaks it.",
    "language.en": "The studio speaks English.",
    "language.ja": "The studio speaks Japanese.",
    "letters.system": "Letters are as large as the computer's others.",
    "letters.80": "The smallest letters: more has room.",
    "letters.90": "Smaller letters: more has room.",
    "letters.100": "Letters of the usual size.",
    "letters.110": "Larger letters; drawings are made larger by zooming.",
    "letters.125": "Much larger letters; drawings are made larger by zooming.",
    "letters.150": "The largest letters; drawings are made larger by zooming.",
    "next_panel": "Takes the keyboard to the next panel.",
    "previous_panel": "Takes the keyboard to the panel before.",
    "connect_states": "Each of the selected states leads to the next.",
    "mark_start": "The application starts in the selected state.",
    "align.left": "The left edges come to stand below each other.",
    "align.center": "The middles come to stand below each other.",
    "align.right": "The right edges come to stand below each other.",
    "align.top": "The upper edges come to stand at one height.",
    "align.middle": "The middles come to stand at one height.",
    "align.bottom": "The lower edges come to stand at one height.",
    "distribute.across": "The gaps from left to right become equal.",
    "distribute.down": "The gaps from top to bottom become equal.",
    "order.front": "Before all other components of the screen.",
    "order.forward": "Before the next component.",
    "order.backward": "Behind the next component.",
    "order.back": "Behind all other components of the screen.",
    "disconnect": "The robot goes on; it is followed no more.",
    "help": "Explains what is selected, or where the keyboard is.",
    "shortcuts": "All keys in a list that can be searched.",
    "about": "Which version of the studio this is.",
}
"""Of those that have no tip in the table of commands."""

PANELS: dict[str, Panel] = {
    "panel/project": Panel(
        "Project", "The documents of the project and its media. A click shows one in a tab."
    ),
    "panel/outline": Panel(
        "Outline", "What the shown document has, in its order. A click selects it everywhere."
    ),
    "panel/palette": Panel(
        "Palette",
        "What can be added. Drag it onto the drawing, or press it to add it at the selection.",
    ),
    "panel/inspector": Panel(
        "Inspector", "The form of what is selected. Enter ends a field."
    ),
    "panel/problems": Panel(
        "Problems",
        "What can not work, and what is probably not meant. A click goes there; a button mends it.",
    ),
    "panel/find": Panel("Find", "Every place in which a text or a name stands."),
    "panel/blackboard": Panel("Blackboard", "The values that the robot knows now, by their tags."),
    "panel/authority": Panel(
        "Authority", "Which module holds which part of the robot, who else asks, and why not they."
    ),
    "panel/breakpoints": Panel(
        "Breakpoints",
        "Where the robot pauses, and beside it while what. A click goes there, Delete takes one "
        "away.",
    ),
    "panel/field": Panel(
        "Field",
        "How often, how long, and where people gave up, counted over recordings. A click goes to "
        "the state; a head sorts.",
    ),
    "panel/trace": Panel("Trace", "What the robot did, one line each, the latest at the end."),
    "panel/why": Panel(
        "Why?", "What led to it, the input that began it first. A click on a row goes there."
    ),
    "panel/scenarios": Panel(
        "Scenarios",
        "What was done before is done again, and what shall happen is looked for. A click on what "
        "failed shows that moment in all views.",
    ),
    "panel/rehearsal": Panel(
        "Rehearsal",
        "The robot's screen, to be touched; what people say, data and modules. Nothing of it is "
        "in the documents.",
    ),
    "panel/tabs": Panel(
        "Tabs", "One for each open document; at the right, the ways in which it can be shown."
    ),
    "panel/canvas": Panel(
        "Drawing",
        "Click a card or an arrow to select it; drag the ground to select several, hold Space "
        "to move the drawing, Ctrl and wheel to zoom.",
    ),
    "panel/matrix": Panel(
        "Matrix",
        "The priority of each module in each situation. Type a number; pale ones are taken over "
        "from another situation.",
    ),
    "panel/texts": Panel("Texts", "What is spoken, shown and heard, a column for each language."),
    "panel/welcome": Panel(
        "Welcome page", "Where a project is begun or opened. Esc goes back to the one that is open."
    ),
    "status/link": Panel(
        "The robot", "Whether a robot is followed, and how old what you see of it is."
    ),
    "status/errors": Panel("Errors", "How much there is that can not work. A click shows it."),
    "status/warnings": Panel("Warnings", "How much is probably not meant. A click shows it."),
    "status/selection": Panel("Selection", "How much is selected."),
    "status/counts": Panel("Size", "How much there is in the shown document."),
    "status/saved": Panel("Saved", "Whether the project's files have all changes, and since when."),
}  # fmt: skip
"""By their topics."""
