"""Records of a ward with nobody in it, or with Jack."""

from __future__ import annotations

import pytest
from tests.vitals.ward import Clock

from ward_records.store import Resident, Store


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(clock: Clock) -> Store:
    return Store(None, clock)


@pytest.fixture
def jack(store: Store) -> Resident:
    return store.add(12, "Jack <Nilsen>", "1234")
