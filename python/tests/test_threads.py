"""Other threads run while the library works, and signals end it."""

import multiprocessing
import signal
import threading
import time

import numpy as np
import pytest

import limn
from conftest import cube


def big_mesh():
    V, F = cube()
    return limn.Scheme("catmull-clark").refine(V, F, 7)


def test_the_interpreter_is_free_meanwhile():
    V, F = big_mesh()
    scheme = limn.Scheme("catmull-clark")
    ticks, working = [], threading.Event()

    def tick():
        while not working.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.perf_counter()
    scheme.refine(V, F, 2, engine="plain")
    end = time.perf_counter()
    working.set()
    thread.join()
    assert end - start > 0.1
    inside = [t for t in ticks if start < t < end]
    gaps = np.diff([start, *inside, end])
    assert len(inside) > 10 and max(gaps) < 0.5 * (end - start)


def test_many_threads_give_what_one_gives():
    V, F = cube()
    refiner = limn.Refiner("catmull-clark", F, 4)
    frames = [V * (1 + i / 10) for i in range(32)]
    alone = [refiner.evaluate(frame) for frame in frames]
    together = [None] * len(frames)

    def work(first):
        for i in range(first, len(frames), 4):
            together[i] = refiner.evaluate(frames[i])
            refiner.evaluate_limit(frames[i])

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for one, other in zip(alone, together):
        assert np.array_equal(one, other)


def test_the_number_of_threads_changes_no_bit():
    V, F = cube()
    try:
        results = []
        for threads in (1, 2, 0):
            limn.set_thread_limit(threads)
            assert limn.thread_limit() == threads
            results.append(limn.Scheme("catmull-clark").refine(V, F, 6)[0])
    finally:
        limn.set_thread_limit(0)
    assert np.array_equal(results[0], results[1]) and np.array_equal(results[0], results[2])


class Alarm(Exception):
    pass


def long_calls():
    V, F = big_mesh()
    return {
        "refine": lambda: [limn.Scheme("catmull-clark").refine(V, F, 2, engine="plain") for _ in range(20)],
        "certify": lambda: limn.Scheme("butterfly").certify(range(3, 500)),
        "regularity": lambda: limn.Scheme("optimal-low").regularity(
            budget=10**6, tolerance=1e-6, seconds=None
        ),
        "tune": lambda: limn.tune("sqrt3", "alpha", "cup = tangent^2", range(3, 2000), seconds=None),
        "eigen": lambda: limn.Scheme("loop").eigen(range(500, 1500)),
        "compare": lambda: limn.compare("loop", "butterfly", valence=range(3, 1000), seconds=None),
    }


@pytest.mark.parametrize("name", ["refine", "certify", "regularity", "tune", "eigen", "compare"])
def test_a_signal_ends_it(name):
    call = long_calls()[name]

    def handler(number, frame):
        raise Alarm

    before = signal.signal(signal.SIGALRM, handler)
    start = time.perf_counter()
    signal.setitimer(signal.ITIMER_REAL, 0.5)
    try:
        with pytest.raises(Alarm):
            call()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert time.perf_counter() - start < 20


def test_an_interrupt_is_a_keyboard_interrupt():
    V, F = big_mesh()
    timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(50):
            limn.Scheme("catmull-clark").refine(V, F, 2, engine="plain")
    timer.join()


def test_a_handler_that_does_not_raise_ends_nothing():
    V, F = big_mesh()
    seen = []
    before = signal.signal(signal.SIGALRM, lambda number, frame: seen.append(number))
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    try:
        fine, _ = limn.Scheme("catmull-clark").refine(V, F, 2, engine="plain")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert len(fine) > len(V) and seen


def refined(scale):
    V, F = cube()
    return limn.Scheme("catmull-clark").refine(scale * V, F, 6)[0]


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_processes(start):
    expected = [refined(scale) for scale in (1, 2, 3)]  # this process has threads by now
    with multiprocessing.get_context(start).Pool(2) as pool:
        for mine, theirs in zip(expected, pool.map_async(refined, (1, 2, 3)).get(timeout=120)):
            assert np.array_equal(mine, theirs)
