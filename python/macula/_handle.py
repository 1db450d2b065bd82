"""Handles of the library, and what is given to it."""

import contextlib
import ctypes
import operator
import os
import threading

is_heard = threading.local()  # .now: this thread tells the log to somebody


def bytes_of(text):
    """A path, or a word, or nothing."""
    if text is None:
        return None
    told = os.fsencode(text)
    if b"\0" in told:  # where C would end: it would be another path
        raise ValueError("A name has no 0 in it.")
    return told


def numbers(values, count, what):
    given = [float(value) for value in values]
    if len(given) != count:
        raise ValueError(f"{what}: {count} numbers, and not {len(given)}.")
    return (ctypes.c_double * count)(*given)


def whole(value, most, what):
    """A number that ctypes would cut off in silence."""
    number = operator.index(value)
    if not 0 <= number <= most:
        raise ValueError(f"{what}: 0 to {most}.")
    return number


class _AtOnce:
    """A lock that nobody waits for."""

    def __init__(self, lock):
        self._lock = lock

    def __enter__(self):
        if not self._lock.acquire(blocking=False):
            raise ValueError("It is in use by another thread. Make one for each, and call nothing of Macula from "
                             "functions that hear of progress.")

    def __exit__(self, *_raised):
        self._lock.release()


class Handle:
    """What is closed once."""

    _is_of_process = False  # has a device, whose threads a fork does not take along

    def __init__(self, handle, close):
        self._handle, self._close, self._left = handle, close, None
        self._in_use, self._user, self._process = threading.Lock(), None, os.getpid()

    def _is_of_another_process(self):
        return self._is_of_process and self._process != os.getpid()

    def _open(self):
        if self._handle is None:
            raise ValueError("It is closed.")
        if self._is_of_another_process():
            raise ValueError("It was opened before this process was forked. Open it here.")
        return self._handle

    @contextlib.contextmanager
    def _held(self, waits=True):
        """The handle, from a call to what there is to know of what it made: that must not be of another call. Where it
        is closed meanwhile, that waits. Without `waits`, it is an error that another thread has it."""
        if self._user == threading.get_ident():
            raise ValueError("It is in use. Functions that hear of progress must not call Macula.")
        try:
            with self._in_use if waits else _AtOnce(self._in_use):
                self._user = threading.get_ident()
                try:
                    yield self._open()
                finally:
                    self._user = None
        finally:
            self._close_left()

    def _close_left(self):
        # Who has it meanwhile comes here after that.
        while self._left is not None and self._in_use.acquire(blocking=False):
            try:
                handle, self._left = self._left, None
                if handle is not None:
                    self._close(handle)
            finally:
                self._in_use.release()

    def close(self):
        """At once, or after the picture that another thread draws with it."""
        # Let go of first: Ctrl-C while it closes is raised as soon as that returns, and __del__ would close it again.
        handle, self._handle = getattr(self, "_handle", None), None
        if handle is not None and not self._is_of_another_process():
            self._left = handle
            self._close_left()

    def __del__(self):
        # What closes may have to say something to the log, which waits for what is told of it now.
        if getattr(self, "_handle", None) is not None and getattr(is_heard, "now", False):
            threading.Thread(target=self.close).start()
        else:
            self.close()

    def __enter__(self):
        return self

    def __exit__(self, *_raised):
        self.close()
