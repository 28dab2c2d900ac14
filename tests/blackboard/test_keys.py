"""Key files, and ``situ keys`` (docs/security.md)."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from situ.blackboard import keys
from situ.blackboard.client import person
from situ.blackboard.curve import Curve
from situ.blackboard.identity import ROBOT, Identity, KeyRole
from situ.blackboard.keys import KnownKey, RobotKey, RobotKeys
from situ.blackboard.link import reachable
from situ.cli import main
from situ.errors import UsageError

LAB = Path(__file__).parent / "lab"
AT = "tcp://10.0.0.5:5570"


def let_in(folder: Path, name: str, role: KeyRole = "module", *write: str) -> keys.KeyPair:
    pair = keys.new_pair(name)
    keys.add_known(folder, name, KnownKey(pair.public, role, write))
    return pair


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """The folder of a robot that knows nobody yet."""
    keys.new_robot(tmp_path / "keys")
    return tmp_path / "keys"


# -- the robot's -------------------------------------------------------------


def test_a_robot_knows_itself_and_whom_it_was_told_of(robot: Path) -> None:
    face, ann = let_in(robot, "face", "module", "face.*"), let_in(robot, "ann", "operator")
    own = RobotKeys(robot)
    assert own.identity(face.public) == Identity("face", "module", ("face.*",))
    assert own.identity(ann.public) == Identity("ann", "operator")
    assert own.identity(own.public.decode()) == Identity(ROBOT, "service")
    assert own.identity(keys.new_pair("bob").public) is None


def test_secrets_are_for_their_owner_only(robot: Path) -> None:
    assert (robot / "secret.toml").stat().st_mode & 0o777 == 0o600
    assert robot.stat().st_mode & 0o777 == 0o700
    (robot / "secret.toml").chmod(0o640)
    with pytest.raises(UsageError, match="others can read this secret key; chmod 600"):
        RobotKeys(robot)


def test_keys_are_never_overwritten(robot: Path) -> None:
    before = (robot / "secret.toml").read_bytes()
    with pytest.raises(UsageError, match="there are keys already"):
        keys.new_robot(robot)
    assert (robot / "secret.toml").read_bytes() == before
    let_in(robot, "face")
    with pytest.raises(UsageError, match="known already"):
        let_in(robot, "face")


def test_who_is_added_changed_or_removed_counts_after_a_refresh(robot: Path) -> None:
    own = RobotKeys(robot)
    face = let_in(robot, "face")
    assert own.identity(face.public) is None
    assert not own.refresh()
    assert own.identity(face.public) == Identity("face", "module")
    file = robot / "known" / "face.toml"
    new = file.with_suffix(".new")
    new.write_text(file.read_text("utf-8") + 'write = ["face.*"]\n', "utf-8")
    new.replace(file)
    assert not own.refresh()
    assert own.identity(face.public) == Identity("face", "module", ("face.*",))
    keys.remove_known(robot, "face")
    assert own.refresh()
    assert own.identity(face.public) is None


def test_while_a_file_is_wrong_who_is_known_stays_as_it_was(
    robot: Path, caplog: pytest.LogCaptureFixture
) -> None:
    face = let_in(robot, "face")
    own = RobotKeys(robot)
    (robot / "known" / "ann.toml").write_text("role =", "utf-8")
    own.refresh()
    assert own.identity(face.public) is not None
    assert "ann.toml: no file of keys" in caplog.text
    (robot / "known" / "ann.toml").unlink()
    shutil.copy(robot / "known" / "face.toml", robot / "known" / "a.toml")
    keys.remove_known(robot, "face")
    shutil.copy(robot / "known" / "a.toml", robot / "known" / "b.toml")
    own.refresh()
    assert own.identity(face.public) == Identity("face", "module")
    assert "have the same key" in caplog.text
    with pytest.raises(UsageError, match="have the same key"):
        RobotKeys(robot)


@pytest.mark.parametrize(
    ("name", "content", "why"),
    [
        ("face", 'public = "{key}"\nrole = "boss"\n', "boss"),
        ("face", 'public = "{key}"\nrole = "module"\nwrites = ["a"]\n', "writes"),
        ("face", 'public = "short"\nrole = "module"\n', "no key"),
        ("face", 'public = "{key}"\nrole = "module"\nwrite = ["robot/*"]\n', "can be given"),
        ("face", 'public = "{key}"\nrole = "module"\nwrite = ["Face"]\n', "can be given"),
        ("ann", 'public = "{key}"\nrole = "operator"\nwrite = ["a"]\n', "for modules"),
        ("robot", 'public = "{key}"\nrole = "viewer"\n', "nobody's name"),
        ("a.b", 'public = "{key}"\nrole = "viewer"\n', "nobody's name"),
    ],
)
def test_a_file_that_is_wrong_is_told_with_its_path(
    robot: Path, name: str, content: str, why: str
) -> None:
    file = robot / "known" / f"{name}.toml"
    file.write_text(content.replace("{key}", keys.new_pair("x").public), "utf-8")
    with pytest.raises(UsageError, match=why) as wrong:
        RobotKeys(robot)
    assert str(file) in str(wrong.value)
    assert "\n" not in str(wrong.value)


def test_one_key_is_one_persons(robot: Path) -> None:
    face = let_in(robot, "face")
    with pytest.raises(UsageError, match="face has this key already"):
        keys.add_known(robot, "ann", KnownKey(face.public, "operator"))
    shutil.copy(robot / "known" / "face.toml", robot / "known" / "twin.toml")
    with pytest.raises(UsageError, match="the same key"):
        RobotKeys(robot)


def test_a_token_gives_keys_and_the_robot_keeps_only_the_public_one(robot: Path) -> None:
    public, secret = keys.token_keys("open sesame")
    keys.add_known(robot, "web", KnownKey(public.decode(), "viewer", door=True))
    own = RobotKeys(robot)
    assert own.door("open sesame") == Curve(public, secret, own.public, "web")
    assert own.door("open sesam") is None
    assert "sesame" not in (robot / "known" / "web.toml").read_text("utf-8")


# -- a client's --------------------------------------------------------------


@pytest.fixture
def mine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where a person's keys lie by default."""
    monkeypatch.delenv("SITU_KEYS", raising=False)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    return tmp_path / "config" / "situ" / "keys"


def make(folder: Path, *addresses: str) -> RobotKey:
    key = RobotKey(keys.new_pair("r").public, addresses)
    keys.new_client(folder, keys.new_pair("ann"), "lab", key)
    return key


def test_a_robot_that_is_known_is_asked_with_its_key(mine: Path) -> None:
    key = make(mine, AT, "tcp://127.0.0.1:5570")
    for address in key.addresses:
        found = keys.client_keys(address)
        assert found is not None
        assert (found.robot.decode(), found.name) == (key.public, "ann")


def test_one_that_is_not_known_is_asked_without_keys(mine: Path) -> None:
    assert keys.client_keys(AT) is None
    make(mine, AT)
    assert keys.client_keys("tcp://10.0.0.6:5570") is None


def test_a_folder_that_was_told_must_have_keys(
    mine: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(UsageError, match="no robot there is asked at"):
        keys.client_keys(AT, tmp_path / "none")
    monkeypatch.setenv("SITU_KEYS", str(tmp_path / "none"))
    with pytest.raises(UsageError, match="no robot there is asked at"):
        keys.client_keys(AT)


def test_the_only_robot_of_a_folder_that_was_told_may_have_another_address(tmp_path: Path) -> None:
    key = make(tmp_path, AT)
    found = keys.client_keys("tcp://robot.local:5570", tmp_path)
    assert found is not None
    assert found.robot.decode() == key.public
    other = tmp_path / "robots" / "other.toml"
    other.write_text((tmp_path / "robots" / "lab.toml").read_text("utf-8").replace("5", "6"))
    with pytest.raises(UsageError, match=r"only at tcp://10\.0\.0\.5:5570"):
        keys.client_keys("tcp://robot.local:5570", tmp_path)


def test_who_is_known_as_a_viewer_connects_as_one_unless_he_says_otherwise(mine: Path) -> None:
    key = RobotKey(keys.new_pair("r").public, (AT,), "viewer")
    keys.new_client(mine, keys.new_pair("tablet"), "lab", key)
    found = keys.client_keys(AT)
    assert person(keys=found).role == "viewer"
    assert person(role="operator", keys=found).role == "operator"
    assert person().role == "operator"


def test_a_clients_secret_is_for_its_owner_only(mine: Path) -> None:
    make(mine, AT)
    (mine / "secret.toml").chmod(0o604)
    with pytest.raises(UsageError, match="chmod 600"):
        keys.client_keys(AT)


@pytest.mark.parametrize(
    ("told", "endpoint", "address"),
    [
        ("tcp://0.0.0.0:5571", "tcp://10.0.0.5:5570", "tcp://10.0.0.5:5571"),
        ("tcp://[::]:5571", "tcp://[fe80::1]:5570", "tcp://[fe80::1]:5571"),
        ("tcp://0.0.0.0:5571", "tcp://robot.local:5570", "tcp://robot.local:5571"),
        ("tcp://10.0.0.5:5571", "tcp://robot.local:5570", "tcp://10.0.0.5:5571"),
        ("ipc:///run/situ/n", "tcp://robot.local:5570", "ipc:///run/situ/n"),
        ("tcp://0.0.0.0:5571", "ipc:///run/situ/r", "tcp://0.0.0.0:5571"),
    ],
)
def test_a_robot_bound_to_all_its_addresses_is_heard_where_it_is_asked(
    told: str, endpoint: str, address: str
) -> None:
    assert reachable(told, endpoint) == address


# -- the command -------------------------------------------------------------


def situ(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    status = main(["keys", *arguments])
    said = capsys.readouterr()
    assert status == 0, said.err
    return said.out


def test_a_robot_and_a_person_are_set_up(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    state, folder = tmp_path / "state", tmp_path / "ann"
    where = ("--project", str(LAB), "--state", str(state))
    situ(capsys, "new", *where)
    added = situ(
        *(capsys, "add", "ann", "--role", "operator", "--to", str(folder), *where),
        *("--robot", AT, "--json"),
    )
    assert json.loads(added)["name"] == "ann"
    found = keys.client_keys(AT, folder)
    own = RobotKeys(state / "keys")
    assert found is not None
    assert (found.robot, found.role) == (own.public, "operator")
    assert own.identity(found.public.decode()) == Identity("ann", "operator")
    listed = json.loads(situ(capsys, "list", *where, "--json"))
    assert [(one["name"], one["role"]) for one in listed["known"]] == [("ann", "operator")]
    assert listed["robot"] == own.public.decode()
    assert "ann  operator" in situ(capsys, "list", *where)
    situ(capsys, "remove", "ann", *where)
    assert json.loads(situ(capsys, "list", *where, "--json"))["known"] == []
    assert main(["keys", "remove", "ann", *where]) == 2
    assert "nobody there is named ann" in capsys.readouterr().err


def test_a_key_that_was_made_elsewhere_is_let_in(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    public = keys.new_pair("nod").public
    said = situ(
        *(capsys, "add", "nod", "--role", "module", "--write", "head.*", "--public", public),
        *("--keys", str(robot)),
    )
    own = RobotKeys(robot)
    assert own.identity(public) == Identity("nod", "module", ("head.*",))
    assert own.public.decode() in said


def test_a_token_is_told_once(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    where = ("--keys", str(robot))
    said = situ(capsys, "add", "web", "--role", "viewer", "--token", *where, "--json")
    token = json.loads(said)["token"]
    own = RobotKeys(robot)
    door = own.door(token)
    assert door is not None
    assert door.name == "web"
    assert token not in situ(capsys, "list", *where, "--json")


def test_what_is_wrong_makes_no_folder(
    robot: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "out"
    arguments = ["keys", "add", "a.b", "--role", "viewer", "--to", str(folder)]
    assert main([*arguments, "--keys", str(robot), "--robot", AT]) == 2
    assert "nobody's name" in capsys.readouterr().err
    assert not folder.exists()


def test_without_a_robots_keys_nobody_is_added(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["keys", "add", "ann", "--role", "viewer", "--keys", str(tmp_path)]) == 2
    assert "situ keys new" in capsys.readouterr().err


def test_a_lab_is_set_up_in_one_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "lab"
    people = ("chase", "ann:operator")
    situ(capsys, "lab", str(out), *people, "--project", str(LAB), "--robot", AT)
    own = RobotKeys(out / "robot")
    roles: dict[str, KeyRole] = {"chase": "module", "ann": "operator"}
    for name, role in roles.items():
        found = keys.client_keys(AT, out / name)
        assert found is not None
        assert (found.robot, found.role) == (own.public, role)
        assert own.identity(found.public.decode()) == Identity(name, role)
    assert main(["keys", "lab", str(out), "--project", str(LAB)]) == 2
    assert "there is something already" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        "OUT chase ann:operator --project LAB --robot AT",
        "OUT --robot AT chase ann:operator --project LAB",
        "--project LAB --robot AT OUT chase ann:operator",
        "OUT chase --robot AT ann:operator --project LAB",
    ],
)
def test_names_stand_before_and_after_options(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], words: str
) -> None:
    meant = {"OUT": str(tmp_path / "out"), "LAB": str(LAB), "AT": AT}
    situ(capsys, "lab", *(meant.get(word, word) for word in words.split()))
    assert set(keys.read_known(tmp_path / "out" / "robot")) == {"chase", "ann"}
    assert keys.client_keys(AT, tmp_path / "out" / "ann") is not None


@pytest.mark.parametrize(
    ("given", "why"),
    [
        ("--robot here", "an address is needed"),
        ("chase a.b:viewer", "nobody's name"),
        ("bob", "say its role"),
        ("bob:boss", "there is no role 'boss'"),
        ("chase:", "no role ''"),
        ("chase chase", "twice"),
    ],
)
def test_a_lab_is_asked_for_right(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], given: str, why: str
) -> None:
    assert main(["keys", "lab", str(tmp_path / "lab"), *given.split(), "--project", str(LAB)]) == 2
    assert why in capsys.readouterr().err
    assert not (tmp_path / "lab").exists()
