"""Calls of the library: what they fail with, and what is heard of them meanwhile."""

import ctypes
import threading

from . import _interface

library = _interface.load()
_CANCELLED = 5


class Error(RuntimeError):
    """What Macula could not do: `message` and `advice` for a person; `place`, which may name a patient, is in neither
    of them and belongs in no log."""

    def __init__(self, status, message, advice, place):
        super().__init__(f"{message} {advice}".strip())
        self.status, self.message, self.advice, self.place = status, message, advice, place

    def __reduce__(self):  # it goes from process to process
        return Error, (self.status, self.message, self.advice, self.place)

    @property
    def is_cancelled(self):
        return self.status == _CANCELLED


Error.__module__ = "macula"


def check(status):
    if status == 0:
        return
    error = _interface.ErrorStruct()
    library.macula_last_error(error)
    raise Error(error.status, *((text or b"").decode("utf-8", "replace")
                                for text in (error.message, error.advice, error.place)))


def texts(told, handle):
    found = []
    while (text := told(handle, len(found))) is not None:
        found.append(text.decode("utf-8", "replace"))
    return found


class Watch:
    """Hands progress to a function of Python, which cancels by returning True. What it raises, Ctrl-C too, cancels, and
    is raised again once Macula has come back."""

    def __init__(self, listener):
        self._listener, self._raised = listener, None
        self._told = _interface.Told(self._hear)  # must live as long as the call
        self.progress = _interface.Progress(told=self._told)

    def _hear(self, _user, stage, fraction):
        return self.ask(self._listener, lambda: (stage.decode("utf-8", "replace"), fraction))

    def ask(self, listener, told):
        """What C is told of what a listener returns of `told()`."""
        try:
            return 1 if listener is not None and listener(*told()) else 0
        except BaseException as raised:  # nothing may go through C
            self._raised = raised
            return 1

    def check(self, status):
        raised, self._raised = self._raised, None
        if raised is not None:
            raise raised
        check(status)

    def made(self, status, kind, handle, close):
        """What a call has opened, which is closed where a listener has raised meanwhile."""
        opened = kind(handle, close) if handle else None
        try:
            self.check(status)
        except BaseException:
            if opened is not None:
                opened.close()
            raise
        return opened


class _Cancel:
    """A handle that cancels; whoever has it last closes it."""

    def __init__(self):
        self.handle, self._close = ctypes.c_void_p(), library.macula_cancel_close
        check(library.macula_cancel_create(self.handle))

    def __del__(self):
        self._close(self.handle)


class PatientWatch(Watch):
    """For calls that may hear nothing for long, as those to an archive. They run in a thread of their own, because Ctrl-C
    does not reach Python while it waits for C."""

    def __init__(self, listener):
        super().__init__(listener)
        self._cancel = _Cancel()
        self.progress.cancel = self._cancel.handle

    def run(self, call):
        """What `call()` returns or raises, which checks its status itself: the last error is that of a thread."""
        done, failed = [], []

        def work():
            try:
                done.append(call())
            except BaseException as raised:
                failed.append(raised)

        thread = threading.Thread(target=work)
        try:
            thread.start()
            thread.join()
        except BaseException:  # Ctrl-C
            library.macula_cancel_now(self._cancel.handle)
            if thread.ident is not None:
                thread.join()
            raise
        if failed:
            raise failed[0]
        return done[0]
