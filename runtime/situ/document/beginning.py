"""A project to start from: a template of ``resources/templates``, under a name of its own.

A template is a whole project that is called ``newproject``, in its files and in their names. It is
English; its ``texts/LANG.po`` has what it says, shows and notes in another language, and its names
(the context ``name``): a project begun in that language has these in their place, and no .po.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
import unicodedata
from html import escape
from pathlib import Path

from situ.document import catalogue
from situ.document.beside import language_of, texts_file
from situ.document.folder import load
from situ.errors import UsageError

PLACEHOLDER = "newproject"
ENGLISH = "en"
NAME = "name"
"""The context (``msgctxt``) of what is a name in a template: of a state, of a situation."""

_NAME = re.compile(r"[a-z][a-z0-9_-]*")


def project_name(title: str) -> str:
    """A project's name for what a person typed: ``robot-nurse-2`` for ``Robot nurse 2``.

    What they typed itself where nothing in it fits into a name.
    """
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode().lower()
    made = re.sub(r"[^a-z0-9_]+", "-", plain).strip("-_")
    made = re.sub(r"^[^a-z]+", "", made)
    return made or title


def languages(template: Path) -> list[str]:
    """The codes of the languages in which a project can be begun from a template, English first."""
    others = (language_of(f"texts/{file.name}") for file in template.glob("texts/*.po"))
    return [ENGLISH, *sorted(one for one in others if one is not None)]


def begin(template: Path, target: Path, name: str, language: str = ENGLISH) -> None:
    """Makes the folder ``target`` from a template; its application is called ``name``, and
    ``language`` is the one in which the project is written.

    All of it, or nothing. Raises UsageError where the name is none or is that of a module of the
    template, where the template has no texts in the language, where the folder holds anything, and
    where it can not be made.
    """
    if not _NAME.fullmatch(name):
        raise UsageError(
            f"{name!r} is no name for a project: use small letters, digits, - and _, a letter first"
        )
    if name in _modules(template):
        raise UsageError(f"{name} is a module of this template: give the project another name")
    known = languages(template)
    if language not in known:
        raise UsageError(
            f"this template has no texts in {language!r}; it has them in: {', '.join(known)}"
        )
    try:
        if os.path.lexists(target) and (not target.is_dir() or any(target.iterdir())):
            raise UsageError(f"{target}: is there already and not empty; name a new folder")
        parent = target.absolute().parent
        parent.mkdir(parents=True, exist_ok=True)
        whole = Path(tempfile.mkdtemp(prefix=".new.", dir=parent))
        try:
            _copy(template, whole, name, language)
            target.mkdir(exist_ok=True)
            # The folder itself stays: somebody may be working in it.
            for entry in whole.iterdir():
                entry.rename(target / entry.name)
        finally:
            shutil.rmtree(whole)
    except OSError as error:
        raise UsageError(f"{target}: can not be made: {error.strerror or error}") from error


def _copy(template: Path, target: Path, name: str, language: str) -> None:
    # The project's own name last: it may be a word of the template.
    instead = {**_in_language(template, language), PLACEHOLDER: name}
    for file in sorted(one for one in template.rglob("*") if one.is_file()):
        path = str(file.relative_to(template))
        if language_of(path) is not None:
            continue
        place = target / path.replace(PLACEHOLDER, name)
        place.parent.mkdir(parents=True, exist_ok=True)
        # A picture is no text.
        data = file.read_bytes()
        for old, new in instead.items():
            data = data.replace(old.encode(), new.encode())
        place.write_bytes(data)


def _in_language(template: Path, language: str) -> dict[str, str]:
    """What stands in the files of a template to what does in a project in this language: whole
    texts, comments and names with what is round them, and the language itself.
    """
    if language == ENGLISH:
        return {}
    file = texts_file(language)
    found, problems = catalogue.read((template / file).read_bytes(), file)
    if found is None:
        raise UsageError(str(problems[0]))
    instead = {f'languages = ["{ENGLISH}"]': f'languages = ["{language}"]'}
    for one in found.translations:
        forms = ('"{}"',) if one.context == NAME else (">{}<", "<!-- {} -->", '"text":"{}"')
        text, said = (escape(each, quote=False) for each in (one.text, one.said))
        instead |= {form.format(text): form.format(said) for form in forms}
    return instead


def _modules(template: Path) -> set[str]:
    project, _ = load(template)
    declared = [] if project is None else [project.spds, project.modules]
    return {one.name for part in declared if part is not None for one in part.modules}
