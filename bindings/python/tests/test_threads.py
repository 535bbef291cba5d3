"""Work is done without Python's lock, and forms are shared between threads and processes."""

import multiprocessing
import os
import signal
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import pforms as pf


def lets_others_run(work, seconds):
    """Does another thread get the lock while this one calls again and again?"""
    ran, stop = threading.Event(), threading.Event()

    def run():
        while not stop.is_set():
            ran.set()
            time.sleep(0.0001)

    thread = threading.Thread(target=run)
    before = sys.getswitchinterval()
    # No thread is interrupted for so long: the lock is had only by those it is given to.
    sys.setswitchinterval(1000)
    try:
        thread.start()
        ran.wait()
        ran.clear()
        end = time.monotonic() + seconds
        while not ran.is_set() and time.monotonic() < end:
            work()
        return ran.is_set()
    finally:
        stop.set()
        sys.setswitchinterval(before)
        thread.join()


def test_the_lock_is_released(make):
    form = make(8, 8)
    t = np.linspace(0, 1, 300)
    # The machine may be busy with something else when the lock is free.
    for work in (
        lambda: form.grid(t, t),
        lambda: form.normals(t[:, None], t),
        lambda: form.subdivide(5),
    ):
        assert lets_others_run(work, 60)


def test_small_calls_keep_the_lock(make):
    form = make(2)
    assert not lets_others_run(lambda: form(0.5), 0.2)
    assert not lets_others_run(lambda: form.elevate(1), 0.2)


def test_threads_share_forms(make):
    form = make(4, 4)
    t = np.linspace(0, 1, 200)
    expected = form.grid(t, t)
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: form.grid(t, t), range(16)))
    for result in results:
        np.testing.assert_array_equal(result, expected)


def test_processes_receive_forms(make):
    form = make(3, 3)
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(pf.elevate, (form, 1)) == form.elevate(1)


def test_evaluation_does_not_slow_down_over_time(make):
    # A leak of references or arrays would show here.
    form = make(4, 4)
    t = np.linspace(0, 1, 50)
    begin = sys.getrefcount(form)
    start = time.perf_counter()
    for _ in range(300):
        form(t[:, None], t)
    assert sys.getrefcount(form) == begin
    assert time.perf_counter() - start < 30


@pytest.mark.skipif(sys.platform == "win32", reason="there are no timers that signal")
@pytest.mark.parametrize(
    "work",
    [
        lambda t: curve().frame(t, kind="rotation-minimising"),
        lambda t: curve().frame(t),
        lambda t: surface()(t, t),
        lambda t: surface().grid(2, np.resize(t, 10**7)),
        lambda t: surface().normals(t, t),
        lambda t: surface().evaluate(t, t, derivative=(2, 2)),
        lambda t: surface().subdivide(2)(t, t),
    ],
)
def test_long_work_is_interrupted(work):
    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    start = time.monotonic()
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.1)
        with pytest.raises(KeyboardInterrupt):
            again_and_again(work)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    # A fraction of a second on a machine that has nothing else to do.
    assert time.monotonic() - start < 5


@pytest.mark.skipif(sys.platform == "win32", reason="there are no timers that signal")
def test_one_long_call_is_interrupted():
    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    start = time.monotonic()
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.1)
        ball = pf.sphere(1)
        with pytest.raises(KeyboardInterrupt):
            pf.common(ball, pf.translate(ball, (1, 0, 0)), accuracy=1e-4)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - start < 5


def again_and_again(work):
    t = np.linspace(0, 1, 10**6)
    while True:
        work(t)


def curve():
    return pf.Form(np.random.default_rng(1).uniform(-1, 1, (30, 3)))


def surface():
    return pf.Form(np.random.default_rng(1).uniform(-1, 1, (20, 20, 3)))


@pytest.fixture
def threads():
    """Leaves the number of threads as it was."""
    yield
    pf.set_threads(None)


@pytest.mark.usefixtures("threads")
def test_threads_can_be_limited_and_leave_no_trace():
    pf.set_threads(1)
    assert pf.threads() == 1
    t = np.linspace(0, 1, 700)
    table = np.random.default_rng(1).uniform(0, 1, (300_000, 2))
    lazy = pf.immerse(pf.Form([[(0, 0), (0, 1)], [(1, 0), (1, 1)]]), surface(), lazy=True)
    work = (
        lambda: surface().grid(t, t),
        lambda: surface()(*table.T),
        lambda: surface()(*np.ascontiguousarray(table.T)),
        lambda: surface().normals(*table.T),
        lambda: lazy(*table[:2000].T),
    )
    alone = [job() for job in work]
    pf.set_threads(None)
    assert pf.threads() >= 1
    most = pf.threads()
    pf.set_threads(10_000)
    assert pf.threads() == most
    for job, expected in zip(work, alone, strict=True):
        np.testing.assert_array_equal(job(), expected)


@pytest.mark.parametrize(
    ("count", "error"),
    [(0, pf.DomainError), (-1, pf.DomainError), (1.5, pf.DomainError), ("all", pf.ArgumentError)],
)
def test_a_number_of_threads_is_whole(count, error):
    with pytest.raises(error, match="^count: received"):
        pf.set_threads(count)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_forked_process_has_threads_of_its_own():
    t = np.linspace(0, 1, 700)
    expected = surface().grid(t, t)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        np.testing.assert_array_equal(pool.apply(pf.grid, (surface(), t, t)), expected)
