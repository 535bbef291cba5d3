"""Work is done without Python's lock, and forms are shared between threads and processes."""

import multiprocessing
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import pforms as pf


def counted_during(work):
    """How far another thread counts while this one works, and how long that took."""
    count, stop, started = [0], threading.Event(), threading.Event()

    def count_up():
        started.set()
        while not stop.is_set():
            count[0] += 1

    thread = threading.Thread(target=count_up)
    before = sys.getswitchinterval()
    # Long enough for the lines around the work: without a release the counter stands still.
    sys.setswitchinterval(0.1)
    try:
        thread.start()
        started.wait()
        count[0] = 0
        work()
        return count[0]
    finally:
        stop.set()
        sys.setswitchinterval(before)
        thread.join()


def test_the_lock_is_released(make):
    form = make(8, 8)
    t = np.linspace(0, 1, 500)
    assert counted_during(lambda: form.grid(t, t)) > 100
    assert counted_during(lambda: form.subdivide(5)) > 100


def test_small_calls_keep_the_lock(make):
    form = make(2)
    assert counted_during(lambda: form(0.5)) < 100


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
