"""Work is done without Python's lock, and forms are shared between threads and processes."""

import multiprocessing
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import pforms as pf


def lets_others_run(work):
    """Does another thread get the lock during some of many calls?"""
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
        for _ in range(100):
            work()
            if ran.is_set():
                return True
        return False
    finally:
        stop.set()
        sys.setswitchinterval(before)
        thread.join()


def test_the_lock_is_released(make):
    form = make(8, 8)
    t = np.linspace(0, 1, 300)
    assert lets_others_run(lambda: form.grid(t, t))
    assert lets_others_run(lambda: form.normals(t[:, None], t))
    assert lets_others_run(lambda: form.subdivide(5))
    assert lets_others_run(lambda: pf.Sheet("pfs = 1\n[cells]\nA1 = '=1/2'"))


def test_small_calls_keep_the_lock(make):
    form = make(2)
    assert not lets_others_run(lambda: form(0.5))
    assert not lets_others_run(lambda: form.elevate(1))


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
